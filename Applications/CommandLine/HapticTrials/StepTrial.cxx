#include "HapticTrials.h"
#include "Haptics/HapticStep.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SimdScene.h"
#include "Studies/BenchRenderers.h"
#include "Studies/HapticBench.h"
#include "Studies/StepRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hasp
{
namespace
{

HapticStepSettings AllLevels(bool snap)
{
  HapticStepSettings settings;
  settings.budgetUs = std::numeric_limits<double>::infinity();
  settings.contact = { .stiffness = 0.05F, .attraction = snap ? 0.001F : 0.0F };
  return settings;
}

std::unique_ptr<HapticScene> OneOfEach(
  const std::shared_ptr<const PointShell>& shell, const TrialBody& body)
{
  return std::make_unique<HapticScene>(
    std::vector<HapticShell>{ { shell, {} } }, std::vector<HapticBody>{ { body.Map(), {} } });
}

struct TickCosts
{
  Quartiles cpuS, pointsPerMs;
  double wallS = 0.0, slowS = 0.0; ///< the slowest of a hundred, CPU
  double evaluations = 0.0;        ///< of contact, a tick
  ContactSums sums;                ///< of the last tick
};

/// A hand that trembles by 0.02 mm: nothing sleeps, and a tick moves as far as a hand does.
TickCosts Measure(HapticStep& step, int ticks)
{
  constexpr int Settling = 200; // until levels and fades are where they go
  std::vector<double> cpu, rates, wall;
  TickCosts costs;
  for (int n = 0; n < Settling + ticks; ++n)
  {
    const double sway = 0.02 * std::sin(0.06 * n);
    const RigidPose device{ { sway, 0.7 * sway, -0.5 * sway },
      TurnBy(glm::dvec3(0.0, 0.0, 0.002 * sway)) };
    HapticTick tick;
    const Timing time = ThreadTimeOf([&] { tick = step.Tick(device); });
    if (n < Settling)
      continue;
    cpu.push_back(time.cpuS);
    wall.push_back(time.wallS);
    rates.push_back(1e-3 * tick.points / time.cpuS);
    costs.evaluations += tick.evaluations / static_cast<double>(ticks);
    costs.sums = tick.sums;
  }
  costs.cpuS = QuartilesOf(cpu);
  costs.pointsPerMs = QuartilesOf(rates);
  costs.wallS = QuartilesOf(wall).median;
  std::sort(cpu.begin(), cpu.end());
  costs.slowS = cpu[cpu.size() * 99 / 100];
  return costs;
}

TickCosts MeasureStep(
  const TrialBody& body, const std::shared_ptr<const PointShell>& shell, bool snap, int ticks)
{
  HapticStep step(AllLevels(snap));
  auto scene = OneOfEach(shell, body);
  step.Swap(scene);
  step.Place({});
  step.Attract(snap);
  return Measure(step, ticks);
}

/// What the kernels of a tick are off by, against float distances in double precision.
double KernelError(
  const TrialBody& body, const PointShell& shell, ContactTerms terms, const RigidPose& pose)
{
  const std::vector<ContactPoints> runs = UpTo(shell, shell.Levels() - 1);
  const std::span<const ContactPoints> all(runs);
  const ContactSettings settings = AllLevels(true).contact;
  ContactSums felt, truth;
  FastestContactKernels()[terms](all, { pose }, body.Map()->View(), settings, felt);
  ContactForceReference(terms, all, { pose }, body.Map()->Reference(), settings, truth);
  return WrenchError(felt.contact, truth.contact, body.Radius());
}

const RigidPose Beside{ { 0.25, -0.2, 0.3 }, TurnBy({ 0.02, -0.01, 0.015 }) };

void AddPoints(ReportContext& context, const TrialBody& body, int points, int ticks)
{
  const auto shell = body.Shell(points);
  const TickCosts costs = MeasureStep(body, shell, false, ticks);
  const SimdScene same(128, 20'000);
  std::vector<double> plain; // the first call warms up
  for (int n = 0; n < 20; ++n)
    plain.push_back(ThreadTimeOf([&] { same.Rival(ContactTerms::Matrix, false); }).cpuS);
  ReportRow row;
  row.id = IdAt("haptics.points", points, 100'000);
  row.value = costs.pointsPerMs.median;
  row.q1 = costs.pointsPerMs.q1;
  row.q3 = costs.pointsPerMs.q3;
  row.unit = "points evaluated in 1 ms of CPU time";
  row.better = Better::Higher;
  row.error = KernelError(body, *shell, ContactTerms::Matrix, Beside);
  row.errorUnit = "of the force";
  row.timeS = costs.wallS;
  row.cpuS = costs.cpuS.median;
  row.n = ticks;
  char text[200];
  std::snprintf(text, sizeof text,
    "plain code (g++ -O2, contact and matrix alone, no coupling): %.0f points",
    1e-3 * same.Points() / QuartilesOf(plain).median);
  row.rival = text;
  std::snprintf(text, sizeof text,
    "128^3, %d points, %.0f%% in contact, whole ticks: coarse phase, gradient, 6x6, coupling, "
    "limits; %.2f evaluations a tick%s",
    points, 100.0 * costs.sums.contacts / points, costs.evaluations,
    points == 100'000 ? "; aim 200000" : "");
  row.data = text;
  if (points == 100'000)
    row.bars = { { 100'000.0, {} } };
  context.report.rows.push_back(row);
}

void AddSnap(ReportContext& context, const TrialBody& body, int points, int ticks)
{
  const auto shell = body.FittingShell(points);
  const TickCosts costs = MeasureStep(body, shell, true, ticks);
  ReportRow row;
  row.id = IdAt("haptics.snap.ms", points, 5'000);
  row.value = 1e3 * costs.cpuS.median;
  row.q1 = 1e3 * costs.cpuS.q1;
  row.q3 = 1e3 * costs.cpuS.q3;
  row.unit = "ms of CPU a tick";
  row.better = Better::Lower;
  row.rival = "the thesis: stable at 1 kHz with 5,000 contact points";
  row.error = KernelError(body, *shell, ContactTerms::Snap, Beside);
  row.errorUnit = "of the force";
  row.timeS = costs.wallS;
  row.cpuS = costs.cpuS.median;
  row.n = ticks;
  char text[200];
  std::snprintf(text, sizeof text,
    "128^3, %d points, %.0f%% of the area in contact, %.0f%% attracted, whole ticks; %.2f "
    "evaluations a tick, p99 %.3f ms%s",
    points, 100.0 * costs.sums.contactArea / shell->SurfaceArea(),
    100.0 * costs.sums.attractedArea / shell->SurfaceArea(), costs.evaluations, 1e3 * costs.slowS,
    points == 5'000 ? "" : "; aim 0.5");
  row.data = text;
  if (points == 5'000)
    row.bars = { { {}, 0.1 } };
  context.report.rows.push_back(row);
}

/// A part held 0.6 mm beside where it fits for 10 s, in virtual time.
BenchFigures Hold(const TrialBody& body, const std::shared_ptr<const PointShell>& shell,
  const BenchHand& hand, double& tickS)
{
  BenchScene scene;
  scene.device = FalconLike();
  scene.hand = hand;
  scene.start.position = { 0.4, -0.3, 0.3 };
  scene.leanN = hand.stiffness > 0.0 ? glm::dvec3(0.0) : glm::dvec3(0.0, 0.0, -0.25);
  scene.holdFromS = 1.5;
  scene.seconds = 11.5;
  scene.pressed = false;
  HapticStepSettings settings = AllLevels(true);
  settings.coupling = DefaultCoupling(scene.device, scene.clock, 1.0, 7.1);
  settings.limits.force = scene.device.forceLimitN;
  settings.limits.torque = scene.device.torqueLimitNmm;
  StepRenderer renderer(settings, OneOfEach(shell, body));
  renderer.OnTick([](double, HapticStep& step) { step.Attract(true); });
  const BenchFigures figures = RunBench(scene, renderer);
  tickS = figures.cpuS * scene.clock.tickS / scene.seconds;
  return figures;
}

void AddRipple(ReportContext& context, const TrialBody& body)
{
  const auto shell = body.FittingShell(5'000);
  ReportRow row;
  row.id = "haptics.snap.ripple";
  row.value = 0.0;
  double tickS = 0.0;
  for (const BenchHand& hand : { LooseHand(), FirmHand(), NoHand() })
  {
    const BenchFigures figures = Hold(body, shell, hand, tickS);
    if (!(figures.forceRipple <= *row.value)) // also where it is no number
      row.value = figures.forceRipple;
    char text[120];
    std::snprintf(text, sizeof text, "%s%s %.2g%% at %.2g N", row.data.empty() ? "" : ", ",
      hand.name, 100.0 * figures.forceRipple, figures.holdForceN);
    row.data += text;
  }
  row.unit = "of the device's largest force, RMS over 5 Hz";
  row.rival = "a force that does not change";
  row.error = row.value;
  row.errorUnit = "of the largest force";
  row.timeS = row.cpuS = tickS;
  row.n = 3;
  row.data = "5000 points, Falcon-like with its friction and encoders, held for 10 s in virtual "
             "time beside the fit by each hand: " +
             row.data;
  row.bars = { { {}, 0.02 } };
  context.report.rows.push_back(row);
}

} // namespace

void TrySteps(ReportContext& context)
{
  const int ticks = context.settings.quick ? 200 : 1000;
  const TrialBody body(128, { 45.0, 3.0, 6.0 });
  AddPoints(context, body, 100'000, ticks);
  AddPoints(context, body, 20'000, ticks);
  AddSnap(context, body, 5'000, ticks);
  AddSnap(context, body, 50'000, ticks);
  AddRipple(context, body);
}

} // namespace hasp
