#include "FitRivals.h"
#include "FitRows.h"
#include "ReductionTrials.h"
#include "Report.h"
#include "ReportRegistry.h"

#include "Grid/ParallelFor.h"
#include "Grid/Stopwatch.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{
constexpr double StartMm = 3.0, StartDegrees = 5.0;
constexpr const char* Bones =
  "broken mandibles and heads, half with faces eroded by 0.3 mm; all other "
  "pieces where they belong";
constexpr double SameMm = 1.0; // a proposal within this is the truth's, as far as data tell

FitTrial TryProposals(const TrialStart& start)
{
  ProposalSettings settings;
  settings.startMm = StartMm;
  settings.startDegrees = StartDegrees;
  const Stopwatch time;
  const FitProposals found =
    ProposeFits(start.moved, start.start, start.scene, settings, start.seed);
  FitTrial trial =
    start.Of(found.proposals.empty() ? start.start : found.proposals[0].fit.groupInWorld);
  trial.milliseconds = time.Milliseconds();
  trial.within95Mm = found.within95Mm;
  const RigidPose& truth = start.broken.trueBodyInWorld[start.body];
  for (std::size_t n = 0; n < std::min<std::size_t>(3, found.proposals.size()); ++n)
    trial.inFirstThree = trial.inFirstThree ||
                         RmsWay(start.moved, truth, found.proposals[n].fit.groupInWorld) <= SameMm;
  return trial;
}

FitTrial Timed(const TrialStart& start, const std::function<RigidPose()>& fit)
{
  const Stopwatch time;
  const RigidPose pose = fit();
  FitTrial trial = start.Of(pose);
  trial.milliseconds = time.Milliseconds();
  return trial;
}

/// A method's error against its time, by how many points it takes.
void DrawCurve(ReportContext& context, const std::vector<ReductionCase>& cases,
  const std::string& method, const std::vector<int>& points,
  const std::function<RigidPose(const TrialStart&, int)>& fit)
{
  ReportCurve curve{ "reduction.error_time", method, "s", "mm, median", {} };
  for (const int count : points)
  {
    const std::vector<FitTrial> trials =
      TryAll(cases, 2, StartMm, StartDegrees, context.settings.seed + 7,
        [&](const TrialStart& start) { return Timed(start, [&] { return fit(start, count); }); });
    curve.points.push_back({ 1e-3 * Quantile(Figures(trials, &FitTrial::milliseconds), 0.5),
      Quantile(Figures(trials, &FitTrial::mm), 0.5) });
  }
  context.report.curves.push_back(curve);
}
} // namespace

FitTrial TrialStart::Of(const RigidPose& pose) const
{
  const RigidPose& truth = this->broken.trueBodyInWorld[this->body];
  FitTrial trial;
  trial.pose = pose;
  trial.startMm = RmsWay(this->moved, truth, this->start);
  trial.mm = RmsWay(this->moved, truth, pose);
  trial.degrees =
    glm::degrees(glm::length(RotationVector(pose.orientation * glm::conjugate(truth.orientation))));
  return trial;
}

std::vector<ReductionCase> MakeTrialCases(
  ReportContext& context, int count, std::uint64_t firstSeed, bool jawsAlone)
{
  std::vector<ReductionCase> cases;
  for (int n = 0; n < count; ++n)
  {
    context.progress(double(n) / count, "reduction: breaking bone");
    ReductionCaseSettings settings;
    const bool head = n % 2 == 1 && !jawsAlone;
    settings.bone = head ? BrokenBone::Head : BrokenBone::Mandible;
    settings.spacingMm = head ? 1.0 : 0.8;
    settings.damage.erodedMm = n / 2 % 2 == 0 ? 0.3 : 0.0;
    settings.damage.noiseHU = 25.0;
    settings.seed = firstSeed + std::uint64_t(n);
    cases.push_back(MakeReductionCase(settings));
  }
  return cases;
}

