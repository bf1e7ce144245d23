#include "ReportReduction.h"

#include "ReductionTrials.h"
#include "Report/ReportRegistry.h"

namespace hasp
{

void ReportReduction(ReportContext& context)
{
  // Others than those that the fit's settings were chosen by, whose seeds are below 100.
  const std::uint64_t first = 100 + 100 * context.settings.seed;
  const std::vector<ReductionCase> cases =
    MakeTrialCases(context, context.settings.quick ? 2 : 8, first);
  TryFits(context, cases);
  TryAssembly(context, cases);
  TryCapture(context, cases);
  TryPot(context);
  TryFidelity(context);
  AddUnusedReduction(context);
}

} // namespace hasp
