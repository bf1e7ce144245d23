// What levels of a shell buy: error of the wrench against time, levels that fit a budget, and the
// time of Snap-to-fit. Usage: BenchKernelHapticLevels [rounds, default 15]
//
// Error: a rough ball's shell of 65,536 points in 60 poses, each level against all points, in
// percent of the force, the torque's at the shell's radius: root of the mean square, and the worst.
// "fit": against its own surface, moved by up to 1 mm, half of the points in contact. "press":
// against a ball as rough, pressed in by 0.2 to 1 mm, 0.6% in contact; there the coarse phase would
// leave most points out, which here are paid for. Time: this thread's, a pose on average, best
// round; all contestants take turns. Run it with nice -n -20.
#include "Haptics/CoarsePhase.h"
#include "Haptics/ContactForce.h"
#include "Haptics/CostModel.h"
#include "Haptics/PointShell.h"
#include "Testing/Dice.h"
#include "Testing/SampledDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <span>
#include <vector>

namespace
{

using namespace hasp;

double CpuMicroseconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

constexpr double Radius = 38.0;
constexpr int Poses = 60;

hasp::testing::SampledDistance RoughBall()
{
  return { [](const glm::dvec3& p)
    {
      return glm::length(p) - Radius -
             0.6 * std::sin(0.4 * p.x + 1.0) * std::sin(0.5 * p.y) * std::sin(0.45 * p.z + 2.0);
    },
    hasp::testing::CubeGrid(128) };
}

std::vector<RigidPose> FitPoses()
{
  std::vector<RigidPose> poses;
  Dice dice(17);
  for (int n = 0; n < Poses; ++n)
    poses.push_back(
      { (0.3 + 0.7 * dice()) * glm::normalize(dice.InBox(1.0)), TurnBy(dice.InBox(0.02)) });
  return poses;
}

std::vector<RigidPose> PressPoses()
{
  std::vector<RigidPose> poses;
  Dice dice(18);
  for (int n = 0; n < Poses; ++n)
    poses.push_back({ (2.0 * Radius - 0.2 - 0.8 * dice()) * glm::normalize(dice.InBox(1.0)),
      TurnBy(dice.InBox(2.0)) });
  return poses;
}

/// The levels up to `last`, each point for its share of the whole surface.
std::vector<ContactPoints> Upto(const PointShell& shell, int last)
{
  std::vector<ContactPoints> runs;
  for (int level = 0; level <= last; ++level)
  {
    runs.push_back(shell.Level(level));
    runs.back().area = static_cast<float>(shell.SurfaceArea() / shell.LevelEnd(last));
  }
  return runs;
}

std::vector<ContactSums> FeelAll(const ContactKernels& kernels, ContactTerms terms,
  const std::vector<ContactPoints>& runs, const std::vector<RigidPose>& poses,
  const DistanceMap& map)
{
  std::vector<ContactSums> all(poses.size());
  for (std::size_t n = 0; n < poses.size(); ++n)
    kernels[terms](std::span<const ContactPoints>(runs), { poses[n] }, map.View(),
      { .attraction = 0.01F, .captureMm = 3.0F }, all[n]);
  return all;
}

/// Microseconds a pose, by level: [0] one point after the other, [1] the fastest kernel.
using Times = std::vector<std::array<double, 2>>;

Times TimeLevels(const PointShell& shell, ContactTerms terms, const std::vector<RigidPose>& poses,
  const DistanceMap& map, int rounds)
{
  const ContactKernels kernels[2] = { ScalarContactKernels(), FastestContactKernels() };
  const double never = std::numeric_limits<double>::infinity();
  Times least(static_cast<std::size_t>(shell.Levels()), { never, never });
  for (int round = 0; round < rounds; ++round)
    for (int level = 0; level < shell.Levels(); ++level)
      for (int k = 0; k < 2; ++k)
      {
        const std::vector<ContactPoints> runs = Upto(shell, level);
        const double start = CpuMicroseconds();
        FeelAll(kernels[k], terms, runs, poses, map);
        double& best = least[level][k];
        best = std::min(best, (CpuMicroseconds() - start) / static_cast<double>(poses.size()));
      }
  return least;
}

/// Percent: root of the mean square and worst, of force and torque.
std::array<double, 4> ErrorsOf(
  const std::vector<ContactSums>& sums, const std::vector<ContactSums>& truth)
{
  std::array<double, 4> errors{};
  for (std::size_t n = 0; n < sums.size(); ++n)
  {
    const Wrench &a = sums[n].contact, &b = truth[n].contact;
    const double size = glm::length(b.force);
    const double parts[2] = { glm::length(a.force - b.force) / size,
      glm::length(a.torque - b.torque) / (size * Radius) };
    for (int part = 0; part < 2; ++part)
    {
      errors[2 * part] += parts[part] * parts[part] / static_cast<double>(sums.size());
      errors[2 * part + 1] = std::max(errors[2 * part + 1], 100.0 * parts[part]);
    }
  }
  errors[0] = 100.0 * std::sqrt(errors[0]);
  errors[2] = 100.0 * std::sqrt(errors[2]);
  return errors;
}

Times ReportErrors(const char* what, const PointShell& shell, const std::vector<RigidPose>& poses,
  const DistanceMap& map, int rounds)
{
  const Times times = TimeLevels(shell, ContactTerms::Matrix, poses, map, rounds);
  const ContactKernels& kernels = FastestContactKernels();
  const int last = shell.Levels() - 1;
  const auto feel = [&](int level)
  { return FeelAll(kernels, ContactTerms::Matrix, Upto(shell, level), poses, map); };
  const std::vector<ContactSums> truth = feel(last);
  std::printf("%s: gradient + 6x6\n  %8s %12s %12s   %s\n", what, "points", "scalar us",
    kernels.name, "force error rms, max | torque rms, max, %");
  for (int level = 0; level <= last; ++level)
  {
    const std::array<double, 4> e = ErrorsOf(feel(level), truth);
    std::printf("  %8u %12.1f %12.1f   %12.2f %8.2f | %8.2f %8.2f\n", shell.LevelEnd(level),
      times[level][0], times[level][1], e[0], e[1], e[2], e[3]);
  }
  return times;
}

/// How many levels more the fastest kernel allows than one point after the other.
void ReportLevels(const PointShell& shell, const Times& times)
{
  std::vector<std::uint32_t> points;
  for (int level = 0; level < shell.Levels(); ++level)
    points.push_back(shell.LevelEnd(level) - (level > 0 ? shell.LevelEnd(level - 1) : 0));
  const auto settled = [&](int k, double budgetUs)
  {
    CostModel model({ .firstUsPerPoint = times.back()[k] / shell.LevelEnd(shell.Levels() - 1) });
    int levels = 0;
    for (int tick = 0; tick <= shell.Levels(); ++tick)
      levels = model.Levels(points, budgetUs);
    return levels;
  };
  std::printf("levels in a budget:   us  scalar  %s\n", FastestContactKernels().name);
  for (const double budgetUs : { 25.0, 50.0, 100.0, 200.0, 400.0, 800.0 })
    std::printf(
      "                   %5.0f  %6d  %4d\n", budgetUs, settled(0, budgetUs), settled(1, budgetUs));
}

void ReportSnap(const GridView<const float>& body, const DistanceMap& map, int points, int rounds)
{
  // The part that fits: the same surface, looking the other way.
  const auto same = PointShell::OfSurface(body, glm::dvec3(0.0), { .points = points });
  std::vector<SurfacePoint> turned;
  for (const ContactPoints& run : Upto(*same, same->Levels() - 1))
    for (std::uint32_t n = 0; n < run.count; ++n)
      if (run.x[n] != ContactPoints::FarAway)
        turned.push_back(
          { { run.x[n], run.y[n], run.z[n] }, { -run.nx[n], -run.ny[n], -run.nz[n] } });
  const auto shell =
    PointShell::OfPoints(turned, same->SurfaceArea(), glm::dvec3(0.0), { .points = points });
  const std::vector<RigidPose> poses = FitPoses();
  const int last = shell->Levels() - 1;
  const Times times = TimeLevels(*shell, ContactTerms::Snap, poses, map, rounds);
  const ContactSums one =
    FeelAll(FastestContactKernels(), ContactTerms::Snap, Upto(*shell, last), { poses[0] }, map)[0];
  std::printf("snap: %d points, %.0f%% of the area in contact, %.0f%% attracted: %.1f us a tick, "
              "one by one %.1f us\n",
    points, 100.0 * one.contactArea / shell->SurfaceArea(),
    100.0 * one.attractedArea / shell->SurfaceArea(), times[last][1], times[last][0]);
}

/// Ticks of a shell that trembles by 0.1 mm as a hand does, all its points or what the coarse phase
/// leaves of them.
class Trembling
{
public:
  Trembling(std::shared_ptr<const PointShell> shell, std::shared_ptr<const DistanceMap> map)
    : Shell(std::move(shell)),
      Map(std::move(map)),
      Coarse(this->Shell, this->Map),
      All(Upto(*this->Shell, this->Shell->Levels() - 1))
  {
  }
  void Report(const char* what, double apart, int rounds)
  {
    std::vector<RigidPose> poses;
    for (int tick = 0; tick < Ticks; ++tick)
    {
      const double a = 0.06 * tick; // 9.5 Hz at 1 kHz
      poses.push_back({ { apart + 0.1 * std::sin(a), 0.1 * std::cos(a), 0.0 },
        TurnBy({ 0.0, 0.0, 3.0 + 0.001 * std::sin(a) }) });
    }
    double least[2] = { 1e300, 1e300 };
    ContactSums sums[2];
    for (int round = 0; round < rounds; ++round)
      for (int coarse = 0; coarse < 2; ++coarse)
      {
        sums[coarse] = {};
        const double start = CpuMicroseconds();
        for (const RigidPose& pose : poses)
          this->Tick(pose, coarse == 1, sums[coarse]);
        least[coarse] = std::min(least[coarse], (CpuMicroseconds() - start) / Ticks);
      }
    std::printf("  %-10s %8u %8.2f %8.2f %7.1f x   %.0e\n", what, sums[0].contacts / Ticks,
      least[0], least[1], least[0] / least[1],
      glm::length(sums[1].contact.force - sums[0].contact.force) /
        std::max(glm::length(sums[0].contact.force), 1e-9));
  }

private:
  static constexpr int Ticks = 200;

