#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridGeometry.h"

#include <vector>

namespace hasp
{

/// Anatomy as a solid: distances sampled on a grid, trilinear between them.
///
/// distance   dims.x*dims.y*dims.z values, x fastest, mm, NEGATIVE INSIDE, shared, not copied; such
///            as CoverageDistance gives
/// Face 0 is the isosurface, its gradient that of the trilinear polynomial, which jumps a little
/// from cell to cell. What reaches the outermost samples is cut off flat there: faces 1 to 26 are
/// those of the grid's box (MakeBox). Beyond it nothing is sampled. Where d > 0 is the value at the
/// nearest place of the grid and t the distance to it, the value is sqrt(d^2 + t^2), a bound of the
/// distance, since the solid lies in the box, which is convex; where d <= 0 it is t.
///
/// Limit: an offset that goes beyond the border has studs there, since the bound is below the
/// distance: sample a grid that reaches further than any offset.
///
/// Steepness is measured: 1 where distances are exact and smooth, up to the square root of 3 at
/// tips, a little more where they are noisy. Throws std::invalid_argument on an invalid geometry,
/// sizes that differ, an axis of one sample, a value that is not finite, one that changes by more
/// than 3 mm a mm, as grey values do, or if most cells on the surface change by less than 0.5 or
/// more than 2, as grey values of any scale and distances in other units do. Any thread; O(samples)
/// to make, O(1) to ask.
SolidPointer MakeGridSolid(
  std::shared_ptr<const std::vector<float>> distance, const GridGeometry& geometry);

} // namespace hasp
