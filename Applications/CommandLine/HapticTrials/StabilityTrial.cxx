#include "StabilityTrial.h"

#include "ReportRegistry.h"
#include "Studies/HapticSoak.h"
#include "Studies/StabilityRows.h"

#include <set>

namespace hasp
{
namespace
{

/// "grid.quasistatic", "plate": what comes before a figure or a name.
std::string FamilyOf(const StabilityRow& row)
{
  const std::size_t end = row.id.find('.', row.id.starts_with("grid.") ? 5 : 0);
  return row.id.substr(0, end);
}

std::vector<StabilityRow> Chosen(bool quick)
{
  std::vector<StabilityRow> rows = StabilityRows();
  std::set<std::string> seen;
  if (quick)
    std::erase_if(rows, [&](const StabilityRow& row)
      { return !seen.insert(FamilyOf(row) + row.predicted.Faults()).second; });
  return rows;
}

ReportCase Try(const StabilityRow& row)
{
  const BenchVerdict verdict = row.run().verdict;
  ReportCase tried;
  tried.id = "haptics." + row.id;
  tried.testCase = row.text + ": predicted " + row.predicted.Faults();
  tried.pass = AsPredicted(row.predicted, verdict);
  if (!(row.predicted == verdict))
    tried.testCase += ", is " + verdict.Faults();
  tried.figure = row.figure;
  tried.limit = row.limit;
  tried.unit = row.law;
  return tried;
}

using Soak = SoakFigures (*)(std::uint64_t, std::uint32_t, const ProgressFunction&);

void AddSoak(ReportContext& context, const std::string& name, Soak run, std::uint64_t ticks)
{
  context.progress(0.0, "stability: haptics, ticks of " + name);
  const SoakFigures figures = run(ticks, static_cast<std::uint32_t>(context.settings.seed),
    [&](double share)
    {
      context.progress(share, "");
      return true;
    });
  const auto add = [&](const char* id, const std::string& text, std::uint64_t count)
  {
    context.report.stability.push_back(
      { std::string("haptics.soak.") + id + "@" + name, std::to_string(ticks) + " ticks: " + text,
        count == 0 && figures.ticks == ticks, static_cast<double>(count), 0.0, "ticks" });
  };
  add("finite", "a wrench or tool that is no number", figures.notFinite);
  add("limit", "a force beyond the limit", figures.overLimit);
  add("slew", "a force that grew too fast", figures.overSlew);
}

} // namespace

void TryStability(ReportContext& context)
{
  const bool quick = context.settings.quick;
  const std::vector<StabilityRow> rows = Chosen(quick);
  double done = 0.0;
  context.progress(0.0, "stability: haptics");
  for (const StabilityRow& row : rows)
  {
    context.report.stability.push_back(Try(row));
    context.progress(++done / static_cast<double>(rows.size()), "");
  }
  const std::uint64_t ticks = context.settings.soak ? 86'400'000 : quick ? 60'000 : 600'000;
  AddSoak(context, "coupling", RunSoak, ticks);
  AddSoak(context, "step", RunStepSoak, ticks);
}

} // namespace hasp
