#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SegmentationTrials.h"

namespace hasp
{

void TryDirect(ReportContext& context)
{
  context.report.rows.push_back(AbsentRow("segmentation.direct", "Eigen's SimplicialLDLT",
    "this build has no Eigen (HASP_ENABLE_EIGEN; Utilities/Scripts/setup --develop)"));
}

} // namespace hasp
