#include "Distance/BlockContour.h"
#include "Distance/ImplicitShapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace hasp
{

namespace
{
constexpr double LeastTurn = 1e-3; ///< of a triangle's area, twice
constexpr int MostLevels = 2;      ///< edges of vertices below are halved where a tip comes through
constexpr double Steepest = 1.001; ///< slopes: directions are orthonormal within 1e-4

/// Keeps shares of corners, which sum up to 1, at least those of `least`, on the way to `safe`,
/// whose shares are.
template <class Shares>
Shares KeepInside(const Shares& wanted, const Shares& safe, const Shares& least, bool& moved)
{
  double way = 1.0;
  for (int n = 0; n < Shares::length(); ++n)
    if (wanted[n] < least[n])
      way = std::min(way, (safe[n] - least[n]) / (safe[n] - wanted[n]));
  moved = way < 1.0;
  return safe + way * (wanted - safe);
}

/// Of the triangles of a fan from a center to a ring: the least height.
double LeastHeight(const glm::dvec3& center, const std::vector<glm::dvec3>& ring)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t n = 0; n < ring.size(); ++n)
  {
    const glm::dvec3 a = ring[n] - center, b = ring[(n + 1) % ring.size()] - center;
    const double longest = std::max({ glm::dot(a, a), glm::dot(b, b), glm::dot(b - a, b - a) });
    least = std::min(least, glm::length(glm::cross(a, b)) / std::sqrt(longest));
  }
  return least;
}

/// Between the points of an open line and its sides that do not end there: the least distance.
double LeastGap(std::span<const glm::dvec3> line)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t n = 0; n < line.size(); ++n)
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      if (n != k && n != k + 1)
        least = std::min(least, CapsuleDistance(line[n], line[k], line[k + 1], 0.0));
  return least;
}

/// Twice the area of a triangle in a triangle, by the shares of its corners; above 0 to the left.
double Turn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  return (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
}

