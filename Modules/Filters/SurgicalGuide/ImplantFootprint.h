#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridGeometry.h"

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace hasp
{

/// One value for each column of a grid, seen along its third axis: x fastest, mm.
struct ColumnLayer
{
  GridGeometry grid;
  std::vector<float> values;

  /// Of a column, mm along the grid's first two axes from its origin.
  glm::dvec2 Place(std::size_t column) const
  {
    const auto width = std::size_t(this->grid.dims.x);
    return glm::dvec2(this->grid.spacing) * glm::dvec2(column % width, column / width);
  }
  /// A world's place, seen along the axis.
  glm::dvec2 Place(const glm::dvec3& world) const
  {
    return glm::dvec2((world - this->grid.origin) * this->grid.direction);
  }
  /// Between the columns; beyond them, at the nearest.
  double At(const glm::dvec2& place) const;
};

/// Signed distance to the line where a layer is 0, exact to straight pieces between columns, and of
/// the layer's sign. 1e3 everywhere, of its sign, if it has none. All cores; O(columns * pieces).
ColumnLayer DistanceToZero(ColumnLayer layer);

/// What lies at least clearanceMm from what is blocked, opened by a disc: where that does not fit
/// in, nothing is left, so that no tongue is narrower than 2 radiusMm and corners are round by it.
///
/// toBlocked  mm, a distance where it is positive
/// The largest connected part alone. Returns mm, POSITIVE INSIDE; a distance outside and within
/// radiusMm inside. Throws std::runtime_error, beginning with "implant", if there is none, or
/// another one of a twentieth of its area, naming the places on the `outline`'s mean plane.
ColumnLayer MakeFootprint(const ColumnLayer& toBlocked, double clearanceMm, double radiusMm,
  std::span<const glm::dvec3> outline);

/// The columns where a footprint is positive, without ends along the grid's third axis, as high as
/// the grid.
SolidPointer MakeFootprintSolid(const ColumnLayer& footprint);

/// Middles of holes in rows, every other one half a pitch on, from the footprint's middle, where
/// it is at least `room` deep. Throws std::runtime_error over 2,000.
std::vector<glm::dvec2> PlacePerforation(const ColumnLayer& footprint, double pitchMm, double room);

} // namespace hasp
