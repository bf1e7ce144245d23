#pragma once
#include "Grid/GridView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/common.hpp>

namespace hasp
{

/// The eight samples of cell (i,j,k), x fastest: corner[c] is at (i + (c&1), j + (c>>1&1), k +
/// (c>>2)).
template <typename T>
std::array<double, 8> CellCorners(const GridView<const T>& grid, const glm::ivec3& cell)
{
  const T* p = &grid(cell.x, cell.y, cell.z);
  const std::size_t row = grid.geometry.dims.x, slice = row * grid.geometry.dims.y;
  return { double(p[0]), double(p[1]), double(p[row]), double(p[row + 1]), double(p[slice]),
    double(p[slice + 1]), double(p[slice + row]), double(p[slice + row + 1]) };
}

/// The trilinear polynomial of a cell at local coordinates t in [0,1]^3. Written as (1-t)a + tb, so
/// that two cells give the same value on the face they share.
inline double TrilinearValue(const std::array<double, 8>& c, const glm::dvec3& t)
{
  const auto lerp = [](double a, double b, double s) { return (1.0 - s) * a + s * b; };
  const double y0 = lerp(lerp(c[0], c[1], t.x), lerp(c[2], c[3], t.x), t.y);
  const double y1 = lerp(lerp(c[4], c[5], t.x), lerp(c[6], c[7], t.x), t.y);
  return lerp(y0, y1, t.z);
}

/// Its gradient per index step (not per millimetre: see GridGeometry::GradientToWorld).
inline glm::dvec3 TrilinearGradient(const std::array<double, 8>& c, const glm::dvec3& t)
{
  const auto bilinear = [](double a, double b, double d, double e, double s, double r)
  { return (1.0 - r) * ((1.0 - s) * a + s * b) + r * ((1.0 - s) * d + s * e); };
  return { bilinear(c[1] - c[0], c[3] - c[2], c[5] - c[4], c[7] - c[6], t.y, t.z),
    bilinear(c[2] - c[0], c[3] - c[1], c[6] - c[4], c[7] - c[5], t.x, t.z),
    bilinear(c[4] - c[0], c[5] - c[1], c[6] - c[2], c[7] - c[3], t.x, t.y) };
}

/// The cell holding a continuous index position, and the position inside it. The last sample of an
/// axis belongs to the last cell. Nothing if the position is outside the grid, not finite, or an
/// axis has only one sample.
struct CellPosition
{
  glm::ivec3 cell;
  glm::dvec3 local;
};
inline std::optional<CellPosition> LocateCell(const GridGeometry& geometry, const glm::dvec3& index)
{
  CellPosition found{};
  for (int a = 0; a < 3; ++a)
  {
    const int last = geometry.dims[a] - 1;
    if (last < 1 || !(index[a] >= 0.0 && index[a] <= double(last)))
      return std::nullopt;
    found.cell[a] = std::min(static_cast<int>(index[a]), last - 1);
    found.local[a] = index[a] - found.cell[a];
  }
  return found;
}

/// Trilinear interpolation at a continuous index position; nothing outside the grid.
template <typename T>
std::optional<double> SampleTrilinear(const GridView<const T>& grid, const glm::dvec3& index)
{
  const auto at = LocateCell(grid.geometry, index);
  if (!at)
    return std::nullopt;
  return TrilinearValue(CellCorners(grid, at->cell), at->local);
}

} // namespace hasp
