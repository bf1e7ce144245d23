#include "Haptics/ExplicitCoupling.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double MetresToMillimetres = 1000.0; // N = kg m/s^2, and all lengths are mm

} // namespace

ExplicitCoupling::ExplicitCoupling(const ExplicitCouplingSettings& settings) : Settings(settings)
{
  (void)VirtualCoupling({ .spring = settings.spring }); // the spring's own checks
  for (const double value : { settings.massKg, settings.inertia, settings.tickS })
    if (!(value > 0.0) || !std::isfinite(value))
      throw std::invalid_argument("A mass, inertia or tick of an explicit coupling is " +
                                  std::to_string(value) + "; it must be positive and finite");
  for (const double value : { settings.damping, settings.turnDamping })
    if (!(value >= 0.0) || !std::isfinite(value))
      throw std::invalid_argument("A damping of an explicit coupling is " + std::to_string(value) +
                                  "; it must be finite and not negative");
}

void ExplicitCoupling::Place(const RigidPose& tool) noexcept
{
  this->ToolPose = tool;
  this->Velocity = {};
  this->HasLast = false;
}

CouplingTick ExplicitCoupling::Tick(const RigidPose& device, ToolContact& contact) noexcept
{
  CouplingTick tick;
  if (!IsPose(device))
  {
    tick.status = CouplingTick::BadDevicePose;
    return tick;
  }
  const ExplicitCouplingSettings& s = this->Settings;
  if (!this->HasLast)
    this->LastDevice = device;
  const glm::dvec3 speed = (device.position - this->LastDevice.position) / s.tickS;
  const glm::dvec3 turning =
    RotationVector(device.orientation * glm::conjugate(this->LastDevice.orientation)) / s.tickS;
  this->LastDevice = device;
  this->HasLast = true;

  tick.sums = contact.At(this->ToolPose).sums;
  tick.evaluations = 1;
  Wrench pull = s.spring.Pull(device, this->ToolPose);
  pull += { s.damping * (speed - this->Velocity.linear),
    s.turnDamping * (turning - this->Velocity.angular) };
  const glm::dvec3 force = pull.force + tick.sums.contact.force + tick.sums.attraction.force;
  const glm::dvec3 torque = pull.torque + tick.sums.contact.torque + tick.sums.attraction.torque;
  tick.residual = glm::length(force) / s.spring.forceLimit;
  this->Velocity.linear += force * (s.tickS * MetresToMillimetres / s.massKg);
  this->Velocity.angular += torque * (s.tickS * MetresToMillimetres / s.inertia);
  RigidPose moved{ this->ToolPose.position + s.tickS * this->Velocity.linear,
    glm::normalize(TurnBy(s.tickS * this->Velocity.angular) * this->ToolPose.orientation) };
  if (!IsPose(moved))
  {
    this->Place(device);
    tick.status = CouplingTick::Unsolved;
    return tick;
  }
  this->ToolPose = moved;
  tick.onDevice = { -pull.force, -pull.torque };
  return tick;
}

} // namespace hasp
