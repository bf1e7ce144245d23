#include "Devices/WorkspaceMapping.h"

#include "Devices/SettingsCheck.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr const char* What = "workspace";
constexpr double LeastScale = 1e-3, MostScale = 1e3;

/// Within what rounding leaves; then exactly.
bool MakeUnit(glm::dquat& q) noexcept
{
  const double length = glm::length(q);
  if (!(std::abs(length - 1.0) <= 1e-3))
    return false;
  q = q / length;
  return true;
}
} // namespace

WorkspaceMapping::WorkspaceMapping(const WorkspaceSettings& settings) : Settings(settings)
{
  CheckRange(What, "scale", settings.scale, LeastScale, MostScale);
  CheckRange(What, "forceGain", settings.forceGain, 0.0, 10.0);
  CheckRange(What, "fadeS", settings.fadeS, 0.0, 1.0);
}

void WorkspaceMapping::AnchorHere() noexcept
{
  this->DeviceAnchor = this->Device;
  this->WorldAnchor = this->World;
}

void WorkspaceMapping::Place(const RigidPose& deviceToWorld) noexcept
{
  RigidPose place = deviceToWorld;
  if (!IsFinite(place) || !MakeUnit(place.orientation))
    return;
  this->Axes = place.orientation;
  this->DeviceAnchor = {};
  this->WorldAnchor = place;
  this->World = place;
  this->Device = {};
}

bool WorkspaceMapping::SetAxes(const glm::dquat& deviceToWorld) noexcept
{
  glm::dquat axes = deviceToWorld;
  if (!MakeUnit(axes))
    return false;
  this->AnchorHere();
  this->Axes = axes;
  return true;
}

bool WorkspaceMapping::SetScale(double scale) noexcept
{
  if (!(scale >= LeastScale && scale <= MostScale))
    return false;
  this->AnchorHere();
  this->Settings.scale = scale;
  return true;
}

const RigidPose& WorkspaceMapping::Update(
  const RigidPose& device, bool clutchHeld, double dtS) noexcept
{
  RigidPose now = device;
  if (!IsFinite(now) || !MakeUnit(now.orientation))
    return this->World;
  const double step =
    this->Settings.fadeS > 0.0 ? (dtS > 0.0 ? dtS : 0.0) / this->Settings.fadeS : 1.0;
  this->Share = std::clamp(this->Share + (clutchHeld ? -step : step), 0.0, 1.0);
  const RigidPose &from = this->DeviceAnchor, &to = this->WorldAnchor;
  const glm::dvec3 position =
    to.position + this->Settings.scale * (this->Axes * (now.position - from.position));
  if (!IsFinite(position))
    return this->World;
  this->Device = now;
  if (clutchHeld || this->Held)
  {
    this->AnchorHere(); // the tool stays, and goes on from here
    this->Held = clutchHeld;
    return this->World;
  }
  this->World.position = position;
  this->World.orientation =
    glm::normalize(this->Axes * (now.orientation * glm::conjugate(from.orientation)) *
                   glm::conjugate(this->Axes) * to.orientation);
  return this->World;
}

Wrench WorkspaceMapping::ToDevice(const Wrench& world) const noexcept
{
  if (!IsFinite(world))
    return {};
  const double gain = this->Settings.forceGain * this->Share;
  const glm::dquat back = glm::conjugate(this->Axes);
  return { gain * (back * world.force), gain / this->Settings.scale * (back * world.torque) };
}

} // namespace hasp
