#pragma once
#include "Report.h"

#include <vector>

namespace hasp
{

/// Of `hasp report segmentation`: see TermsOf.
std::vector<ReportTerm> SegmentationTerms();

} // namespace hasp
