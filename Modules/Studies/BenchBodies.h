#pragma once
#include "Grid/GridView.h"
#include "Haptics/ImplicitField.h"

#include <vector>

namespace hasp
{

/// Bodies of the bench as signed distances in closed form: exact outside, and inside up to the
/// surface that is nearest. mm, world, about the origin.

/// Solid below z = height; `normal` instead of z if given.
struct WallBody : ImplicitField
{
  glm::dvec3 normal{ 0.0, 0.0, 1.0 }; ///< unit
  double height = 0.0;
  Sample At(const glm::dvec3& p) const noexcept override;
};

/// Solid where |z| < half: pushes out to the nearer side.
struct PlateBody : ImplicitField
{
  double half = 0.5;
  Sample At(const glm::dvec3& p) const noexcept override;
};

/// A groove along y: free where z > |x| tan(slope); the tip of a tool meets both flanks.
struct GrooveBody : ImplicitField
{
  double slope = 0.785;
  Sample At(const glm::dvec3& p) const noexcept override;
};

/// A round hole along z of this radius; solid around it.
struct HoleBody : ImplicitField
{
  double radius = 5.0;
  Sample At(const glm::dvec3& p) const noexcept override;
};

/// Two walls, free where |x| < half.
struct SlotBody : ImplicitField
{
  double half = 5.0;
  Sample At(const glm::dvec3& p) const noexcept override;
};

struct BallBody : ImplicitField
{
  double radius = 10.0;
  glm::dvec3 center{ 0.0 };
  Sample At(const glm::dvec3& p) const noexcept override;
};

/// Points of a tool: one; n x n on a square foot of z = 0; rings of a peg from z = 0 up; on a ball.
std::vector<glm::dvec3> TipPoints();
std::vector<glm::dvec3> FootPoints(int perSide, double sideMm);
std::vector<glm::dvec3> PegPoints(double radiusMm, double heightMm, int rings, int perRing);
std::vector<glm::dvec3> LinePoints(int count, double lengthMm);

/// 36 samples an axis about the origin: of 1 mm, or of the spacings and turns that scanners give.
GridGeometry MapGrid(bool skewed);

} // namespace hasp
