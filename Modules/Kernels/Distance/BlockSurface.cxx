#include "Distance/BlockContour.h"
#include "HeldShares.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr double FaceShare = 0.0025; ///< of each corner, that a point in a triangle keeps
constexpr double FaceSteps = 32.0;   ///< of floats, that parts of a bent triangle are high
constexpr double CellSteps = 1.0;    ///< the same for those of a tetrahedron
constexpr double MostMargin = 0.3;   ///< above, and there is no room for a vertex between
constexpr int FarLevels = 2; ///< simplices of vertices below are divided where they are far off
} // namespace

/// A vertex in a triangle or tetrahedron whose surface is too far off: at that place, or at its
/// mirror image in the solid's face. None if it is near, or there is no room.
template <std::size_t N>
std::uint32_t BlockContour::DivideFar(
  const std::array<std::uint32_t, N>& simplex, const Furthest& furthest)
{
  if (std::abs(furthest.value) < FarShare * this->Solid.Cell() || this->Level(simplex) >= FarLevels)
    return None;
  const double margin = this->Tips(simplex).margin;
  if (margin > MostMargin)
    return None;
  std::array<glm::dvec3, N> world;
  for (std::size_t n = 0; n < N; ++n)
    world[n] = this->Vertices[simplex[n]].world;
  const glm::dvec3 slope = this->Solid.SampleAt(furthest.at).gradient;
  for (const double way : { 0.0, 2.0 })
  {
    const auto share = Barycentric(world, furthest.at - way * furthest.value * slope);
    const glm::dvec3 first = this->Vertices[simplex[0]].index;
    glm::dvec3 index = first;
    double least = share[0];
    for (int n = 1; n < int(N); ++n)
    {
      index += share[n] * (this->Vertices[simplex[n]].index - first);
      least = std::min(least, share[n]);
    }
    if (!(least >= margin))
      continue;
    ++this->Splits;
    return this->AddVertex(index, this->Level(simplex) + 1);
  }
  return None;
}

void BlockContour::Bend(Face& face, const std::array<std::uint32_t, 3>& v)
{
  std::array<glm::dvec3, 3> world, index;
  for (int n = 0; n < 3; ++n)
    world[n] = this->Vertices[v[n]].world, index[n] = this->Vertices[v[n]].index;
  const bool inside[] = { this->Inside(v[0]), this->Inside(v[1]), this->Inside(v[2]) };
  const int lone = inside[0] == inside[1] ? 2 : inside[0] == inside[2] ? 1 : 0;
  CrossedTriangle& parts = face.triangle;
  parts.lone = world[lone], parts.inside = inside[lone];
  EdgeCrossing crossing[2];
  glm::dvec3 safe(0.0);
  for (int n = 0; n < 2; ++n)
  {
    const int end = (lone + 1 + n) % 3;
    const Edge& edge = this->FindEdge(v[lone], v[end]);
    if (n == 0)
      face.from = edge.point;
    crossing[n] = edge.crossing;
    parts.ends[n] = world[end], parts.crossing[n] = this->Points[edge.point];
    safe += 0.5 * Barycentric(world, parts.crossing[n]);
  }
  const glm::dvec3 normal = glm::normalize(glm::cross(world[1] - world[0], world[2] - world[0]));
  Bends bends = FindBends(this->Solid, normal, crossing[0], crossing[1], this->Limits.tolerance);
  // From the first corner on, so that a point on a plane of the grid has that plane's index.
  const auto place = [&](const glm::dvec3& share)
  { return index[0] + share.y * (index[1] - index[0]) + share.z * (index[2] - index[0]); };
  // Both bends, the one or the other; nearer to the straight line; or none.
  std::array<glm::dvec3, 2> wanted, share;
  for (int n = 0; n < bends.count; ++n)
    wanted[n] = BackToSurface(this->Solid, world,
      KeepInside(Barycentric(world, bends.point[n].at), safe, FaceShare), safe,
      FarShare * this->Solid.Cell());
  const auto fits = [&](double way)
  {
    parts.bends = bends.count;
    for (int n = 0; n < bends.count; ++n)
    {
      share[n] = safe + way * (wanted[n] - safe);
      parts.bend[n] = this->Rounded(place(share[n]));
    }
    return ChooseDiagonal(parts) >= FaceSteps * this->Limits.step;
  };
  bool fit = bends.count > 0 && fits(1.0);
  if (!fit && bends.count == 2)
  {
    const auto off = [&](int n)
    {
      return glm::length(
        glm::cross(parts.bend[n] - parts.crossing[0], parts.crossing[1] - parts.crossing[0]));
    };
    const int further = off(1) > off(0);
    bends = { 1, { bends.point[further], {} } };
    wanted[0] = wanted[further];
    fit = fits(1.0);
  }
  for (double way = 0.75; bends.count > 0 && !fit && way > 0.0; way -= 0.25)
    fit = fits(way);
  parts.bends = bends.count = fit ? bends.count : 0;
  ChooseDiagonal(parts);
  if (fit || crossing[0].sample.face != crossing[1].sample.face)
  {
    const glm::dvec3 line[] = { parts.crossing[0], parts.bend[0], parts.bend[1] };
    Furthest furthest;
    for (int n = 0; n <= bends.count; ++n)
      furthest.Offer(
        this->Solid, 0.5 * (line[n] + (n < bends.count ? line[n + 1] : parts.crossing[1])));
    face.split = this->DivideFar(v, furthest);
    if (face.split != None)
      return;
  }
  for (int n = 0; n < bends.count; ++n)
  {
    face.point[n] = this->AddPoint(place(share[n]));
    this->CreasePoints += bends.point[n].Crease();
    this->KeptInside += share[n] != Barycentric(world, bends.point[n].at);
  }
  face.bends = bends;
}

