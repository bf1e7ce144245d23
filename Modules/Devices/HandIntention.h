#pragma once
#include "Grid/RigidPose.h"

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

namespace hasp
{

/// Where a hand wants to be, and how it moves there. Device axes; mm, radians, seconds.
struct IntendedPose
{
  RigidPose pose;
  glm::dvec3 velocityMmPerS{ 0.0 };
  glm::dvec3 turnRadPerS{ 0.0 }; ///< about fixed axes
};

// What a hand may do for a while; each begins where the one before has ended. Seconds > 0.
struct HoldMotion
{
  double forS = 1.0;
};
/// As people reach (Flash and Hogan 1985): the fifth-degree polynomial at rest at both ends.
struct MinimumJerkMotion
{
  RigidPose to;
  double forS = 1.0;
};
/// To and fro about where it begins, faster and faster: sin of a phase that grows quadratically.
struct ChirpMotion
{
  glm::dvec3 reachMm{ 0.0 };
  glm::dvec3 reachRad{ 0.0 };
  double fromHz = 0.5, toHz = 5.0;
  double forS = 10.0;
};
/// Straight on at one speed, whatever is in the way.
struct ImpactMotion
{
  glm::dvec3 velocityMmPerS{ 0.0 };
  double forS = 0.1;
};
using HandMotion = std::variant<HoldMotion, MinimumJerkMotion, ChirpMotion, ImpactMotion>;

/// What a hand does without meaning to: on each axis three sines between 8 and 12 Hz.
struct TremorSettings
{
  double reachMm = 0.0;  ///< at most so far along each axis; 0.1 is a healthy hand; in [0, 10]
  double reachRad = 0.0; ///< … about each; in [0, 1]
  std::uint64_t seed = 1;
};

/// A hand's plan, in closed form: the pose it aims at is known at any time, so truth is.
///
/// Before 0 s it is where it starts, after the last motion where that has ended; the tremor goes
/// on. The same seed gives the same plan on every machine, but for the last digits of std::sin. Any
/// thread may read; no memory after construction. Cost: 100 ns, 200 with a tremor of moves.
class HandIntention
{
public:
  /// Throws std::invalid_argument if a number is not finite, a motion takes no time or more than
  /// 1e6 s, a frequency is outside [0, 200] Hz, or the tremor out of its range.
  explicit HandIntention(const RigidPose& start = {}, std::vector<HandMotion> motions = {},
    const TremorSettings& tremor = {});

  IntendedPose At(double timeS) const noexcept;

  double DurationS() const noexcept { return this->EndS; } ///< of all motions
  const RigidPose& Start() const noexcept { return this->StartPose; }

private:
  struct Part
  {
    HandMotion motion;
    RigidPose from;
    double beginS, forS;
  };
  struct Wave
  {
    double reach, radPerS, phase;
  };
  static constexpr int Waves = 3;

  void AddTremor(double timeS, IntendedPose& intended) const noexcept;

  RigidPose StartPose, EndPose;
  double EndS = 0.0;
  std::vector<Part> Parts;
  bool Trembles = false;
  std::array<std::array<Wave, Waves>, 6> Tremor{}; ///< x, y, z, about x, y, z
};

} // namespace hasp
