#pragma once
#include <glm/glm.hpp>

#include <vector>

// What a developer writes without this kernel: points one after the other as an array of
// structures, a volume of floats, glm. Compiled twice, with flags of their own.
namespace rival
{

struct Point
{
  glm::vec3 position, normal;
};

/// An isotropic grid along the body's axes.
struct Map
{
  const float* mm;
  glm::ivec3 dims;
  glm::vec3 origin;
  float perSpacing;
};

struct Pose
{
  glm::mat3 turn;
  glm::vec3 position;
};

struct Sums
{
  glm::vec3 force{ 0.0F }, torque{ 0.0F };
  float matrix[21] = {};
  int contacts = 0;
};

namespace o2
{
Sums Force(const std::vector<Point>& points, const Pose& pose, const Map& map, float stiffness);
Sums Matrix(const std::vector<Point>& points, const Pose& pose, const Map& map, float stiffness);
}
namespace native
{
Sums Force(const std::vector<Point>& points, const Pose& pose, const Map& map, float stiffness);
Sums Matrix(const std::vector<Point>& points, const Pose& pose, const Map& map, float stiffness);
}

} // namespace rival
