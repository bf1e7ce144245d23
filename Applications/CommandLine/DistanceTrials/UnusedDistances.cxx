#include "Distance/Csg.h"
#include "Distance/NearSurface.h"
#include "Distance/SolidShapes.h"
#include "Distance/SurfaceElements.h"
#include "DistanceTrials.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

namespace hasp
{

void AddUnusedDistances(ReportContext& context)
{
  const GridGeometry grid = TrialGrid(64);
  const std::vector<float> nothing(grid.Size(), 0.0F);
  const SurfaceElements none = ExtractSurfaceElements(grid, nothing);
  context.report.unused.push_back({ "surface elements",
    none.elements.size() * sizeof(SurfaceElements::Element) +
      none.places.size() * sizeof(SurfaceElements::Place),
    0.0, "the image holds no surface" });
  const SolidPointer ball = MakeCapsule(glm::dvec3(0.0), glm::dvec3(0.0), 2.0);
  const NearSurface gone = EvaluateNearSurface(*MakeOffset(ball, -4.0), grid, 1.2);
  context.report.unused.push_back({ "samples of a solid", gone.values.size() * sizeof(float), 0.0,
    "the offset is beyond the part" });
  const NearSurface far =
    EvaluateNearSurface(*MakeCapsule(glm::dvec3(500.0), glm::dvec3(500.0), 2.0), grid, 1.2);
  context.report.unused.push_back({ "samples of a solid elsewhere",
    far.values.size() * sizeof(float), 0.0, "no surface is near" });
}

} // namespace hasp
