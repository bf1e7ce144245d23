#pragma once
#include "Report.h"

namespace hasp
{

/// The report as JSON text, two spaces deep. What a row does not have is left out. Keys beyond the
/// common ones: rows have "method" and "cpu_s" where known, "absent" with the reason, "bars"
/// and "bar_missed" where they have bars, and "quick": true where the report is quick. A figure
/// that is not finite and so misses its bar, or blew up in a case that does not pass, is null.
/// Throws std::invalid_argument for any other figure that is not finite: JSON has none (see
/// ReportFaults).
std::string ReportJson(const Report& report);

/// One report as it is, several as an array.
std::string ReportJson(const std::vector<Report>& reports);

} // namespace hasp
