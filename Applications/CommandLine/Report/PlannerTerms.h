#pragma once
#include "Report.h"

#include <vector>

namespace hasp
{

/// Of `hasp report planner`: see TermsOf.
std::vector<ReportTerm> PlannerTerms();

} // namespace hasp
