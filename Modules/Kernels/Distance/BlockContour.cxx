#include "Distance/BlockContour.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hasp
{

namespace
{
constexpr int MostLevels = 3;      ///< edges of vertices below are halved where a tip comes through
constexpr double Steepest = 1.001; ///< slopes: directions are orthonormal within 1e-4

/// Share of an edge that points keep from its ends. The thinnest parts of a tetrahedron, with two
/// points near to the ends of edges, are about as high as its square.
double EdgeMargin(double steps)
{
  return std::clamp(1.6 / std::sqrt(steps), 0.01, 0.25);
}
} // namespace

BlockContour::BlockContour(
  const BoundedSolid& solid, const GridGeometry& grid, const ContourLimits& limits)
  : Solid(solid),
    Grid(grid),
    Limits(limits)
{
}

void BlockContour::Contour(const glm::ivec3& first, int size)
{
  const glm::ivec3 last = glm::min(first + size, this->Grid.Cells());
  if (first.x >= last.x || first.y >= last.y || first.z >= last.z)
    return;
  const glm::dvec3 middle = 0.5 * glm::dvec3(first + last);
  const double reach = 0.5 * glm::length(this->Grid.spacing * glm::dvec3(last - first));
  if (std::abs(this->Solid.At(this->Grid.IndexToWorld(middle))) > Steepest * reach)
    return;
  if (size == 1)
    this->Cell(first);
  else
    for (int c = 0; c < 8; ++c)
      this->Contour(first + CellCorner(c) * (size / 2), size / 2);
}

void BlockContour::FreeWork()
{
  this->Vertices = {};
  this->EdgeList = {};
  this->VertexAt = {};
  this->EdgeBetween = {};
  this->FaceBetween = {};
}

bool BlockContour::Before(std::uint32_t a, std::uint32_t b) const
{
  const glm::dvec3 &p = this->Vertices[a].index, &q = this->Vertices[b].index;
  return p.z != q.z ? p.z < q.z : p.y != q.y ? p.y < q.y : p.x < q.x;
}

/// An order of all edges, the same in all tetrahedra round an edge or a triangle: edges of the
/// grid before those that halving made.
bool BlockContour::EarlierEdge(
  const std::array<std::uint32_t, 2>& a, const std::array<std::uint32_t, 2>& b) const
{
  const auto level = [&](const auto& e)
  { return std::max(this->Vertices[e[0]].level, this->Vertices[e[1]].level); };
  if (level(a) != level(b))
    return level(a) < level(b);
  return a[0] != b[0] ? this->Before(a[0], b[0]) : this->Before(a[1], b[1]);
}

std::uint32_t BlockContour::AddVertex(const glm::dvec3& index, int level)
{
  const glm::dvec3 world = this->Grid.IndexToWorld(index);
  this->Vertices.push_back({ index, world, this->Solid.SampleAt(world), level });
  return std::uint32_t(this->Vertices.size() - 1);
}

std::uint32_t BlockContour::GridVertex(const glm::ivec3& place)
{
  const std::uint64_t key =
    std::uint64_t(place.z) << 42 | std::uint64_t(place.y) << 21 | std::uint64_t(place.x);
  const auto [found, isNew] = this->VertexAt.try_emplace(key, 0U);
  if (isNew)
    found->second = this->AddVertex(glm::dvec3(place), 0);
  return found->second;
}

glm::dvec3 BlockContour::Rounded(const glm::dvec3& index) const
{
  return glm::dvec3(glm::vec3(this->Grid.IndexToWorld(index)));
}

std::uint32_t BlockContour::AddPoint(const glm::dvec3& index)
{
  this->Indices.push_back(index);
  this->Points.push_back(this->Rounded(index));
  return std::uint32_t(this->Points.size() - 1);
}

int BlockContour::Level(std::span<const std::uint32_t> simplex) const
{
  int level = 0;
  for (const std::uint32_t corner : simplex)
    level = std::max(level, this->Vertices[corner].level);
  return level;
}

/// Of tips that divide a simplex. Parts are divided again, and so keep more from their corners: and
/// only by what would be far off, as parts of parts are thin, and the last have no tips at all.
TipLimits BlockContour::Tips(std::span<const std::uint32_t> simplex) const
{
  double shortest = std::numeric_limits<double>::max();
  for (const std::uint32_t a : simplex)
    for (const std::uint32_t b : simplex)
      if (a != b)
        shortest =
          std::min(shortest, glm::distance(this->Vertices[a].world, this->Vertices[b].world));
  const double root = std::sqrt(shortest / this->Limits.step);
  const int level = this->Level(simplex);
  return { std::max(16.0 * std::pow(1.5, level) / root, 0.03),
    level == 0 ? 0.0 : FarShare * this->Solid.Cell() };
}

BlockContour::Edge& BlockContour::FindEdge(std::uint32_t a, std::uint32_t b)
{
  const auto [found, isNew] = this->EdgeBetween.try_emplace(
    std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), std::uint32_t(this->EdgeList.size()));
  if (!isNew)
    return this->EdgeList[found->second];
  if (!this->Before(a, b))
    std::swap(a, b);
  const Vertex p = this->Vertices[a], q = this->Vertices[b];
  Edge edge;
  const bool crossed = this->Inside(a) != this->Inside(b);
  if (crossed)
    edge.crossing = FindCrossing(this->Solid, p.world, p.sample.value, q.world, q.sample.value);
  if (const std::array<std::uint32_t, 2> ends{ a, b }; this->Level(ends) < MostLevels)
  {
    const TipLimits limits = this->Tips(ends);
    const auto tip =
      crossed ? FindTip(this->Solid, p.world, p.sample, q.world, q.sample, edge.crossing, limits)
              : FindTip(this->Solid, p.world, p.sample, q.world, q.sample, limits);
    if (tip)
    {
      edge.split = this->AddVertex(p.index + *tip * (q.index - p.index), this->Level(ends) + 1);
      ++this->Splits;
    }
  }
  if (crossed && edge.split == None)
  {
    const double margin = EdgeMargin(glm::distance(p.world, q.world) / this->Limits.step);
    const double share = std::clamp(edge.crossing.share, margin, 1.0 - margin);
    edge.point = this->AddPoint(p.index + share * (q.index - p.index));
  }
  this->EdgeList.push_back(edge);
  return this->EdgeList.back();
}

