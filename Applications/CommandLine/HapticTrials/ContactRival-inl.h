// Included where a namespace for one set of flags is open.

#include "ContactRivalCell-inl.h"

Sums Force(const std::vector<Point>& points, const Pose& pose, const Map& map, float stiffness)
{
  Sums sums;
  for (const Point& point : points)
  {
    const glm::vec3 lever = pose.turn * point.position;
    Corners corners;
    if (!Find(map, lever + pose.position, corners))
      continue;
    const float mm = corners.Value();
    if (mm >= 0.0F)
      continue;
    const glm::vec3 force = (stiffness * mm) * (pose.turn * point.normal);
    sums.force += force;
    sums.torque += glm::cross(lever, force);
    ++sums.contacts;
  }
  return sums;
}

Sums Matrix(const std::vector<Point>& points, const Pose& pose, const Map& map, float stiffness)
{
  Sums sums;
  for (const Point& point : points)
  {
    const glm::vec3 lever = pose.turn * point.position;
    Corners corners;
    if (!Find(map, lever + pose.position, corners))
      continue;
    const float mm = corners.Value();
    if (mm >= 0.0F)
      continue;
    const glm::vec3 g = corners.Gradient() * map.perSpacing;
    const glm::vec3 t = glm::cross(lever, g);
    sums.force -= (stiffness * mm) * g;
    sums.torque -= (stiffness * mm) * t;
    const float j[6] = { g.x, g.y, g.z, t.x, t.y, t.z };
    for (int r = 0, n = 0; r < 6; ++r)
      for (int c = r; c < 6; ++c, ++n)
        sums.matrix[n] += stiffness * j[r] * j[c];
    ++sums.contacts;
  }
  return sums;
}
