#pragma once
#include "Grid/RigidPose.h"

namespace hasp
{

// Whether all numbers of it are finite. Any thread; nothing throws; no memory: for ticks.

inline bool IsFinite(const glm::dvec3& v) noexcept
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool IsFinite(const RigidPose& pose) noexcept
{
  const glm::dquat& q = pose.orientation;
  return IsFinite(pose.position) && std::isfinite(q.w) && std::isfinite(q.x) &&
         std::isfinite(q.y) && std::isfinite(q.z);
}

inline bool IsFinite(const Wrench& wrench) noexcept
{
  return IsFinite(wrench.force) && IsFinite(wrench.torque);
}

} // namespace hasp
