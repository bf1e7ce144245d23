#pragma once
#include "Report.h"

namespace hasp
{

/// The report for a terminal: a line a figure.
std::string ReportText(const Report& report);

/// How to read the figures, in sentences.
std::string LegendText();

/// "higher", "lower", or nothing: which way the row's value is better.
std::string BetterText(const ReportRow& row);

/// The terms that explain a row or curve of the report.
std::vector<ReportTerm> TermsUsed(const Report& report);

/// The row's bars: "bar: at least 8", "bar missed: at most 0.25, lead -0.1 at least 0 (missed)";
/// empty if it has none.
std::string BarText(const ReportRow& row);

/// A figure with four digits, and its unit: "0.1235 mm".
std::string FigureText(const std::optional<double>& value, const std::string& unit = "");

} // namespace hasp