  void Tick(const RigidPose& pose, bool coarse, ContactSums& sums)
  {
    const auto feel = [&](std::span<const ContactPoints> runs)
    { this->Kernels[ContactTerms::Matrix](runs, { pose }, this->Map->View(), {}, sums); };
    if (!coarse)
      return feel(this->All);
    this->Coarse.Begin(pose, 0.0);
    this->Near.clear();
    for (int level = 0; level < this->Shell->Levels(); ++level)
      for (ContactPoints run : this->Coarse.Near(level))
      {
        run.area = this->All[0].area;
        this->Near.push_back(run);
      }
    feel(this->Near);
  }

  std::shared_ptr<const PointShell> Shell;
  std::shared_ptr<const DistanceMap> Map;
  CoarsePhase Coarse;
  std::vector<ContactPoints> All, Near;
  const ContactKernels& Kernels = FastestContactKernels();
};

} // namespace

int main(int argc, char** argv)
{
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 15;
  if (rounds < 1)
  {
    std::fprintf(stderr, "rounds must be at least 1\n");
    return 1;
  }
  const hasp::testing::SampledDistance body = RoughBall();
  const auto mapOfBody = std::make_shared<const DistanceMap>(body.View());
  const DistanceMap& map = *mapOfBody;
  const auto shell = PointShell::OfSurface(body.View(), glm::dvec3(0.0));
  const Times times = ReportErrors("fit", *shell, FitPoses(), map, rounds);
  ReportErrors("press", *shell, PressPoses(), map, rounds);
  ReportLevels(*shell, times);
  ReportSnap(body.View(), map, 5'000, rounds);
  ReportSnap(body.View(), map, 50'000, rounds);
  Trembling shells(
    PointShell::OfSurface(body.View(), glm::dvec3(0.0), { .points = 20'000 }), mapOfBody);
  std::printf("20,000 points, %s: contacts, us without and with the coarse phase; difference\n",
    FastestContactKernels().name);
  shells.Report("separated", 2.0 * Radius + 20.0, rounds);
  shells.Report("2 mm off", 2.0 * Radius + 2.0, rounds);
  shells.Report("touching", 2.0 * Radius - 1.0, rounds);
  shells.Report("pressed", 2.0 * Radius - 5.0, rounds);
  shells.Report("inside", 0.5, rounds);
  return 0;
}
