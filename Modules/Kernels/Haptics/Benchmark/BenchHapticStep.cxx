// What a whole tick costs: coarse phase, contact with its matrix, coupling, limits. A bumpy ball's
// shell pressed on its own surface in a map of 128^3, half of the points in contact, all levels.
// Usage: BenchKernelHapticStep [ticks, default 300]. CPU time of this thread; the best tick, the
// median and the slowest of a hundred.
#include "Haptics/HapticStep.h"
#include "Haptics/Solve6.h"
#include "Testing/SampledDistance.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <vector>

namespace
{

using namespace hasp;

double CpuUs()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

struct Measured
{
  double best, median, slow, pointsPerTick, evaluations;
};

Measured Time(HapticStep& step, int ticks)
{
  std::vector<double> us;
  double points = 0.0, evaluations = 0.0;
  for (int n = 0; n < ticks; ++n)
  {
    // A hand that trembles by 0.02 mm: nothing sleeps, and a tick moves as far as a hand does.
    const double sway = 0.02 * std::sin(0.06 * n);
    const RigidPose device{ { sway, 0.7 * sway, -0.5 * sway },
      TurnBy(glm::dvec3(0.0, 0.0, 0.002 * sway)) };
    const double before = CpuUs();
    const HapticTick tick = step.Tick(device);
    us.push_back(CpuUs() - before);
    points += tick.points;
    evaluations += tick.evaluations;
  }
  std::sort(us.begin(), us.end());
  return { us.front(), us[us.size() / 2], us[us.size() * 99 / 100], points / ticks,
    evaluations / ticks };
}

void Report(const std::shared_ptr<const DistanceMap>& map, const GridView<const float>& body,
  int points, bool snap, int ticks)
{
  const auto shell = PointShell::OfSurface(body, {}, { .points = points });
  HapticStepSettings settings;
  settings.budgetUs = std::numeric_limits<double>::infinity();
  settings.contact = { .stiffness = 0.05F, .attraction = snap ? 0.001F : 0.0F };
  HapticStep step(settings);
  auto scene = std::make_unique<HapticScene>(
    std::vector<HapticShell>{ { shell, {} } }, std::vector<HapticBody>{ { map, {} } });
  step.Swap(scene);
  step.Place({});
  step.Attract(snap);
  Time(step, 200); // levels and fades are where they go
  const Measured m = Time(step, ticks);
  std::printf("%-9s %7d points: %8.1f us a tick (median %8.1f, p99 %8.1f), %.2f evaluations, "
              "%6.0f points evaluated per ms\n",
    snap ? "snap" : "contact", points, m.best, m.median, m.slow, m.evaluations,
    1000.0 * m.pointsPerTick / m.median);
}

} // namespace

int main(int argc, char** argv)
{
  const int ticks = argc > 1 ? std::max(10, std::atoi(argv[1])) : 300;
  const testing::SampledDistance body(testing::BumpyBall(45.0, 3.0), testing::CubeGrid(128));
  const auto map = std::make_shared<DistanceMap>(body.View());
  std::printf("kernels: %s\n", FastestContactKernels().name);
  for (const int points : { 1'000, 5'000, 20'000, 50'000, 100'000 })
    for (const bool snap : { false, true })
      Report(map, body.View(), points, snap, ticks);
  Symmetric6 matrix{};
  for (std::size_t i = 0; i < 6; ++i)
    matrix[UpperIndex(i, i)] = 1.0 + static_cast<double>(i);
  Vector6 x{ 1, 2, 3, 4, 5, 6 };
  const double before = CpuUs();
  for (int n = 0; n < 100'000; ++n)
    (void)Solve6(matrix, x, 1.0, x); // each needs the one before
  std::printf("solve: %.3f us\n", (CpuUs() - before) / 100'000);
  return 0;
}
