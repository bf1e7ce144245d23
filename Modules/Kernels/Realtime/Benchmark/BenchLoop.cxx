// How regular a loop of 1 kHz is on this machine: an empty one beside one that works 0.3 ms a tick,
// with normal and with real-time scheduling, alone and while all cores stream memory. Microseconds;
// then the periods, as shares of all ticks. What a virtual machine's host takes shows in the last
// percentiles of the empty loop: compare the others with it.
//
//   bin/BenchKernelLoop [seconds a row: 3]
#include "Realtime/LoopThread.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace
{

using namespace hasp;

/// Every core but for what the loop takes of it: memory and arithmetic.
class Load
{
public:
  explicit Load(unsigned cores)
  {
    for (unsigned n = 0; n < cores; ++n)
      this->Threads.emplace_back(
        [](const std::stop_token& stop)
        {
          std::vector<double> stream(std::size_t(8) << 20, 2.0); // 64 MiB
          while (!stop.stop_requested())
            for (std::size_t at = 0; at < stream.size() && !stop.stop_requested(); ++at)
              stream[at] = std::sqrt(stream[at] + static_cast<double>(at));
        });
  }

private:
  std::vector<std::jthread> Threads;
};

struct Row
{
  std::string name;
  RateCounts rates;
  bool dropped = false;
};

Row Measure(const char* name, bool realTime, bool loaded, std::int64_t workNs, double seconds)
{
  const Load load(loaded ? std::max(1u, std::thread::hardware_concurrency()) : 0);
  LoopSettings settings;
  if (!realTime)
    settings.scheduling = {
      .fifoPriority = 0, .exactTimer = false, .flushDenormals = false, .lock = MemoryLocking::None
    };
  LoopThread loop;
  const SchedulingReport got = loop.Start(settings,
    [workNs, left = static_cast<std::uint64_t>(1000.0 * seconds)](const LoopTick& tick) noexcept
    {
      MonotonicClock clock;
      if (workNs > 0)
        for (const std::int64_t until = clock.CpuNs() + workNs; clock.CpuNs() < until;)
        {
        }
      return tick.number + 1 < left;
    });
  for (const std::string& text : got.Shortfalls())
    std::printf("  (%s: %s)\n", name, text.c_str());
  while (loop.Running())
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  loop.Stop();
  return { name, loop.Rates(), loop.Dropped() };
}

void Print(const std::vector<Row>& rows)
{
  std::printf("\n%-34s %8s %8s %8s %9s %8s %8s %8s\n", "us", "late p50", "p99", "p99.9", "most",
    "cost p50", "p99", "skipped");
  for (const Row& row : rows)
  {
    const NanosecondCounts &late = row.rates.lateness, &cost = row.rates.cost;
    std::printf("%-34s %8.1f %8.1f %8.1f %9.1f %8.1f %8.1f %8llu%s\n", row.name.c_str(),
      1e-3 * late.PercentileNs(0.5), 1e-3 * late.PercentileNs(0.99),
      1e-3 * late.PercentileNs(0.999), 1e-3 * static_cast<double>(late.mostNs),
      1e-3 * cost.PercentileNs(0.5), 1e-3 * cost.PercentileNs(0.99),
      static_cast<unsigned long long>(row.rates.skipped),
      row.dropped ? "  lost real-time scheduling" : "");
  }
  constexpr std::array<double, 7> EdgesMs = { 0.5, 0.9, 0.98, 1.02, 1.1, 2.0, 10.0 };
  std::printf("\n%-34s", "periods, ms: % of ticks");
  for (const double edge : EdgesMs)
    std::printf("   < %4.2f", edge);
  std::printf(" %8s\n", "more");
  for (const Row& row : rows)
  {
    const NanosecondCounts& period = row.rates.period;
    std::printf("%-34s", row.name.c_str());
    std::uint64_t above = period.total;
    for (const double edge : EdgesMs)
    {
      const std::uint64_t over = period.Above(static_cast<std::int64_t>(1e6 * edge));
      std::printf(
        " %8.3f", 100.0 * static_cast<double>(above - over) / static_cast<double>(period.total));
      above = over;
    }
    std::printf(" %8.3f\n", 100.0 * static_cast<double>(above) / static_cast<double>(period.total));
  }
}

} // namespace

int main(int argc, char** argv)
{
  const double seconds = std::clamp(argc > 1 ? std::atof(argv[1]) : 3.0, 0.1, 3600.0);
  constexpr std::int64_t WorkNs = 300'000;
  std::vector<Row> rows;
  rows.push_back(Measure("normal, idle, empty", false, false, 0, seconds));
  rows.push_back(Measure("normal, idle, 0.3 ms", false, false, WorkNs, seconds));
  rows.push_back(Measure("normal, all cores loaded, empty", false, true, 0, seconds));
  rows.push_back(Measure("normal, all cores loaded, 0.3 ms", false, true, WorkNs, seconds));
  rows.push_back(Measure("real time, idle, empty", true, false, 0, seconds));
  rows.push_back(Measure("real time, idle, 0.3 ms", true, false, WorkNs, seconds));
  rows.push_back(Measure("real time, all loaded, empty", true, true, 0, seconds));
  rows.push_back(Measure("real time, all loaded, 0.3 ms", true, true, WorkNs, seconds));
  Print(rows);
}
