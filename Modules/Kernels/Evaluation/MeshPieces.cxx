#include "Evaluation/MeshPieces.h"

#include "Evaluation/DisjointSets.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>

namespace hasp
{

namespace
{
struct Edge
{
  std::uint32_t low, high, triangle;
  auto Key() const { return std::tie(low, high); }
};

DisjointSets JoinThroughEdges(const TriangleMesh& mesh)
{
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t a = mesh.triangles[t][c], b = mesh.triangles[t][(c + 1) % 3];
      edges.push_back({ std::min(a, b), std::max(a, b), t });
    }
  std::sort(
    edges.begin(), edges.end(), [](const Edge& l, const Edge& r) { return l.Key() < r.Key(); });
  DisjointSets pieces(mesh.triangles.size());
  for (std::size_t n = 1; n < edges.size(); ++n)
    if (edges[n].Key() == edges[n - 1].Key())
      pieces.Join(edges[n - 1].triangle, edges[n].triangle);
  return pieces;
}
} // namespace

std::vector<MeshPiece> MeshPieces(const TriangleMesh& mesh)
{
  for (const glm::uvec3& t : mesh.triangles)
    if (const std::uint32_t most = std::max({ t.x, t.y, t.z }); most >= mesh.points.size())
      throw std::invalid_argument("mesh: a triangle names point " + std::to_string(most) + " of " +
                                  std::to_string(mesh.points.size()));
  DisjointSets roots = JoinThroughEdges(mesh);
  std::unordered_map<std::uint32_t, std::size_t> numbers;
  std::vector<MeshPiece> pieces;
  for (std::uint32_t n = 0; n < mesh.triangles.size(); ++n)
  {
    const auto [found, isNew] = numbers.try_emplace(roots.Root(n), pieces.size());
    if (isNew)
    {
      pieces.emplace_back();
      pieces.back().low = glm::dvec3(std::numeric_limits<double>::infinity());
      pieces.back().high = -pieces.back().low;
    }
    MeshPiece& piece = pieces[found->second];
    const glm::uvec3& t = mesh.triangles[n];
    const glm::dvec3 &o = mesh.points[mesh.triangles.front().x], &a = mesh.points[t.x],
                     &b = mesh.points[t.y], &c = mesh.points[t.z];
    ++piece.triangles;
    piece.volumeMm3 += glm::dot(a - o, glm::cross(b - o, c - o)) / 6.0;
    piece.low = glm::min(piece.low, glm::min(a, glm::min(b, c)));
    piece.high = glm::max(piece.high, glm::max(a, glm::max(b, c)));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
    [](const MeshPiece& l, const MeshPiece& r)
    { return std::abs(l.volumeMm3) > std::abs(r.volumeMm3); });
  return pieces;
}

} // namespace hasp
