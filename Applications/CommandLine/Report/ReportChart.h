#pragma once
#include "Report.h"

namespace hasp
{

/// Text made safe for HTML and SVG.
std::string EscapeHtml(const std::string& text);

/// An SVG element of the given curves, which share one id and its units. An axis is logarithmic if
/// all its figures are > 0 and span more than a factor of 5. Curves without points are left out.
std::string ErrorTimeChart(const std::vector<ReportCurve>& curves);

} // namespace hasp
