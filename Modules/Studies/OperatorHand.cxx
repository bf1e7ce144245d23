#include "Studies/OperatorHand.h"

#include "Studies/SeededShare.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr int Substeps = 4;      // a ms
constexpr double PerMetre = 1e3; // 1 N = 1000 kg mm / s^2

void Require(double value, double least, double most, const char* name)
{
  if (!(value >= least && value <= most))
    throw std::invalid_argument("operator's hand: " + std::string(name) + " is " +
                                std::to_string(value) + ", must be in [" + std::to_string(least) +
                                ", " + std::to_string(most) + "]");
}

glm::dvec3 AtMost(const glm::dvec3& v, double most)
{
  const double length = glm::length(v);
  return length > most ? v * (most / length) : v;
}

} // namespace

OperatorNoise::OperatorNoise(const OperatorHandSettings& settings, std::uint64_t seed)
{
  std::uint64_t n = 0;
  const auto share = [&] { return SeededShare(seed, n++); };
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (std::size_t w = 0; w < 5; ++w)
    {
      const bool tremor = w < 3;
      const double degrees = tremor ? settings.tremorDegrees : settings.driftDegrees;
      const double mm = tremor ? settings.tremorMm : settings.driftMm;
      const double hertz = tremor ? 8.0 + 4.0 * share() : 0.1 + 0.4 * share();
      this->Waves[axis][w] = { (axis < 3 ? mm : glm::radians(degrees)) / (tremor ? 3.0 : 2.0),
        glm::two_pi<double>() * hertz, glm::two_pi<double>() * share() };
    }
}

RigidPose OperatorNoise::At(double timeS) const
{
  std::array<double, 6> off{};
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (const Wave& wave : this->Waves[axis])
      off[axis] += wave.reach * std::sin(wave.radPerS * timeS + wave.phase);
  return { { off[0], off[1], off[2] }, TurnBy({ off[3], off[4], off[5] }) };
}

OperatorHand::OperatorHand(const OperatorHandSettings& settings, const RigidPose& start)
  : Settings(settings),
    Now(start)
{
  Require(settings.massKg, 0.01, 10.0, "massKg");
  Require(settings.inertiaKgMm2, 1.0, 1e5, "inertiaKgMm2");
  Require(settings.springNPerMm, 0.01, 5.0, "springNPerMm");
  Require(settings.turnSpringNmmPerRad, 1.0, 1e5, "turnSpringNmmPerRad");
  Require(settings.mostN, 0.1, 100.0, "mostN");
  Require(settings.mostNmm, 1.0, 1e4, "mostNmm");
  Require(settings.tremorMm, 0.0, 2.0, "tremorMm");
  Require(settings.tremorDegrees, 0.0, 10.0, "tremorDegrees");
  Require(settings.driftMm, 0.0, 10.0, "driftMm");
  Require(settings.driftDegrees, 0.0, 20.0, "driftDegrees");
  // Explicit steps stand what is slower than they are: d h / m < 1 and k h^2 / m < 1.
  const double step = 0.001 / Substeps;
  const double lightest = settings.massKg / PerMetre, least = settings.inertiaKgMm2 / PerMetre;
  Require(settings.damperNsPerMm, 0.0, lightest / step, "damperNsPerMm");
  Require(settings.turnDamperNmmSPerRad, 0.0, least / step, "turnDamperNmmSPerRad");
  Require(settings.springNPerMm, 0.0, lightest / (step * step), "springNPerMm");
  Require(settings.turnSpringNmmPerRad, 0.0, least / (step * step), "turnSpringNmmPerRad");
}

void OperatorHand::Advance(const RigidPose& meant, const Wrench& applied, double tickS)
{
  const OperatorHandSettings& s = this->Settings;
  const double step = tickS / Substeps;
  for (int n = 0; n < Substeps; ++n)
  {
    const glm::dvec3 off = meant.position - this->Now.position;
    const glm::dvec3 turned =
      RotationVector(meant.orientation * glm::conjugate(this->Now.orientation));
    const glm::dvec3 force = AtMost(s.springNPerMm * off, s.mostN);
    const glm::dvec3 torque = AtMost(s.turnSpringNmmPerRad * turned, s.mostNmm);
    this->Velocity +=
      (PerMetre * step / s.massKg) * (force + applied.force - s.damperNsPerMm * this->Velocity);
    this->Turn += (PerMetre * step / s.inertiaKgMm2) *
                  (torque + applied.torque - s.turnDamperNmmSPerRad * this->Turn);
    this->Now.position += step * this->Velocity;
    this->Now.orientation = glm::normalize(TurnBy(step * this->Turn) * this->Now.orientation);
  }
}

} // namespace hasp
