#include "Devices/MouseHeadPose.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
void Check(const char* what, double value, double least, double most)
{
  if (!(value >= least && value <= most))
    throw std::invalid_argument(std::string("mouse as head: ") + what + " is " +
                                std::to_string(value) + ", must be in [" + std::to_string(least) +
                                ", " + std::to_string(most) + "]");
}
} // namespace

MouseHeadPose::MouseHeadPose(const MouseHeadSettings& settings)
  : Settings(settings),
    DistanceMm(settings.rest.position.z)
{
  ValidateHeadPose(settings.rest);
  Check("reachMm.x", settings.reachMm.x, 0.0, 5000.0);
  Check("reachMm.y", settings.reachMm.y, 0.0, 5000.0);
  Check("stepFactor", settings.stepFactor, 1.0001, 2.0);
  Check("nearestMm", settings.nearestMm, 1.0, 5000.0);
  Check("farthestMm", settings.farthestMm, settings.nearestMm, 5000.0);
  Check("the rest pose's distance", this->DistanceMm, settings.nearestMm, settings.farthestMm);
}

void MouseHeadPose::SetPosition(const glm::dvec2& position)
{
  if (std::isfinite(position.x) && std::isfinite(position.y))
    this->Position = { std::clamp(position.x, -1.0, 1.0), std::clamp(position.y, -1.0, 1.0) };
}

void MouseHeadPose::TurnWheel(double steps)
{
  if (std::isfinite(steps))
    this->DistanceMm = std::clamp(this->DistanceMm * std::pow(this->Settings.stepFactor, steps),
      this->Settings.nearestMm, this->Settings.farthestMm);
}

void MouseHeadPose::Reset()
{
  this->Position = glm::dvec2(0.0);
  this->DistanceMm = this->Settings.rest.position.z;
}

std::optional<TimedHeadPose> MouseHeadPose::Latest(double nowS)
{
  HeadPose pose = this->Settings.rest;
  pose.position.x += this->Position.x * this->Settings.reachMm.x;
  pose.position.y += this->Position.y * this->Settings.reachMm.y;
  pose.position.z = this->DistanceMm;
  return TimedHeadPose{ nowS, pose };
}

} // namespace hasp
