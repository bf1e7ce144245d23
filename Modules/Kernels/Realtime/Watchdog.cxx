#include "Realtime/Watchdog.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr std::int64_t MostNs = 1'000'000'000;

bool Finite(const ForceNumbers& force) noexcept
{
  return std::all_of(force.begin(), force.end(), [](double f) { return std::isfinite(f); });
}

void Check(const char* what, std::int64_t ns, std::int64_t leastNs)
{
  if (ns < leastNs || ns > MostNs)
    throw std::invalid_argument(std::string("watchdog: ") + what + " is " + std::to_string(ns) +
                                " ns, must be in [" + std::to_string(leastNs) + ", " +
                                std::to_string(MostNs) + "]");
}
} // namespace

WatchedForce Watch(const WatchdogSettings& settings, std::int64_t nowNs, std::int64_t freshNs,
  bool plugged, const ForceNumbers& force) noexcept
{
  if (!plugged)
    return { {}, WatchdogState::Unplugged };
  if (!Finite(force))
    return { {}, WatchdogState::NotFinite };
  // Doubles: the difference of any two times fits, and 20 ms are exact.
  const double ageNs = static_cast<double>(nowNs) - static_cast<double>(freshNs);
  const auto staleNs = static_cast<double>(settings.staleNs),
             rampNs = static_cast<double>(settings.rampNs);
  if (std::abs(ageNs) <= staleNs)
    return { force, WatchdogState::Fresh };
  if (ageNs < 0.0 || ageNs >= staleNs + rampNs)
    return { {}, WatchdogState::Silent };
  const double share = 1.0 - (ageNs - staleNs) / rampNs;
  ForceNumbers less = force;
  for (double& f : less)
    f *= share;
  return { less, WatchdogState::Ramping };
}

Watchdog::Watchdog(const WatchdogSettings& settings) : Settings(settings)
{
  Check("staleNs", settings.staleNs, 1);
  Check("rampNs", settings.rampNs, 0);
}

void Watchdog::Feed(std::int64_t nowNs, const ForceNumbers& force) noexcept
{
  this->Force = force;
  this->FreshNs = nowNs;
  this->Any = true;
  this->Seen.notFinite += !Finite(force);
}

WatchedForce Watchdog::At(std::int64_t nowNs, bool plugged) noexcept
{
  WatchedForce out;
  if (!plugged)
  {
    this->Any = false;
    out.state = WatchdogState::Unplugged;
  }
  else if (this->Any)
    out = Watch(this->Settings, nowNs, this->FreshNs, true, this->Force);
  const auto stale = [](WatchdogState s)
  { return s == WatchdogState::Ramping || s == WatchdogState::Silent; };
  this->Seen.ramps += stale(out.state) && !stale(this->Last);
  this->Last = out.state;
  return out;
}

} // namespace hasp
