#include "EvaluateSteps.h"
#include "EvaluateText.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "VerbWork.h"

#include <iostream>

namespace hasp
{
namespace
{

constexpr double LeastFaceMm2 = 4.0; // a corner that points at the other is no neighbour

struct PlacedSurface
{
  std::string called;
  PlanId id;
  RigidPose pose;
  std::shared_ptr<const MeasuredSurface> surface;
};

} // namespace

FracturesResult MeasureFractures(
  const EvaluatedSide& side, const SurfaceLookup& surfaceOf, double reachMm, Session& session)
{
  FracturesResult result;
  std::vector<PlacedSurface> placed;
  for (const std::string& key : KeysOf(side))
  {
    const EvaluatedFragment& fragment = side.fragments.at(key);
    const std::string called = CalledFragment(key, fragment, session);
    const std::optional<EvaluatedSurface> surface = surfaceOf(key);
    if (surface && surface->closed)
      placed.push_back({ called, fragment.id, fragment.scanToPlanned, surface->measured });
    else
      result.unmeasured.push_back(
        called + (surface ? ": its surface is open" : ": its surface is not at hand"));
  }
  StepAndGapSettings settings;
  settings.reachMm = reachMm;
  for (std::size_t a = 0; a < placed.size(); ++a)
    for (std::size_t b = a + 1; b < placed.size(); ++b)
    {
      session.progress.Step("measuring " + placed[a].called + " to " + placed[b].called);
      const StepAndGap found = MeasureStepAndGap(
        *placed[a].surface, placed[a].pose, *placed[b].surface, placed[b].pose, settings);
      if (found.gap.areaMm2 >= LeastFaceMm2)
        result.fractures.push_back(
          { placed[a].called, placed[b].called, placed[a].id, placed[b].id, found });
    }
  return result;
}

void EvaluateFractures(const EvaluateOptions& options, Session& session)
{
  if (!options.csv.empty())
    RequireWritable(options.csv, { ".csv" });
  const EvaluatedSide side = ReadSide(options.first, session);
  EvaluatedSurfaces surfaces(options.volumes, options.surfaces, session);
  const FracturesResult result = Try(ExitCode::BadInput, "",
    [&]
    {
      return MeasureFractures(
        side,
        [&](const std::string& key) -> std::optional<EvaluatedSurface>
        { return surfaces.At(key, { &side }); },
        options.reachMm, session);
    });
  session.progress.Wipe();
  session.result.update(JsonOf(result));
  if (!session.json)
    std::cout << TextOf(result);
  if (!options.csv.empty())
    WriteFile(options.csv, CsvOf(result));
}

} // namespace hasp
