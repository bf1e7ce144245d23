#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

#include <vector>

namespace hasp
{

/// Signed distances of a closed mesh to the samples of a grid whose samples lie at whole multiples
/// of its spacing, the same along all axes: mm, NEGATIVE INSIDE, clamped to +-rangeMm. Throws as
/// LevelSetOf; std::runtime_error without HASP_ENABLE_OPENVDB; Cancelled.
std::vector<float> SurfaceDistances(const TriangleMesh& closed, const GridGeometry& grid,
  double rangeMm, const ProgressFunction& progress);

} // namespace hasp
