#include "GuideTrials.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"

namespace hasp
{

void TryPlans(ReportContext& context, std::size_t)
{
  context.report.rows.push_back(AbsentRow("guides.plan", "the plan as it was saved",
    "this build saves no plans (HASP_ENABLE_JSON, HASP_ENABLE_OPENSSL)"));
}

} // namespace hasp