std::vector<FitTrial> TryAll(const std::vector<ReductionCase>& cases, int starts, double mm,
  double degrees, std::uint64_t seed, const TryStart& trial)
{
  std::vector<FitScene> scenes;
  std::vector<TrialStart> all;
  std::size_t moved = 0;
  for (const ReductionCase& broken : cases)
    for (std::size_t body = 0; body < broken.bodies.size(); ++body)
      moved += !broken.fixed[body];
  scenes.reserve(moved); // starts refer to them
  for (const ReductionCase& broken : cases)
    for (std::size_t body = 0; body < broken.bodies.size(); ++body)
    {
      if (broken.fixed[body])
        continue;
      scenes.push_back(broken.SceneWithout(body));
      for (int n = 0; n < starts; ++n)
      {
        const std::uint64_t one = seed + 1000 * all.size();
        all.push_back({ broken, body, { { broken.bodies[body].body, {} } }, scenes.back(),
          broken.StartOf(body, mm, degrees, one), one, all.size() });
      }
    }
  std::vector<FitTrial> trials(all.size());
  ParallelFor(0, std::int64_t(all.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
        trials[n] = trial(all[n]);
    });
  return trials;
}

void TryFits(ReportContext& context, const std::vector<ReductionCase>& cases)
{
  const bool quick = context.settings.quick;
  // Two bones in turn, of three and of four pieces: 18 starts of each in eight cases are 504 fits.
  const int starts = quick ? 2 : 18;
  context.progress(0.0, "reduction: proposals");
  const std::vector<FitTrial> snap =
    TryAll(cases, starts, StartMm, StartDegrees, context.settings.seed, TryProposals);
  AddMethod(context, ".snap", snap, IcpWords() + " (reduction.tre.icp)", Bones, true);
  const std::string data = "as reduction.tre.snap";
  AddShare(
    context, "reduction.coverage", snap, [](const FitTrial& t) { return t.mm <= t.within95Mm; },
    quick ? ReportBar{ 0.0, 1.0 } : ReportBar{ 0.90, 0.99 }, data);
  AddShare(
    context, "reduction.top3", snap, [](const FitTrial& t) { return t.inFirstThree; },
    ReportBar{ quick ? 0.5 : 0.90, {} }, data);
  context.progress(0.6, "reduction: rivals");
  const int few = quick ? 2 : 6;
  const auto rival = [&](const std::string& key, const std::string& words,
                       const std::function<RigidPose(const TrialStart&)>& fit)
  {
    AddMethod(context, key,
      TryAll(cases, few, StartMm, StartDegrees, context.settings.seed,
        [&](const TrialStart& s) { return Timed(s, [&] { return fit(s); }); }),
      words, Bones, false);
  };
  rival(".single", "one descent from the start alone; against " + IcpWords(),
    [](const TrialStart& s) { return FitFracture(s.moved, s.start, s.scene).groupInWorld; });
  rival(".contact", ContactWords(),
    [](const TrialStart& s) { return FitByContact(s.moved, s.start, s.scene); });
  rival(
    ".icp", IcpWords(), [](const TrialStart& s) { return FitByIcp(s.moved, s.start, s.scene); });
  const std::vector<int> points =
    quick ? std::vector<int>{ 1024, 16'384 } : std::vector<int>{ 256, 1024, 4096, 16'384 };
  DrawCurve(context, cases, "Snap-to-fit, one descent", points,
    [](const TrialStart& s, int count)
    {
      FitSettings settings;
      settings.points = count;
      settings.coarsePoints = std::min(settings.coarsePoints, count);
      return FitFracture(s.moved, s.start, s.scene, settings).groupInWorld;
    });
  DrawCurve(context, cases, "point-to-plane ICP", points,
    [](const TrialStart& s, int count)
    { return FitByIcp(s.moved, s.start, s.scene, { .points = std::size_t(count) }); });
}

void AddUnusedReduction(ReportContext& context)
{
  context.report.unused.push_back(
    { "haptic thread", 0, 0.0, "fits have no hand: no loop and no device is made" });
}

} // namespace hasp
