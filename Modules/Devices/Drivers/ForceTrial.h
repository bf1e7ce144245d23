#pragma once
#include "Devices/HapticDevice.h"

#include <span>

namespace hasp
{

/// What a device is asked to do so that a person can judge it. Nothing is done unless a button of
/// the device is held, so that a hand is on it and lets go of it at once: a dead-man's button.
struct ForceTrial
{
  enum class Kind
  {
    None,  ///< no force
    Axes,  ///< right, left, up, down, towards the user, away: a second each, growing and fading
    Steady ///< along `direction`, for a spring scale
  };
  Kind kind = Kind::None;
  double newton = 1.0;             ///< of the largest force; in (0, 3]
  glm::dvec3 direction{ 0, 0, 1 }; ///< device axes; its length does not count
  static constexpr double mostN = 3.0;
};

/// The wrench of a trial. `heldS`: for how long the button is held now, s; 0 or less: it is not.
/// Finite, and no longer than mostN, whatever comes in. A pure function. Any thread.
Wrench WrenchOf(const ForceTrial& trial, double heldS) noexcept;

/// What was said to the device and what a spring scale read, N, both > 0.
struct ScaleReading
{
  double saidN = 0.0, readN = 0.0;
};
/// How much of what is said is felt: read = share x said, by least squares through zero.
struct ScaleFit
{
  double share = 1.0;
  double rmsN = 0.0;   ///< of the readings about that line
  double worstN = 0.0; ///< the largest of them
};

/// Throws std::invalid_argument where a number is not finite or not positive, with fewer than
/// three readings, where the largest said force is less than twice the smallest (a share cannot be
/// told from an offset then), or where share is not in [0.1, 10]: units or the axis are wrong.
/// Any thread.
ScaleFit FitScale(std::span<const ScaleReading> readings);

} // namespace hasp
