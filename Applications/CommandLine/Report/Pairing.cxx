#include "Pairing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <string>

namespace hasp
{

Timing TimeOf(const std::function<void()>& work)
{
  const auto wall = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock(); // of the process: all threads
  work();
  const std::clock_t cpuEnd = std::clock();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - wall;
  return { spent.count(), static_cast<double>(cpuEnd - cpu) / CLOCKS_PER_SEC };
}

Timing ThreadTimeOf(const std::function<void()>& work)
{
  const auto cpuS = []
  {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  const auto wall = std::chrono::steady_clock::now();
  const double cpu = cpuS();
  work();
  const double spent = cpuS() - cpu;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - wall;
  return { passed.count(), spent };
}

Quartiles QuartilesOf(std::vector<double> figures)
{
  if (figures.empty())
    throw std::invalid_argument("quartiles: no figures, must be at least 1");
  std::sort(figures.begin(), figures.end());
  const auto rank = [&](double share)
  {
    const double position = share * static_cast<double>(figures.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, figures.size() - 1);
    return std::lerp(figures[below], figures[above], position - static_cast<double>(below));
  };
  return { rank(0.25), rank(0.5), rank(0.75) };
}

namespace
{

Timing MedianOf(const std::vector<Timing>& runs)
{
  std::vector<double> wall, cpu;
  for (const Timing& run : runs)
  {
    wall.push_back(run.wallS);
    cpu.push_back(run.cpuS);
  }
  return { QuartilesOf(wall).median, QuartilesOf(cpu).median };
}

/// A run shorter than the CPU clock's tick has no CPU ratio; 1 would be a lie and 0/0 is none.
Quartiles CpuRatios(const std::vector<Timing>& a, const std::vector<Timing>& b)
{
  std::vector<double> ratios;
  for (std::size_t p = 0; p < a.size(); ++p)
    if (b[p].cpuS > 0.0)
      ratios.push_back(a[p].cpuS / b[p].cpuS);
  const double none = std::nan("");
  return ratios.empty() ? Quartiles{ none, none, none } : QuartilesOf(ratios);
}

} // namespace

PairedTimes ComparePairs(
  const std::function<Timing()>& a, const std::function<Timing()>& b, const PairSettings& settings)
{
  if (settings.pairs < 9)
    throw std::invalid_argument(
      "pairing: " + std::to_string(settings.pairs) + " pairs, must be at least 9");
  if (settings.warmUps < 1)
    throw std::invalid_argument(
      "pairing: " + std::to_string(settings.warmUps) + " warm-ups, must be at least 1");
  std::vector<Timing> runsA, runsB;
  std::vector<double> ratios;
  for (int p = -settings.warmUps; p < settings.pairs; ++p)
  {
    const Timing runA = a();
    const Timing runB = b();
    if (p < 0)
      continue;
    if (!(runB.wallS > 0.0))
      throw std::runtime_error("pairing: a run took no measurable time; repeat the work inside it");
    runsA.push_back(runA);
    runsB.push_back(runB);
    ratios.push_back(runA.wallS / runB.wallS);
  }
  return { QuartilesOf(ratios), CpuRatios(runsA, runsB), MedianOf(runsA), MedianOf(runsB),
    settings.pairs };
}

} // namespace hasp
