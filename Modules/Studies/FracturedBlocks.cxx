#include "Studies/FracturedBlocks.h"

#include "Distance/DistanceBounds.h"
#include "Grid/ParallelFor.h"
#include "Studies/RoughPlane.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double RangeMm = 6.0; // of maps: so far faces attract

void Require(bool holds, const char* name, double value, const char* range)
{
  if (!holds || !std::isfinite(value))
    throw std::invalid_argument("fractured blocks: " + std::string(name) + " is " +
                                std::to_string(value) + ", must be " + range);
}

void Check(const FracturedBlockSettings& s)
{
  Require(s.pieces == 2 || s.pieces == 3, "pieces", s.pieces, "2 or 3");
  for (int a = 0; a < 3; ++a)
    Require(s.sideMm[a] >= 10.0 && s.sideMm[a] <= 100.0, "sideMm", s.sideMm[a], "in [10, 100]");
  Require(s.roughMm >= 0.0 && s.roughMm <= 2.0, "roughMm", s.roughMm, "in [0, 2]");
  Require(s.spacingMm >= 0.2 && s.spacingMm <= 2.0, "spacingMm", s.spacingMm, "in [0.2, 2]");
  Require(s.shortestMm >= 3.0 * s.spacingMm, "shortestMm", s.shortestMm, "3 spacings or more");
  Require(s.longestMm >= s.shortestMm, "longestMm", s.longestMm, "shortestMm or more");
  Require(s.lostMm >= 0.0 && s.lostMm <= 2.0, "lostMm", s.lostMm, "in [0, 2]");
  Require(s.points >= 64 && s.points <= 1'000'000, "points", s.points, "in [64, 10^6]");
  Require(s.coarsest >= 1 && s.coarsest <= s.points, "coarsest", s.coarsest, "in [1, points]");
  Require(s.widerMm >= 0.0 && s.widerMm <= 20.0, "widerMm", s.widerMm, "in [0, 20]");
  Require(s.pieces == 2 || (s.widerMm == 0.0 && !s.mirrored), "pieces", s.pieces,
    "2 where one is wider or mirrored");
}

/// A face of a piece: before it (1) or behind it (-1).
struct Side
{
  const RoughPlane* face;
  double sign;
};

struct Piece
{
  glm::dvec3 low, high; ///< of the box that holds it
  std::vector<Side> sides;
  bool moved;
};

/// What a face lost there: nothing to all of it, along the face and smoothly.
double LostShare(const glm::dvec3& x)
{
  return 0.5 + 0.5 * std::sin(0.9 * x.x + 1.0) * std::sin(1.1 * x.y + 0.4 * x.z);
}

double DistanceTo(
  const Piece& piece, const FracturedBlockSettings& settings, const glm::dvec3& place)
{
  const bool turned = piece.moved && settings.mirrored;
  const glm::dvec3 x(turned ? -place.x : place.x, place.y, place.z);
  const glm::dvec3 q = glm::abs(x) - 0.5 * settings.sideMm - (piece.moved ? 0.0 : settings.widerMm);
  double distance =
    glm::length(glm::max(q, glm::dvec3(0.0))) + std::min(0.0, std::max({ q.x, q.y, q.z }));
  const double lost = piece.moved ? settings.lostMm * LostShare(x) : 0.0;
  for (const Side& side : piece.sides)
    distance = std::max(distance, -side.sign * side.face->FootOf(x).mm + lost);
  return distance;
}

BlockPiece Bake(const Piece& piece, const FracturedBlockSettings& settings)
{
  GridGeometry grid;
  grid.spacing = glm::dvec3(settings.spacingMm);
  const double margin = RangeMm + 2.0 * settings.spacingMm;
  grid.origin = piece.low - margin;
  grid.dims =
    glm::ivec3(glm::ceil((piece.high - piece.low + 2.0 * margin) / settings.spacingMm)) + 1;
  std::vector<float> distances(grid.Size());
  const std::int64_t row = grid.dims.x, rows = std::int64_t(grid.dims.y) * grid.dims.z;
  ParallelFor(0, rows, 16,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t r = begin; r < end; ++r)
        for (std::int64_t i = 0; i < row; ++i)
        {
          const glm::dvec3 index(double(i), double(r % grid.dims.y), double(r / grid.dims.y));
          distances[std::size_t(r * row + i)] =
            float(DistanceTo(piece, settings, grid.IndexToWorld(index)));
        }
    });
  BoundByNeighbours(grid, float(settings.spacingMm), distances);
  const GridView<const float> view{ distances.data(), grid };
  const glm::dvec3 origin = 0.5 * (piece.low + piece.high);
  BlockPiece made;
  made.map = std::make_shared<const DistanceMap>(
    view, DistanceMapSettings{ .rangeMm = RangeMm, .origin = origin });
  made.shell = PointShell::OfSurface(view, origin,
    { .points = settings.points,
      .coarsest = settings.coarsest,
      .seed = std::uint32_t(settings.seed) });
  made.whole = { std::make_shared<const FitBody>(made.map, made.shell), { origin } };
  return made;
}

RoughPlane FaceOf(
  const FracturedBlockSettings& settings, const glm::dvec3& outward, std::uint64_t seed)
{
  FractureFace face;
  face.outward = outward;
  face.roughMm = settings.roughMm;
  face.shortestMm = settings.shortestMm;
  face.longestMm = settings.longestMm;
  face.seed = seed;
  return RoughPlane(face);
}

} // namespace

FitScene FracturedBlocks::SceneOfOthers() const
{
  FitScene scene;
  for (std::size_t n = 0; n + 1 < this->pieces.size(); ++n)
    scene.partners.push_back(this->pieces[n].whole);
  return scene;
}

std::unique_ptr<HapticScene> FracturedBlocks::TouchScene() const
{
  std::vector<HapticBody> bodies;
  for (std::size_t n = 0; n + 1 < this->pieces.size(); ++n)
    bodies.push_back({ this->pieces[n].map, this->pieces[n].whole.bodyInWorld });
  return std::make_unique<HapticScene>(
    std::vector<HapticShell>{ { this->Moved().shell, {} } }, std::move(bodies));
}

FracturedBlocks MakeFracturedBlocks(const FracturedBlockSettings& settings)
{
  Check(settings);
  const RoughPlane across = FaceOf(settings, { 0, 0, 1 }, 2 * settings.seed);
  const RoughPlane along = FaceOf(settings, { 1, 0, 0 }, 2 * settings.seed + 1);
  const glm::dvec3 half = 0.5 * settings.sideMm;
  const double high = std::min(across.MostMm(), half.z), wide = std::min(along.MostMm(), half.x);
  FracturedBlocks made;
  const glm::dvec3 farther = half + settings.widerMm;
  made.pieces.push_back(
    Bake({ -farther, { farther.x, farther.y, high }, { { &across, -1.0 } }, false }, settings));
  const glm::dvec3 low(-half.x, -half.y, -high);
  if (settings.pieces == 2)
  {
    made.pieces.push_back(Bake({ low, half, { { &across, 1.0 } }, true }, settings));
    return made;
  }
  made.pieces.push_back(Bake(
    { low, { wide, half.y, half.z }, { { &across, 1.0 }, { &along, -1.0 } }, false }, settings));
  made.pieces.push_back(Bake(
    { { -wide, -half.y, -high }, half, { { &across, 1.0 }, { &along, 1.0 } }, true }, settings));
  made.push = glm::normalize(glm::dvec3(-1.0, 0.0, -1.0));
  return made;
}

} // namespace hasp
