#pragma once
#include "Report.h"

namespace hasp
{

/// The reports as one HTML page that needs nothing else: tables, and one SVG chart for each curve
/// id with time across and error upwards, a line per method and a point per setting. No script.
std::string ReportHtml(const std::vector<Report>& reports);

} // namespace hasp
