#pragma once
#include "Planning/Plan.h"

#include <span>
#include <vector>

namespace hasp
{

/// Fragments that move as one: a fragment alone, or those of a group.
struct PlanUnit
{
  PlanId group = 0; ///< 0: a fragment alone
  std::vector<PlanId> fragments;
  bool stays = false; ///< one of them is locked, so that none may move

  bool operator==(const PlanUnit&) const noexcept = default;
};

/// How these fragments move, in the order of each unit's first. Groups that share a fragment move
/// as one, under the first one's id. Ids that are no fragment's are left out.
std::vector<PlanUnit> UnitsOf(const Plan& plan, std::span<const PlanId> fragments);

} // namespace hasp
