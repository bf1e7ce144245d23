#include "Planning/Plan.h"

#include "Planning/PlanObjects.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace hasp
{

namespace
{
template <typename T>
void CheckIds(const Plan& plan, const PlanList<T>& list, std::set<PlanId>& given)
{
  const ValueChecks check("plan");
  const std::vector<T>& objects = plan.*list.objects;
  if (objects.size() > MaxPlanObjects)
    check.Refuse(list.key, "has more than " + std::to_string(MaxPlanObjects) + " entries");
  for (std::size_t n = 0; n < objects.size(); ++n)
  {
    const PlanId id = objects[n].id, before = n == 0 ? 0 : objects[n - 1].id;
    if (id <= before)
      check.Refuse(ListKey(list.key, n, "id"), id, "above that of the entry before");
    if (id >= plan.nextId)
      check.Refuse(ListKey(list.key, n, "id"), id, "below nextId");
    if (!given.insert(id).second)
      check.Refuse(ListKey(list.key, n, "id"), id, "given once in the plan");
  }
}
} // namespace

void ValidatePlan(const Plan& plan)
{
  CheckCaseLabel(plan.caseLabel);
  ValueChecks("plan").Closed("nextId", plan.nextId, 1, double(MaxPlanId) + 1);
  std::set<PlanId> given;
  ForEachPlanList([&](const auto& list) { CheckIds(plan, list, given); });
  ForEachPlanList(
    [&](const auto& list)
    {
      const auto& objects = plan.*list.objects;
      for (std::size_t n = 0; n < objects.size(); ++n)
        CheckInPlan(plan, objects[n], "plan: " + ListKey(list.key, n));
    });
}

const char* PlanNoun(const Plan& plan, PlanId id)
{
  const char* noun = nullptr;
  ForEachPlanList(
    [&]<typename T>(const PlanList<T>& list)
    {
      if (FindPlanObject<T>(plan, id))
        noun = list.noun;
    });
  return noun;
}

bool IsDivided(const Plan& plan, PlanId fragment)
{
  return std::any_of(plan.fragments.begin(), plan.fragments.end(),
    [&](const PlanFragment& other)
    {
      const auto* piece = std::get_if<PieceSource>(&other.source);
      return piece && piece->fragment == fragment;
    });
}

std::vector<PlanId> CutsThrough(const Plan& plan, PlanId fragment)
{
  std::vector<PlanId> cuts;
  for (const PlanCut& cut : plan.cuts)
    if (std::find(cut.fragments.begin(), cut.fragments.end(), fragment) != cut.fragments.end())
      cuts.push_back(cut.id);
  return cuts;
}

std::vector<Osteotomy> BladesOf(const Plan& plan, const PlanGuide& guide)
{
  std::vector<Osteotomy> blades;
  for (const PlanId id : guide.cuts)
    if (const PlanCut* cut = FindPlanObject<PlanCut>(plan, id))
      blades.push_back(cut->blade);
  return blades;
}

glm::dvec3 PlannedPlace(const Plan& plan, const MeasurePoint& point)
{
  const PlanFragment* fragment = FindPlanObject<PlanFragment>(plan, point.fragment);
  if (!fragment)
    return point.point;
  const PlanPose& pose = fragment->scanToPlanned;
  return pose.position + pose.orientation * point.point;
}

double MeasureValue(const Plan& plan, const PlanMeasure& measure)
{
  std::vector<glm::dvec3> places;
  for (const MeasurePoint& point : measure.points)
    places.push_back(PlannedPlace(plan, point));
  if (measure.kind == MeasureKind::Distance)
    return glm::distance(places.at(0), places.at(1));
  const glm::dvec3 a = places.at(0) - places.at(1), b = places.at(2) - places.at(1);
  // Exact near 0 and 180 degrees, where an arc cosine is not.
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / M_PI;
}

} // namespace hasp
