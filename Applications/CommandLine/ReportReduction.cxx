#include "ReportReduction.h"

#include "ReductionTrials.h"
#include "Report/ReportRegistry.h"
#if HASP_WITH_COLOURS
#include "ReductionColours.h"
#endif

#include "Grid/Stopwatch.h"

#include <functional>
#include <string>

namespace hasp
{
namespace
{

/// Tries one part of the report, and says how long that took.
class Parts
{
public:
  explicit Parts(ReportContext& context) : Context(context) {}

  void Try(const std::string& name, const std::function<void()>& part)
  {
    const Stopwatch time;
    part();
    this->Add(name, 1e-3 * time.Milliseconds(), "this part of the report, wall time");
  }
  void AddAll()
  {
    this->Add("all", 1e-3 * this->All.Milliseconds(), "the whole report, wall time; aim 600 s");
  }

private:
  void Add(const std::string& name, double seconds, const std::string& data)
  {
    ReportRow row;
    row.id = "reduction.part." + name;
    row.value = seconds;
    row.unit = "s";
    row.better = Better::Lower;
    row.data = data;
    this->Context.report.rows.push_back(row);
  }

  ReportContext& Context;
  Stopwatch All;
};

} // namespace

void ReportReduction(ReportContext& context)
{
  const bool quick = context.settings.quick;
  // Others than those that the fit's settings were chosen by, whose seeds are below 100.
  const std::uint64_t first = 100 + 100 * context.settings.seed;
  Parts parts(context);
  std::vector<ReductionCase> cases, jaws;
  parts.Try("bones",
    [&]
    {
      cases = MakeTrialCases(context, quick ? 2 : 8, first);
      jaws = MakeTrialCases(context, quick ? 1 : 8, first + 50, true);
      for (std::size_t n = 0; n < cases.size(); n += 2)
        jaws.push_back(cases[n]);
    });
  parts.Try("fits", [&] { TryFits(context, cases); });
  parts.Try("assembly", [&] { TryAssembly(context, cases); });
  parts.Try("capture", [&] { TryCapture(context, cases); });
  parts.Try("pot", [&] { TryPot(context); });
  parts.Try("fidelity", [&] { TryFidelity(context); });
  parts.Try("precision", [&] { TryPrecision(context, jaws); });
#if HASP_WITH_COLOURS
  parts.Try("colours", [&] { TryColours(context); });
#endif
  parts.AddAll();
  AddUnusedReduction(context);
}

} // namespace hasp
