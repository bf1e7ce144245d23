#pragma once
#include "Realtime/RateMonitor.h"

#include <atomic>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace hasp
{

/// What a tick is told.
struct LoopTick
{
  std::uint64_t number = 0;  ///< 0, 1, 2, … : ticks that were made
  std::int64_t dueNs = 0;    ///< the period's beginning, on the clock
  std::int64_t nowNs = 0;    ///< when the tick started: dueNs, or up to a period later
  std::uint64_t skipped = 0; ///< periods since the tick before that had none
};

/// What a loop needs of a clock. A test has its own, of virtual time.
template <class Clock>
concept LoopClock = requires(Clock& clock, std::int64_t ns)
{
  {
    clock.NowNs()
  }
  noexcept->std::same_as<std::int64_t>;
  {
    clock.CpuNs()
  }
  noexcept->std::same_as<std::int64_t>; ///< that this thread has used
  {
    clock.SleepUntil(ns)
  }
  noexcept;
};

/// Calls tick once a period, on an absolute clock, until it returns false or `stop` is set.
///
/// The beginnings of periods lie at start + n * periodNs, n = 1, 2, …, and never drift. A period
/// whose beginning has passed by a whole period or more when its tick could start is skipped: the
/// tick that comes next is that of the period that is running. So there is never more than one tick
/// a period, and never a burst.
///
/// tick: bool(const LoopTick&) noexcept. It should use the nominal period for what it integrates,
/// and nowNs for nothing but the filtering of velocities.
/// spent: void(std::int64_t costNs, std::int64_t passedNs) noexcept, called after each tick with
/// its CPU time and the time since the tick before began. `overrunShare` of a period: a tick that
/// costs more is counted as an overrun.
/// Threads: the caller's; `monitor` may be read by others meanwhile. Takes no memory, no lock.
template <LoopClock Clock, class Tick, class Spent>
void RunPeriods(Clock& clock, std::int64_t periodNs, double overrunShare, RateMonitor& monitor,
  const std::atomic<bool>& stop, Tick& tick, Spent& spent) noexcept
{
  static_assert(std::is_nothrow_invocable_r_v<bool, Tick&, const LoopTick&>, "a tick is noexcept");
  static_assert(std::is_nothrow_invocable_v<Spent&, std::int64_t, std::int64_t>);
  const auto overrunNs = static_cast<std::int64_t>(overrunShare * static_cast<double>(periodNs));
  std::int64_t beforeNs = clock.NowNs();
  LoopTick next{ .dueNs = beforeNs + periodNs };
  for (bool first = true; !stop.load(std::memory_order_relaxed); first = false)
  {
    clock.SleepUntil(next.dueNs);
    if (stop.load(std::memory_order_relaxed))
      return;
    next.nowNs = clock.NowNs();
    const std::int64_t late = next.nowNs > next.dueNs ? (next.nowNs - next.dueNs) / periodNs : 0;
    next.skipped = static_cast<std::uint64_t>(late);
    next.dueNs += late * periodNs;

    const std::int64_t cpuNs = clock.CpuNs();
    const bool goOn = tick(static_cast<const LoopTick&>(next));
    const std::int64_t costNs = clock.CpuNs() - cpuNs, passedNs = next.nowNs - beforeNs;
    monitor.Add({ first ? -1 : passedNs, next.nowNs - next.dueNs + late * periodNs, costNs,
      next.skipped, costNs > overrunNs });
    spent(costNs, passedNs);
    if (!goOn)
      return;
    beforeNs = next.nowNs;
    next.dueNs += periodNs;
    ++next.number;
  }
}

} // namespace hasp
