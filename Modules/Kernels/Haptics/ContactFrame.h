// Private to the contact kernels: what one call computes once, and what its points add up to.
#pragma once
#include "Haptics/ContactForce.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>

namespace hasp
{

/// A shell before a map, in the shell's body axes: kernels sum there, and turn the sums once.
template <typename Real>
struct ContactFrame
{
  using Vec3 = glm::vec<3, Real>;
  using Mat3 = glm::mat<3, 3, Real>;

  Mat3 shellToIndex{ Real(1) };
  Vec3 indexOfShell{ Real(0) };
  Mat3 gradientToShell{ Real(1) }; ///< of samples per index step: mm per mm in the shell's axes
  glm::dmat3 shellToMap{ 1.0 };
  bool finite = false; ///< otherwise the pose is not: nothing is felt

  template <typename T>
  ContactFrame(const ContactPlacement& placement, const DistanceMapView<T>& map) noexcept
  {
    const RigidPose& pose = placement.shellInMap;
    this->shellToMap = glm::mat3_cast(pose.orientation);
    const glm::dmat3 toIndex(map.toIndex);
    const glm::dmat3 turned = toIndex * this->shellToMap;
    const glm::dvec3 origin = toIndex * pose.position + glm::dvec3(map.indexOfOrigin);
    this->shellToIndex = Mat3(turned);
    this->indexOfShell = Vec3(origin);
    this->gradientToShell = Mat3(glm::transpose(this->shellToMap) * glm::dmat3(map.gradientToBody) *
                                 static_cast<double>(map.mmPerStep));
    double sum = origin.x + origin.y + origin.z;
    for (int axis = 0; axis < 3; ++axis)
      sum += turned[axis].x + turned[axis].y + turned[axis].z;
    this->finite = std::isfinite(static_cast<float>(sum));
  }
};

/// How contact hardens (ContactSettings), of depths in any unit.
template <typename Real>
struct HardeningLaw
{
  Real c, hard, perHard; ///< hard and 1 / hard in the depths' unit

  HardeningLaw(const ContactSettings& settings, Real perMm) noexcept
    : c(settings.hardening),
      hard(settings.hardMm * perMm),
      perHard(Real(1) / this->hard)
  {
  }
  struct Pressure
  {
    Real depth;   ///< that a linear law would take for this pressure; < 0 as the depth is
    Real slope;   ///< in k
    Real squares; ///< twice the energy, in k
  };
  Pressure At(Real depth) const noexcept
  {
    const Real until = depth < -this->hard ? -this->hard : depth, beyond = depth - until;
    const Real u = until * this->perHard, more = this->c * u * u * u * u;
    const Real pressed = until * (Real(1) + more), slope = Real(1) + Real(5) * more;
    return { pressed + slope * beyond, slope,
      until * until * (Real(1) + more / Real(3)) + beyond * (Real(2) * pressed + slope * beyond) };
  }
};

/// Sums over points in the shell's body axes, j = [g; p x g], without the factors that all share.
struct ShellSums
{
  std::array<double, 6>
    push{}; ///< of A d j, d as a linear law would take it: the wrench is -k times it
  std::array<double, 6> pull{};    ///< of A (d / R) (1 - (d / R)^2)^2 f j: -s a times it
  std::array<double, 21> matrix{}; ///< of A j j^T, times the hardening's slope
  double squares = 0.0;            ///< of A d^2: twice the energy, in k
  double area = 0.0;
  double attractedArea = 0.0;
  double deepestMm = 0.0; ///< the least distance: negative inside
  std::uint32_t contacts = 0;

  /// Of sums that were made of points of area 1, of depths and pushes in other units.
  void Scale(double pointArea, double depthMm, double pushMm) noexcept;
  /// Adds these to `sums`, turned into the map's axes and with their factors.
  void AddTo(ContactTerms terms, const glm::dmat3& shellToMap, const ContactSettings& settings,
    ContactSums& sums) const noexcept;
};

} // namespace hasp
