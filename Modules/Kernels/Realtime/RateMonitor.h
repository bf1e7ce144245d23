#pragma once
#include "Realtime/NanosecondHistogram.h"

#include <atomic>
#include <cstdint>

namespace hasp
{

/// One tick of a loop, as it went.
struct TickTimes
{
  std::int64_t periodNs = -1;  ///< from the start of the tick before; < 0 for the first one
  std::int64_t latenessNs = 0; ///< from when it was due to when it started
  std::int64_t costNs = 0;     ///< CPU time of the thread in it
  std::uint64_t skipped = 0;   ///< periods that went by without a tick, before it
  bool overrun = false;        ///< cost more than its share of a period
};

/// What RateMonitor held at one moment. 24 KiB; plain.
struct RateCounts
{
  NanosecondCounts period, lateness, cost;
  std::uint64_t ticks = 0, skipped = 0, overruns = 0;

  /// Of `earlier` from the same monitor: the last second, say.
  RateCounts Since(const RateCounts& earlier) const noexcept;
};

/// How regular a loop is: nothing that went wrong is lost in a mean.
///
/// Threads: Add on the loop's (HAPTIC), Read on any other at any time; neither waits. Fixed memory,
/// 24 KiB. Cost: about 15 ns an Add, 12 us a Read.
class RateMonitor
{
public:
  void Add(const TickTimes& tick) noexcept;
  RateCounts Read() const noexcept;

private:
  NanosecondHistogram Period, Lateness, Cost;
  std::atomic<std::uint64_t> Ticks{ 0 }, Skipped{ 0 }, Overruns{ 0 };
};

} // namespace hasp
