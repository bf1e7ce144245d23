#include "ReportText.h"

#include <cstdio>

namespace hasp
{
namespace
{

std::string Padded(const std::string& text, std::size_t width)
{
  return text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

std::string RowText(const ReportRow& row)
{
  const std::string start = Padded(row.id, 34);
  if (!row.absent.empty())
    return start + "absent: " + row.absent + " (" + row.rival + ")\n";
  std::string text = start + Padded(FigureText(row.value, row.unit), 18);
  if (row.q1 && row.q3)
    text.append("[")
      .append(FigureText(row.q1))
      .append(", ")
      .append(FigureText(row.q3))
      .append("] n ")
      .append(std::to_string(row.n))
      .append("  ");
  if (row.error)
    text += "error " + FigureText(row.error, row.errorUnit) + "  ";
  if (row.timeS)
    text += "time " + FigureText(row.timeS, "s") + "  ";
  if (row.cpuS)
    text += "CPU " + FigureText(row.cpuS, "s") + "  ";
  if (!row.rival.empty())
    text += "against " + row.rival;
  return text + (row.data.empty() ? "" : "  on " + row.data) + "\n";
}

} // namespace

std::string FigureText(const std::optional<double>& value, const std::string& unit)
{
  if (!value)
    return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", *value);
  std::string result = text;
  if (!unit.empty())
    result.append(" ").append(unit);
  return result;
}

std::string ReportText(const Report& report)
{
  std::string text =
    "report " + report.name + (report.quick ? " (quick)" : "") + ", seed " +
    std::to_string(report.seed) + "\n" +
    "ratio: ours / rival, below 1 is better for us (ids with speedup, simd, speed or rays: "
    "above 1). error, time, CPU: of ours in a ratio, else of the method measured.\n";
  for (const ReportRow& row : report.rows)
    text += RowText(row);
  for (const StabilityRow& row : report.stability)
    text += Padded(row.id, 34) + (row.pass ? "holds  " : "FAILS  ") +
            FigureText(row.figure, row.unit) + " (limit " + FigureText(row.limit) + ")  " +
            row.testCase + "\n";
  for (const ResourceUse& use : report.unused)
    text += Padded("unused: " + use.resource, 34) + std::to_string(use.bytes) + " bytes, " +
            FigureText(use.milliseconds, "ms") + "\n";
  return text;
}

} // namespace hasp
