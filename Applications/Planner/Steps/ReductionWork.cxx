#include "Steps/ReductionWork.h"

#include "Grid/ProgressPart.h"
#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"
#include "SurfaceFragment.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace hasp
{
namespace
{

BakedFitBody BakeSurfaceBody(const SurfaceSource& source, const TriangleMesh& mesh,
  const FitBakeSettings& bake, const ProgressFunction& progress)
{
  SurfaceFragmentSettings settings;
  settings.thicknessMm = source.thicknessMm;
  settings.behind = source.side == SheetSide::Behind;
  settings.spacingMm = source.spacingMm;
  settings.rangeMm = bake.rangeMm;
  settings.shellPoints =
    ShellPointsOf(mesh, source.thicknessMm, bake.body.pointMm2, bake.body.mostPoints);
  settings.mostSamples = bake.mostSamples;
  const SurfaceFragment made =
    BakeSurface(mesh, settings, { .map = true, .shell = true }, progress);
  return { std::make_shared<const FitBody>(made.model.map, made.model.shell, bake.body),
    made.model.map, made.model.shell, made.model.origin };
}

} // namespace

std::vector<PlanId> ReducibleFragments(const Plan& plan)
{
  std::vector<PlanId> ids;
  for (const PlanFragment& fragment : plan.fragments)
    if (fragment.state == FragmentState::Kept && !IsDivided(plan, fragment.id))
      ids.push_back(fragment.id);
  return ids;
}

ReductionResult Reduce(const ReductionWork& work, const ProgressFunction& progress)
{
  const Plan& plan = work.snapshot.plan;
  PlanReductionSettings settings = work.settings;
  std::vector<PlanId> scanned;
  for (const PlanId id : ReducibleFragments(plan))
  {
    const auto* source =
      std::get_if<SurfaceSource>(&FindPlanObject<PlanFragment>(plan, id)->source);
    if (!source && work.snapshot.scans.contains(VolumeOfFragment(plan, id)))
      scanned.push_back(id);
    else if (!source)
      continue; // what needs it says so
    else if (const auto mesh = work.surfaces.find(id); mesh != work.surfaces.end())
      settings.surfaces[id] =
        BakeSurfaceBody(*source, *mesh->second, settings.bake, PartOf(progress, 0.0, 0.1));
  }
  const SnapshotImages images =
    ImagesOfFragments(work.snapshot, scanned, PartOf(progress, 0.1, 0.3));
  ReductionResult result{ plan,
    ReducePlan(plan, images.images, settings, PartOf(progress, 0.3, 1.0)), images.made };
  return result;
}

bool IsOf(const Plan& plan, const ReductionResult& result)
{
  return std::all_of(result.reduction.fragments.begin(), result.reduction.fragments.end(),
    [&](PlanId id)
    {
      const auto *now = FindPlanObject<PlanFragment>(plan, id),
                 *then = FindPlanObject<PlanFragment>(result.plan, id);
      return now && then && now->source == then->source && now->state == then->state &&
             now->locked == then->locked && now->scanToPlanned == then->scanToPlanned;
    });
}

} // namespace hasp
