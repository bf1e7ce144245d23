#pragma once
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hasp
{

/// A triangle mesh in world millimetres. Triangles index points and run counter-clockwise seen from
/// outside, so normals point out of the solid.
struct TriangleMesh
{
  std::vector<glm::dvec3> points;
  std::vector<glm::uvec3> triangles;
};

} // namespace hasp
