#pragma once
#include "Grid/RigidPose.h"

#include <array>
#include <cstdint>

namespace hasp
{

/// A hand on a device. Firm by default, near critical damping.
struct OperatorHandSettings
{
  double massKg = 0.17;        ///< of hand and device, [0.01, 10]
  double inertiaKgMm2 = 100.0; ///< about every axis, [1, 1e5]
  double springNPerMm = 0.5;   ///< to where it means to be, [0.01, 5]
  double damperNsPerMm = 0.015;
  double turnSpringNmmPerRad = 1500.0; ///< [1, 1e5]
  double turnDamperNmmSPerRad = 20.0;
  double mostN = 8.0;         ///< no more is pulled with, [0.1, 100]
  double mostNmm = 240.0;     ///< nor turned, [1, 1e4]
  double tremorMm = 0.1;      ///< at 8 to 12 Hz, at most so far on an axis, [0, 2]
  double tremorDegrees = 0.1; ///< [0, 10]
  double driftMm = 0.3;       ///< at 0.1 to 0.5 Hz, [0, 10]
  double driftDegrees = 0.3;  ///< [0, 20]
};

/// What a hand does without meaning to, in closed form in time, so that two trials of one seed have
/// the same: on each axis three sines of tremor and two of drift.
class OperatorNoise
{
public:
  OperatorNoise(const OperatorHandSettings& settings, std::uint64_t seed);
  RigidPose At(double timeS) const; ///< about the pose that is meant; axes of the world

private:
  struct Wave
  {
    double reach, radPerS, phase;
  };
  std::array<std::array<Wave, 5>, 6> Waves;
};

/// A rigid body that a spring and a damper pull to where the hand means to be, and the device's
/// wrench away from it. Why not Devices/HandModel: its intention is told beforehand, in closed
/// form, for truth's sake; this one reacts to what it feels, its force is bounded, and a few
/// percent of error in its motion do not matter here. Semi-implicit Euler, a quarter of a ms.
class OperatorHand
{
public:
  /// Throws std::invalid_argument with the value and its legal range.
  OperatorHand(const OperatorHandSettings& settings, const RigidPose& start);
  /// By a tick, s: with one intention and one wrench, about the body's origin, world axes.
  void Advance(const RigidPose& meant, const Wrench& applied, double tickS);
  const RigidPose& Pose() const { return this->Now; }

private:
  OperatorHandSettings Settings;
  RigidPose Now;
  glm::dvec3 Velocity{ 0.0 }, Turn{ 0.0 };
};

} // namespace hasp
