#include "Devices/SimulatedHeadPath.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double LeastHz = 0.06, MostHz = 1.1;

/// In [0, 1); std's own distributions differ between libraries.
double Even(std::mt19937_64& random)
{
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Standard normal, by Box and Muller.
double Normal(std::mt19937_64& random)
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Even(random)));
  return radius * std::cos(2.0 * std::numbers::pi * Even(random));
}

glm::dvec3 Normal3(std::mt19937_64& random)
{
  const double x = Normal(random), y = Normal(random);
  return { x, y, Normal(random) };
}

void Check(const char* what, double value, double most)
{
  if (!(value >= 0.0 && value <= most))
    throw std::invalid_argument(std::string("simulated head: ") + what + " is " +
                                std::to_string(value) + ", must be in [0, " + std::to_string(most) +
                                "]");
}
} // namespace

SimulatedHeadPath::SimulatedHeadPath(const SimulatedHeadSettings& settings) : Settings(settings)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Check("reachMm", settings.reachMm[axis], 5000.0);
    Check("reachDegrees", settings.reachDegrees[axis], 80.0);
    Check("the centre's distance from 0", std::abs(settings.center[axis]), 5000.0);
  }
  Check("noiseMm", settings.noiseMm, 1000.0);
  Check("noiseDegrees", settings.noiseDegrees, 45.0);
  Check("jitterS", settings.jitterS, 1.0);

  std::mt19937_64 random(settings.seed);
  for (Motion& motion : this->Motions)
  {
    double sum = 0.0;
    for (int w = 0; w < Waves; ++w)
    {
      // One wave in each fifth of the octaves: no two fall together, none is missing.
      const double octave = (w + Even(random)) / Waves;
      const double hz = LeastHz * std::pow(MostHz / LeastHz, octave);
      motion[w] = { std::pow(hz, -1.3), 2.0 * std::numbers::pi * hz,
        2.0 * std::numbers::pi * Even(random) };
      sum += motion[w].amplitude;
    }
    for (Wave& wave : motion)
      wave.amplitude /= sum;
  }
}

HeadPose SimulatedHeadPath::At(double timeS) const
{
  std::array<double, 6> at{};
  for (std::size_t m = 0; m < at.size(); ++m)
    for (const Wave& wave : this->Motions[m])
      at[m] += wave.amplitude * std::sin(wave.radiansPerS * timeS + wave.phase);
  const glm::dvec3 turn = glm::radians(this->Settings.reachDegrees);
  return { this->Settings.center + this->Settings.reachMm * glm::dvec3(at[0], at[1], at[2]),
    HeadOrientation(turn[0] * at[3], turn[1] * at[4], turn[2] * at[5]) };
}

glm::dvec3 SimulatedHeadPath::VelocityMmPerS(double timeS) const
{
  glm::dvec3 velocity(0.0);
  for (int axis = 0; axis < 3; ++axis)
    for (const Wave& wave : this->Motions[axis])
      velocity[axis] +=
        wave.amplitude * wave.radiansPerS * std::cos(wave.radiansPerS * timeS + wave.phase);
  return this->Settings.reachMm * velocity;
}

HeadPath SimulatedHeadPath::Record(double startS, double seconds, double hz) const
{
  if (!(std::isfinite(startS) && seconds > 0.0 && hz > 0.0 && seconds * hz <= 1e6))
    throw std::invalid_argument("simulated head: " + std::to_string(seconds) + " s at " +
                                std::to_string(hz) +
                                " Hz; both must be above 0, and a million poses the most");
  if (this->Settings.jitterS * hz >= 0.5)
    throw std::invalid_argument("simulated head: jitterS is " +
                                std::to_string(this->Settings.jitterS) +
                                ", must be less than half a period");
  std::mt19937_64 random(this->Settings.seed ^ 0x9E3779B97F4A7C15ull); // not those of the waves
  const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(seconds * hz + 0.5));
  HeadPath path(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    TimedHeadPose& timed = path[n];
    timed.timeS =
      startS + static_cast<double>(n) / hz + this->Settings.jitterS * (2.0 * Even(random) - 1.0);
    timed.pose = this->At(timed.timeS);
    timed.pose.position += this->Settings.noiseMm * Normal3(random);
    const glm::dvec3 turn = glm::radians(this->Settings.noiseDegrees) * Normal3(random);
    timed.pose.orientation =
      glm::normalize(timed.pose.orientation * HeadOrientation(turn.y, turn.x, turn.z));
  }
  return path;
}

} // namespace hasp
