#pragma once
#include "Haptics/ExplicitCoupling.h"
#include "Studies/HapticBench.h"

namespace hasp
{

/// One axis of hand, device and renderer, in contact, linear: what can be said of it without
/// running it. The transition of a whole tick (mechanics, sampling, delay, zero-order hold) is a
/// matrix; the loop settles if and only if its spectral radius is under 1.
struct SampledLoop
{
  double massKg = 0.17;
  double damping = 0.002;     ///< b + b_h, N s/mm
  double handStiffness = 0.1; ///< N/mm
  double tickS = 0.001;
  int delayTicks = 1;

  SampledLoop() = default;
  SampledLoop(const BenchDevice& device, const BenchHand& hand, const BenchClock& clock);

  /// Device on a sampled spring to ground (direct penalty; a quasi-static coupling in series with
  /// its contact).
  double SpringRadius(double stiffness) const;
  /// Device, explicit tool and contact.
  double ExplicitRadius(const ExplicitCouplingSettings& coupling, double contactStiffness) const;
  /// The stiffest spring whose radius is under 1, by bisection; N/mm.
  double CriticalSpring() const;
  /// The rule of thumb for the same: (b + b_h) / (T/2 + t_d).
  double FormulaSpring() const;
};

/// Two springs, end to end.
constexpr double SpringsInSeries(double a, double b)
{
  return a * b / (a + b);
}

} // namespace hasp
