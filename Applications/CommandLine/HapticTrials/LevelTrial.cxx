#include "HapticTrials.h"
#include "Haptics/CostModel.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SimdScene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>

namespace hasp
{
namespace
{

constexpr int Poses = 60, TimedPoses = 10, Points = 65'536;
constexpr const char* Plain = "one point after the other";

/// A rough body, its shell in levels, and poses in which it touches a body like itself.
struct LevelScene
{
  TrialBody body{ 128, { 38.0, 0.6, 15.2 } };
  std::shared_ptr<const PointShell> shell = body.Shell(Points);
  std::vector<RigidPose> poses;

  int Last() const { return this->shell->Levels() - 1; }
  std::vector<Wrench> Feel(const ContactKernels& kernels, int level, int count = Poses) const
  {
    const std::vector<ContactPoints> runs = UpTo(*this->shell, level);
    std::vector<Wrench> felt;
    for (const RigidPose& pose : std::span(this->poses).first(static_cast<std::size_t>(count)))
    {
      ContactSums sums;
      kernels[ContactTerms::Matrix](
        std::span<const ContactPoints>(runs), { pose }, this->body.Map()->View(), {}, sums);
      felt.push_back(sums.contact);
    }
    return felt;
  }
  /// Root of the mean square over the poses, of all points' force.
  double Error(int level) const
  {
    const std::vector<Wrench> truth = this->Feel(FastestContactKernels(), this->Last());
    const std::vector<Wrench> felt = this->Feel(FastestContactKernels(), level);
    double sum = 0.0;
    for (std::size_t n = 0; n < felt.size(); ++n)
    {
      const double error = WrenchError(felt[n], truth[n], this->body.Radius());
      sum += error * error / static_cast<double>(felt.size());
    }
    return std::sqrt(sum);
  }
};

/// Seconds a pose, of one point after the other and of the fastest kernels: medians of rounds in
/// which both take turns.
using Costs = std::vector<std::array<double, 2>>;

Costs Measure(const LevelScene& scene)
{
  Costs costs;
  for (int level = 0; level <= scene.Last(); ++level)
  {
    const auto of = [&](const ContactKernels& kernels)
    { return ThreadTimeOf([&] { scene.Feel(kernels, level, TimedPoses); }); };
    const PairedTimes times = ComparePairs(
      [&] { return of(ScalarContactKernels()); }, [&] { return of(FastestContactKernels()); });
    costs.push_back({ times.a.cpuS / TimedPoses, times.b.cpuS / TimedPoses });
  }
  return costs;
}

/// Levels that the step's own model settles at.
int LevelsIn(double budgetS, const PointShell& shell, double secondsPerPoint)
{
  std::vector<std::uint32_t> points;
  for (int level = 0; level < shell.Levels(); ++level)
    points.push_back(shell.LevelEnd(level) - (level > 0 ? shell.LevelEnd(level - 1) : 0));
  CostModel model({ .firstUsPerPoint = 1e6 * secondsPerPoint });
  int levels = 0;
  for (int tick = 0; tick <= shell.Levels(); ++tick)
    levels = model.Levels(points, 1e6 * budgetS);
  return levels;
}

void AddCurves(
  ReportContext& context, const LevelScene& scene, const std::string& name, const std::string& data)
{
  const Costs costs = Measure(scene);
  std::vector<double> errors;
  for (int level = 0; level <= scene.Last(); ++level)
    errors.push_back(scene.Error(level));
  const std::string id = "haptics.error.levels@" + name;
  const std::array<std::string, 2> methods{ Plain, FastestContactKernels().name };
  for (int method = 0; method < (AllContactKernels().size() == 1 ? 1 : 2); ++method)
  {
    ReportCurve levels{ id, methods[method], "ms", "% of the force", {} };
    ReportCurve budgets{ "haptics.error.budgets@" + name, methods[method], "ms of budget",
      "% of the force", {} };
    for (int level = 0; level < scene.Last(); ++level) // the last is the truth
      levels.points.emplace_back(1e3 * costs[level][method], 100.0 * errors[level]);
    const double perPoint = costs.back()[method] / scene.shell->LevelEnd(scene.Last());
    for (const double budget : { 25e-6, 50e-6, 100e-6, 200e-6, 400e-6, 800e-6 })
      budgets.points.emplace_back(1e3 * budget,
        100.0 *
          errors[std::clamp(LevelsIn(budget, *scene.shell, perPoint) - 1, 0, scene.Last() - 1)]);
    context.report.curves.insert(context.report.curves.end(), { levels, budgets });
  }
  double worst = 0.0;
  for (int level = 1; level < scene.Last(); ++level)
    worst = std::max(worst, errors[level] / errors[level - 1]);
  ReportRow row;
  row.id = "haptics.error.falls@" + name;
  row.value = worst;
  row.unit = "of the error with a quarter of the points, worst level";
  row.rival = std::to_string(Points) + " points";
  row.error = errors[static_cast<std::size_t>(scene.Last()) - 1];
  row.errorUnit = "of the force, RMS, finest level but one";
  row.timeS = row.cpuS = costs[static_cast<std::size_t>(scene.Last()) - 1][1];
  row.n = Poses;
  row.data = data;
  row.bars = { { {}, 1.0 } };
  context.report.rows.push_back(row);
}

/// The levels more that vectors allow in budgets that neither leave the coarsest level unfinished
/// nor the finest behind.
void AddLevels(ReportContext& context, const LevelScene& scene)
{
  const std::string rival = "array of structures, linear float volume, glm, g++ -O2; its levels in "
                            "the same budget";
  if (AllContactKernels().size() == 1)
  {
    context.report.rows.push_back(AbsentRow("haptics.levels", rival, WhyNoKernels("vectors")));
    return;
  }
  const SimdScene same(128, 20'000);
  const ContactKernels& kernels = FastestContactKernels();
  const auto time = [](const auto& feel) { return ThreadTimeOf([&] { feel(); }); };
  const PairedTimes times =
    ComparePairs([&] { return time([&] { same.Ours(kernels, ContactTerms::Matrix); }); },
      [&] { return time([&] { same.Rival(ContactTerms::Matrix, false); }); });
  const double ours = times.a.cpuS / same.Points(), plain = times.b.cpuS / same.Points();
  // From what plain code needs for the coarsest level to what vectors need for all but the finest.
  const double least = plain * scene.shell->LevelEnd(0) / 0.8,
               most = ours * scene.shell->LevelEnd(scene.Last()) / 0.8;
  std::vector<double> more;
  constexpr int Budgets = 101;
  double sum = 0.0;
  for (int n = 0; n < Budgets; ++n)
  {
    const double budget = least * std::pow(most / least, n / (Budgets - 1.0));
    more.push_back(LevelsIn(budget, *scene.shell, ours) - LevelsIn(budget, *scene.shell, plain));
    sum += more.back() / Budgets;
  }
  const Quartiles quartiles = QuartilesOf(more);
  ReportRow row;
  row.id = "haptics.levels";
  row.value = sum;
  row.unit = "levels more, on average over budgets";
  row.rival = rival;
  row.error = scene.Error(scene.Last() - 1);
  row.errorUnit = "of the force, RMS, finest level but one";
  row.timeS = times.a.wallS;
  row.cpuS = times.a.cpuS;
  row.q1 = quartiles.q1;
  row.q3 = quartiles.q3;
  row.n = Budgets;
  char text[160];
  std::snprintf(text, sizeof text, "%s, budgets of %.3g to %.3g ms, gradient and 6x6; aim 2",
    kernels.name, 1e3 * least, 1e3 * most);
  row.data = text;
  row.bars = { { 1.0, {} } };
  context.report.rows.push_back(row);
}

} // namespace

void TryLevels(ReportContext& context)
{
  LevelScene scene;
  const std::uint64_t seed = context.settings.seed;
  scene.poses = PressPoses(Poses, scene.body.Radius(), seed);
  AddCurves(context, scene, "press", "60 poses of two rough balls pressed 0.2 to 1 mm together");
  scene.poses = FitPoses(Poses, seed);
  AddCurves(context, scene, "fit", "60 poses of a rough ball on itself, half of it in contact");
  AddLevels(context, scene);
}

} // namespace hasp
