#include "Realtime/PeriodicLoop.h"
#include "Realtime/RealTimeScheduling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

namespace
{

using namespace hasp;

constexpr std::int64_t Us = 1000, Ms = 1'000'000;

/// Time passes only where the test says so: late wake-ups, and what ticks take.
struct VirtualClock
{
  std::int64_t now = 5 * Ms, cpu = 0;
  std::function<std::int64_t()> lateNs = [] { return std::int64_t(0); };

  std::int64_t NowNs() noexcept { return this->now; }
  std::int64_t CpuNs() noexcept { return this->cpu; }
  void SleepUntil(std::int64_t ns) noexcept
  {
    this->now = std::max(this->now, ns) + this->lateNs();
  }
  void Take(std::int64_t ns) { this->now += ns, this->cpu += ns; }
};

struct Course
{
  std::vector<LoopTick> ticks;
  RateCounts rates;
};

/// `count` ticks of 1 ms, each of which takes what `tickNs` says.
Course RunTicks(VirtualClock& clock, std::size_t count, const std::function<std::int64_t()>& tickNs)
{
  Course run;
  run.ticks.reserve(count);
  RateMonitor monitor;
  const std::atomic<bool> stop{ false };
  auto tick = [&](const LoopTick& t) noexcept
  {
    run.ticks.push_back(t);
    clock.Take(tickNs());
    return run.ticks.size() < count;
  };
  auto spent = [](std::int64_t, std::int64_t) noexcept {};
  RunPeriods(clock, Ms, 0.8, monitor, stop, tick, spent);
  run.rates = monitor.Read();
  return run;
}

TEST(PeriodicLoop, KeepsToItsPeriodsAndDoesNotDrift)
{
  VirtualClock clock;
  clock.lateNs = [] { return 70 * Us; };
  const Course run = RunTicks(clock, 2000, [] { return 300 * Us; });
  ASSERT_EQ(run.ticks.size(), 2000u);
  for (std::size_t n = 0; n < run.ticks.size(); ++n)
  {
    EXPECT_EQ(run.ticks[n].number, n);
    EXPECT_EQ(run.ticks[n].dueNs, 5 * Ms + static_cast<std::int64_t>(n + 1) * Ms);
    EXPECT_EQ(run.ticks[n].nowNs, run.ticks[n].dueNs + 70 * Us);
    EXPECT_EQ(run.ticks[n].skipped, 0u);
  }
  EXPECT_EQ(run.rates.period.total, 1999u);
  EXPECT_EQ(run.rates.period.leastNs, Ms);
  EXPECT_EQ(run.rates.period.mostNs, Ms);
  EXPECT_EQ(run.rates.lateness.mostNs, 70 * Us);
  EXPECT_EQ(run.rates.cost.mostNs, 300 * Us);
  EXPECT_EQ(run.rates.skipped + run.rates.overruns, 0u);
}

TEST(PeriodicLoop, SkipsWholePeriodsAndNeverBursts)
{
  VirtualClock clock;
  int tick = 0;
  // The fifth tick takes 3.3 ms: the periods that begin at 6, 7 and 8 ms are over or running.
  const Course run = RunTicks(clock, 8, [&] { return ++tick == 5 ? 3300 * Us : 10 * Us; });
  const std::int64_t due[] = { 1, 2, 3, 4, 5, 8, 9, 10 };
  for (std::size_t n = 0; n < 8; ++n)
    EXPECT_EQ(run.ticks[n].dueNs, 5 * Ms + due[n] * Ms) << n;
  EXPECT_EQ(run.ticks[5].nowNs, 5 * Ms + 8300 * Us) << "at once, in the period that runs";
  EXPECT_EQ(run.ticks[5].skipped, 2u);
  EXPECT_EQ(run.ticks[5].number, 5u);
  EXPECT_EQ(run.ticks[6].skipped, 0u);
  EXPECT_EQ(run.rates.skipped, 2u);
  EXPECT_EQ(run.rates.overruns, 1u);
  EXPECT_EQ(run.rates.lateness.mostNs, 2300 * Us) << "since its first chance";
}

/// Whatever lateness and cost: one tick a period at most, none early, and each period is either
/// ticked or counted as skipped.
TEST(PeriodicLoop, AnyDelayLeavesAtMostOneTickAPeriod)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    std::mt19937_64 random(seed);
    const auto tail = [&random] // mostly microseconds, now and then some milliseconds
    {
      return static_cast<std::int64_t>(
        random() % 100 < 95 ? random() % (50 * Us) : random() % (9 * Ms));
    };
    VirtualClock clock;
    clock.lateNs = tail;
    const Course run = RunTicks(clock, 3000, tail);
    std::int64_t due = 5 * Ms;
    std::uint64_t skipped = 0;
    for (const LoopTick& tick : run.ticks)
    {
      EXPECT_EQ(tick.dueNs - due, static_cast<std::int64_t>(1 + tick.skipped) * Ms);
      EXPECT_GE(tick.nowNs, tick.dueNs);
      EXPECT_LT(tick.nowNs, tick.dueNs + Ms);
      due = tick.dueNs;
      skipped += tick.skipped;
    }
    EXPECT_EQ(run.rates.skipped, skipped);
    EXPECT_GT(skipped, 100u) << "else this tried nothing";
  }
}

TEST(PeriodicLoop, AnHourOfSuspendIsOneLateTick)
{
  VirtualClock clock;
  int sleeps = 0;
  clock.lateNs = [&] { return ++sleeps == 3 ? 3'600'000 * Ms : 0; };
  const Course run = RunTicks(clock, 5, [] { return std::int64_t(0); });
  EXPECT_EQ(run.ticks[2].skipped, 3'600'000u);
  EXPECT_EQ(run.ticks[3].dueNs - run.ticks[2].dueNs, Ms);
  EXPECT_EQ(run.ticks[3].nowNs, run.ticks[3].dueNs) << "on time again";
}

TEST(PeriodicLoop, StopEndsItBeforeTheNextTick)
{
  VirtualClock clock;
  RateMonitor monitor;
  std::atomic<bool> stop{ false };
  int ticks = 0;
  auto tick = [&](const LoopTick&) noexcept { return stop = ++ticks == 3, true; };
  auto spent = [](std::int64_t, std::int64_t) noexcept {};
  RunPeriods(clock, Ms, 0.8, monitor, stop, tick, spent);
  EXPECT_EQ(ticks, 3);
  RunPeriods(clock, Ms, 0.8, monitor, stop, tick, spent);
  EXPECT_EQ(ticks, 3) << "set before it began";
}

TEST(CpuBudget, ForgivesSingleOverrunsAndEndsARunOfThem)
{
  CpuBudget single(0.8, 50 * Ms);
  for (int tick = 0; tick < 100'000; ++tick) // 5 ms of each 50: a long way below the share
    ASSERT_TRUE(single.Spend(tick % 50 == 0 ? 5 * Ms : 0, Ms)) << tick;

  CpuBudget run(0.8, 50 * Ms);
  int ticks = 0;
  while (run.Spend(95 * Ms / 100, Ms)) // 0.15 ms too much each
    ++ticks;
  EXPECT_NEAR(ticks, 50.0 / 0.15, 1.0) << "rounding decides about the last one";

  CpuBudget just(0.8, 50 * Ms);
  for (int tick = 0; tick < 100'000; ++tick)
    ASSERT_TRUE(just.Spend(79 * Ms / 100, Ms));
}

} // namespace
