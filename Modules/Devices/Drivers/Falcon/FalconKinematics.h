#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <optional>

/// Where a Falcon's grip is for three motor angles, and the other way round.
///
/// Geometry: R. E. Stamper, "A Three Degree of Freedom Parallel Manipulator with Only Translational
/// Degrees of Freedom", PhD thesis, University of Maryland 1997; lengths as libnifalcon has them.
/// Three legs at azimuths 105, -15 and -135 degrees. In the axes of one leg the grip is at
///   u = cos(phi) x + sin(phi) y - r,  v = -sin(phi) x + cos(phi) y - s,  w = z,
/// and the leg closes where, with U = u + c, V = v + f and the arm's angle t,
///   R(x, y, z, t) = hypot(U - a cos t, w - a sin t) - (d + e) - sqrt(b^2 - V^2) = 0.
///
/// Axes: those of a device (HapticDevice.h), mm. The equations have their origin in the plane of
/// the motors' axes; ours is 125 mm in front of it, in the middle of the workspace, with the same
/// directions: x right, y up, z out of the device, towards the user. That x is to the right is by
/// the word of libnifalcon; it was not seen on a device.
/// Angles: rad, of the arms, in the order of the motors; they grow as the grip is pulled out.
/// Any thread; no state, no memory, nothing throws; a NaN in gives nullopt.
namespace hasp
{

/// How far out an answer is believed: beyond what the mechanism reaches (z from 75 to 180 mm of the
/// equations) there are 5 mm for one that is out of true.
constexpr double FalconLeastZMm = -55.0, FalconMostZMm = 60.0, FalconMostRadiusMm = 80.0;

/// The arms' angles with the grip at `positionMm`: closed form,
///   t = atan2(w, U) - acos((a^2 + D^2 - L^2) / (2 a D)),  D = hypot(U, w),
///   L = d + e + sqrt(b^2 - V^2),
/// the elbow that points outwards. nullopt where not each leg reaches, beyond the reach above, and
/// near and behind the places where the shanks fold over (det dR/dp = 0; all are more than 60 mm
/// from the axis), so that no two poses have the same angles. About 0.4 us.
std::optional<glm::dvec3> FalconAnglesAt(const glm::dvec3& positionMm) noexcept;

/// Where the grip is, and what it took to find that out.
struct FalconPosition
{
  glm::dvec3 positionMm{ 0.0 };
  int iterations = 0; ///< Newton steps; 3 from a pose 1 mm off, up to 10 from the middle
};

/// The grip's position for the arms' angles: Newton on the three R with their derivatives, begun
/// at `nearMm` (the pose before, or the middle). The parallelogram's d + e makes the legs no
/// spheres, so there is no closed form. It ends with a step below 1e-4 mm, whose error is of the
/// order of its square: 1e-9 mm. What comes out is put through FalconAnglesAt and must give the
/// angles back, so that it is the one of the solutions that the mechanism is in.
/// nullopt: the angles have no solution within the reach, as with a damaged count. About 1.3
/// us, 2.3 from the middle.
std::optional<FalconPosition> FalconPositionAt(
  const glm::dvec3& angles, const glm::dvec3& nearMm = glm::dvec3(0.0)) noexcept;

/// J = dp/dt, mm/rad: column i is how the grip moves as arm i turns, from dR/dp dp/dt + dR/dt = 0.
/// For angles that belong to the position. nullopt where FalconAnglesAt gives none.
std::optional<glm::dmat3> FalconJacobian(
  const glm::dvec3& positionMm, const glm::dvec3& angles) noexcept;

/// The arms' torques, N mm, that hold a force on the grip, N: t = J^T F. By the power that goes in
/// and out: t . dt = F . dp.
glm::dvec3 FalconTorques(const glm::dmat3& jacobian, const glm::dvec3& forceN) noexcept;

/// An encoder has 320 slots, 4 counts each, on a shaft of 14.25 mm that winds a drum of 110 mm:
/// 0.036435 degrees of the arm a count. Homed, count 0 is at 35 degrees.
double FalconAngleOfCount(int count) noexcept;
/// The other way, not rounded.
double FalconCountOfAngle(double angle) noexcept;

} // namespace hasp
