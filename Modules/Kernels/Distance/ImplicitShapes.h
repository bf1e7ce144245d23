#pragma once
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

/// Exact signed distances of simple shapes, mm, negative inside, and their composition:
/// union min(a, b), intersection max(a, b), difference max(a, -b), offset a - mm. A composition is
/// exact at its surface's faces and a bound elsewhere. Unit vectors must be unit; nothing is
/// checked. Any thread.
namespace hasp
{

/// The half space behind a plane (its normal points out).
inline double PlaneSide(const glm::dvec3& x, const glm::dvec3& point, const glm::dvec3& normal)
{
  return glm::dot(x - point, normal);
}

/// The slab of total thickness `width` around a plane.
inline double SlabDistance(
  const glm::dvec3& x, const glm::dvec3& point, const glm::dvec3& normal, double width)
{
  return std::abs(glm::dot(x - point, normal)) - 0.5 * width;
}

/// A cylinder without ends around a line.
inline double CylinderDistance(
  const glm::dvec3& x, const glm::dvec3& point, const glm::dvec3& axis, double radius)
{
  const glm::dvec3 v = x - point;
  return glm::length(v - glm::dot(v, axis) * axis) - radius;
}

/// The ball-ended tube around a segment; a ball if both ends are the same.
inline double CapsuleDistance(
  const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b, double radius)
{
  const glm::dvec3 along = b - a, v = x - a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0.0 ? glm::clamp(glm::dot(v, along) / squared, 0.0, 1.0) : 0.0;
  return glm::length(v - t * along) - radius;
}

/// The tube around a polyline, or around a closed polygon. No points: +infinity.
inline double TubeDistance(
  const glm::dvec3& x, std::span<const glm::dvec3> line, bool closed, double radius)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < line.size(); ++n)
    if (closed || n + 1 < line.size() || line.size() == 1)
      least = std::min(least, CapsuleDistance(x, line[n], line[(n + 1) % line.size()], radius));
  return least;
}

/// A box; `axes` holds its unit directions as columns, `half` half its sides.
inline double BoxDistance(
  const glm::dvec3& x, const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& half)
{
  const glm::dvec3 q =
    glm::abs((x - center) * axes) - half; // row vector times matrix: dot products
  return glm::length(glm::max(q, glm::dvec3(0.0))) + std::min(std::max({ q.x, q.y, q.z }), 0.0);
}

/// A polygon in the plane (even-odd rule where it crosses itself); at least three corners.
inline double PolygonDistance(const glm::dvec2& x, std::span<const glm::dvec2> corners)
{
  double squared = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t n = 0; n < corners.size(); ++n)
  {
    const glm::dvec2 a = corners[n], b = corners[(n + 1) % corners.size()];
    const glm::dvec2 e = b - a, v = x - a;
    const double length = glm::dot(e, e);
    const glm::dvec2 d =
      v - (length > 0.0 ? glm::clamp(glm::dot(v, e) / length, 0.0, 1.0) : 0.0) * e;
    squared = std::min(squared, glm::dot(d, d));
    if ((a.y > x.y) != (b.y > x.y) && v.x < (x.y - a.y) * e.x / e.y)
      inside = !inside;
  }
  return inside ? -std::sqrt(squared) : std::sqrt(squared);
}

} // namespace hasp
