#include "Steps/MoveEdits.h"

#include "Planning/PlanLists.h"
#include "Planning/PlanUnits.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>

namespace hasp
{
namespace
{

bool IsIn(std::span<const PlanId> ids, PlanId id)
{
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

} // namespace

std::vector<PlanId> UnitOf(const Plan& plan, PlanId fragment)
{
  std::vector<PlanId> all;
  for (const PlanFragment& one : plan.fragments)
    all.push_back(one.id);
  for (const PlanUnit& unit : UnitsOf(plan, all))
    if (IsIn(unit.fragments, fragment))
      return unit.fragments;
  return {};
}

PoseFragments MovedFragments(
  const Plan& plan, std::span<const PlanId> fragments, const PlanPose& motion)
{
  PoseFragments moved;
  for (const PlanId id : fragments)
  {
    const PoseFragments one = MovedFragment(plan, id, motion);
    moved.poses.insert(moved.poses.end(), one.poses.begin(), one.poses.end());
  }
  return moved;
}

PlanPose TurnAbout(const glm::dvec3& middle, const glm::dvec3& axis, double degrees)
{
  const glm::dquat turn = glm::angleAxis(glm::radians(degrees), axis);
  return { middle - turn * middle, turn };
}

std::optional<PoseFragments> BackToScan(const Plan& plan, std::span<const PlanId> fragments)
{
  PoseFragments back;
  for (const PlanId id : fragments)
    if (const auto* fragment = FindPlanObject<PlanFragment>(plan, id);
        fragment && !(fragment->scanToPlanned == PlanPose{}))
      back.poses.push_back({ id, {} });
  return back.poses.empty() ? std::nullopt : std::optional(std::move(back));
}

std::vector<PlanEdit> LockEdits(const Plan& plan, std::span<const PlanId> fragments)
{
  std::vector<PlanFragment> all;
  for (const PlanId id : fragments)
    if (const auto* fragment = FindPlanObject<PlanFragment>(plan, id))
      all.push_back(*fragment);
  const bool stay = std::all_of(
    all.begin(), all.end(), [](const PlanFragment& fragment) { return fragment.locked; });
  std::vector<PlanEdit> edits;
  for (PlanFragment& fragment : all)
    if (fragment.locked == stay)
    {
      fragment.locked = !stay;
      edits.push_back(ChangeObject<PlanFragment>{ std::move(fragment) });
    }
  return edits;
}

std::vector<PlanEdit> UngroupEdits(const Plan& plan, std::span<const PlanId> fragments)
{
  std::vector<PlanEdit> edits;
  for (const PlanGroup& group : plan.groups)
    if (std::any_of(group.fragments.begin(), group.fragments.end(),
          [&](PlanId id) { return IsIn(fragments, id); }))
      edits.push_back(RemoveObject{ group.id });
  return edits;
}

} // namespace hasp
