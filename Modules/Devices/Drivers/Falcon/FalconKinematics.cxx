#include "Devices/Drivers/Falcon/FalconKinematics.h"

#include "Grid/FinitePose.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <numbers>

namespace hasp
{

namespace
{
constexpr double A = 60.0;         // arm
constexpr double B = 102.5;        // long side of the parallelogram
constexpr double C = 14.43;        // grip's centre to its joint
constexpr double DE = 2 * 11.25;   // its two short pieces
constexpr double F = -25.0;        // sideways from the grip's centre to its joint
constexpr double R = 40.0;         // device's axis to a motor's
constexpr double S = -23.09;       // and sideways
constexpr double MiddleMm = 125.0; // of the equations' z

constexpr int Legs = 3;
constexpr double CosPhi[Legs] = { -0.25881904510252076, 0.96592582628906829, -0.70710678118654752 };
constexpr double SinPhi[Legs] = { 0.96592582628906829, -0.25881904510252076, -0.70710678118654752 };

constexpr double StepIsSmallMm = 1e-4;
constexpr double LongestStepMm = 20.0; // with longer ones Newton loses its way to the reach's edge
constexpr int MostSteps = 20;
// Of dR/dp, whose rows are of length 1 and more. It is negative in the middle; where it is 0 the
// shanks can be folded over for the same angles, which no device can do. -0.07 at the worst place
// within 60 mm.
constexpr double LastDeterminant = -0.05;
constexpr double SolvableDeterminant = 1e-3; // for a step on the way
constexpr double AnglesAgreeRad = 1e-9;

/// The grip in the axes of leg i, from the joint at its motor.
struct InLeg
{
  InLeg(int i, const glm::dvec3& p)
    : U(CosPhi[i] * p.x + SinPhi[i] * p.y - R + C),
      V(-SinPhi[i] * p.x + CosPhi[i] * p.y - S + F),
      W(p.z + MiddleMm)
  {
  }
  double U, V, W;
};

/// R of the three legs, dR/dp with a leg a row, and dR/dt.
struct Closure
{
  glm::dvec3 residual{ 0.0 };
  glm::dvec3 byPosition[Legs]{};
  glm::dvec3 byAngle{ 0.0 };

  Closure(const glm::dvec3& position, const glm::dvec3& angles) noexcept
  {
    for (int i = 0; i < Legs; ++i)
    {
      const InLeg leg(i, position);
      const double across = leg.U - A * std::cos(angles[i]);
      const double out = leg.W - A * std::sin(angles[i]);
      const double reach = std::hypot(across, out);
      // Where V is too long there is no root; a small one instead leads Newton back.
      const double root = std::sqrt(std::fmax(B * B - leg.V * leg.V, 1.0));
      this->residual[i] = reach - DE - root;
      const double byU = across / reach, byV = leg.V / root;
      this->byPosition[i] = { byU * CosPhi[i] - byV * SinPhi[i], byU * SinPhi[i] + byV * CosPhi[i],
        out / reach };
      this->byAngle[i] = A * (across * std::sin(angles[i]) - out * std::cos(angles[i])) / reach;
    }
  }

  double Determinant() const noexcept
  {
    return glm::dot(this->byPosition[0], glm::cross(this->byPosition[1], this->byPosition[2]));
  }
  /// x with dR/dp x = right, by Cramer; the determinant is not 0.
  glm::dvec3 Solve(const glm::dvec3& right, double determinant) const noexcept
  {
    const auto& row = this->byPosition;
    return (right[0] * glm::cross(row[1], row[2]) + right[1] * glm::cross(row[2], row[0]) +
             right[2] * glm::cross(row[0], row[1])) /
           determinant;
  }
};

bool WithinReach(const glm::dvec3& p) noexcept
{
  return p.z >= FalconLeastZMm && p.z <= FalconMostZMm &&
         std::hypot(p.x, p.y) <= FalconMostRadiusMm;
}
} // namespace

std::optional<glm::dvec3> FalconAnglesAt(const glm::dvec3& positionMm) noexcept
{
  if (!WithinReach(positionMm)) // nor is a NaN
    return std::nullopt;
  glm::dvec3 angles;
  for (int i = 0; i < Legs; ++i)
  {
    const InLeg leg(i, positionMm);
    const double rootSquared = B * B - leg.V * leg.V;
    if (!(rootSquared > 0.0))
      return std::nullopt;
    const double l = DE + std::sqrt(rootSquared);
    const double d = std::hypot(leg.U, leg.W);
    const double cosine = (A * A + d * d - l * l) / (2.0 * A * d);
    if (!(std::abs(cosine) <= 1.0))
      return std::nullopt;
    angles[i] = std::atan2(leg.W, leg.U) - std::acos(cosine);
  }
  if (!(Closure(positionMm, angles).Determinant() <= LastDeterminant))
    return std::nullopt;
  return angles;
}

std::optional<FalconPosition> FalconPositionAt(
  const glm::dvec3& angles, const glm::dvec3& nearMm) noexcept
{
  FalconPosition found{ nearMm };
  double stepMm = HUGE_VAL;
  while (stepMm >= StepIsSmallMm)
  {
    const Closure closure(found.positionMm, angles);
    const double determinant = closure.Determinant();
    // Also false where something is not finite.
    if (!(std::abs(determinant) >= SolvableDeterminant) || found.iterations == MostSteps)
      return std::nullopt;
    glm::dvec3 step = closure.Solve(closure.residual, determinant);
    stepMm = glm::length(step);
    if (stepMm > LongestStepMm)
      step *= LongestStepMm / stepMm;
    found.positionMm -= step;
    ++found.iterations;
  }
  const auto back = FalconAnglesAt(found.positionMm);
  if (!back || !(glm::distance(*back, angles) <= AnglesAgreeRad))
    return std::nullopt;
  return found;
}

std::optional<glm::dmat3> FalconJacobian(
  const glm::dvec3& positionMm, const glm::dvec3& angles) noexcept
{
  const Closure closure(positionMm, angles);
  const double determinant = closure.Determinant();
  if (!(determinant <= LastDeterminant) || !IsFinite(closure.byAngle))
    return std::nullopt;
  glm::dmat3 jacobian(0.0);
  for (int i = 0; i < Legs; ++i)
  {
    glm::dvec3 turned(0.0);
    turned[i] = -closure.byAngle[i];
    jacobian[i] = closure.Solve(turned, determinant);
  }
  return jacobian;
}

glm::dvec3 FalconTorques(const glm::dmat3& jacobian, const glm::dvec3& forceN) noexcept
{
  return glm::transpose(jacobian) * forceN;
}

namespace
{
constexpr double RadPerCount = 2.0 * std::numbers::pi * (14.25 / 110.0) / (320.0 * 4.0);
constexpr double RadOfZero = 35.0 * std::numbers::pi / 180.0;
} // namespace

double FalconAngleOfCount(int count) noexcept
{
  return RadOfZero + RadPerCount * count;
}

double FalconCountOfAngle(double angle) noexcept
{
  return (angle - RadOfZero) / RadPerCount;
}

} // namespace hasp
