#pragma once
#include "Planning/Plan.h"
#include "Tools/Touch.h"

#include <vector>

namespace hasp
{

struct Planner;

/// RENDER. All bone of the scan that is shown which is connected with a touched place, as a
/// new fragment of the plan. Its isovalue is the one that is shown.
PlanFragment FragmentFromTouch(Planner& planner, const TouchedPlace& place);

/// The fragments that places were touched on, each once, in that order.
std::vector<PlanId> FragmentsOf(const Plan& plan, const std::vector<TouchedPlace>& places);

/// Those of scans, in the plan's order: what can be cut, guided and plated.
std::vector<PlanId> FragmentsOfScans(const Plan& plan);

} // namespace hasp
