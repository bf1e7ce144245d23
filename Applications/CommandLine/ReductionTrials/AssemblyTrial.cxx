#include "FitRows.h"
#include "ReportRegistry.h"

#include "Grid/Stopwatch.h"
#include "Reduction/Assembly.h"

namespace hasp
{
namespace
{
constexpr double StartMm = 3.0, StartDegrees = 5.0;

/// All pieces of a bone from coarse poses at once: one trial of each.
std::vector<FitTrial> TryBone(const ReductionCase& broken, std::uint64_t seed)
{
  std::vector<AssemblyUnit> units;
  for (std::size_t n = 0; n < broken.bodies.size(); ++n)
  {
    AssemblyUnit unit{ { { broken.bodies[n].body, {} } }, broken.trueBodyInWorld[n],
      broken.fixed[n], broken.partners[n] };
    if (!unit.fixed)
      unit.groupInWorld = broken.StartOf(n, StartMm, StartDegrees, seed);
    units.push_back(std::move(unit));
  }
  const Stopwatch time;
  const std::vector<AssembledUnit> made = Assemble(units, {}, seed);
  const double ms = time.Milliseconds();
  std::vector<FitTrial> trials;
  for (std::size_t n = 0; n < units.size(); ++n)
    if (!broken.fixed[n])
    {
      const FitScene nothing;
      const TrialStart start{ broken, n, units[n].bodies, nothing, units[n].groupInWorld, seed, n };
      trials.push_back(start.Of(made[n].groupInWorld));
      trials.back().milliseconds = ms / double(units.size());
      trials.back().within95Mm = made[n].within95Mm;
    }
  return trials;
}
} // namespace

void TryAssembly(ReportContext& context, const std::vector<ReductionCase>& cases)
{
  std::vector<FitTrial> all;
  const int rounds = context.settings.quick ? 1 : 3;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t n = 0; n < cases.size(); ++n)
    {
      context.progress(double(n) / double(cases.size()), "reduction: whole bones");
      const std::vector<FitTrial> bone =
        TryBone(cases[n], context.settings.seed + 100 * std::uint64_t(round));
      all.insert(all.end(), bone.begin(), bone.end());
    }
  const std::string truth = "the poses that the bone was broken by";
  const std::string data = "as reduction.tre.snap, but all pieces begin off and are put together";
  AddMethod(context, ".assembled", all, truth, data, false);
  AddShare(
    context, "reduction.coverage.assembled", all,
    [](const FitTrial& t) { return t.mm <= t.within95Mm; }, {}, data);
}

} // namespace hasp
