#include "SurfaceBodies.h"

#include "FragmentSurfaces.h"
#include "VerbWork.h"

namespace hasp
{
std::map<PlanId, BakedFitBody> BodiesOfSurfaces(const Plan& plan,
  const std::vector<PlanId>& fragments, const std::vector<std::string>& files,
  const FitBakeSettings& settings, Session& session)
{
  const PlanSurfaces surfaces = SurfacesOfFragments(plan, fragments, files, session);
  std::map<PlanId, BakedFitBody> bodies;
  for (const PlanId id : fragments)
  {
    const SurfaceSource* source = SurfaceOf(plan, id);
    if (!source)
      continue;
    const SurfaceFragment made = BakeFragment(plan, id, surfaces,
      { .rangeMm = settings.rangeMm,
        .shellPoints = ShellPointsOf(surfaces.at(source->surface), source->thicknessMm,
          settings.body.pointMm2, settings.body.mostPoints),
        .mostSamples = settings.mostSamples },
      { .map = true, .shell = true }, session);
    bodies[id] = Try(ExitCode::BadInput, "fragment " + std::to_string(id) + ": ",
      [&]
      {
        return BakedFitBody{ std::make_shared<const FitBody>(
                               made.model.map, made.model.shell, settings.body),
          made.model.map, made.model.shell, made.model.origin };
      });
  }
  return bodies;
}

} // namespace hasp
