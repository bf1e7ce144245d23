#pragma once
#include "Report.h"

#include <vector>

namespace hasp
{

/// Of `hasp report light`: see TermsOf.
std::vector<ReportTerm> LightTerms();

} // namespace hasp
