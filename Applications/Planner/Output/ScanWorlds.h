#pragma once
#include "Planning/Plan.h"

#include <vector>

namespace hasp
{

/// What a plan has in the world of one scan. Scans lie one over the other, a donor's over the
/// jaw's, so that no view or picture may show two.
struct ScanWorld
{
  PlanId volume;        ///< 0: of a plan without scans
  bool isDonor = false; ///< segments are taken there, and none are put there
  Plan plan;            ///< with the objects of that world alone, all scans
};

/// One for each scan of the plan, in its order. What is of no scan is in the world of the first
/// that is no donor's. Any thread.
std::vector<ScanWorld> WorldsOf(const Plan& plan);

/// What can be seen of one of them: fragments that are not in pieces, cuts, and all that is made.
std::vector<PlanId> SeenIn(const ScanWorld& world);

} // namespace hasp
