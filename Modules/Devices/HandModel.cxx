#include "Devices/HandModel.h"

#include "Devices/SettingsCheck.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr const char* What = "hand";
constexpr std::int64_t StepNs = 20'000;
constexpr double MmPerM = 1000.0; // 1 N = 1 kg m/s^2 = 1000 kg mm/s^2, so 1 N mm = 1000 kg mm^2/s^2

/// Dry friction without its jump at rest.
glm::dvec3 Dry(double coulomb, double creep, const glm::dvec3& v) noexcept
{
  const double speed = glm::length(v);
  if (coulomb == 0.0 || speed == 0.0)
    return glm::dvec3(0.0);
  return v * (-coulomb * std::tanh(speed / creep) / speed);
}

void CheckGrip(const HandGrip& grip)
{
  CheckRange(What, "springNPerMm", grip.springNPerMm, 0.0, 1e6);
  CheckRange(What, "damperNsPerMm", grip.damperNsPerMm, 0.0, 1e6);
  CheckRange(What, "turnSpringNmmPerRad", grip.turnSpringNmmPerRad, 0.0, 1e9);
  CheckRange(What, "turnDamperNmmSPerRad", grip.turnDamperNmmSPerRad, 0.0, 1e9);
}

void CheckBody(const HandBody& body)
{
  CheckRange(What, "massKg", body.massKg, 1e-6, 1e6);
  const glm::dvec3& i = body.inertiaKgMm2;
  for (int axis = 0; axis < 3; ++axis)
  {
    CheckRange(What, "inertiaKgMm2", i[axis], 1e-6, 1e6);
    // No mass distribution has a moment larger than the two others together.
    CheckRange(What, "the largest of inertiaKgMm2", i[axis], 0.0,
      (i[(axis + 1) % 3] + i[(axis + 2) % 3]) * (1.0 + 1e-12));
  }
  CheckRange(What, "viscousNsPerMm", body.viscousNsPerMm, 0.0, 1e6);
  CheckRange(What, "turnViscousNmmSPerRad", body.turnViscousNmmSPerRad, 0.0, 1e9);
  CheckRange(What, "coulombN", body.coulombN, 0.0, 1e3);
  CheckRange(What, "turnCoulombNmm", body.turnCoulombNmm, 0.0, 1e6);
  CheckRange(What, "creepMmPerS", body.creepMmPerS, 1e-6, 1e6);
  CheckRange(What, "creepRadPerS", body.creepRadPerS, 1e-6, 1e6);
}

/// The fastest of a body's own time constants: what a step must be short against.
double FastestPerS(double mass, double spring, double damping)
{
  return std::max(std::sqrt(MmPerM * spring / mass), MmPerM * damping / mass);
}
} // namespace

HandGrip NoGrip() noexcept
{
  return {};
}

HandGrip LooseGrip() noexcept
{
  return { 0.1, 0.001, 300.0, 2.0 };
}

HandGrip FirmGrip() noexcept
{
  return { 0.5, 0.006, 1500.0, 12.0 };
}

HandModel::HandModel(const HandBody& body, const HandGrip& grip, HandIntention intention)
  : Body(body),
    Grip(grip),
    Plan(std::move(intention))
{
  CheckBody(body);
  CheckGrip(grip);
  this->CheckStep();
  this->Now.pose = this->Plan.Start();
}

void HandModel::SetGrip(const HandGrip& grip)
{
  CheckGrip(grip);
  const HandGrip before = std::exchange(this->Grip, grip);
  try
  {
    this->CheckStep();
  }
  catch (const std::invalid_argument&)
  {
    this->Grip = before;
    throw;
  }
}

void HandModel::CheckStep() const
{
  const HandBody& b = this->Body;
  const double lightest = std::min({ b.inertiaKgMm2.x, b.inertiaKgMm2.y, b.inertiaKgMm2.z });
  const double fastest =
    std::max(FastestPerS(b.massKg, this->Grip.springNPerMm,
               this->Grip.damperNsPerMm + b.viscousNsPerMm + b.coulombN / b.creepMmPerS),
      FastestPerS(lightest, this->Grip.turnSpringNmmPerRad,
        this->Grip.turnDamperNmmSPerRad + b.turnViscousNmmSPerRad +
          b.turnCoulombNmm / b.creepRadPerS));
  constexpr double Most = 0.5 / (1e-9 * StepNs);
  if (fastest <= Most)
    return;
  std::ostringstream text;
  text << What << ": the body answers at " << fastest << " 1/s, must be at most " << Most
       << " for steps of 20 us; more mass or inertia, or less spring, damping or dry friction";
  throw std::invalid_argument(text.str());
}