/// A line through four places turns one way, also back to its start: it does not meet itself.
bool IsConvex(const std::array<glm::dvec3, 4>& line)
{
  double least = 1.0, most = -1.0;
  for (int n = 0; n < 4; ++n)
  {
    const double turn = Turn(line[n], line[(n + 1) % 4], line[(n + 2) % 4]);
    least = std::min(least, turn), most = std::max(most, turn);
  }
  return least > LeastTurn || most < -LeastTurn;
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

std::uint32_t BlockContour::AddPoint(const glm::dvec3& index)
{
  this->Points.push_back(index);
  return std::uint32_t(this->Points.size() - 1);
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
  if (this->Inside(a) != this->Inside(b))
  {
    edge.crossing = FindCrossing(this->Solid, p.world, p.sample.value, q.world, q.sample.value);
    const double share =
      std::clamp(edge.crossing.share, this->Limits.margin, 1.0 - this->Limits.margin);
    edge.point = this->AddPoint(p.index + share * (q.index - p.index));
  }
  else if (const int level = std::max(p.level, q.level); level < MostLevels)
    if (const auto tip = FindTip(this->Solid, p.world, p.sample, q.world, q.sample))
    {
      edge.split = this->AddVertex(p.index + *tip * (q.index - p.index), level + 1);
      ++this->Splits;
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
  else if (const int level = std::max(
             { this->Vertices[a].level, this->Vertices[b].level, this->Vertices[c].level });
           level < MostLevels)
  {
    const auto vertex = [&](int n) -> const Vertex& { return this->Vertices[v[n]]; };
    const auto tip =
      FindTip(this->Solid, { vertex(0).world, vertex(1).world, vertex(2).world }, this->Inside(a));
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

void BlockContour::Bend(Face& face, const std::array<std::uint32_t, 3>& v)
{
  std::array<glm::dvec3, 3> world, index;
  for (int n = 0; n < 3; ++n)
    world[n] = this->Vertices[v[n]].world, index[n] = this->Vertices[v[n]].index;
  EdgeCrossing crossing[2];
  glm::dvec3 end[2];
  int count = 0;
  for (int n = 0; n < 3; ++n)
    if (const auto p = v[n], q = v[(n + 1) % 3]; this->Inside(p) != this->Inside(q))
    {
      const Edge& edge = this->FindEdge(p, q);
      if (count == 0)
        face.from = edge.point;
      end[count] = Barycentric(world, this->Grid.IndexToWorld(this->Points[edge.point]));
      crossing[count++] = edge.crossing;
    }
  const glm::dvec3 normal = glm::normalize(glm::cross(world[1] - world[0], world[2] - world[0]));
  Bends bends = FindBends(this->Solid, normal, crossing[0], crossing[1], this->Limits.tolerance);
  const glm::dvec3 safe = 0.5 * (end[0] + end[1]);
  glm::dvec3 share[2];
  bool moved[2]{};
  for (int n = 0; n < bends.count; ++n)
    share[n] =
      KeepInside(Barycentric(world, bends.point[n].at), safe,
      glm::dvec3(0.25 * this->Limits.margin), moved[n]);
  if (bends.count == 2 && !IsConvex({ end[0], share[0], share[1], end[1] }))
  {
    // The one that is further from the straight line.
    const auto off = [&](int n) { return std::abs(Turn(end[0], share[n], end[1])); };
    if (off(1) > off(0))
      std::swap(share[0], share[1]), std::swap(bends.point[0], bends.point[1]);
    bends.count = 1;
  }
  for (int n = 0; n < bends.count; ++n)
  {
    // From the first corner on, so that a point on a plane of the grid has that plane's index.
    face.point[n] = this->AddPoint(
      index[0] + share[n].y * (index[1] - index[0]) + share[n].z * (index[2] - index[0]));
    this->CreasePoints += bends.point[n].Crease();
    this->KeptInside += moved[n];
  }
  face.bends = bends;
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
    if (this->Inside(v[0]) != this->Inside(v[1]) || this->Inside(v[0]) != this->Inside(v[2]) ||
        (face(0) == face(1) && face(0) == face(2)))
      continue;
    split = this->FindFace(v[0], v[1], v[2]).split;
    if (split != None)
      return v;
  }
  return {};
}

void BlockContour::Refine(const Tetrahedron& corners)
{
  const auto divide = [&](const auto& ends, std::uint32_t split)
  {
    for (const std::uint32_t end : ends)
    {
      Tetrahedron part = corners;
      std::replace(part.begin(), part.end(), end, split);
      this->Refine(part);
    }
  };
  std::uint32_t split = None;
  const auto edge = this->SplitEdge(corners, split);
  if (split != None)
    return divide(edge, split);
  const auto face = this->SplitFace(corners, split);
  if (split != None)
    return divide(face, split);
  this->Surface(corners);
}

void BlockContour::Surface(const Tetrahedron& corners)
{
  const TetrahedronSides sides = SidesOf({ this->Inside(corners[0]), this->Inside(corners[1]),
    this->Inside(corners[2]), this->Inside(corners[3]) });
  if (sides.crossings == 0)
    return;
  Loop loop;
  for (int n = 0; n < 4; ++n)
    loop.tetrahedron[n] = this->Vertices[corners[n]].world;
  for (int n = 0; n < sides.crossings; ++n)
    this->Follow(loop, corners, sides, n);

  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
  { this->Triangles.push_back(sides.odd ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c)); };
  const auto& points = loop.points;
  if (points.size() == std::size_t(sides.crossings))
  {
    for (std::size_t n = 2; n < points.size(); ++n)
      triangle(points[0], points[n - 1], points[n]);
    return;
  }
  const glm::dvec4 share = this->FanCenter(loop);
  glm::dvec3 index(0.0);
  for (int n = 0; n < 4; ++n)
    index += share[n] * this->Vertices[corners[n]].index;
  const std::uint32_t center = this->AddPoint(index);
  for (std::size_t n = 0; n < points.size(); ++n)
    triangle(center, points[n], points[(n + 1) % points.size()]);
}

/// From one crossing of a tetrahedron's surface up to the next.
void BlockContour::Follow(
  Loop& loop, const Tetrahedron& corners, const TetrahedronSides& sides, int n)
{
  const auto& e = sides.crossing[n];
  const auto& next = sides.crossing[(n + 1) % sides.crossings];
  const auto id = [&](int place) { return corners[sides.corner[place]]; };
  const auto worldOf = [&](std::uint32_t point)
  { return this->Grid.IndexToWorld(this->Points[point]); };
  const Edge& edge = this->FindEdge(id(e[0]), id(e[1]));
  const std::size_t begin = loop.points.size();
  loop.points.push_back(edge.point);
  loop.ring.push_back(worldOf(edge.point));
  loop.places.push_back({ edge.crossing.at, edge.crossing.sample.face });
  loop.start += edge.crossing.at / double(sides.crossings);
  loop.safe += Barycentric(loop.tetrahedron, loop.ring.back()) / double(sides.crossings);

  const int third = e[0] == next[0] ? next[1] : next[0];
  const Face& face = this->FindFace(id(e[0]), id(e[1]), id(third));
  for (int b = 0; b < face.bends.count; ++b)
  {
    const int at = face.from == edge.point ? b : face.bends.count - 1 - b;
    const BendPoint& bend = face.bends.point[at];
    loop.points.push_back(face.point[at]);
    loop.ring.push_back(worldOf(face.point[at]));
    for (const std::uint32_t met : bend.faces)
      loop.places.push_back({ bend.at, met });
    if (bend.Crease())
      loop.creases += bend.at, ++loop.creaseCount;
  }
  if (face.bends.count > 0)
  {
    std::vector<glm::dvec3> line(loop.ring.begin() + std::ptrdiff_t(begin), loop.ring.end());
    line.push_back(worldOf(this->FindEdge(id(next[0]), id(next[1])).point));
    loop.gap[sides.corner[6 - e[0] - e[1] - third]] = LeastGap(line);
  }
}

/// The fan's center, as shares of the tetrahedron's corners.
glm::dvec4 BlockContour::FanCenter(const Loop& loop)
{
  const auto& t = loop.tetrahedron;
  // Two fans on both sides of a triangle rise from the same line in it. Where that line comes close
  // to itself they are as far apart as they are steep: enough for `height`.
  glm::dvec4 least(0.125 * this->Limits.margin);
  for (int n = 0; n < 4; ++n)
  {
    const glm::dvec3 &a = t[(n + 1) % 4], &b = t[(n + 2) % 4], &c = t[(n + 3) % 4];
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const double altitude = std::abs(glm::dot(t[n] - a, normal));
    const double steep = this->Limits.height * this->Solid.Cell() / (loop.gap[n] * altitude);
    least[n] = std::max(least[n], std::min(steep, 0.75 * loop.safe[n]));
  }
  const glm::dvec3 corner = FindCorner(this->Solid, t, loop.places,
    loop.creaseCount > 0 ? loop.creases / double(loop.creaseCount) : loop.start,
    this->Limits.tolerance);
  bool moved = false;
  glm::dvec4 share = KeepInside(Barycentric(t, corner), loop.safe, least, moved);
  const auto place = [&]
  { return share[0] * t[0] + share[1] * t[1] + share[2] * t[2] + share[3] * t[3]; };
  for (int n = 0; n < 6 && LeastHeight(place(), loop.ring) < this->Limits.height; ++n)
    share = 0.5 * (share + loop.safe), moved = true;
  this->KeptInside += moved;
  return share;
}

} // namespace hasp
