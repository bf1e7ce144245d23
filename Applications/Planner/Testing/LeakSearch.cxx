#include "LeakSearch.h"

#include "../../CommandLine/Testing/CanaryFiles.h"

#include "vtk_zlib.h"

#include <QByteArray>

#include <algorithm>

#include <X11/Xlib.h> // last: it defines words as macros

namespace
{

constexpr std::size_t MostBytes = std::size_t{ 1 } << 26;

/// Of CanaryFiles.h and of PlannerDesk.h. A year alone is in every long list of numbers.
std::string PlainLeaks(const std::string& bytes)
{
  std::string lower = bytes, found = canary::TokensIn(bytes);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* token : { "mustermann", "erika_" })
    if (lower.find(token) != lower.npos)
      found += std::string(token) + "; ";
  return found;
}

/// An entry of a zip file: deflated without a header of its own.
std::string Unzipped(const std::string& bytes, std::size_t at)
{
  z_stream stream{};
  if (at >= bytes.size() || inflateInit2(&stream, -15) != Z_OK)
    return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + at));
  stream.avail_in = static_cast<uInt>(bytes.size() - at);
  std::string result, piece(1 << 16, '\0');
  for (int state = Z_OK; state == Z_OK && result.size() < MostBytes;)
  {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    result.append(piece, 0, piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return result;
}

std::size_t TwoBytes(const std::string& bytes, std::size_t at)
{
  const auto byte = [&](std::size_t n)
  { return std::size_t(static_cast<unsigned char>(bytes[n])); };
  return byte(at) + 256 * byte(at + 1);
}

} // namespace

std::string LeaksIn(const std::string& bytes)
{
  std::string found = PlainLeaks(bytes);
  std::string narrow = bytes; // of UTF-16 what is ASCII
  narrow.erase(std::remove(narrow.begin(), narrow.end(), '\0'), narrow.end());
  if (found.empty())
    found = PlainLeaks(narrow);
  constexpr std::size_t Head = 30;
  const std::string entry("PK\3\4", 4), embedded = "base64,";
  for (std::size_t at = bytes.find(entry); at != bytes.npos && at + Head < bytes.size();
       at = bytes.find(entry, at + 1))
    found +=
      PlainLeaks(Unzipped(bytes, at + Head + TwoBytes(bytes, at + 26) + TwoBytes(bytes, at + 28)));
  for (std::size_t at = bytes.find(embedded); at != bytes.npos; at = bytes.find(embedded, at + 1))
  {
    const std::size_t from = at + embedded.size(), to = bytes.find_first_of("\"')", from);
    found +=
      PlainLeaks(QByteArray::fromBase64(QByteArray::fromStdString(bytes.substr(from, to - from)))
                   .toStdString());
  }
  return found;
}

std::string TitlesOn(const std::string& display)
{
  std::string titles;
  Display* screen = XOpenDisplay(display.c_str());
  if (!screen)
    return titles;
  Window root = 0, parent = 0, *windows = nullptr;
  unsigned int count = 0;
  XQueryTree(screen, DefaultRootWindow(screen), &root, &parent, &windows, &count);
  for (unsigned int n = 0; n < count; ++n)
    if (char* name = nullptr; XFetchName(screen, windows[n], &name))
    {
      titles += std::string(name) + "\n";
      XFree(name);
    }
  XFree(windows);
  XCloseDisplay(screen);
  return titles;
}
