#include "Evaluation/MeshCheck.h"

#include "Evaluation/DisjointSets.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace hasp
{

namespace
{
struct HalfEdge
{
  std::uint32_t low, high, triangle;
  bool up; ///< runs from low to high
  bool operator<(const HalfEdge& o) const
  {
    return std::tie(low, high, triangle) < std::tie(o.low, o.high, o.triangle);
  }
  bool SameEdge(const HalfEdge& o) const { return low == o.low && high == o.high; }
};

std::vector<HalfEdge> SortedHalfEdges(const TriangleMesh& mesh)
{
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t a = mesh.triangles[t][c], b = mesh.triangles[t][(c + 1) % 3];
      edges.push_back({ std::min(a, b), std::max(a, b), t, a < b });
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::uint32_t CornerOf(const TriangleMesh& mesh, std::uint32_t triangle, std::uint32_t point)
{
  const glm::uvec3& t = mesh.triangles[triangle];
  return 3 * triangle + (t.x == point ? 0 : t.y == point ? 1 : 2);
}

void Count(std::size_t& number, std::optional<glm::dvec3>& first, const glm::dvec3& place)
{
  if (number++ == 0)
    first = place;
}

/// Counts faults of edges, and joins pieces (triangles) and fans (corners) across sound edges.
void CheckEdges(
  const TriangleMesh& mesh, MeshCheck& check, DisjointSets& pieces, DisjointSets& fans)
{
  const std::vector<HalfEdge> edges = SortedHalfEdges(mesh);
  for (std::size_t first = 0, last; first < edges.size(); first = last)
  {
    for (last = first + 1; last < edges.size() && edges[last].SameEdge(edges[first]); ++last)
      pieces.Join(edges[first].triangle, edges[last].triangle);
    const glm::dvec3 middle =
      0.5 * (mesh.points[edges[first].low] + mesh.points[edges[first].high]);
    if (last - first == 1)
      Count(check.borderEdges, check.borderAt, middle);
    else if (last - first > 2)
      Count(check.crowdedEdges, check.crowdedAt, middle);
    else
    {
      const HalfEdge &a = edges[first], &b = edges[first + 1];
      if (a.up == b.up)
        Count(check.turnedEdges, check.turnedAt, middle);
      for (const std::uint32_t p : { a.low, a.high })
        fans.Join(CornerOf(mesh, a.triangle, p), CornerOf(mesh, b.triangle, p));
    }
  }
}
} // namespace

MeshCheck CheckMesh(const TriangleMesh& mesh)
{
  MeshCheck check;
  check.points = mesh.points.size();
  check.triangles = mesh.triangles.size();
  for (const glm::uvec3& t : mesh.triangles)
  {
    if (std::max({ t.x, t.y, t.z }) >= mesh.points.size())
      throw std::invalid_argument("mesh: a triangle names point " +
                                  std::to_string(std::max({ t.x, t.y, t.z })) + " of " +
                                  std::to_string(mesh.points.size()));
    const glm::dvec3 &o = mesh.points[mesh.triangles.front().x], &a = mesh.points[t.x],
                     &b = mesh.points[t.y], &c = mesh.points[t.z];
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    check.areaMm2 += area;
    check.volumeMm3 += glm::dot(a - o, glm::cross(b - o, c - o)) / 6.0;
    if (t.x == t.y || t.y == t.z || t.z == t.x || !(area > 0.0))
      Count(check.degenerate, check.degenerateAt, a);
  }
  DisjointSets pieces(mesh.triangles.size()), fans(3 * mesh.triangles.size());
  CheckEdges(mesh, check, pieces, fans);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    check.pieces += pieces.Root(t) == t;

  std::vector<std::uint32_t> fansAt(mesh.points.size(), 0);
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner)
    if (fans.Root(corner) == corner)
      ++fansAt[mesh.triangles[corner / 3][static_cast<int>(corner % 3)]];
  for (std::size_t p = 0; p < fansAt.size(); ++p)
    if (fansAt[p] > 1)
      Count(check.pinchedPoints, check.pinchedAt, mesh.points[p]);
  return check;
}

TriangleMesh WeldPoints(const TriangleMesh& mesh)
{
  for (std::size_t n = 0; n < mesh.points.size(); ++n)
    if (const glm::dvec3& p = mesh.points[n];
        !(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
      throw std::invalid_argument(
        "mesh: point " + std::to_string(n) + " is not finite, and has no place in an order");
  struct Place
  {
    glm::dvec3 at;
    std::uint32_t point;
    bool operator<(const Place& o) const
    {
      return std::tie(at.x, at.y, at.z) < std::tie(o.at.x, o.at.y, o.at.z);
    }
  };
  std::vector<Place> order;
  order.reserve(mesh.points.size());
  for (const glm::dvec3& p : mesh.points)
    order.push_back({ p, static_cast<std::uint32_t>(order.size()) });
  std::sort(order.begin(), order.end());
  TriangleMesh welded;
  std::vector<std::uint32_t> newId(mesh.points.size());
  for (std::size_t n = 0; n < order.size(); ++n)
  {
    if (n == 0 || order[n - 1] < order[n])
      welded.points.push_back(order[n].at);
    newId[order[n].point] = static_cast<std::uint32_t>(welded.points.size() - 1);
  }
  welded.triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles)
    welded.triangles.emplace_back(newId[t.x], newId[t.y], newId[t.z]);
  return welded;
}

} // namespace hasp
