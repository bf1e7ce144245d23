#pragma once
#include "Report.h"

namespace hasp
{

/// What the ids of a report's rows and curves stand for, by its name on the command line; none if
/// there is no such report. Whoever adds an id explains it there: ReportFaults asks for it.
std::vector<ReportTerm> TermsOf(const std::string& report);

} // namespace hasp
