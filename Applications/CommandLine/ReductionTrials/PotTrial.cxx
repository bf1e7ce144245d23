#include "ReductionTrials.h"
#include "Report.h"
#include "ReportRegistry.h"

#include "Grid/Stopwatch.h"
#include "Reduction/Assembly.h"
#include "Studies/BrokenPot.h"
#include "Studies/ReductionCases.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace hasp
{
namespace
{
constexpr double StartMm = 3.0, StartDegrees = 5.0, GoodMm = 0.5;

/// A pot put together from coarse poses; its largest sherd stands.
ReportRow TryToMend(ReportContext& context, const BrokenPotSettings& settings, int starts)
{
  context.progress(0.0, "reduction: breaking a pot");
  const std::uint64_t seed = context.settings.seed;
  const BrokenPot pot = MakeBrokenPot(settings);
  const auto largest =
    std::size_t(std::max_element(pot.areaMm2.begin(), pot.areaMm2.end()) - pot.areaMm2.begin());
  std::vector<AssemblyUnit> units;
  for (std::size_t n = 0; n < pot.sherds.size(); ++n)
  {
    const RigidPose& truth = pot.sherds[n].bodyInWorld;
    const bool fixed = n == largest;
    units.push_back({ { { pot.sherds[n].body, {} } },
      fixed ? truth
            : UniformStart(
                truth, pot.sherds[n].body->Centroid(), StartMm, StartDegrees, 1000 * seed + n),
      fixed, {} });
  }
  AssemblySettings assembly;
  assembly.proposals.starts = starts;
  const Stopwatch time;
  const std::vector<AssembledUnit> made = Assemble(units, assembly, seed,
    [&](double share)
    {
      context.progress(share, "reduction: putting a pot together");
      return true;
    });
  ReportRow row;
  row.timeS = 1e-3 * time.Milliseconds();
  std::vector<double> errors;
  for (std::size_t n = 0; n < made.size(); ++n)
    errors.push_back(RmsWay(units[n].bodies, pot.sherds[n].bodyInWorld, made[n].groupInWorld));
  const auto placed =
    std::count_if(errors.begin(), errors.end(), [](double mm) { return mm <= GoodMm; });
  row.value = double(placed);
  row.unit = "sherds";
  row.better = Better::Higher;
  row.rival = "the pot before it broke, " + std::to_string(made.size()) +
              " sherds; one stands, the others begin within 3 mm and 5 degrees";
  row.error = *std::max_element(errors.begin(), errors.end());
  row.errorUnit = "mm, the worst sherd";
  row.n = int(made.size());
  std::sort(errors.begin(), errors.end());
  char text[120];
  std::snprintf(text, sizeof text,
    "placed within 0.5 mm, rms over the sherd, of the one that stands; median %.3f mm",
    errors[errors.size() / 2]);
  row.data = text;
  return row;
}
} // namespace

void TryPot(ReportContext& context)
{
  BrokenPotSettings settings;
  settings.seed = 40 + context.settings.seed;
  settings.spacingMm = context.settings.quick ? 1.0 : 0.6;
  ReportRow row = TryToMend(context, settings, 8);
  row.id = "reduction.pot";
  row.data += "; aim 12";
  row.bars = { { 11.0, {} } };
  context.report.rows.push_back(row);
  if (context.settings.quick)
    return;
  settings.sherds = 60;
  settings.spacingMm = 0.8;
  row = TryToMend(context, settings, 4);
  row.id = "reduction.pot@60";
  context.report.rows.push_back(row);
}

} // namespace hasp
