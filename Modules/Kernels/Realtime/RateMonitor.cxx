#include "Realtime/RateMonitor.h"

namespace hasp
{

namespace
{
constexpr auto relaxed = std::memory_order_relaxed;

void Grow(std::atomic<std::uint64_t>& count, std::uint64_t by) noexcept
{
  count.store(count.load(relaxed) + by, relaxed); // one thread adds
}
} // namespace

void RateMonitor::Add(const TickTimes& tick) noexcept
{
  if (tick.periodNs >= 0)
    this->Period.Add(tick.periodNs);
  this->Lateness.Add(tick.latenessNs);
  this->Cost.Add(tick.costNs);
  Grow(this->Ticks, 1);
  Grow(this->Skipped, tick.skipped);
  Grow(this->Overruns, tick.overrun ? 1 : 0);
}

RateCounts RateMonitor::Read() const noexcept
{
  return { this->Period.Read(), this->Lateness.Read(), this->Cost.Read(), this->Ticks.load(relaxed),
    this->Skipped.load(relaxed), this->Overruns.load(relaxed) };
}

RateCounts RateCounts::Since(const RateCounts& earlier) const noexcept
{
  return { this->period.Since(earlier.period), this->lateness.Since(earlier.lateness),
    this->cost.Since(earlier.cost), this->ticks - earlier.ticks, this->skipped - earlier.skipped,
    this->overruns - earlier.overruns };
}

} // namespace hasp
