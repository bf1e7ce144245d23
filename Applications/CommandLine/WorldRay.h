#pragma once
#include <glm/vec3.hpp>

namespace hasp
{

/// In world mm; direction of length 1.
struct WorldRay
{
  glm::dvec3 origin, direction;
};

} // namespace hasp
