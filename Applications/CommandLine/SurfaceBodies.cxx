#include "SurfaceBodies.h"

#include "FragmentSurfaces.h"
#include "VerbWork.h"

#include "Evaluation/MeshCheck.h"

#include <algorithm>

namespace hasp
{
namespace
{

/// Of a pointshell, as BakeFitBody has them: by the area. A sheet has two faces.
int PointsOf(const TriangleMesh& mesh, bool sheet, const FitBodySettings& body)
{
  const double faces = sheet ? 2.0 : 1.0;
  return int(std::clamp(faces * CheckMesh(WeldPoints(mesh)).areaMm2 / body.pointMm2, 1024.0,
    double(std::max(1024, body.mostPoints))));
}

} // namespace

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
        .shellPoints =
          PointsOf(surfaces.at(source->surface), source->thicknessMm > 0.0, settings.body),
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
