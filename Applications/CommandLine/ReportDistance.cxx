#include "ReportDistance.h"

#include "DistanceTrials.h"
#include "ReportRegistry.h"
#include "VtkRivals.h"

namespace hasp
{

void ReportDistance(ReportContext& context)
{
  const std::vector<RivalTransform> rivals = { MaurerRival(), VtkEuclideanRival(), VtkPointsRival(),
    FogRival(), MeshRival(4), MeshRival(40) };
  context.progress(0.0, "distance: what anti-aliasing is worth");
  TryChamfer(context);
  context.progress(0.1, "distance: the guides' transform");
  TryGuides(context);
  context.progress(0.3, "distance: blurred and noisy images");
  TryScans(context);
  context.progress(0.4, "distance: others' transforms");
  TryRivals(context, rivals);
  context.progress(0.5, "distance: error against time");
  DrawCurves(context, rivals);
  context.progress(0.6, "distance: a shell around a bone");
  TryShell(context);
  context.progress(0.7, "distance: how sharp contours are");
  TrySharpness(context, FlyingEdges());
  context.progress(0.0, "distance: contours of random trees");
  TryContour(context, context.settings.quick ? 200 : 1000);
  context.progress(0.0, "distance: Booleans of meshes");
  TryBooleans(context, VtkBooleans(), context.settings.quick ? 20 : 200);
  AddUnusedDistances(context);
}

} // namespace hasp
