#pragma once
#include "Grid/GridView.h"
#include "Haptics/BlockKernels.h"

#include <array>
#include <cstdint>

namespace hasp
{

/// The isosurface in one block of 8x8x8 cells, with a copy of the block's samples: what points are
/// drawn from. HAPTIC: takes no memory.
class BlockSurface
{
public:
  /// Asks for the samples, so that Read finds them near: in a large volume they are not.
  static void Prefetch(const AnyGridView& grid, const glm::ivec3& block) noexcept;
  /// Copies the samples. 1 us.
  void Read(const AnyGridView& grid, const glm::ivec3& block) noexcept;
  /// Chooses the surface; outward: 1 where values grow outwards (a distance), -1 where they fall (a
  /// grey volume, whose inside is value >= isovalue). Forgets the cells. 1 ns.
  void SetIsovalue(double isovalue, double outward) noexcept;
  /// Finds the cells that the surface crosses, and their areas. Cells with a sample that is not
  /// finite hold no surface. 2 us; scalar 10 us.
  void FindCells(const BlockKernels& kernels) noexcept;
  bool HasCells() const noexcept { return this->CellsKnown; }
  double Area() const noexcept
  {
    return this->CellCount == 0 ? 0.0 : this->Ends[this->CellCount - 1];
  }
  const BlockSamples& Samples() const noexcept { return this->Block; }

  /// Where 16 points are to be drawn.
  struct Shares
  {
    double area[BlockPlaces::Count];                     ///< in [0, 1), cell after cell
    double u[BlockPlaces::Count], v[BlockPlaces::Count]; ///< in [0, 1)^2 of the triangle there
  };
  /// The places there, on the surface. Returns a bit for each that was found. Needs cells and an
  /// area. 1 us; scalar 3 us.
  std::uint32_t Draw(
    const BlockKernels& kernels, const Shares& shares, BlockPlaces& places) const noexcept;

private:
  std::uint32_t InsideInRow(int j, int k) const noexcept;

  BlockSamples Block;
  bool CellsKnown = false, Finite = true;
  int CellCount = 0;
  std::array<std::uint16_t, BlockSamples::MostCells> Cells{};
  std::array<float, BlockSamples::MostCells> Ends{}; ///< area up to and with each cell, mm^2
};

} // namespace hasp
