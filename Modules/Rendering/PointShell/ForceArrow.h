#pragma once
#include <glm/vec3.hpp>

namespace hasp
{

/// A force where it acts.
struct ForceArrow
{
  glm::dvec3 atMm{ 0.0 };   ///< world, or what the actor's matrix places
  glm::dvec3 forceN{ 0.0 }; ///< in the same axes
};

} // namespace hasp
