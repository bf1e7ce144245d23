#pragma once
#include "Devices/HeadPath.h"

#include <array>
#include <cstdint>

namespace hasp
{

struct SimulatedHeadSettings
{
  std::uint64_t seed = 1;
  glm::dvec3 center{ 0, 0, 600 };        ///< mm, room
  glm::dvec3 reachMm{ 150, 60, 120 };    ///< at most so far from the centre along x, y, z
  glm::dvec3 reachDegrees{ 25, 15, 10 }; ///< at most: yaw, pitch, roll
  double noiseMm = 0.0;                  ///< of a tracker: standard deviation along each axis
  double noiseDegrees = 0.0;             ///< about each axis
  double jitterS = 0.0; ///< times of a tracker: evenly within +- that; less than half a period
};

/// How a person before a screen moves: six smooth motions, each a sum of sines between 0.06 and 1.1
/// Hz, slow ones wide and fast ones small. With the settings above about 100 mm/s in the mean. A
/// closed form, so that truth is known at any time; for tests and reports, and to look at a scene
/// without a tracker.
///
/// The same seed gives the same path on every machine, but for the last digits of std::sin.
/// Any thread may read. Cost: 30 sines a pose.
class SimulatedHeadPath
{
public:
  /// Throws std::invalid_argument unless reaches, noise and jitter are finite and >= 0, reachMm at
  /// most 5000 and reachDegrees at most 80, and the centre within 5 m.
  explicit SimulatedHeadPath(const SimulatedHeadSettings& settings = {});

  /// Without noise. Any finite time.
  HeadPose At(double timeS) const;
  glm::dvec3 VelocityMmPerS(double timeS) const;

  /// What a tracker would record: `hz` poses a second from `startS` on, with noise and jitter.
  /// Throws std::invalid_argument unless seconds > 0, hz > 0, both finite, at most a million poses.
  HeadPath Record(double startS, double seconds, double hz) const;

private:
  struct Wave
  {
    double amplitude, radiansPerS, phase;
  };
  static constexpr int Waves = 5;
  using Motion = std::array<Wave, Waves>; ///< amplitudes add up to 1

  SimulatedHeadSettings Settings;
  std::array<Motion, 6> Motions; ///< x, y, z, yaw, pitch, roll
};

} // namespace hasp
