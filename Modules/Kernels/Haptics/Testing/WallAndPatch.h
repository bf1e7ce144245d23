#pragma once
#include "Grid/RigidPose.h"
#include "Testing/ShellOfPoints.h"

namespace hasp
{

/// A wall through the origin: distances are linear, so interpolating them is exact.
inline const glm::dvec3 WallNormal = glm::normalize(glm::dvec3(0.36, 0.48, 0.8));
inline double WallMm(const glm::dvec3& p)
{
  return glm::dot(WallNormal, p);
}
/// A flat patch that faces the wall.
inline ShellOfPoints Patch()
{
  ShellOfPoints patch;
  for (int i = -6; i <= 6; ++i)
    for (int j = -5; j <= 5; ++j)
      patch.Add({ 1.0 + 0.5 * i, 0.45 * j, 2.0 }, { 0.0, 0.0, -1.0 });
  return patch;
}
/// The patch parallel to the wall, with its points `mm` in front of it.
inline RigidPose PatchAt(double mm)
{
  const glm::dvec3 axis = glm::cross(glm::dvec3(0, 0, 1), WallNormal);
  const double angle = std::acos(WallNormal.z);
  const glm::dquat turn = TurnBy(glm::normalize(axis) * angle);
  return { WallNormal * (mm - 2.0) + glm::dvec3(0.2, -0.1, 0.0) -
             WallNormal * glm::dot(WallNormal, glm::dvec3(0.2, -0.1, 0.0)),
    turn };
}

} // namespace hasp
