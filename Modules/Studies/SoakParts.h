#pragma once
#include "Haptics/VirtualCoupling.h"
#include "Realtime/ForceLimiter.h"
#include "Studies/CpuSeconds.h"
#include "Studies/HapticSoak.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace hasp
{

// What soaks have in common: dice, a hand, and who judges what leaves.

class SoakDice
{
public:
  explicit SoakDice(std::uint32_t seed) : Random(seed) {}
  double In(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  bool Falls(double share) { return this->In(0.0, 1.0) < share; }
  int Below(int count) { return static_cast<int>(this->In(0.0, count - 0.001)); }
  glm::dvec3 Vector(double size)
  {
    return { this->In(-size, size), this->In(-size, size), this->In(-size, size) };
  }

private:
  std::mt19937 Random;
};

/// Of a hand in a hurry: 0.3 m/s, kept about the bodies; jumps a few times a minute; one pose in a
/// thousand is none.
class SoakHand
{
public:
  RigidPose Next(SoakDice& dice, double tickS)
  {
    this->Speed += dice.Vector(40.0) - 0.05 * this->Speed - 0.2 * this->Device.position;
    this->Device.position += this->Speed * tickS;
    this->Turning += dice.Vector(1.0) - 0.05 * this->Turning;
    this->Device.orientation =
      glm::normalize(TurnBy(this->Turning * tickS) * this->Device.orientation);
    if (dice.Falls(1e-4))
      this->Device = { dice.Vector(dice.Falls(0.5) ? 20.0 : 1e4), TurnBy(dice.Vector(3.0)) };
    RigidPose read = this->Device;
    if (dice.Falls(0.001))
      read.orientation.x = dice.Falls(0.5) ? std::numeric_limits<double>::quiet_NaN() : 1e9;
    return read;
  }

private:
  RigidPose Device;
  glm::dvec3 Speed{ 0.0 }, Turning{ 0.0 };
};

/// Holds each wrench against the limits and the one before.
class SoakJudge
{
public:
  explicit SoakJudge(const ForceLimits& limits) : Limits(limits) {}
  void Restart() { this->Last = {}; } ///< forces begin at zero again
  void Check(const Wrench& out, const RigidPose& tool, double tickS, SoakFigures& figures)
  {
    const double force = glm::length(out.force), torque = glm::length(out.torque);
    figures.notFinite += !IsFinite(out) || !IsPose(tool);
    figures.overLimit +=
      force > this->Limits.force * (1.0 + 1e-12) || torque > this->Limits.torque * (1.0 + 1e-12);
    figures.overSlew +=
      force > glm::length(this->Last.force) + this->Limits.forceSlew * tickS + 1e-9 ||
      torque > glm::length(this->Last.torque) + this->Limits.torqueSlew * tickS + 1e-9;
    figures.largestForceN = std::max(figures.largestForceN, force);
    this->Last = out;
  }

private:
  ForceLimits Limits;
  Wrench Last;
};

/// Ticks of `soak`, which has Tick() and Figures.
template <class Soak>
SoakFigures SoakFor(std::uint64_t ticks, Soak& soak, const ProgressFunction& progress)
{
  const double began = CpuSeconds();
  while (soak.Figures.ticks < ticks)
  {
    if (soak.Figures.ticks % 65'536 == 0)
      ReportProgress(
        progress, static_cast<double>(soak.Figures.ticks) / static_cast<double>(ticks));
    soak.Tick();
  }
  soak.Figures.cpuS = CpuSeconds() - began;
  return soak.Figures;
}

} // namespace hasp
