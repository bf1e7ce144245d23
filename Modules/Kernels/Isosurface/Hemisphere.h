#pragma once
// Directions around a normal, for ambient occlusion and for light.
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace hasp
{

/// Columns: two unit vectors across `axis`, and axis itself, unit. Duff et al. 2017, without a
/// branch.
inline glm::dmat3 FrameAround(const glm::dvec3& axis)
{
  const double sign = std::copysign(1.0, axis.z), a = -1.0 / (sign + axis.z),
               b = axis.x * axis.y * a;
  return { { 1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x },
    { b, sign + axis.y * axis.y * a, -axis.y }, axis };
}

/// A direction of the cosine-weighted hemisphere around z; even over it where p is over the unit
/// square.
inline glm::dvec3 CosineWeighted(const glm::dvec2& p)
{
  const double turn = glm::two_pi<double>() * p.x, r = std::sqrt(p.y);
  return { r * std::cos(turn), r * std::sin(turn), std::sqrt(1.0 - p.y) };
}

/// The same around a unit normal.
inline glm::dvec3 CosineAround(const glm::dvec3& normal, const glm::dvec2& p)
{
  return FrameAround(normal) * CosineWeighted(p);
}

} // namespace hasp
