#include "FitRivals.h"
#include "ReductionTrials.h"
#include "Report.h"
#include "ReportRegistry.h"

#include "Grid/Stopwatch.h"

#include <algorithm>
#include <cstdio>
#include <functional>

namespace hasp
{
namespace
{
constexpr double SameMm = 0.5, AcceptedMm = 2.0, GoodShare = 0.95;

using FitFrom = std::function<RigidPose(const TrialStart&, double mm)>;

/// The farthest of the scales, in mm, up to which all have 95 % of captured fits.
struct Captured
{
  double mm = 0.0;
  std::string shares; ///< "1 mm: 1.00, 2 mm: 0.98 ...", up to the first that is too few
  double seconds = 0.0, medianMm = 0.0;
};

/// Where the method ends from the truth itself, one of each moved body.
std::vector<FitTrial> FromTruth(
  const std::vector<ReductionCase>& cases, std::uint64_t seed, const FitFrom& fit)
{
  return TryAll(cases, 1, 0.0, 0.0, seed, [&](const TrialStart& s) { return s.Of(fit(s, 0.0)); });
}

Captured Capture(const std::vector<ReductionCase>& cases, const std::vector<double>& scales,
  int starts, std::uint64_t seed, const FitFrom& fit)
{
  const std::vector<FitTrial> ends = FromTruth(cases, seed, fit);
  Captured made;
  for (const double mm : scales)
  {
    const Stopwatch time;
    std::vector<FitTrial> trials = TryAll(cases, starts, mm, mm * 5.0 / 3.0, seed,
      [&](const TrialStart& s)
      {
        FitTrial trial = s.Of(fit(s, mm));
        const FitTrial& end = ends[s.number / std::size_t(starts)];
        trial.captured = trial.mm <= AcceptedMm && RmsWay(s.moved, trial.pose, end.pose) <= SameMm;
        return trial;
      });
    const auto good =
      std::count_if(trials.begin(), trials.end(), [](const FitTrial& t) { return t.captured; });
    const double share = double(good) / double(trials.size());
    char text[40];
    std::snprintf(text, sizeof text, "%s%.1f mm: %.2f", made.shares.empty() ? "" : ", ", mm, share);
    made.shares += text;
    made.seconds = 1e-3 * time.Milliseconds() / double(trials.size());
    if (share < GoodShare)
      break; // farther starts cannot change the figure
    made.mm = mm;
    std::sort(trials.begin(), trials.end(),
      [](const FitTrial& a, const FitTrial& b) { return a.mm < b.mm; });
    made.medianMm = trials[trials.size() / 2].mm;
  }
  return made;
}

ReportRow RowOf(const std::string& id, const Captured& captured, const std::string& rival, int n)
{
  ReportRow row;
  row.id = id;
  row.value = captured.mm;
  row.unit = "mm";
  row.better = Better::Higher;
  row.rival = rival;
  row.error = captured.medianMm;
  row.errorUnit = "mm, median at that start";
  row.timeS = captured.seconds;
  row.n = n;
  row.data = "captured (ends within 0.5 mm of where it ends from the truth, and within 2 mm of "
             "the truth), by starts: " +
             captured.shares + "; degrees are 5/3 of the millimetres";
  return row;
}
} // namespace

void TryCapture(ReportContext& context, const std::vector<ReductionCase>& cases)
{
  const bool quick = context.settings.quick;
  const int starts = quick ? 1 : 2;
  const std::vector<double> scales = quick
                                       ? std::vector<double>{ 2.0, 4.0 }
                                       : std::vector<double>{ 1.0, 2.0, 3.0, 4.5, 6.0, 9.0, 12.0 };
  context.progress(0.0, "reduction: capture range");
  const std::uint64_t seed = context.settings.seed + 31;
  const Captured ours = Capture(cases, scales, starts, seed,
    [](const TrialStart& s, double mm)
    {
      ProposalSettings settings;
      settings.startMm = mm;
      settings.startDegrees = mm * 5.0 / 3.0;
      settings.starts = 16;
      settings.most = 1;
      const FitProposals found = ProposeFits(s.moved, s.start, s.scene, settings, s.seed);
      return found.proposals.empty() ? s.start : found.proposals[0].fit.groupInWorld;
    });
  const Captured single = Capture(cases, scales, starts, seed,
    [](const TrialStart& s, double)
    { return FitFracture(s.moved, s.start, s.scene).groupInWorld; });
  // ICP at its best reach for each start, whichever that is.
  const Captured icp = Capture(cases, scales, starts, seed,
    [](const TrialStart& s, double mm)
    { return FitByIcp(s.moved, s.start, s.scene, { .reachMm = std::max(5.0, 1.5 * mm) }); });
  int bodies = 0;
  for (const ReductionCase& broken : cases)
    bodies += int(std::count(broken.fixed.begin(), broken.fixed.end(), false));
  auto& rows = context.report.rows;
  rows.push_back(RowOf("reduction.capture.snap", ours, IcpWords(), bodies * starts));
  rows.push_back(RowOf("reduction.capture.single", single, IcpWords(), bodies * starts));
  rows.push_back(RowOf("reduction.capture.icp", icp, IcpWords(), bodies * starts));
  ReportRow row = RowOf("reduction.capture", ours, IcpWords(), bodies * starts);
  // Where ICP captures nothing at the least start, that start is taken for it: no ratio is
  // infinite.
  row.value = ours.mm / std::max(icp.mm, scales.front());
  row.unit = "times as far";
  if (!quick)
    row.bars = { { 1.0, {} } };
  rows.push_back(row);
}

} // namespace hasp
