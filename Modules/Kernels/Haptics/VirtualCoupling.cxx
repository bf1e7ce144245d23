#include "Haptics/VirtualCoupling.h"
#include "Haptics/Solve6.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

void RequirePositive(double value, const char* name, const char* unit)
{
  if (!(value > 0.0) || !std::isfinite(value))
    throw std::invalid_argument(std::string(name) + " of a coupling is " + std::to_string(value) +
                                ' ' + unit + "; it must be positive and finite");
}

/// F(d)/d of limit tanh(k d / limit): k near 0.
double Secant(double stiffness, double limit, double way) noexcept
{
  const double u = stiffness * way / limit;
  return u < 1e-6 ? stiffness : limit * std::tanh(u) / way;
}

/// Where a tool stands between spring and contacts.
struct Balance
{
  Symmetric6 matrix;
  Vector6 wrench;
  double residual; ///< shares of the limits
};

Balance BalanceOf(const CouplingSpring& spring, const RigidPose& device, const RigidPose& tool,
  const ContactSums& sums) noexcept
{
  const glm::dvec3 way = device.position - tool.position;
  const glm::dvec3 turn = RotationVector(device.orientation * glm::conjugate(tool.orientation));
  const double k = Secant(spring.stiffness, spring.forceLimit, glm::length(way));
  const double kTurn = Secant(spring.turnStiffness, spring.torqueLimit, glm::length(turn));
  const glm::dvec3 force = k * way + sums.contact.force + sums.attraction.force;
  const glm::dvec3 torque = kTurn * turn + sums.contact.torque + sums.attraction.torque;
  Balance balance{ sums.matrix, { force.x, force.y, force.z, torque.x, torque.y, torque.z },
    std::max(glm::length(force) / spring.forceLimit, glm::length(torque) / spring.torqueLimit) };
  for (std::size_t i = 0; i < 6; ++i)
    balance.matrix[UpperIndex(i, i)] += i < 3 ? k : kTurn;
  return balance;
}

} // namespace

Wrench CouplingSpring::Pull(const RigidPose& device, const RigidPose& tool) const noexcept
{
  const glm::dvec3 way = device.position - tool.position;
  const glm::dvec3 turn = RotationVector(device.orientation * glm::conjugate(tool.orientation));
  return { Secant(this->stiffness, this->forceLimit, glm::length(way)) * way,
    Secant(this->turnStiffness, this->torqueLimit, glm::length(turn)) * turn };
}

double StableStiffness(double damping, double tickS, double delayS, double share) noexcept
{
  return share * damping / (0.5 * tickS + delayS);
}

bool IsPose(const RigidPose& pose) noexcept
{
  const double length = glm::length(pose.orientation);
  return std::isfinite(pose.position.x) && std::isfinite(pose.position.y) &&
         std::isfinite(pose.position.z) && std::abs(length - 1.0) < 1e-3; // false for NaN
}

VirtualCoupling::VirtualCoupling(const VirtualCouplingSettings& settings) : Settings(settings)
{
  RequirePositive(settings.spring.stiffness, "The stiffness", "N/mm");
  RequirePositive(settings.spring.turnStiffness, "The turn's stiffness", "N mm/rad");
  RequirePositive(settings.spring.forceLimit, "The force limit", "N");
  RequirePositive(settings.spring.torqueLimit, "The torque limit", "N mm");
  RequirePositive(settings.travelMm, "The travel", "mm");
  RequirePositive(settings.radiusMm, "The radius", "mm");
  RequirePositive(settings.tolerance, "The tolerance", "of the limits");
  RequirePositive(settings.steps, "The number of steps", "");
}

void VirtualCoupling::SetTravel(double travelMm, double radiusMm) noexcept
{
  this->Settings.travelMm = travelMm;
  this->Settings.radiusMm = radiusMm;
}

CouplingTick VirtualCoupling::Tick(const RigidPose& device, ToolContact& contact) noexcept
{
  CouplingTick tick;
  if (!IsPose(device))
  {
    tick.status = CouplingTick::BadDevicePose;
    return tick;
  }
  const VirtualCouplingSettings& s = this->Settings;
  while (tick.evaluations < s.steps)
  {
    const ToolContact::Answer answer = contact.At(this->ToolPose);
    ++tick.evaluations;
    const Balance balance = BalanceOf(s.spring, device, this->ToolPose, answer.sums);
    tick.sums = answer.sums;
    tick.residual = balance.residual;
    tick.status &= ~CouplingTick::Travelling;
    if (tick.evaluations > 1 && balance.residual <= s.tolerance)
      break;
    Vector6 step;
    if (!Solve6(balance.matrix, balance.wrench, s.radiusMm, step))
    {
      tick.status |= CouplingTick::Unsolved;
      break;
    }
    const glm::dvec3 move(step[0], step[1], step[2]), turn(step[3], step[4], step[5]);
    const double way = glm::length(move) + glm::length(turn) * s.radiusMm;
    const double longest = s.travelMm + answer.clearanceMm;
    const double share = way > longest ? longest / way : 1.0;
    this->ToolPose.position += share * move;
    this->ToolPose.orientation = glm::normalize(TurnBy(share * turn) * this->ToolPose.orientation);
    const bool free = way <= answer.clearanceMm && answer.sums.attractedArea == 0.0;
    if (share == 1.0 && (free || balance.residual <= s.tolerance))
      break;
    tick.status |= CouplingTick::Travelling;
    if (answer.last)
      break;
  }
  const Wrench pull = s.spring.Pull(device, this->ToolPose);
  tick.onDevice = { -pull.force, -pull.torque };
  return tick;
}

} // namespace hasp
