#pragma once
#include "Grid/FinitePose.h"

namespace hasp
{

struct ForceLimits
{
  double force = 8.0;           ///< N, by norm; >= 0
  double torque = 180.0;        ///< N mm, by norm; >= 0
  double forceSlew = 2000.0;    ///< N/s that a force may grow or turn by; > 0
  double torqueSlew = 60'000.0; ///< N mm/s; > 0
  double rampInS = 0.5;         ///< from Restart until all force is let through; >= 0
};

/// The last thing before a device: whatever comes in, what goes out is finite, within the limits by
/// norm (so that its direction is kept), grows no faster than the slew and begins at zero.
///
/// A force may always shrink at once: holding on to one that the contact no longer asks for would
/// push energy into the hand. A wrench that is not finite counts as no wrench.
/// Threads: one, HAPTIC once constructed; no memory; nothing throws.
class ForceLimiter
{
public:
  /// Throws std::invalid_argument with the value and its legal range.
  explicit ForceLimiter(const ForceLimits& limits = {});

  /// seconds: since the last call; >= 0. Not finite: as 0, so nothing grows.
  Wrench Limit(const Wrench& wanted, double seconds) noexcept;
  /// The next force grows from zero, over rampInS.
  void Restart() noexcept;
  const ForceLimits& Limits() const noexcept { return this->Settings; }

private:
  ForceLimits Settings;
  Wrench Last;
  double SinceS = 0.0;
};

} // namespace hasp