void BlockContour::Surface(const Tetrahedron& corners)
{
  const TetrahedronSides sides = SidesOf({ this->Inside(corners[0]), this->Inside(corners[1]),
    this->Inside(corners[2]), this->Inside(corners[3]) });
  if (sides.crossings == 0)
    return;
  Loop loop;
  for (int n = 0; n < 4; ++n)
    loop.index[n] = this->Vertices[corners[n]].index,
    loop.world[n] = this->Vertices[corners[n]].world;
  for (int n = 0; n < sides.crossings; ++n)
    this->Follow(loop, corners, sides, n);
  if (sides.odd)
    std::reverse(loop.points.begin(), loop.points.end());
  this->Enclose(loop, corners);

  const auto& points = loop.points;
  if (points.size() == std::size_t(sides.crossings))
    for (std::size_t first = 0; first + 2 < points.size(); ++first)
      if (this->IsPlain(loop, first))
      {
        for (std::size_t n = 1; n + 1 < points.size(); ++n)
          this->Triangles.emplace_back(points[first], points[(first + n) % points.size()],
            points[(first + n + 1) % points.size()]);
        return;
      }
  Fan fan = this->FirstFan(loop);
  if (fan.turned > MostTurned)
  {
    if (const auto fans = this->BestTwoFans(loop, MostTurned))
      return this->AddFans(loop, *fans);
    this->Improve(loop, fan);
  }
  if (const std::uint32_t split = this->DivideFar(corners, fan.furthest); split != None)
    return this->Divide(corners, corners, split);
  if (fan.turned > MostTurned)
    if (const auto fans = this->BestTwoFans(loop, 0.5 * fan.turned))
      return this->AddFans(loop, *fans);
  this->LeastSteps = std::min(this->LeastSteps, fan.steps);
  this->KeptInside += fan.kept;
  const std::uint32_t center = this->AddPoint(fan.center);
  for (std::size_t n = 0; n < points.size(); ++n)
    this->Triangles.emplace_back(center, points[n], points[(n + 1) % points.size()]);
}

/// From one crossing of a tetrahedron's surface up to the next.
void BlockContour::Follow(
  Loop& loop, const Tetrahedron& corners, const TetrahedronSides& sides, int n)
{
  const auto& e = sides.crossing[n];
  const auto& next = sides.crossing[(n + 1) % sides.crossings];
  const auto id = [&](int place) { return corners[sides.corner[place]]; };
  const Edge& edge = this->FindEdge(id(e[0]), id(e[1]));
  loop.points.push_back(edge.point);
  loop.places.push_back({ edge.crossing.at, edge.crossing.sample.face });
  loop.start += edge.crossing.at / double(sides.crossings);
  loop.safe += Barycentric(loop.world, this->Points[edge.point]) / double(sides.crossings);

  const int third = e[0] == next[0] ? next[1] : next[0];
  const Face& face = this->FindFace(id(e[0]), id(e[1]), id(third));
  for (int b = 0; b < face.bends.count; ++b)
  {
    const int at = face.from == edge.point ? b : face.bends.count - 1 - b;
    const BendPoint& bend = face.bends.point[at];
    loop.points.push_back(face.point[at]);
    for (const std::uint32_t met : bend.faces)
      loop.places.push_back({ bend.at, met });
    if (bend.Crease())
      loop.creases += bend.at, ++loop.creaseCount;
  }
}

/// The tetrahedron's boundary as the line divides it.
void BlockContour::Enclose(Loop& loop, const Tetrahedron& corners)
{
  for (int away = 0; away < 4; ++away)
  {
    const int a = (away + 1) % 4, b = (away + 2) % 4, c = (away + 3) % 4;
    const auto isOut = [&](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r)
    { return glm::dot(glm::cross(q - p, r - p), loop.world[away] - p) < 0.0; };
    const bool inside = this->Inside(corners[a]);
    if (inside != this->Inside(corners[b]) || inside != this->Inside(corners[c]))
    {
      const CrossedTriangle& t = this->FindFace(corners[a], corners[b], corners[c]).triangle;
      hasp::Divide(t, !isOut(t.lone, t.ends[0], t.ends[1]), loop.shell);
    }
    else if (isOut(loop.world[a], loop.world[b], loop.world[c]))
      loop.shell.push_back({ { loop.world[a], loop.world[b], loop.world[c] }, inside });
    else
      loop.shell.push_back({ { loop.world[a], loop.world[c], loop.world[b] }, inside });
  }
}

/// A line without bends is closed well enough by triangles from its first point.
bool BlockContour::IsPlain(const Loop& loop, std::size_t first)
{
  const glm::dmat3 axes(
    loop.world[1] - loop.world[0], loop.world[2] - loop.world[0], loop.world[3] - loop.world[0]);
  const bool mirrored = glm::determinant(axes) < 0.0;
  const std::size_t count = loop.points.size();
  std::array<std::array<glm::dvec3, 3>, 2> surface;
  for (std::size_t n = 1; n + 1 < count; ++n)
  {
    surface[n - 1] = { this->Points[loop.points[first]],
      this->Points[loop.points[(first + n) % count]],
      this->Points[loop.points[(first + n + 1) % count]] };
    if (mirrored)
      std::swap(surface[n - 1][1], surface[n - 1][2]);
  }
  const double steps = LeastHeight(loop.shell, { surface.data(), count - 2 }) / this->Limits.step;
  if (steps < CellSteps)
    return false;
  this->LeastSteps = std::min(this->LeastSteps, steps);
  return true;
}

} // namespace hasp
