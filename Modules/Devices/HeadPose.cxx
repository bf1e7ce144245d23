#include "Devices/HeadPose.h"

#include <glm/geometric.hpp>

#include <chrono>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double UnitWithin = 1e-3;

bool Finite(const HeadPose& pose) noexcept
{
  const glm::dvec3& p = pose.position;
  const glm::dquat& q = pose.orientation;
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(q.w) &&
         std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}
} // namespace

glm::dquat HeadOrientation(double yaw, double pitch, double roll)
{
  return glm::angleAxis(yaw, glm::dvec3(0, 1, 0)) * glm::angleAxis(pitch, glm::dvec3(1, 0, 0)) *
         glm::angleAxis(roll, glm::dvec3(0, 0, 1));
}

HeadPoseFault FaultOf(const HeadPose& pose) noexcept
{
  if (!Finite(pose))
    return HeadPoseFault::NotFinite;
  if (!(glm::length(pose.position) <= MostHeadDistanceMm)) // not <=: 1e300 squared is infinite
    return HeadPoseFault::TooFar;
  if (!(std::abs(glm::length(pose.orientation) - 1.0) <= UnitWithin))
    return HeadPoseFault::NotUnit;
  return HeadPoseFault::None;
}

void ValidateHeadPose(const HeadPose& pose)
{
  std::ostringstream text;
  text << "head pose: ";
  switch (FaultOf(pose))
  {
    case HeadPoseFault::None:
      return;
    case HeadPoseFault::NotFinite:
      text << "a number is not finite";
      break;
    case HeadPoseFault::TooFar:
      text << "the head is " << glm::length(pose.position)
           << " mm from the screen's middle, must be"
           << " at most " << MostHeadDistanceMm << "; are the units mm?";
      break;
    case HeadPoseFault::NotUnit:
      text << "the quaternion's length is " << glm::length(pose.orientation)
           << ", must be 1 within " << UnitWithin;
      break;
  }
  throw std::invalid_argument(text.str());
}

double SteadySeconds() noexcept
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace hasp
