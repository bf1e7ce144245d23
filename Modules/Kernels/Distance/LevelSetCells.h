#pragma once
#include "Grid/GridView.h"
#include "Grid/Trilinear.h"

#include <openvdb/openvdb.h>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace hasp
{

/// The affine map of a grid, index to world; throws std::invalid_argument on frustums.
struct LevelSetFrame
{
  explicit LevelSetFrame(const openvdb::FloatGrid& grid)
  {
    if (!grid.transform().isLinear())
      throw std::invalid_argument("level set: its transform is a frustum; resample it first");
    const auto m = grid.transform().baseMap()->getAffineMap()->getMat4(); // of row vectors
    for (int a = 0; a < 3; ++a)
    {
      for (int row = 0; row < 3; ++row)
        this->toWorld[a][row] = m(a, row);
      this->origin[a] = m(3, a);
    }
    this->toIndex = glm::inverse(this->toWorld);
  }
  glm::dvec3 Index(const glm::dvec3& world) const { return this->toIndex * (world - this->origin); }

  glm::dmat3 toWorld{}, toIndex{}; ///< columns: of one index step
  glm::dvec3 origin{};             ///< of index 0
};

/// The eight values around places of a level set. Takes no memory, throws nothing; a place that is
/// not finite has some values. One thread; make one for each piece of work.
class LevelSetCells
{
public:
  explicit LevelSetCells(const openvdb::FloatGrid& grid) : Values(grid.tree()) {}

  CellPosition Locate(const glm::dvec3& index) const noexcept
  {
    constexpr double most = 1e9; // so that neighbours' indices fit
    CellPosition found{};
    for (int a = 0; a < 3; ++a)
    {
      const double at = index[a] > -most ? std::min(index[a], most) : -most;
      found.cell[a] = static_cast<int>(std::floor(at));
      found.local[a] = at - found.cell[a];
    }
    return found;
  }
  std::array<double, 8> Corners(const glm::ivec3& cell) const noexcept
  {
    std::array<double, 8> corners{};
    for (int n = 0; n < 8; ++n)
      corners[n] = double(this->Values.getValue(
        openvdb::Coord(cell.x + (n & 1), cell.y + (n >> 1 & 1), cell.z + (n >> 2))));
    return corners;
  }

private:
  openvdb::FloatGrid::ConstUnsafeAccessor
    Values; // unsafe: not known to the tree, so without a lock
};

} // namespace hasp
