#include "SurfaceDistances.h"

#include "Distance/LevelSet.h"

#include <cmath>

namespace hasp
{

std::vector<float> SurfaceDistances(const TriangleMesh& closed, const GridGeometry& grid,
  double rangeMm, const ProgressFunction& progress)
{
  const double spacing = grid.spacing.x;
  const auto levelSet = LevelSetOf(closed, spacing, std::ceil(rangeMm / spacing) + 1.0, progress);
  return SampleLevelSet(*levelSet, grid);
}

} // namespace hasp
