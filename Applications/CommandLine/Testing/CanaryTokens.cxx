#include "CanaryFiles.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <array>

namespace canary
{
namespace
{

/// What is compressed at this place, up to 16 MiB; empty if nothing is.
std::string Inflated(const std::string& bytes, std::size_t at)
{
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) // zlib or gzip, by its first bytes
    return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + at));
  stream.avail_in = static_cast<uInt>(bytes.size() - at);
  std::string result;
  std::array<char, 1 << 16> piece;
  int state = Z_OK;
  while (state == Z_OK && result.size() < std::size_t(1) << 24)
  {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = piece.size();
    state = inflate(&stream, Z_NO_FLUSH);
    result.append(piece.data(), piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return result;
}

std::string PlainTokens(const std::string& bytes)
{
  std::string lower = bytes, found;
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  for (const std::string& token : { Family, Given, Number, Day })
    if (const auto at = lower.find(token); at != lower.npos)
      found += token + " at " + std::to_string(at) + "; ";
  return found;
}

} // namespace

std::string Name()
{
  return Family + "_" + Given;
}

std::string TokensIn(const std::string& bytes)
{
  std::string found = PlainTokens(bytes);
  for (std::size_t at = 0; at + 2 < bytes.size(); ++at)
  {
    const auto first = static_cast<unsigned char>(bytes[at]),
               second = static_cast<unsigned char>(bytes[at + 1]);
    if ((first == 0x1f && second == 0x8b) || (first == 0x78 && (first * 256 + second) % 31 == 0))
      if (const std::string inside = PlainTokens(Inflated(bytes, at)); !inside.empty())
        found += "compressed at " + std::to_string(at) + ": " + inside;
  }
  return found;
}

} // namespace canary
