#pragma once
#include "Grid/GridView.h"
#include "Grid/MinMaxBlocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace hasp
{

/// Which samples of a row satisfy a condition, a bit each.
using RowBits = std::uint8_t*;

/// Eight bytes of 0 or 1 to eight bits, the first lowest.
inline std::uint8_t PackBits(const std::uint8_t* flags)
{
  std::uint64_t eight;
  std::memcpy(&eight, flags, 8);
  return static_cast<std::uint8_t>(eight * 0x0102040810204080ULL >> 56);
}

/// Finds the active cells of a row of blocks along x, 8x8 rows of cells, all blocks at once: the
/// loops run along x, so that the compiler can use whole vectors.
template <typename T>
class BlockRow
{
public:
  static constexpr int Side = MinMaxBlocks::Side;

  BlockRow(const GridView<const T>& grid, float isovalue)
    : Grid(grid),
      Isovalue(isovalue),
      Bytes((grid.geometry.dims.x + Side - 1) / Side + 1),
      Inside(std::size_t{ (Side + 1) * (Side + 1) } * Bytes),
      Bad(std::is_same_v<T, float> ? Inside.size() : 0),
      Active(std::size_t{ Side * Side } * Bytes),
      Flags(std::size_t(Bytes) * 8)
  {
  }

  /// Blocks [from, to) of the row of blocks at (y, z).
  void Read(int from, int to, int y, int z)
  {
    const glm::ivec3 dims = this->Grid.geometry.dims;
    this->Rows =
      glm::min(glm::ivec2(Side), glm::ivec2(dims.y, dims.z) - 1 - glm::ivec2(y, z) * Side);
    const int first = from * Side, count = std::min(to * Side + 1, dims.x) - first;
    for (int k = 0; k <= this->Rows.y; ++k)
      for (int j = 0; j <= this->Rows.x; ++j)
        this->ReadRow(&this->Grid(first, y * Side + j, z * Side + k), count,
          this->InsideRow(j, k) + from, this->Bad.empty() ? nullptr : this->BadRow(j, k) + from);
    for (int k = 0; k < this->Rows.y; ++k)
      for (int j = 0; j < this->Rows.x; ++j)
        this->FindActive(j, k, from, to);
  }

  /// Active cells of block x, a word a slice; false if there are none.
  bool ActiveCells(int x, std::array<std::uint64_t, Side>& active) const
  {
    const int cells = std::min(Side, this->Grid.geometry.dims.x - 1 - x * Side);
    const std::uint64_t valid = 0x0101010101010101ULL * ((1U << cells) - 1U);
    std::uint64_t any = 0;
    for (int k = 0; k < Side; ++k)
    {
      std::uint64_t slice = 0;
      if (k < this->Rows.y)
        for (int j = 0; j < this->Rows.x; ++j)
          slice |= std::uint64_t{ this->Active[std::size_t(k * Side + j) * this->Bytes + x] }
                   << 8 * j;
      active[k] = slice & valid;
      any |= active[k];
    }
    return any != 0;
  }

private:
  RowBits InsideRow(int j, int k)
  {
    return &this->Inside[std::size_t(k * (Side + 1) + j) * this->Bytes];
  }
  RowBits BadRow(int j, int k) { return &this->Bad[std::size_t(k * (Side + 1) + j) * this->Bytes]; }

  void ReadRow(const T* row, int count, RowBits inside, RowBits bad)
  {
    // In a block with surface min < isovalue <= max, so the next integer is one of T.
    const T least = std::is_same_v<T, float> ? T(this->Isovalue) : T(std::ceil(this->Isovalue));
    std::uint8_t* flags = this->Flags.data();
    const int bytes = (count + 7) / 8;
    std::memset(flags + count, 0, 8 * bytes - count);
    for (int i = 0; i < count; ++i)
      flags[i] = row[i] >= least;
    for (int b = 0; b < bytes; ++b)
      inside[b] = PackBits(flags + 8 * b);
    if constexpr (std::is_same_v<T, float>)
    {
      for (int i = 0; i < count; ++i)
        flags[i] = !(std::abs(row[i]) <= std::numeric_limits<float>::max());
      for (int b = 0; b < bytes; ++b)
        bad[b] = PackBits(flags + 8 * b);
    }
  }

  /// Corners on both sides, all of them finite. The last byte of a row holds the last corner only.
  void FindActive(int j, int k, int from, int to)
  {
    const auto pairs = [](RowBits bits, int b) // each bit or-ed with the next
    { return std::uint8_t(bits[b] | bits[b] >> 1 | bits[b + 1] << 7); };
    const auto bothOf = [](RowBits bits, int b)
    { return std::uint8_t(bits[b] & (bits[b] >> 1 | bits[b + 1] << 7)); };
    RowBits a = this->InsideRow(j, k), b = this->InsideRow(j + 1, k);
    RowBits c = this->InsideRow(j, k + 1), d = this->InsideRow(j + 1, k + 1);
    RowBits out = &this->Active[std::size_t(k * Side + j) * this->Bytes];
    for (int x = from; x < to; ++x)
    {
      const std::uint8_t any = pairs(a, x) | pairs(b, x) | pairs(c, x) | pairs(d, x);
      const std::uint8_t all = bothOf(a, x) & bothOf(b, x) & bothOf(c, x) & bothOf(d, x);
      out[x] = any & ~all;
    }
    if (this->Bad.empty())
      return;
    a = this->BadRow(j, k), b = this->BadRow(j + 1, k);
    c = this->BadRow(j, k + 1), d = this->BadRow(j + 1, k + 1);
    for (int x = from; x < to; ++x)
      out[x] &= ~(pairs(a, x) | pairs(b, x) | pairs(c, x) | pairs(d, x));
  }

  GridView<const T> Grid;
  float Isovalue;
  int Bytes; ///< a row of bits: one a block, and one for the last corner
  glm::ivec2 Rows{ 0 };
  std::vector<std::uint8_t> Inside, Bad, Active, Flags;
};

} // namespace hasp