const BlockContour::Face& BlockContour::FindFace(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  std::array<std::uint32_t, 3> v{ a, b, c };
  std::sort(v.begin(), v.end());
  const auto [found, isNew] = this->FaceBetween.try_emplace(
    std::uint64_t(v[0]) << 42 | std::uint64_t(v[1]) << 21 | v[2], Face());
  Face& face = found->second;
  if (!isNew)
    return face;
  std::sort(v.begin(), v.end(), [&](auto p, auto q) { return this->Before(p, q); });
  if (this->Inside(a) != this->Inside(b) || this->Inside(a) != this->Inside(c))
    this->Bend(face, v);
  else if (const int level = this->Level(v); level < MostLevels)
  {
    const auto vertex = [&](int n) -> const Vertex& { return this->Vertices[v[n]]; };
    const auto tip = FindTip(this->Solid, { vertex(0).world, vertex(1).world, vertex(2).world },
      this->Inside(a), this->Tips(v));
    if (tip)
    {
      face.split = this->AddVertex(vertex(0).index + tip->y * (vertex(1).index - vertex(0).index) +
                                     tip->z * (vertex(2).index - vertex(0).index),
        level + 1);
      ++this->Splits;
    }
  }
  return face;
}

void BlockContour::Cell(const glm::ivec3& cell)
{
  ++this->Cells;
  std::uint32_t corner[8];
  for (int c = 0; c < 8; ++c)
    corner[c] = this->GridVertex(cell + CellCorner(c));
  for (const auto& t : KuhnTetrahedra)
    this->Refine({ corner[t[0]], corner[t[1]], corner[t[2]], corner[t[3]] });
}

/// The ends of the edge to halve first, and the vertex that does it: None if there is nothing to
/// do.
std::array<std::uint32_t, 2> BlockContour::SplitEdge(
  const Tetrahedron& corners, std::uint32_t& split)
{
  split = None;
  std::array<std::uint32_t, 2> ends{};
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b)
    {
      std::array<std::uint32_t, 2> e{ corners[a], corners[b] };
      const std::uint32_t at = this->FindEdge(e[0], e[1]).split;
      if (at == None)
        continue;
      if (!this->Before(e[0], e[1]))
        std::swap(e[0], e[1]);
      if (split == None || this->EarlierEdge(e, ends))
        split = at, ends = e;
    }
  return ends;
}

/// The same for triangles, of a tetrahedron without edges to halve.
std::array<std::uint32_t, 3> BlockContour::SplitFace(
  const Tetrahedron& corners, std::uint32_t& split)
{
  split = None;
  for (int away = 0; away < 4; ++away)
  {
    const std::array<std::uint32_t, 3> v{ corners[away == 0 ? 1 : 0], corners[away < 2 ? 2 : 1],
      corners[away < 3 ? 3 : 2] };
    const auto face = [&](int n) { return this->Vertices[v[n]].sample.face; };
    const bool crossed =
      this->Inside(v[0]) != this->Inside(v[1]) || this->Inside(v[0]) != this->Inside(v[2]);
    if (!crossed && face(0) == face(1) && face(0) == face(2))
      continue;
    split = this->FindFace(v[0], v[1], v[2]).split;
    if (split != None)
      return v;
  }
  return {};
}

void BlockContour::Refine(const Tetrahedron& corners)
{
  std::uint32_t split = None;
  const auto edge = this->SplitEdge(corners, split);
  if (split != None)
    return this->Divide(corners, edge, split);
  const auto face = this->SplitFace(corners, split);
  if (split != None)
    return this->Divide(corners, face, split);
  this->Surface(corners);
}

/// Into tetrahedra with a vertex in place of one of an edge's, a triangle's or its own corners.
void BlockContour::Divide(
  const Tetrahedron& corners, std::span<const std::uint32_t> around, std::uint32_t split)
{
  for (const std::uint32_t corner : around)
  {
    Tetrahedron part = corners;
    std::replace(part.begin(), part.end(), corner, split);
    this->Refine(part);
  }
}

} // namespace hasp
