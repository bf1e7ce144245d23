#pragma once
#include "PlanReduction.h"
#include "Steps/LabelMaps.h"
#include "Steps/SurfaceShelf.h"

#include <map>
#include <vector>

namespace hasp
{

/// What is to be put together, as a WORKER takes it along.
struct ReductionWork
{
  PlanSnapshot snapshot;
  PlanReductionSettings settings;                  ///< but for its surfaces
  std::map<PlanId, SurfaceShelf::Mesh> surfaces{}; ///< of fragments, as far as in memory
};

struct ReductionResult
{
  Plan plan; ///< that it was made of
  PlanReduction reduction;
  std::vector<DerivedPart> labelMaps; ///< that had to be made on the way: for KeepMade
};

/// Reads and makes what is needed, and ReducePlan. WORKER. Throws as that, and as
/// ImagesOfFragments.
ReductionResult Reduce(const ReductionWork& work, const ProgressFunction& progress);

/// All fragments that can take part: kept, and not cut in pieces. RENDER or WORKER.
std::vector<PlanId> ReducibleFragments(const Plan& plan);

/// Whether what was made is still about this plan: its fragments are what and where they were.
bool IsOf(const Plan& plan, const ReductionResult& result);

} // namespace hasp
