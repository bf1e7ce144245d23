// A build without plans (HASP_ENABLE_JSON, HASP_ENABLE_OPENSSL): there is no file to hold poses.
#include "ReductionTrials.h"

namespace hasp
{

void TryPosesInPlans(ReportContext&) {}

} // namespace hasp
