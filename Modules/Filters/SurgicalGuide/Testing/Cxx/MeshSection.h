#pragma once
#include "Grid/TriangleMesh.h"

#include <glm/geometric.hpp>

#include <limits>
#include <utility>

/// What is measured of parts with closed forms.
namespace parttest
{

/// Where a mesh meets a plane: seen along u and v in the plane.
struct MeshSection
{
  double area = 0.0; ///< mm2, positive
  glm::dvec2 low{ std::numeric_limits<double>::infinity() };
  glm::dvec2 high{ -std::numeric_limits<double>::infinity() };
};

inline bool Everywhere(const glm::dvec3&)
{
  return true;
}

/// `u` x `v` is the plane's normal; unit. `isMine(place)`: other parts of the section do not count.
template <typename IsMine>
MeshSection SectionOf(const hasp::TriangleMesh& mesh, const glm::dvec3& point, const glm::dvec3& u,
  const glm::dvec3& v, const IsMine& isMine)
{
  const glm::dvec3 normal = glm::cross(u, v);
  MeshSection section;
  for (const glm::uvec3& t : mesh.triangles)
  {
    std::pair<int, glm::dvec2> ends[2]; // comes in (-1) or goes out (1)
    int count = 0;
    glm::dvec3 middle(0.0);
    for (int n = 0; n < 3; ++n)
    {
      const glm::dvec3 a = mesh.points[t[n]] - point, b = mesh.points[t[(n + 1) % 3]] - point;
      const double da = glm::dot(a, normal), db = glm::dot(b, normal);
      if ((da < 0.0) == (db < 0.0))
        continue;
      const glm::dvec3 x = glm::mix(a, b, da / (da - db));
      middle += 0.5 * x;
      ends[count++] = { da < 0.0 ? -1 : 1, { glm::dot(x, u), glm::dot(x, v) } };
    }
    if (count != 2 || !isMine(point + middle))
      continue;
    const glm::dvec2 from = ends[0].first > 0 ? ends[0].second : ends[1].second;
    const glm::dvec2 to = ends[0].first > 0 ? ends[1].second : ends[0].second;
    section.area += 0.5 * (from.x * to.y - from.y * to.x);
    section.low = glm::min(section.low, glm::min(from, to));
    section.high = glm::max(section.high, glm::max(from, to));
  }
  section.area = std::abs(section.area);
  return section;
}

/// Distances from an axis of a mesh's points between two heights along it that are nearer than
/// `within`: least and most.
inline std::pair<double, double> RadiiOf(const hasp::TriangleMesh& mesh, const glm::dvec3& origin,
  const glm::dvec3& axis, double fromHeight, double toHeight, double within)
{
  std::pair<double, double> radii{ std::numeric_limits<double>::infinity(), 0.0 };
  for (const glm::dvec3& p : mesh.points)
  {
    const double height = glm::dot(p - origin, axis);
    const double away = glm::length(p - origin - height * axis);
    if (height < fromHeight || height > toHeight || away > within)
      continue;
    radii = { std::min(radii.first, away), std::max(radii.second, away) };
  }
  return radii;
}

} // namespace parttest
