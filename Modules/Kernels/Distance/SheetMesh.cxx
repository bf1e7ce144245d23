#include "Distance/SheetMesh.h"

#include "MeshChecks.h"
#include "SolidChecks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace hasp
{
namespace
{

/// For each point the first that is equal to it within a millionth of a millimetre.
std::vector<std::uint32_t> FirstNear(std::vector<glm::dvec3> points)
{
  for (glm::dvec3& p : points)
    p = glm::round(p * 1e6) + 0.0; // -0 and 0 are one
  return FirstEqualPoints(points);
}

/// Unit; 0 of a triangle whose normal is rounding alone.
glm::dvec3 NormalOf(const glm::dvec3 (&p)[3])
{
  const glm::dvec3 a = p[1] - p[0], b = p[2] - p[0], c = p[2] - p[1];
  const glm::dvec3 normal = glm::cross(a, b);
  const double longest = std::max({ glm::dot(a, a), glm::dot(b, b), glm::dot(c, c) });
  return glm::length(normal) > 1e-9 * longest ? glm::normalize(normal) : glm::dvec3(0.0);
}

/// A mesh's triangles that have a normal, by points that are shared; and these points' normals.
struct Welded
{
  std::vector<glm::uvec3> triangles;
  std::vector<glm::dvec3> normals; ///< one a point of the mesh; those of points not used are 0
};

Welded Weld(const TriangleMesh& mesh)
{
  const std::vector<std::uint32_t> first = FirstNear(mesh.points);
  Welded welded{ {}, std::vector<glm::dvec3>(mesh.points.size(), glm::dvec3(0.0)) };
  for (const glm::uvec3& named : mesh.triangles)
  {
    const glm::uvec3 t(first[named.x], first[named.y], first[named.z]);
    const glm::dvec3 p[3] = { mesh.points[t.x], mesh.points[t.y], mesh.points[t.z] };
    const glm::dvec3 normal = NormalOf(p);
    if (normal == glm::dvec3(0.0))
      continue;
    welded.triangles.push_back(t);
    for (int n = 0; n < 3; ++n)
    {
      const glm::dvec3 a = p[(n + 1) % 3] - p[n], b = p[(n + 2) % 3] - p[n];
      welded.normals[t[n]] += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * normal;
    }
  }
  for (glm::dvec3& normal : welded.normals)
    if (glm::length(normal) > 1e-12)
      normal = glm::normalize(normal);
  return welded;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Edges that are left over when those that run both ways are taken away; each as often as it is.
std::vector<Edge> RimsOf(const std::vector<glm::uvec3>& triangles)
{
  std::map<Edge, int> turns; // from the lower number to the higher
  for (const glm::uvec3& t : triangles)
    for (int n = 0; n < 3; ++n)
    {
      const std::uint32_t a = t[n], b = t[(n + 1) % 3];
      if (a != b)
        turns[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  std::vector<Edge> rims;
  for (const auto& [edge, net] : turns)
    for (int n = 0; n < std::abs(net); ++n)
      rims.push_back(net > 0 ? edge : Edge(edge.second, edge.first));
  return rims;
}

} // namespace

TriangleMesh SheetMesh(const TriangleMesh& mesh, const SheetMeshSettings& settings)
{
  RequireFiniteMesh("sheet", mesh);
  if (!(settings.thicknessMm > 0.0 && settings.thicknessMm <= 100.0))
    throw std::invalid_argument(
      "sheet: thicknessMm is " + SolidNumber(settings.thicknessMm) + ", must be in (0, 100]");
  const Welded welded = Weld(mesh);
  if (welded.triangles.empty())
    throw std::invalid_argument("sheet: the mesh has no triangle with an area; give one that has");
  const auto count = static_cast<std::uint32_t>(mesh.points.size());
  const double out = settings.behind ? 0.0 : 0.5 * settings.thicknessMm;
  TriangleMesh sheet;
  sheet.points.reserve(2 * mesh.points.size());
  for (const double mm : { out, out - settings.thicknessMm })
    for (std::size_t n = 0; n < mesh.points.size(); ++n)
      sheet.points.push_back(mesh.points[n] + mm * welded.normals[n]);
  sheet.triangles = welded.triangles;
  for (const glm::uvec3& t : welded.triangles)
    sheet.triangles.push_back(glm::uvec3(t.x, t.z, t.y) + count);
  for (const auto& [a, b] : RimsOf(welded.triangles)) // against the way that the front passes it
  {
    sheet.triangles.push_back({ b, a, a + count });
    sheet.triangles.push_back({ b, a + count, b + count });
  }
  return sheet;
}

MeshRims FindRims(const TriangleMesh& mesh)
{
  RequireFiniteMesh("sheet", mesh);
  const std::vector<Edge> edges = RimsOf(Weld(mesh).triangles);
  MeshRims rims;
  rims.edges = edges.size();
  if (edges.empty())
    return rims;
  rims.at = 0.5 * (mesh.points[edges[0].first] + mesh.points[edges[0].second]);
  std::map<std::uint32_t, std::uint32_t> parent; // of points, towards their loop's
  const auto root = [&](std::uint32_t n)
  {
    while (parent[n] != n)
      n = parent[n] = parent[parent[n]];
    return n;
  };
  for (const auto& [a, b] : edges)
    for (const std::uint32_t n : { a, b })
      parent.emplace(n, n);
  for (const auto& [a, b] : edges)
    parent[root(a)] = root(b);
  std::map<std::uint32_t, double> lengths;
  for (const auto& [a, b] : edges)
    lengths[root(a)] += glm::distance(mesh.points[a], mesh.points[b]);
  rims.loops = lengths.size();
  for (const auto& [loop, mm] : lengths)
  {
    rims.lengthMm += mm;
    rims.longestMm = std::max(rims.longestMm, mm);
  }
  return rims;
}

} // namespace hasp
