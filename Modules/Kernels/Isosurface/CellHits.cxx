#include "Isosurface/CellHits.h"
#include "Isosurface/RayRoot.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <bit>
#include <utility>

namespace hasp
{

namespace
{

// Boxes reach this far into their neighbours, in voxels, so that no line slips between two; as in
// drawing.
constexpr double Overlap = 1e-4;

struct Line
{
  glm::dvec3 from, way;
};

/// The part of the line in a box of `side`, as two values of t in [0, 1]; nothing if there is none.
std::optional<std::pair<double, double>> ClipToBox(
  const Line& line, const glm::dvec3& corner, double side)
{
  double t0 = 0.0, t1 = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    const double low = corner[a] - Overlap - line.from[a], high = low + side + 2.0 * Overlap;
    if (line.way[a] == 0.0)
    {
      if (!(low <= 0.0 && high >= 0.0))
        return std::nullopt;
      continue;
    }
    const double u = low / line.way[a], v = high / line.way[a];
    t0 = std::max(t0, std::min(u, v));
    t1 = std::min(t1, std::max(u, v));
  }
  if (!(t0 <= t1))
    return std::nullopt;
  return std::pair(t0, t1);
}

std::optional<LineHit> Hit(const ClusteredCells& cells, const CellCluster& cluster,
  const glm::ivec3& inCluster, std::size_t n, const Line& line)
{
  const glm::dvec3 cell(cluster.Origin() + inCluster);
  const auto part = ClipToBox(line, cell, 1.0);
  if (!part)
    return std::nullopt;
  const std::array<float, 8> c = cells.CornersFromIsovalue(cluster, inCluster);
  const glm::vec4 low(c[0], c[1], c[2], c[3]), high(c[4], c[5], c[6], c[7]);
  const glm::dvec3 enter = line.from + part->first * line.way - cell;
  const glm::dvec3 leave = line.from + part->second * line.way - cell;
  float s = 0.0F;
  if (!glsl::HaspFirstRoot(
        glsl::HaspRayBernstein(low, high, glm::vec3(enter), glm::vec3(leave)), s))
    return std::nullopt;
  const glm::dvec3 local = glm::mix(enter, leave, static_cast<double>(s));
  return LineHit{ n, part->first + s * (part->second - part->first), cell + local,
    glm::dvec3(glsl::HaspTrilinearGradient(low, high, glm::vec3(local))) };
}

bool Finite(const Line& line)
{
  const glm::dvec3 sum = line.from + line.way;
  return sum - sum == glm::dvec3(0.0);
}

} // namespace

std::optional<LineHit> HitCell(
  const ClusteredCells& cells, std::size_t n, const glm::dvec3& from, const glm::dvec3& to)
{
  const Line line{ from, to - from };
  if (n >= cells.Count() || !Finite(line))
    return std::nullopt;
  const CellCluster& cluster = cells.clusters[cells.ClusterOf(n)];
  return Hit(cells, cluster, cells.Cell(n) - cluster.Origin(), n, line);
}

std::optional<LineHit> FirstHit(const ClusteredCells& cells, const glm::dvec3& from,
  const glm::dvec3& to, const std::function<bool(std::size_t)>& counts)
{
  const Line line{ from, to - from };
  std::optional<LineHit> first;
  if (!Finite(line))
    return first;
  for (const CellCluster& cluster : cells.clusters)
  {
    const auto part = ClipToBox(line, glm::dvec3(cluster.Origin()), 8.0);
    if (!part || (first && part->first > first->t))
      continue;
    std::size_t n = cluster.firstCell;
    for (int z = 0; z < 8; ++z)
      for (std::uint64_t left = cluster.active[z]; left != 0; left &= left - 1, ++n)
      {
        const int place = std::countr_zero(left);
        const auto hit = Hit(cells, cluster, { place & 7, place >> 3, z }, n, line);
        if (hit && (!first || hit->t < first->t) && (!counts || counts(n)))
          first = hit;
      }
  }
  return first;
}

} // namespace hasp
