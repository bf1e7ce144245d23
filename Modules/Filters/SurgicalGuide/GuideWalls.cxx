#include "GuideWalls.h"

#include "Distance/CoverageDistance.h"
#include "Distance/Csg.h"
#include "Distance/GridSolid.h"
#include "Distance/NearSurface.h"

#include <glm/common.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace hasp
{

SolidPointer ThickParts(const SolidPointer& solid, const GridGeometry& grid, double ballMm,
  double keptMm, const ProgressFunction& progress)
{
  const double cell = grid.spacing.x;
  const auto half = [&](double from)
  { return [&progress, from](double share) { return !progress || progress(from + 0.5 * share); }; };
  // Balls' centres, as coverage: of a cell that a plane through it at this depth leaves.
  std::vector<float> centres =
    DenseValues(EvaluateNearSurface(*solid, grid, ballMm + cell, half(0.0)));
  bool any = false;
  for (float& value : centres)
  {
    value = static_cast<float>(std::clamp(0.5 - (value + ballMm) / cell, 0.0, 1.0));
    any = any || value >= 0.5F;
  }
  if (!any)
    return nullptr;
  auto distance =
    std::make_shared<const std::vector<float>>(CoverageDistanceBand(grid, centres, half(0.5)));
  return MakeIntersection(
    { solid, MakeOffset(MakeGridSolid(std::move(distance), grid), ballMm + keptMm) });
}

} // namespace hasp
