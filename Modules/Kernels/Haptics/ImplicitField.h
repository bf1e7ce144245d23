#pragma once
#include <glm/vec3.hpp>

namespace hasp
{

/// A smooth function of space whose zero surface can be touched; negative inside.
class ImplicitField
{
public:
  struct Sample
  {
    double value;        ///< mm if the field is a distance
    glm::dvec3 gradient; ///< of value, per mm
  };
  virtual ~ImplicitField() = default;
  /// World, mm. HAPTIC: takes no memory, no lock, and does not throw.
  virtual Sample At(const glm::dvec3& world) const noexcept = 0;
};

} // namespace hasp
