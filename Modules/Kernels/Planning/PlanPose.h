#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace hasp
{

/// Where a rigid body stands: p goes to position + orientation * p. A plain value, as Grid's
/// RigidPose, which Planning does not know. Any thread; nothing throws.
struct PlanPose
{
  glm::dvec3 position{ 0.0 };                   ///< mm
  glm::dquat orientation{ 1.0, 0.0, 0.0, 0.0 }; ///< (w, x, y, z), unit within 1e-6

  bool operator==(const PlanPose&) const noexcept = default;
  glm::dvec3 Place(const glm::dvec3& point) const noexcept
  {
    return this->position + this->orientation * point;
  }
  glm::dvec3 PlaceBack(const glm::dvec3& point) const noexcept
  {
    return glm::conjugate(this->orientation) * (point - this->position);
  }
};

} // namespace hasp
