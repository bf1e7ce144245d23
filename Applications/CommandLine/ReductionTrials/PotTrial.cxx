#include "ReductionTrials.h"
#include "Report.h"
#include "ReportRegistry.h"

#include "Grid/Stopwatch.h"
#include "Reduction/Assembly.h"
#include "Studies/BrokenPot.h"
#include "Studies/ReductionCases.h"

#include <algorithm>

namespace hasp
{
namespace
{
constexpr double StartMm = 3.0, StartDegrees = 5.0, GoodMm = 0.5;
} // namespace

void TryPot(ReportContext& context)
{
  context.progress(0.0, "reduction: breaking a pot");
  const std::uint64_t seed = context.settings.seed;
  BrokenPotSettings settings;
  settings.seed = 40 + seed;
  settings.spacingMm = context.settings.quick ? 1.0 : 0.6;
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
      fixed });
  }
  AssemblySettings assembly;
  assembly.proposals.starts = 8;
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
  std::sort(errors.begin(), errors.end());
  row.id = "reduction.pot";
  row.value =
    double(std::count_if(errors.begin(), errors.end(), [](double mm) { return mm <= GoodMm; }));
  row.unit = "sherds";
  row.better = Better::Higher;
  row.rival = "the pot before it broke, 12 sherds; one stands, the others begin within 3 mm and 5 "
              "degrees";
  row.error = errors.back();
  row.errorUnit = "mm, the worst sherd";
  row.n = int(made.size());
  row.data = "placed within 0.5 mm, rms over the sherd, of the one that stands; aim 12";
  row.bars = { { 11.0, {} } };
  context.report.rows.push_back(row);
}

} // namespace hasp
