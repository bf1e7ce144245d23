#include "Steps/TouchedFragment.h"

#include "Model/ObjectNames.h"
#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"

#include <algorithm>

namespace hasp
{

PlanFragment FragmentFromTouch(Planner& planner, const TouchedPlace& place)
{
  const Plan& plan = planner.plan.Now();
  ComponentSource source;
  source.volume = planner.scene.ShownVolume();
  source.isovalue = planner.scene.Isovalue();
  source.seed = place.inScan;
  if (const ShelfScan* scan = planner.scans.OfVolume(plan, source.volume))
    source.spacingMm = FragmentSpacing(scan->passport.geometry.spacing);
  PlanFragment fragment;
  fragment.id = planner.plan.NewId();
  fragment.name = ObjectNames::Of<PlanFragment>(fragment.id);
  fragment.source = source;
  return fragment;
}

std::vector<PlanId> FragmentsOf(const Plan& plan, const std::vector<TouchedPlace>& places)
{
  std::vector<PlanId> fragments;
  for (const TouchedPlace& place : places)
    if (IsOfScan(plan, place.object) &&
        std::find(fragments.begin(), fragments.end(), place.object) == fragments.end())
      fragments.push_back(place.object);
  return fragments;
}

std::vector<PlanId> FragmentsOfScans(const Plan& plan)
{
  std::vector<PlanId> fragments;
  for (const PlanFragment& fragment : plan.fragments)
    if (IsOfScan(plan, fragment.id))
      fragments.push_back(fragment.id);
  return fragments;
}

} // namespace hasp
