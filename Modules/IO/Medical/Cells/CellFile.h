#pragma once
#include <cstdint>
#include <filesystem>

/// Internal to IOMedical.
namespace hasp
{

/// The head of a .hcells file, byte for byte.
struct CellFileHead
{
  static constexpr char Magic[8] = { '\x89', 'H', 'C', 'E', 'L', 'L', '\r', '\n' };
  static constexpr std::uint32_t Version = 1;

  char magic[8];
  std::uint32_t version;
  std::uint32_t bytes; ///< of the head
  std::int32_t dims[3];
  float isovalue;
  double origin[3], spacing[3];
  double direction[9];      ///< the world direction of the first axis first
  std::uint32_t cornerType; ///< CornerType
  std::uint32_t precision;  ///< CellPrecision
  std::uint64_t cells;
  /// How many there are of each, in the order in which they follow: 96, 4, 4, 2, 4 and 4 bytes
  /// each.
  std::uint64_t clusters, corners, levels, labels, colors, firstColors;
  std::uint32_t bodyChecksum; ///< CRC-32 of all that follows the head
  std::uint32_t headChecksum; ///< CRC-32 of the head up to here
};
static_assert(sizeof(CellFileHead) == 224);

/// Of a file that is named or read as active cells and does not begin as they do.
[[noreturn]] void ThrowIsNoCells(const std::filesystem::path& file);

} // namespace hasp
