#pragma once
#include "Grid/TriangleMesh.h"

#include <glm/geometric.hpp>

#include <map>
#include <tuple>
#include <utility>

namespace hasp
{

/// The facts of a mesh by the plainest means: a map of directed edges.
struct MeshFacts
{
  bool closed = true;     ///< there are triangles, and every directed edge has its opposite
  bool manifold = true;   ///< no directed edge occurs twice, no triangle repeats a point
  std::size_t noArea = 0; ///< triangles
  double volume = 0.0;    ///< signed, mm^3
  int euler = 0;          ///< points in use - edges + triangles
};

inline MeshFacts FactsOf(const TriangleMesh& mesh)
{
  MeshFacts facts;
  std::map<std::pair<unsigned, unsigned>, int> edges;
  std::map<unsigned, int> used;
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3& o = mesh.points[mesh.triangles[0].x];
    facts.noArea += !(glm::length(glm::cross(b - a, c - a)) > 0.0);
    facts.volume += glm::dot(a - o, glm::cross(b - o, c - o)) / 6.0;
    for (int n = 0; n < 3; ++n)
    {
      facts.manifold &= t[n] != t[(n + 1) % 3] && ++edges[{ t[n], t[(n + 1) % 3] }] == 1;
      ++used[t[n]];
    }
  }
  facts.closed = !mesh.triangles.empty();
  for (const auto& [edge, count] : edges)
    facts.closed &= edges.count({ edge.second, edge.first }) == 1;
  facts.euler = int(used.size()) - int(edges.size()) / 2 + int(mesh.triangles.size());
  return facts;
}

/// As an STL file keeps it and gives it back: 32-bit floats, points of equal coordinates made one.
inline TriangleMesh RoundedAndWelded(const TriangleMesh& mesh)
{
  TriangleMesh result;
  std::map<std::tuple<float, float, float>, unsigned> ids;
  const auto id = [&](unsigned p)
  {
    const glm::vec3 at(mesh.points[p]);
    const auto [found, isNew] = ids.try_emplace({ at.x, at.y, at.z }, unsigned(ids.size()));
    if (isNew)
      result.points.emplace_back(at);
    return found->second;
  };
  for (const glm::uvec3& t : mesh.triangles)
    result.triangles.emplace_back(id(t.x), id(t.y), id(t.z));
  return result;
}

} // namespace hasp
