#pragma once
#include "Devices/HapticDevice.h"
#include "Realtime/ForceLimiter.h"
#include "Realtime/Watchdog.h"

namespace hasp
{

struct ForceGateSettings
{
  WatchdogSettings watchdog{};  ///< how long a wrench is good for
  double forceSlew = 2000.0;    ///< N/s; > 0
  double torqueSlew = 60'000.0; ///< N mm/s; > 0
  double rampInS = 0.5; ///< until all force is let through again, after there was none; >= 0
};

/// The one way to motors, for every driver: what HAPTIC wants goes in, what a hand may feel comes
/// out.
///
/// Zero, at once: while the device is not homed or not there, for what is not finite, and where
/// nobody has said a new wrench for staleNs + rampNs (evenly less from staleNs on). Else no more
/// than the profile's peaks, by length, so that directions stay; it grows by no more than the slew
/// and, after it was zero for one of these reasons or in the beginning, over rampInS. A force may
/// shrink at once.
///
/// Time is passed in. Threads: one, the driver's; no memory, no lock, nothing throws once made.
class ForceGate
{
public:
  /// Throws std::invalid_argument as ValidateDeviceProfile, Watchdog and ForceLimiter do.
  explicit ForceGate(const DeviceProfile& profile, const ForceGateSettings& settings = {});

  /// A new wrench, device axes.
  void Want(const Wrench& wrench, std::int64_t nowNs) noexcept;
  /// What the motors get at `nowNs`; `ready`: the device is there, homed and sane.
  Wrench At(std::int64_t nowNs, bool ready) noexcept;

  const WatchdogCounts& Counts() const noexcept { return this->Dog.Counts(); }

private:
  DeviceProfile Of;
  Watchdog Dog;
  ForceLimiter Limiter;
  std::int64_t BeforeNs = 0;
  bool Any = false;
};

} // namespace hasp
