#pragma once
#include "Distance/BoundedSolid.h"

#include <cstddef>

namespace hasp
{

/// About how many triangles a sharp contour will have, from the blocks of cells that may hold
/// surface: eighths of the grid first, and smaller boxes of those that may hold some, until there
/// are enough of them to tell. Within a factor of two where the surface is thicker than the boxes
/// it was told by; 0 where no box may hold any.
///
/// One thread; about 100,000 places are asked at most, whatever the grid.
double EstimateTriangles(const BoundedSolid& solid, const GridGeometry& grid);

} // namespace hasp
