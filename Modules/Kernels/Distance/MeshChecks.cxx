#include "MeshChecks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace hasp
{

std::vector<std::uint32_t> FirstEqualPoints(const std::vector<glm::dvec3>& points)
{
  std::vector<std::uint32_t> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&points](std::uint32_t n)
  { return std::tie(points[n].x, points[n].y, points[n].z); };
  std::sort(order.begin(), order.end(),
    [&key](std::uint32_t a, std::uint32_t b)
    { return key(a) < key(b) || (key(a) == key(b) && a < b); });
  for (std::size_t n = 0; n < order.size(); ++n)
    first[order[n]] = n > 0 && key(order[n]) == key(order[n - 1]) ? first[order[n - 1]] : order[n];
  return first;
}

namespace
{
/// An edge of a triangle, its points as places in the order of all that differ.
struct Edge
{
  std::uint32_t low, high;
  int turn; ///< +1 from low to high
  auto Ends() const { return std::tie(this->low, this->high); }
};

[[noreturn]] void Refuse(const std::string& who, const glm::dvec3& edge, bool wound)
{
  const std::string at = "the edge at (" + std::to_string(edge.x) + ", " + std::to_string(edge.y) +
                         ", " + std::to_string(edge.z) + ") mm";
  throw std::invalid_argument(
    wound ? who + ": the triangles on both sides of " + at +
              " are wound against each other; turn all of them the same way round first"
          : who + ": the mesh is not closed: " + at +
              " has no triangle that goes on beyond it; fill its holes first");
}

/// Where triangles pass each edge as often one way as the other there is no rim: whatever line goes
/// in comes out.
void CheckClosed(const std::string& who, const TriangleMesh& mesh)
{
  const std::vector<std::uint32_t> first = FirstEqualPoints(mesh.points);
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles)
    for (int n = 0; n < 3; ++n)
    {
      const std::uint32_t a = first[t[n]], b = first[t[(n + 1) % 3]];
      if (a != b)
        edges.push_back({ std::min(a, b), std::max(a, b), a < b ? 1 : -1 });
    }
  std::sort(
    edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.Ends() < b.Ends(); });
  for (std::size_t n = 0; n < edges.size();)
  {
    const Edge& edge = edges[n];
    int turns = 0;
    const std::size_t begin = n;
    for (; n < edges.size() && edges[n].Ends() == edge.Ends(); ++n)
      turns += edges[n].turn;
    if (turns != 0)
      Refuse(who, 0.5 * (mesh.points[edge.low] + mesh.points[edge.high]), (n - begin) % 2 == 0);
  }
}
} // namespace

void RequireFiniteMesh(const std::string& who, const TriangleMesh& mesh)
{
  for (const glm::dvec3& p : mesh.points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw std::invalid_argument(who + ": a point of the mesh is not finite");
  for (const glm::uvec3& t : mesh.triangles)
    if (std::max({ t.x, t.y, t.z }) >= mesh.points.size())
      throw std::invalid_argument(who + ": a triangle names point " +
                                  std::to_string(std::max({ t.x, t.y, t.z })) + " of " +
                                  std::to_string(mesh.points.size()));
}

void RequireClosedMesh(const std::string& who, const TriangleMesh& mesh)
{
  RequireFiniteMesh(who, mesh);
  CheckClosed(who, mesh);
}

} // namespace hasp
