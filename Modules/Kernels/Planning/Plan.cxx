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

/// `side`: where the jaw is, seen along the joint's normal.
void PutIntoFace(const Plan& plan, const JawFace& face, double side, TransplantJoint& joint)
{
  if (const PlanCut* cut = FindPlanObject<PlanCut>(plan, face.cut))
  {
    const glm::dvec3 normal = glm::normalize(cut->blade.normal);
    joint.normal = glm::dot(normal, joint.normal) < 0.0 ? -normal : normal;
    const glm::dvec3 on = cut->blade.point + side * 0.5 * cut->blade.kerfMm * joint.normal;
    joint.point += glm::dot(on - joint.point, joint.normal) * joint.normal;
  }
  if (const PlanFragment* fragment = FindPlanObject<PlanFragment>(plan, face.fragment))
  {
    joint.point = fragment->scanToPlanned.Place(joint.point);
    joint.normal = fragment->scanToPlanned.orientation * joint.normal;
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

std::string CalledObject(const Plan& plan, PlanId id)
{
  const char* noun = PlanNoun(plan, id);
  return std::string(noun ? noun : "object") + " " + std::to_string(id);
}

bool IsOfScan(const Plan& plan, PlanId fragment)
{
  const PlanFragment* found = FindPlanObject<PlanFragment>(plan, fragment);
  return found && !std::holds_alternative<SurfaceSource>(found->source);
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

PlateRecipe PlateRecipeOf(const Plan& plan, const PlanPlate& plate)
{
  PlateRecipe recipe = plate.recipe;
  for (std::size_t n = 0; n < plate.fragments.size(); ++n)
  {
    const PlanFragment* fragment = FindPlanObject<PlanFragment>(plan, plate.fragments[n]);
    if (fragment && fragment->state == FragmentState::Kept)
      recipe.fragments.push_back(
        { int(n) + 1, fragment->scanToPlanned.position, fragment->scanToPlanned.orientation });
  }
  return recipe;
}

Transplant TransplantOf(const Plan& plan, const PlanTransplant& transplant)
{
  Transplant placed = transplant.transplant;
  // The jaw lies behind the first joint and ahead of the last one.
  PutIntoFace(plan, transplant.first, -1.0, placed.joints.front());
  PutIntoFace(plan, transplant.last, 1.0, placed.joints.back());
  return placed;
}

glm::dvec3 PlannedPlace(const Plan& plan, const MeasurePoint& point)
{
  const PlanFragment* fragment = FindPlanObject<PlanFragment>(plan, point.fragment);
  return fragment ? fragment->scanToPlanned.Place(point.point) : point.point;
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
