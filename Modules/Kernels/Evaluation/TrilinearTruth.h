#pragma once
#include "Grid/GridView.h"

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace hasp
{

/// Where a ray meets the trilinear isosurface of a volume.
struct TrilinearHit
{
  double t = 0.0;             ///< hit = origin + t * direction
  glm::dvec3 position{ 0.0 }; ///< world, mm
  glm::dvec3 gradient{ 0.0 }; ///< per mm, world directions
  glm::ivec3 cell{ 0 };
};

/// What every tracer and picture of an isosurface is judged by: the first t >= 0 where value -
/// isovalue changes its sign along the ray; inside is >= 0. Long double from the ray to the root,
/// cell by cell, nothing skipped; it shares neither solver nor traversal with what it judges.
///
/// isovalue   as it stands; extraction rounds its own to float first, so give it a float's value
/// direction  need not be unit; 0, or a component that is not finite: nothing
/// Cells with a corner that is not finite are empty. Whether a hit is a tangent, which no float can
/// decide, shows by asking again for an isovalue a little to each side. Any thread; about 20 ns a
/// cell passed, 1 us a root.
std::optional<TrilinearHit> FirstTrilinearHit(
  const AnyGridView& grid, double isovalue, const glm::dvec3& origin, const glm::dvec3& direction);

/// All of them, ascending in t: what translucent surfaces show. Where the ray goes through cells
/// that are empty no change is counted.
std::vector<TrilinearHit> AllTrilinearHits(
  const AnyGridView& grid, double isovalue, const glm::dvec3& origin, const glm::dvec3& direction);

} // namespace hasp
