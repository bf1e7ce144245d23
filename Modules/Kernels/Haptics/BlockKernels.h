#pragma once
#include "Grid/MinMaxBlocks.h"
#include "Haptics/ContactPoints.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hasp
{

/// The samples of a block of 8x8x8 cells, x fastest, and the surface looked for in them.
struct BlockSamples
{
  static constexpr int Side = MinMaxBlocks::Side, Row = Side + 1;
  static constexpr int Most = Row * Row * Row, MostCells = Side * Side * Side;
  static constexpr int IndexOf(int i, int j, int k) noexcept { return (k * Row + j) * Row + i; }
  /// Of a cell's number, x fastest.
  static constexpr glm::ivec3 CellOf(int number) noexcept
  {
    return { number % Side, number / Side % Side, number / (Side * Side) };
  }
  /// At the corners of a cell, as of CellCorners; <= 0 is inside.
  std::array<double, 8> CornersOf(const glm::ivec3& cell) const noexcept;

  std::array<float, Most> values{};
  glm::ivec3 samples{ 0 }; ///< along each axis: 9, fewer at the grid's end
  glm::vec3 spacing{ 1.0F };
  float isovalue = 0.0F, outward = 1.0F; ///< outward: 1 where values grow outwards, else -1
};

/// Places on or near the surface, 16 side by side: index coordinates from the block's first sample
/// on, and outward normals along the grid's axes (unit, of what is measured in mm).
struct BlockPlaces
{
  static constexpr int Count = ContactPoints::Lanes;
  alignas(64) float index[3][Count]{};
  alignas(64) float normal[3][Count]{};
};

/// What takes most of a dynamic shell's tick, for several cells or points at once. One contract:
/// the scalar one computes with doubles and triangles; vectors compute with floats and closed
/// forms, equal within 1e-5 of a cell's area, and 1e-5 of a voxel where points end. A point whose
/// share of the area falls on the border of two tetrahedra within that rounding may be drawn in
/// either. HAPTIC: no memory, no lock.
struct BlockKernels
{
  const char* name = "";
  /// mm^2 of the surface in each of `count` cells whose samples are finite. Both arrays have room
  /// for the next multiple of 16, which may be read (cells: valid numbers) and written.
  void (*areas)(
    const BlockSamples& block, const std::uint16_t* cells, int count, float* areas) noexcept;
  /// In which of CellTetrahedra the place at `left` mm^2 of the cell's surface lies, 16 cells at
  /// once. left: from there on what is left of it.
  void (*pick)(const BlockSamples& block, const std::uint16_t* cells, float* left,
    std::uint8_t* tetrahedra) noexcept;
  /// Moves places along the gradient to the surface, within the block; 5 steps at most, until one
  /// was shorter than 0.02 of the smallest spacing. Returns a bit for each that has found it.
  std::uint32_t (*project)(const BlockSamples& block, BlockPlaces& places) noexcept;
};

BlockKernels ScalarBlockKernels() noexcept;
/// All that this processor runs, the scalar ones first.
std::vector<BlockKernels> AllBlockKernels();
/// Of the instruction set that the contact kernels were found fastest with. WORKER.
const BlockKernels& FastestBlockKernels();

} // namespace hasp
