#pragma once
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>

namespace hasp
{

/// A piece of the surface in one cell, in [0,1]^3.
using CellTriangle = std::array<glm::dvec3, 3>;

/// Six tetrahedra around the diagonal from corner 0 to corner 7; neighbouring cells agree on the
/// faces they share.
inline constexpr int CellTetrahedra[6][4] = { { 0, 1, 3, 7 }, { 0, 3, 2, 7 }, { 0, 2, 6, 7 },
  { 0, 6, 4, 7 }, { 0, 4, 5, 7 }, { 0, 5, 1, 7 } };

/// Calls visit(triangle) for the pieces of surface in one tetrahedron until it returns true;
/// returns that. Inside is <= 0.
template <typename Visit>
bool InTetrahedron(const std::array<double, 8>& values, const int (&corners)[4], const Visit& visit)
{
  std::array<int, 4> sorted{}; // those inside first
  int inside = 0, outside = 4;
  for (const int c : corners)
    (values[c] <= 0.0 ? sorted[inside++] : sorted[--outside]) = c;
  const auto crossing = [&](int in, int out)
  {
    const int a = sorted[in], b = sorted[out];
    const double t = values[a] / (values[a] - values[b]);
    const glm::dvec3 from{ a & 1, a >> 1 & 1, a >> 2 }, to{ b & 1, b >> 1 & 1, b >> 2 };
    return from + t * (to - from);
  };
  if (inside == 1)
    return visit(CellTriangle{ crossing(0, 1), crossing(0, 2), crossing(0, 3) });
  if (inside == 3)
    return visit(CellTriangle{ crossing(0, 3), crossing(1, 3), crossing(2, 3) });
  return inside == 2 && (visit(CellTriangle{ crossing(0, 2), crossing(0, 3), crossing(1, 3) }) ||
                          visit(CellTriangle{ crossing(0, 2), crossing(1, 3), crossing(1, 2) }));
}

/// Calls visit(triangle) for the pieces of the zero surface in a cell, always in the same order,
/// until it returns true; at most 12. Corners as of CellCorners, finite. Inside is <= 0.
template <typename Visit>
void InCell(const std::array<double, 8>& values, const Visit& visit)
{
  for (const auto& tetrahedron : CellTetrahedra)
    if (InTetrahedron(values, tetrahedron, visit))
      return;
}

/// mm^2.
inline double AreaOf(const CellTriangle& t, const glm::dvec3& spacing)
{
  return 0.5 * glm::length(glm::cross((t[1] - t[0]) * spacing, (t[2] - t[0]) * spacing));
}

/// A point in the triangle from two numbers in [0, 1), evenly.
inline glm::dvec3 PointIn(const CellTriangle& t, double u, double v)
{
  const double root = std::sqrt(u);
  return (1.0 - root) * t[0] + root * (1.0 - v) * t[1] + root * v * t[2];
}

} // namespace hasp
