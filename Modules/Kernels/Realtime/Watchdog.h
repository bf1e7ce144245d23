#pragma once
#include <array>
#include <cstdint>

namespace hasp
{

/// A wrench as numbers: force N, then torque N mm.
using ForceNumbers = std::array<double, 6>;

struct WatchdogSettings
{
  std::int64_t staleNs = 20'000'000; ///< a wrench is good for so long; in (0, 1 s]
  std::int64_t rampNs = 20'000'000;  ///< then it goes down to zero, evenly; in [0, 1 s]
};

enum class WatchdogState
{
  Waiting,   ///< no wrench yet: zero
  Fresh,     ///< out as it came
  Ramping,   ///< too old: less and less of it
  Silent,    ///< older still: zero
  NotFinite, ///< the newest wrench was none: zero
  Unplugged  ///< zero, at once
};

struct WatchedForce
{
  ForceNumbers force{}; ///< finite, whatever came in
  WatchdogState state = WatchdogState::Waiting;
};

/// What of a wrench that came at `freshNs` may go out at `nowNs`: all of it for staleNs, then
/// evenly less until it is zero rampNs later, and zero from there on. One zero for all six if one
/// of them is NaN or infinite, or if the device is not plugged in. A clock that was set back more
/// than staleNs gives zero, too.
/// A pure function: no clock is asked, so virtual time is as good as any. Any thread.
WatchedForce Watch(const WatchdogSettings& settings, std::int64_t nowNs, std::int64_t freshNs,
  bool plugged, const ForceNumbers& force) noexcept;

/// What went wrong so far.
struct WatchdogCounts
{
  std::uint64_t notFinite = 0; ///< wrenches that were none
  std::uint64_t ramps = 0;     ///< times that a wrench grew too old
};

/// The last gate before a device's motors: Watch, with the newest wrench kept. It only ever takes
/// force away at once or evenly; bringing it back gently is the force limiter's part.
///
/// Threads: one, the one that writes to the device. HAPTIC may be it: no memory, no lock.
class Watchdog
{
public:
  /// Throws std::invalid_argument if a setting is out of its range.
  explicit Watchdog(const WatchdogSettings& settings = {});

  /// A wrench that was computed for `nowNs`.
  void Feed(std::int64_t nowNs, const ForceNumbers& force) noexcept;

  /// What the motors get at `nowNs`. Once `plugged` was false, a wrench fed before that never
  /// comes back.
  WatchedForce At(std::int64_t nowNs, bool plugged) noexcept;

  const WatchdogCounts& Counts() const noexcept { return this->Seen; }

private:
  WatchdogSettings Settings;
  ForceNumbers Force{};
  std::int64_t FreshNs = 0;
  WatchdogState Last = WatchdogState::Waiting; ///< of the last At; Waiting: nothing to give
  bool Any = false;
  WatchdogCounts Seen;
};

} // namespace hasp
