#pragma once
#include "Planning/Plan.h"
#include "Reduction/BakeFitBody.h"

#include <map>
#include <string>
#include <vector>

namespace hasp
{

struct Session;

/// The fragments that are surfaces as bodies to be fitted (PlanReductionSettings::surfaces): of
/// surfaces found among the files, on grids as fine as the plan says. Of `settings` the range, the
/// most samples and what a body has count.
/// Throws Failure as SurfacesOfFragments and BakeFragment.
std::map<PlanId, BakedFitBody> BodiesOfSurfaces(const Plan& plan,
  const std::vector<PlanId>& fragments, const std::vector<std::string>& files,
  const FitBakeSettings& settings, Session& session);

} // namespace hasp
