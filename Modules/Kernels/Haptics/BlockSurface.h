#pragma once
#include "Grid/GridView.h"
#include "Grid/MinMaxBlocks.h"

#include <array>
#include <cstdint>

namespace hasp
{

/// The isosurface in one block of 8x8x8 cells, with a copy of the block's samples: what points are
/// drawn from. HAPTIC: takes no memory.
class BlockSurface
{
public:
  /// A place on the surface: index coordinates from the block's first sample on, and the outward
  /// normal along the grid's axes (unit, of what is measured in mm).
  struct Place
  {
    glm::dvec3 index;
    glm::dvec3 normal;
  };

  /// Copies the samples. 1 us.
  void Read(const AnyGridView& grid, const glm::ivec3& block) noexcept;
  /// Chooses the surface; outward: 1 where values grow outwards (a distance), -1 where they fall (a
  /// grey volume, whose inside is value >= isovalue). Forgets the cells. 1 ns.
  void SetIsovalue(double isovalue, double outward) noexcept;
  /// Finds the cells that the surface crosses, and their areas. Cells with a sample that is not
  /// finite hold no surface. 10 us.
  void FindCells() noexcept;
  bool HasCells() const noexcept { return this->CellsKnown; }
  double Area() const noexcept
  {
    return this->CellCount == 0 ? 0.0 : this->Ends[this->CellCount - 1];
  }

  /// The place at a share in [0, 1) of the area, cell after cell, and at (u, v) in [0, 1)^2 of the
  /// triangle there. False where the surface is not found. Needs cells. 0.2 us.
  bool Draw(double share, double u, double v, Place& place) const noexcept;
  /// Moves a place along the gradient to the surface, within the block. False where it is not found
  /// there. 0.1 us.
  bool Project(Place& place) const noexcept;

private:
  static constexpr int Side = MinMaxBlocks::Side, Row = Side + 1;
  static constexpr int MostSamples = Row * Row * Row, MostCells = Side * Side * Side;
  static int SampleIndex(int i, int j, int k) noexcept { return (k * Row + j) * Row + i; }
  std::uint32_t InsideInRow(int j, int k) const noexcept;
  std::array<double, 8> CornersOf(const glm::ivec3& cell) const noexcept;

  glm::ivec3 Samples{ 0 }; ///< along each axis: 9, fewer at the grid's end
  glm::dvec3 Spacing{ 1.0 };
  double Isovalue = 0.0, Outward = 1.0;
  bool CellsKnown = false;
  int CellCount = 0;
  std::array<float, MostSamples> Values{};
  std::array<std::uint16_t, MostCells> Cells{};
  std::array<float, MostCells> Ends{}; ///< area up to and with each cell, mm^2
};

} // namespace hasp
