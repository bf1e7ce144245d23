#pragma once
#include "Planning/Plan.h"

#include <vector>

namespace hasp
{

/// What a plan has in the world of one scan. Scans lie one over the other, a donor's over the
/// jaw's, so that no picture may show two.
struct ReportWorld
{
  PlanId volume;        ///< 0: of a plan without scans
  bool isDonor = false; ///< segments are taken there, and none are put there
  Plan plan;            ///< with the objects of that world alone, all scans
};

/// One for each scan of the plan, in its order. What is of no scan is in the world of the first
/// that is no donor's. Internal to CaseReport. Any thread.
std::vector<ReportWorld> WorldsOf(const Plan& plan);

} // namespace hasp
