#include "TrialRows.h"

#include "Pairing.h"
#include "Report.h"
#include "ReportRegistry.h"

#include <array>
#include <cstdio>
#include <vector>

namespace hasp
{
namespace
{

/// One of the table's three kinds of pairs.
struct Kind
{
  const char* id;
  const char* rival;
  TrialSummary TrialRow::*summary;
  bool (*holds)(const TrialPair&);
};
const std::array Kinds{
  Kind{ "reduction.precision.intra", "the same operator's other trial of the same case",
    &TrialRow::intraOperator, [](const TrialPair& p) { return p.second && p.oneOperator; } },
  Kind{ "reduction.precision.inter", "other operators' trials of the same case",
    &TrialRow::interOperator, [](const TrialPair& p) { return p.second && !p.oneOperator; } },
  Kind{ "reduction.accuracy", "the poses that the bone was broken by", &TrialRow::accuracy,
    [](const TrialPair& p) { return !p.second; } },
};

struct Column
{
  TrialMeasure measure;
  const char *id, *unit, *words;
};
constexpr std::array Columns{
  Column{ TrialMeasure::SurfaceMeanMm, "", "mm", "mean distance of surfaces" },
  Column{ TrialMeasure::SurfaceMaxMm, ".max", "mm", "largest distance of surfaces" },
  Column{ TrialMeasure::RotationDegrees, ".rotation", "degrees", "rotation" },
  Column{ TrialMeasure::TranslationMm, ".translation", "mm", "way of the centroid" },
  Column{ TrialMeasure::TreMm, ".tre", "mm", "mean way of places on the fragment" },
};

ReportRow RowOf(const std::string& id, const Kind& kind, const TrialSummary& summary,
  std::vector<double> figures, const Column& column)
{
  const auto m = std::size_t(column.measure);
  const Quartiles quartiles = QuartilesOf(std::move(figures));
  ReportRow row;
  row.id = id;
  row.value = summary.mean[m];
  row.unit = column.unit;
  row.better = Better::Lower;
  row.rival = kind.rival;
  row.q1 = quartiles.q1;
  row.q3 = quartiles.q3;
  row.n = int(summary.pairs);
  return row;
}

std::vector<double> FiguresOf(
  const TrialTable& table, const Kind& kind, const std::string* caseName, TrialMeasure measure)
{
  std::vector<double> figures;
  for (const TrialPair& pair : table.pairs)
    if (kind.holds(pair) && (!caseName || pair.caseName == *caseName))
      figures.push_back(pair.figures[std::size_t(measure)]);
  return figures;
}

/// "mean distance of surfaces 0.12 +- 0.03 mm, ...": a line of the table.
std::string LineOf(const TrialSummary& summary)
{
  std::string line;
  for (const Column& column : Columns)
  {
    const auto m = std::size_t(column.measure);
    char text[100];
    std::snprintf(text, sizeof text, "%s%s %.3f +- %.3f %s", line.empty() ? "" : ", ", column.words,
      summary.mean[m], summary.deviation[m], column.unit);
    line += text;
  }
  return line;
}

} // namespace

void AddTrialRows(ReportContext& context, const TrialTable& table, const std::string& data)
{
  auto& rows = context.report.rows;
  for (const Kind& kind : Kinds)
  {
    const TrialSummary& all = table.overall.*kind.summary;
    if (all.pairs == 0)
      continue;
    for (const Column& column : Columns)
    {
      rows.push_back(RowOf(std::string(kind.id) + column.id, kind, all,
        FiguresOf(table, kind, nullptr, column.measure), column));
      rows.back().data =
        std::string(column.words) + ", mean over pairs" + (*column.id ? "" : "; " + data);
    }
    for (std::size_t n = 0; n < table.rows.size(); ++n)
    {
      const TrialSummary& one = table.rows[n].*kind.summary;
      if (one.pairs == 0)
        continue;
      rows.push_back(RowOf(std::string(kind.id) + "@case" + std::to_string(n + 1), kind, one,
        FiguresOf(table, kind, &table.rows[n].caseName, Columns[0].measure), Columns[0]));
      rows.back().data = LineOf(one);
    }
  }
}

} // namespace hasp