HandModel::Rate HandModel::RateOf(
  const State& state, const IntendedPose& aim, const Wrench& applied) const noexcept
{
  const HandBody& body = this->Body;
  const glm::dvec3 force =
    applied.force + this->Grip.springNPerMm * (aim.pose.position - state.pose.position) +
    this->Grip.damperNsPerMm * (aim.velocityMmPerS - state.velocity) -
    body.viscousNsPerMm * state.velocity + Dry(body.coulombN, body.creepMmPerS, state.velocity);
  const glm::dvec3 torque =
    applied.torque +
    this->Grip.turnSpringNmmPerRad *
      RotationVector(aim.pose.orientation * glm::conjugate(state.pose.orientation)) +
    this->Grip.turnDamperNmmSPerRad * (aim.turnRadPerS - state.turn) -
    body.turnViscousNmmSPerRad * state.turn +
    Dry(body.turnCoulombNmm, body.creepRadPerS, state.turn);

  // Euler's equations, in the axes in which the inertia is three numbers.
  const glm::dquat toBody = glm::conjugate(state.pose.orientation);
  const glm::dvec3 turn = toBody * state.turn;
  const glm::dvec3 inBody =
    (MmPerM * (toBody * torque) - glm::cross(turn, body.inertiaKgMm2 * turn)) / body.inertiaKgMm2;
  return { force * (MmPerM / body.massKg), state.pose.orientation * inBody };
}

void HandModel::Step(double stepS, const Wrench& applied) noexcept
{
  const double timeS = 1e-9 * static_cast<double>(this->NowNs), halfS = 0.5 * stepS;
  // Both stages aim at the middle's: the first one is wrong by half a step there, which the middle
  // sees squared, and the rule stays of second order.
  const IntendedPose aim = this->Plan.At(timeS + halfS);
  const Rate first = this->RateOf(this->Now, aim, applied);
  State half;
  half.pose.position = this->Now.pose.position + halfS * this->Now.velocity;
  half.pose.orientation = TurnBy(halfS * this->Now.turn) * this->Now.pose.orientation;
  half.velocity = this->Now.velocity + halfS * first.acceleration;
  half.turn = this->Now.turn + halfS * first.turnAcceleration;

  const Rate middle = this->RateOf(half, aim, applied);
  this->Now.pose.position += stepS * half.velocity;
  this->Now.pose.orientation =
    glm::normalize(TurnBy(stepS * half.turn) * this->Now.pose.orientation);
  this->Now.velocity += stepS * middle.acceleration;
  this->Now.turn += stepS * middle.turnAcceleration;
  this->Work +=
    stepS * (glm::dot(applied.force, half.velocity) + glm::dot(applied.torque, half.turn));
}

void HandModel::Advance(std::int64_t toNs, const Wrench& applied) noexcept
{
  const Wrench wrench = IsFinite(applied) ? applied : Wrench{};
  while (this->NowNs < toNs)
  {
    const std::int64_t stepNs = std::min(StepNs, toNs - this->NowNs);
    this->Step(1e-9 * static_cast<double>(stepNs), wrench);
    this->NowNs += stepNs;
  }
}

void HandModel::SetState(
  const RigidPose& pose, const glm::dvec3& velocityMmPerS, const glm::dvec3& turnRadPerS) noexcept
{
  this->Now = { pose, velocityMmPerS, turnRadPerS };
}

double HandModel::KineticEnergy() const noexcept
{
  const glm::dvec3 turn = glm::conjugate(this->Now.pose.orientation) * this->Now.turn;
  return 0.5 / MmPerM *
         (this->Body.massKg * glm::dot(this->Now.velocity, this->Now.velocity) +
           glm::dot(turn, this->Body.inertiaKgMm2 * turn));
}

} // namespace hasp
