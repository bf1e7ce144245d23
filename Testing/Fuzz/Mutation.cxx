#include "Mutation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <random>
#include <stdexcept>

namespace hasp
{
namespace
{

using Engine = std::mt19937_64; // its numbers, unlike std distributions, are the same everywhere

constexpr std::size_t HeaderBytes = 1024;
constexpr std::size_t LargestPiece = 512;

std::size_t Below(Engine& engine, std::size_t count)
{
  return count == 0 ? 0 : static_cast<std::size_t>(engine() % count);
}

std::size_t Place(Engine& engine, const std::string& bytes)
{
  const std::size_t header = std::min(bytes.size(), HeaderBytes);
  return Below(engine, engine() % 2 == 0 ? header : bytes.size());
}

void TurnBit(Engine& engine, std::string& bytes)
{
  bytes[Place(engine, bytes)] ^= static_cast<char>(1U << Below(engine, 8));
}

/// 8, 16, 32 or 64 bits of 0, all ones, the largest or smallest number, in either byte order.
void PutTellingValue(Engine& engine, std::string& bytes)
{
  constexpr std::array<std::uint64_t, 8> values{ 0, 1, 0x7f, 0x80, 0xff, 0xffff, 0x7fffffff,
    0xffffffffffffffff };
  const std::uint64_t value = values[Below(engine, values.size())];
  const std::size_t size = std::size_t(1) << Below(engine, 4), at = Place(engine, bytes);
  const bool bigEndian = engine() % 2 == 0;
  for (std::size_t n = 0; n < size && at + n < bytes.size(); ++n)
    bytes[at + n] = static_cast<char>(value >> (8 * (bigEndian ? size - 1 - n : n)));
}

void RemovePiece(Engine& engine, std::string& bytes)
{
  bytes.erase(Place(engine, bytes), 1 + Below(engine, LargestPiece));
}

void DoublePiece(Engine& engine, std::string& bytes)
{
  const std::size_t at = Place(engine, bytes);
  bytes.insert(at, bytes.substr(at, 1 + Below(engine, LargestPiece)));
}

void ZeroPiece(Engine& engine, std::string& bytes)
{
  const std::size_t at = Place(engine, bytes), size = 1 + Below(engine, 64);
  for (std::size_t n = at; n < std::min(bytes.size(), at + size); ++n)
    bytes[n] = '\0';
}

void CutOff(Engine& engine, std::string& bytes)
{
  bytes.resize(Place(engine, bytes));
}

void TakePiece(Engine& engine, const std::string& other, std::string& bytes)
{
  const std::size_t at = Place(engine, bytes), size = 1 + Below(engine, LargestPiece);
  bytes.replace(at, size, other.substr(Place(engine, other), size));
}

void PutWildNumber(Engine& engine, std::string& bytes)
{
  constexpr std::array<const char*, 14> numbers{ "0", "-1", "1", "65535", "65536", "2147483647",
    "2147483648", "4294967295", "99999999999999999999", "1e308", "1e-320", "nan", "-inf", "" };
  const auto digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto first = std::find_if(
    bytes.begin() + static_cast<std::ptrdiff_t>(Place(engine, bytes)), bytes.end(), digit);
  const auto last = std::find_if_not(first, bytes.end(), digit);
  bytes.replace(first, last, numbers[Below(engine, numbers.size())]);
}

void AddFault(Engine& engine, const std::string& other, std::string& bytes)
{
  switch (Below(engine, 8))
  {
    case 0:
      return TurnBit(engine, bytes);
    case 1:
      return PutTellingValue(engine, bytes);
    case 2:
      return RemovePiece(engine, bytes);
    case 3:
      return DoublePiece(engine, bytes);
    case 4:
      return ZeroPiece(engine, bytes);
    case 5:
      return CutOff(engine, bytes);
    case 6:
      return TakePiece(engine, other, bytes);
    default:
      return PutWildNumber(engine, bytes);
  }
}

} // namespace

std::string Mutate(const std::vector<std::string>& seeds, std::uint64_t number)
{
  if (seeds.empty())
    throw std::invalid_argument("there are no seeds to mutate");
  Engine engine(number);
  std::string bytes = seeds[Below(engine, seeds.size())];
  const std::string& other = seeds[Below(engine, seeds.size())];
  for (std::size_t faults = 1 + Below(engine, 4); faults > 0 && !bytes.empty(); --faults)
    AddFault(engine, other, bytes);
  return bytes;
}

} // namespace hasp
