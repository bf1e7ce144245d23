#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <variant>
#include <vector>

namespace hasp
{

/// Solids whose distance is known in closed form, or by one root that converges to the last digit.
/// Lengths in mm, world axes. Values; any thread.

struct EllipsoidShape
{
  glm::dvec3 center{ 0.0 };
  glm::dvec3 radii{ 1.0 }; ///< along the world's axes, > 0
};

/// The hull of two balls: a capsule where they are of one size, a ball where one holds the other.
struct RoundConeShape
{
  glm::dvec3 a{ 0.0 }, b{ 0.0 };
  double radiusA = 1.0, radiusB = 1.0; ///< > 0
};

struct HalfSpaceShape
{
  glm::dvec3 point{ 0.0 };
  glm::dvec3 outward{ 0.0, 0.0, 1.0 }; ///< unit
};

/// A bar without ends along `along` x `across`, its profile a box with rounded corners.
struct BarShape
{
  glm::dvec3 center{ 0.0 };
  glm::dvec3 along{ 1.0, 0.0, 0.0 }, across{ 0.0, 1.0, 0.0 }; ///< unit, at right angles
  glm::dvec2 half{ 1.0 };                                     ///< half the profile's sides
  double corner = 0.0;                                        ///< radius, in [0, smallest of half]
};

/// What lies within `tube` of an upright horseshoe band: an arc that opens towards +y (posterior),
/// lengthened by a straight arm at each end, and swept up and down by halfHeight.
/// Needs arc > tube, halfAngle in (0, pi/2].
struct HorseshoeShape
{
  glm::dvec3 center{ 0.0 }; ///< of the arc, at half height
  double arc = 20.0;        ///< radius of the arc
  double halfAngle = 1.0;   ///< radians, from the front to where an arm begins
  double arm = 30.0;        ///< length of each arm, >= 0
  double halfHeight = 0.0;  ///< >= 0
  double tube = 5.0;        ///< > 0

  /// The point of the middle line at arc length s from the front, s > 0 towards +x (left).
  glm::dvec3 PointAt(double s) const;
};

/// What lies within `rounding` of a convex polyhedron.
struct PolyhedronShape
{
  struct Face
  {
    glm::dvec3 outward; ///< unit
    std::vector<glm::dvec3> corners;
  };
  std::vector<Face> faces;
  double rounding = 0.0; ///< >= 0
};

/// The hull of two polygons with as many corners, corresponding sides parallel: a prism or frustum.
/// Throws std::invalid_argument with fewer than 3 corners, unequal numbers or no volume.
PolyhedronShape Frustum(
  const std::vector<glm::dvec3>& lower, const std::vector<glm::dvec3>& upper, double rounding);

using AnalyticShape = std::variant<EllipsoidShape, RoundConeShape, HalfSpaceShape, BarShape,
  HorseshoeShape, PolyhedronShape>;

/// Where a point stands to a surface. The nearest surface point is point - mm * outward.
struct Foot
{
  double mm = 0.0;           ///< signed distance, NEGATIVE INSIDE
  glm::dvec3 outward{ 0.0 }; ///< gradient of the distance: unit; one of several where it has a kink
};

/// True distance to the shape's surface, inside and outside; error about 1e-13 of the sizes.
/// O(1); O(corners) for a polyhedron.
Foot FootOn(const AnalyticShape& shape, const glm::dvec3& point);

/// Whether the surface lies wholly behind its tangent plane, seen from outside: all but horseshoes.
bool IsConvex(const AnalyticShape& shape);

/// The smallest upright box around it; infinite where the shape is.
struct Box
{
  glm::dvec3 low, high;
};
Box BoundsOf(const AnalyticShape& shape);

} // namespace hasp
