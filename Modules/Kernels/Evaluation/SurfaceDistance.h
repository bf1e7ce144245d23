#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <optional>
#include <span>
#include <vector>

namespace hasp
{

/// Where the isosurface is nearest to a point.
struct NearestSurface
{
  double distance;    ///< mm, negative where the volume at the point is >= the isovalue
  glm::dvec3 closest; ///< on the isosurface, world mm
  glm::dvec3 outward; ///< unit, against the gradient at `closest`
};

/// Distance from points to the trilinear isosurface of a volume: what a guide's gap is measured
/// with. Shares nothing with Kernels/Distance.
///
/// volume    any geometry; inside is value >= isovalue. Its border does not close the surface.
/// points    world mm, anywhere; not finite ones give nothing
/// reachMm   > 0; nothing is returned for points farther from the surface
/// Method: along 25 lines an axis each active cell gives exact points of its surface (trilinear is
/// linear along an axis); from those of every cell that can hold the nearest point, projected steps
/// go down to the foot point within the cell. The result is never less than the true distance, and
/// more by at most 0.01 voxel (tested on planes, spheres and the cell's own saddles).
/// Throws std::invalid_argument on bad geometry, isovalue or reach; Cancelled. Any thread; all
/// cores. Memory and time grow with the active cells within reach of the points' bounding box.
std::vector<std::optional<NearestSurface>> DistanceToIsosurface(const AnyGridView& volume,
  double isovalue, std::span<const glm::dvec3> points, double reachMm,
  const ProgressFunction& progress = {});

} // namespace hasp
