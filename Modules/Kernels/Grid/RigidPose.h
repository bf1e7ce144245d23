#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace hasp
{

/// Where a rigid body is: its own axes, turned by `orientation`, stand at `position`. mm; a value
/// type; any thread; nothing throws.
struct RigidPose
{
  glm::dvec3 position{ 0.0 };
  glm::dquat orientation{ 1.0, 0.0, 0.0, 0.0 }; ///< unit: (w, x, y, z)

  bool operator==(const RigidPose&) const noexcept = default; ///< to the last bit
  glm::dvec3 Place(const glm::dvec3& point) const noexcept
  {
    return this->position + this->orientation * point;
  }
  glm::dvec3 Turn(const glm::dvec3& direction) const noexcept
  {
    return this->orientation * direction;
  }
  /// The pose `inner` of this body's axes, seen from where this pose is seen from.
  RigidPose operator*(const RigidPose& inner) const noexcept
  {
    return { this->Place(inner.position), this->orientation * inner.orientation };
  }
  RigidPose Inverse() const noexcept
  {
    const glm::dquat back = glm::conjugate(this->orientation);
    return { back * -this->position, back };
  }
};

/// A force and the torque about the point that it is said to act at. World axes. Newton, N mm.
struct Wrench
{
  glm::dvec3 force{ 0.0 };
  glm::dvec3 torque{ 0.0 };

  Wrench& operator+=(const Wrench& other) noexcept
  {
    this->force += other.force;
    this->torque += other.torque;
    return *this;
  }
};

/// The turn as axis times angle, radians in [0, pi]: the shorter way round. Exact to the last
/// digits near no turn, where an arc cosine is not. {0} for a quaternion that is 0.
inline glm::dvec3 RotationVector(const glm::dquat& turn) noexcept
{
  const glm::dvec3 v =
    turn.w < 0.0 ? -glm::dvec3(turn.x, turn.y, turn.z) : glm::dvec3(turn.x, turn.y, turn.z);
  const double sine = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const double cosine = std::abs(turn.w);
  if (sine == 0.0)
    return glm::dvec3(0.0);
  return v * (2.0 * std::atan2(sine, cosine) / sine);
}

/// The turn about `vector` by its length in radians; unit.
inline glm::dquat TurnBy(const glm::dvec3& vector) noexcept
{
  const double angle = std::sqrt(vector.x * vector.x + vector.y * vector.y + vector.z * vector.z);
  // sin(a/2)/a, whose limit is 1/2.
  const double share = angle < 1e-8 ? 0.5 : std::sin(0.5 * angle) / angle;
  return { std::cos(0.5 * angle), share * vector.x, share * vector.y, share * vector.z };
}

} // namespace hasp
