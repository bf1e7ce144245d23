#pragma once
#include "Report.h"

#include <vector>

namespace hasp
{

/// Of `hasp report reduction`: see TermsOf.
std::vector<ReportTerm> ReductionTerms();

} // namespace hasp
