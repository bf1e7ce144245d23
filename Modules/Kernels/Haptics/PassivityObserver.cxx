#include "Haptics/PassivityObserver.h"
#include "Haptics/VirtualCoupling.h"
#include "Realtime/ForceLimiter.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

glm::dvec3 TurnBetween(const RigidPose& from, const RigidPose& to) noexcept
{
  return RotationVector(to.orientation * glm::conjugate(from.orientation));
}

} // namespace

void PassivityObserver::Tick(const RigidPose& device, const Wrench& held) noexcept
{
  if (!IsPose(device))
  {
    this->Hold(held); // of the way until the next pose nobody knows when it changed: all with this
    return;
  }
  if (this->HasLast)
  {
    this->Sum -= glm::dot(this->Held.force, device.position - this->Last.position) +
                 glm::dot(this->Held.torque, TurnBetween(this->Last, device));
    this->Least = std::min(this->Least, this->Sum);
  }
  this->Last = device;
  this->HasLast = true;
  this->Hold(held);
}

void PassivityObserver::Hold(const Wrench& held) noexcept
{
  if (IsFinite(held))
    this->Held = held;
}

PassivityController::PassivityController(const PassivityControllerSettings& settings)
  : Settings(settings)
{
  for (const double value :
    { settings.damping, settings.leverMm, settings.cutoffHz, settings.tickS })
    if (!(value > 0.0) || !std::isfinite(value))
      throw std::invalid_argument("A setting of a passivity controller is " +
                                  std::to_string(value) + "; it must be positive and finite");
  if (!(settings.allowance >= 0.0))
    throw std::invalid_argument("A passivity controller's allowance is " +
                                std::to_string(settings.allowance) +
                                " mJ; it must not be negative");
}

void PassivityController::Restart() noexcept
{
  this->Watch.Restart();
  this->HasLast = false;
  this->Speed = this->Turning = glm::dvec3(0.0);
}

Wrench PassivityController::Tick(const RigidPose& device, const Wrench& wanted) noexcept
{
  const PassivityControllerSettings& s = this->Settings;
  if (!IsPose(device))
  {
    this->Watch.Hold(wanted);
    return wanted;
  }
  if (!this->HasLast)
    this->Last = device;
  const double turn = 2.0 * std::numbers::pi * s.cutoffHz * s.tickS, share = turn / (1.0 + turn);
  this->Speed += share * ((device.position - this->Last.position) / s.tickS - this->Speed);
  this->Turning += share * (TurnBetween(this->Last, device) / s.tickS - this->Turning);
  this->Last = device;
  this->HasLast = true;

  Wrench held = wanted;
  // What the wrench held until now has done comes first; what is held from now on, second.
  this->Watch.Tick(device, wanted);
  const double lever = s.leverMm * s.leverMm;
  const double squared =
    glm::dot(this->Speed, this->Speed) + lever * glm::dot(this->Turning, this->Turning);
  const double missing = -s.allowance - this->Watch.Energy();
  if (missing > 0.0 && squared > 1e-4) // 0.01 mm/s: nothing is taken from what rests
  {
    const double damping = std::min(missing / (squared * s.tickS), s.damping);
    held += { -damping * this->Speed, -damping * lever * this->Turning };
    this->Watch.Hold(held);
    ++this->Count;
  }
  return held;
}

} // namespace hasp
