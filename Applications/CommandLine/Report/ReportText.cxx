#include "ReportText.h"

#include <algorithm>
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
  if (const std::string better = BetterText(row); !better.empty())
    text.append("(").append(better).append(" is better) ");
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
  const std::string bar = BarText(row);
  return text + (row.data.empty() ? "" : "  on " + row.data) + (bar.empty() ? "" : "  " + bar) +
         "\n";
}

std::string EndsText(const ReportBar& bar)
{
  if (bar.least && bar.most)
    return *bar.least == *bar.most ? "exactly " + FigureText(bar.least)
                                   : FigureText(bar.least) + " to " + FigureText(bar.most);
  return bar.least ? "at least " + FigureText(bar.least) : "at most " + FigureText(bar.most);
}

/// "bars missed: 1 of 8: raycaching.speedup.primary@cache"; empty if there are none.
std::string MissedText(const Report& report)
{
  std::size_t barred = 0, missed = 0;
  std::string ids;
  for (const ReportRow& row : report.rows)
  {
    barred += !row.bars.empty();
    if (!Missed(row))
      continue;
    ++missed;
    ids += (ids.empty() ? ": " : ", ") + row.id;
  }
  return barred == 0 ? ""
                     : "rows that missed their bar: " + std::to_string(missed) + " of " +
                         std::to_string(barred) + ids + "\n";
}

} // namespace

std::string LegendText()
{
  return "An id is report.figure.variant@data; what each stands for is told below the figures. "
         "Each row says which way its value is better; one that does not is a count, or is to be "
         "just so. ratio: ours / the rival's. times as fast: the rival's time / ours. In brackets "
         "or as quartiles: the middle half of n pairs of runs. error, time, CPU time: of ours "
         "where there is a rival, else of the method measured. bar: what the value is asked to "
         "reach, "
         "aim: what would be good; a row without a bar is told beside those that have one.";
}

std::string BetterText(const ReportRow& row)
{
  const Better better = row.value ? BetterOf(row) : Better::NotSaid;
  return better == Better::NotSaid ? "" : better == Better::Lower ? "lower" : "higher";
}

std::vector<ReportTerm> TermsUsed(const Report& report)
{
  std::vector<ReportTerm> used;
  for (const ReportTerm& term : report.terms)
    if (std::any_of(report.rows.begin(), report.rows.end(),
          [&](const ReportRow& row) { return Explains(term, row.id); }) ||
        std::any_of(report.curves.begin(), report.curves.end(),
          [&](const ReportCurve& curve) { return Explains(term, curve.id); }))
      used.push_back(term);
  return used;
}

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

std::string BarText(const ReportRow& row)
{
  if (row.bars.empty())
    return "";
  std::string text = Missed(row) ? "bar missed: " : "bar: ";
  for (const ReportBar& bar : row.bars)
  {
    text += &bar == &row.bars.front() ? "" : ", ";
    if (!bar.of.empty())
      text += bar.of + " " + FigureText(bar.figure) + " ";
    text += EndsText(bar);
    if (row.bars.size() > 1 && Missed(row, bar))
      text += " (missed)";
  }
  return text;
}

std::string ReportText(const Report& report)
{
  std::string text = "report " + report.name + (report.quick ? " (quick)" : "") + ", seed " +
                     std::to_string(report.seed) + "\n" + LegendText() + "\n";
  for (const ReportRow& row : report.rows)
    text += RowText(row);
  text += MissedText(report);
  for (const ReportTerm& term : TermsUsed(report))
    text += Padded("id " + term.id, 34) + term.meaning + "\n";
  for (const ReportCase& row : report.stability)
    text += Padded(row.id, 34) + (row.pass ? "as predicted  " : "NOT AS PREDICTED  ") +
            FigureText(row.figure, row.unit) + " (limit " + FigureText(row.limit) + ")  " +
            row.testCase + "\n";
  if (!report.stability.empty())
    text += Padded("cases as predicted", 34) +
            std::to_string(std::count_if(report.stability.begin(), report.stability.end(),
              [](const ReportCase& row) { return row.pass; })) +
            " of " + std::to_string(report.stability.size()) + "\n";
  for (const ResourceUse& use : report.unused)
    text += Padded("unused: " + use.resource, 34) + std::to_string(use.bytes) + " bytes, " +
            FigureText(use.milliseconds, "ms") + "\n";
  return text;
}

} // namespace hasp
