#pragma once
#include "Report.h"

namespace hasp
{

/// The report for a terminal: a line a figure.
std::string ReportText(const Report& report);

/// A figure with four digits, and its unit: "0.1235 mm".
std::string FigureText(const std::optional<double>& value, const std::string& unit = "");

} // namespace hasp
