#pragma once
#include "Planning/PlanEdits.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

/// Moves of what moves as one, as edits. Values; any thread.
namespace hasp
{

/// The fragments that move with this one: itself, and those of its groups.
std::vector<PlanId> UnitOf(const Plan& plan, PlanId fragment);

/// A motion of the world behind the poses that they have.
PoseFragments MovedFragments(
  const Plan& plan, std::span<const PlanId> fragments, const PlanPose& motion);

/// By so many degrees about an axis (unit) through `middle`, world.
PlanPose TurnAbout(const glm::dvec3& middle, const glm::dvec3& axis, double degrees);

/// To where they were scanned; nullopt: they are there.
std::optional<PoseFragments> BackToScan(const Plan& plan, std::span<const PlanId> fragments);

/// All of them stay from now on, or, where all stay already, none.
std::vector<PlanEdit> LockEdits(const Plan& plan, std::span<const PlanId> fragments);

/// Takes the groups that these are in apart.
std::vector<PlanEdit> UngroupEdits(const Plan& plan, std::span<const PlanId> fragments);

} // namespace hasp
