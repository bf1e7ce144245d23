#include "ReportHtml.h"

#include "ReportChart.h"
#include "ReportText.h"

#include <initializer_list>
#include <map>

namespace hasp
{
namespace
{

constexpr const char* Style = R"(<style>
body { font: 15px/1.5 system-ui, sans-serif; max-width: 72em; margin: 2em auto; padding: 0 1em; color: #222 }
table { border-collapse: collapse; width: 100%; margin: 1em 0 } th, td { padding: .3em .6em; text-align: left; border-bottom: 1px solid #ddd }
td.figure { text-align: right; font-variant-numeric: tabular-nums } .bad { color: #a40000; font-weight: bold } .faint { color: #666 }
svg { max-width: 44em; font: 12px system-ui, sans-serif } svg .grid { stroke: #ddd }
</style>
)";

std::string Cell(const std::string& text, const char* kind = "")
{
  return std::string("<td") + (*kind ? std::string(" class=\"") + kind + "\"" : "") + ">" +
         EscapeHtml(text) + "</td>";
}

std::string Head(std::initializer_list<const char*> titles)
{
  std::string html = "<table><tr>";
  for (const char* title : titles)
    html += std::string("<th>") + title + "</th>";
  return html + "</tr>\n";
}

std::string RowsTable(const Report& report)
{
  if (report.rows.empty())
    return "";
  std::string html = "<h2>Figures</h2>\n<p>" + EscapeHtml(LegendText()) + "</p>\n" +
                     Head({ "id", "value", "better", "quartiles", "n", "error", "time", "CPU time",
                       "rival", "data", "bar" });
  for (const ReportRow& row : report.rows)
  {
    const std::string quartiles =
      row.q1 && row.q3 ? FigureText(*row.q1) + " – " + FigureText(*row.q3) : "";
    html += "<tr>" + Cell(row.id + (report.quick ? " (quick)" : ""));
    html += row.absent.empty() ? Cell(FigureText(row.value, row.unit), "figure")
                               : Cell("absent: " + row.absent, "faint");
    html += Cell(BetterText(row));
    html += Cell(quartiles, "figure") + Cell(row.n > 0 ? std::to_string(row.n) : "", "figure") +
            Cell(FigureText(row.error, row.errorUnit), "figure") +
            Cell(FigureText(row.timeS, "s"), "figure") + Cell(FigureText(row.cpuS, "s"), "figure") +
            Cell(row.rival) + Cell(row.data) + Cell(BarText(row), Missed(row) ? "bad" : "") +
            "</tr>\n";
  }
  return html + "</table>\n";
}

std::string TermsTable(const Report& report)
{
  const std::vector<ReportTerm> terms = TermsUsed(report);
  if (terms.empty())
    return "";
  std::string html =
    "<h2>What the ids stand for</h2>\n" + Head({ "ids that begin with", "stand for" });
  for (const ReportTerm& term : terms)
    html += "<tr>" + Cell(term.id) + Cell(term.meaning) + "</tr>\n";
  return html + "</table>\n";
}

std::string Charts(const Report& report)
{
  std::map<std::string, std::vector<ReportCurve>> byId;
  for (const ReportCurve& curve : report.curves)
    byId[curve.id].push_back(curve);
  std::string html;
  for (const auto& [id, curves] : byId)
    html += "<h3>" + EscapeHtml(id) + "</h3>\n" + ErrorTimeChart(curves);
  return html.empty() ? "" : "<h2>Error against time</h2>\n" + html;
}

std::string StabilityTable(const Report& report)
{
  if (report.stability.empty())
    return "";
  std::string html =
    "<h2>Stiff and extreme cases</h2>\n" + Head({ "id", "case", "outcome", "figure", "limit" });
  for (const ReportCase& row : report.stability)
    html += "<tr>" + Cell(row.id) + Cell(row.testCase) +
            (row.pass ? Cell("as predicted") : Cell("NOT AS PREDICTED", "bad")) +
            Cell(FigureText(row.figure) + " " + row.unit, "figure") +
            Cell(FigureText(row.limit) + " " + row.unit, "figure") + "</tr>\n";
  return html + "</table>\n";
}

std::string UnusedTable(const Report& report)
{
  if (report.unused.empty())
    return "";
  std::string html =
    "<h2>Not built, not paid for</h2>\n" + Head({ "resource", "bytes", "ms", "why" });
  for (const ResourceUse& use : report.unused)
    html += "<tr>" + Cell(use.resource) + Cell(std::to_string(use.bytes), "figure") +
            Cell(FigureText(use.milliseconds), "figure") + Cell(use.reason) + "</tr>\n";
  return html + "</table>\n";
}

std::string Section(const Report& report)
{
  const std::string made = "Hasp " + report.version + ", commit " + report.commit + ". " +
                           report.machine.cpu + ", " + std::to_string(report.machine.cores) +
                           " cores, " + report.machine.simd +
                           (report.machine.gl.empty() ? "" : ", " + report.machine.gl) + ". Seed " +
                           std::to_string(report.seed) + (report.quick ? ", quick." : ".");
  return "<h1>hasp report " + EscapeHtml(report.name) + "</h1>\n<p class=\"faint\">" +
         EscapeHtml(made) + "<br>Research use only, not a medical device.</p>\n" +
         RowsTable(report) + TermsTable(report) + Charts(report) + StabilityTable(report) +
         UnusedTable(report);
}

} // namespace

std::string ReportHtml(const std::vector<Report>& reports)
{
  std::string page = std::string("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                                 "\n<title>hasp report</title>\n") +
                     Style + "</head><body>\n";
  for (const Report& report : reports)
    page += Section(report);
  return page + "</body></html>\n";
}

} // namespace hasp
