#include "Grid/PhantomScene.h"
#include "Grid/ScannerFaults.h"
#include "Studies/FractureCases.h"
#include "Studies/SeededShare.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{
namespace
{

/// Places in a ball, spread: of some at random the one farthest from those there are.
std::vector<glm::dvec3> SpreadPlaces(int count, double radiusMm, std::uint64_t seed)
{
  std::vector<glm::dvec3> places;
  std::uint64_t n = 0;
  const auto any = [&]
  {
    glm::dvec3 p(1.0);
    while (glm::length(p) > 0.95)
    {
      for (int a = 0; a < 3; ++a)
        p[a] = 2.0 * SeededShare(seed, n + a) - 1.0;
      n += 3;
    }
    return radiusMm * p;
  };
  while (static_cast<int>(places.size()) < count)
  {
    glm::dvec3 best(0.0);
    double farthest = -1.0;
    for (int candidate = 0; candidate < 12; ++candidate)
    {
      const glm::dvec3 p = any();
      double nearest = 1e300;
      for (const glm::dvec3& other : places)
        nearest = std::min(nearest, glm::distance(p, other));
      if (nearest > farthest)
      {
        farthest = nearest;
        best = p;
      }
    }
    places.push_back(best);
  }
  return places;
}

} // namespace

FracturedScan ShatteredBall(int fragments, double radiusMm, double spacingMm, std::uint64_t seed)
{
  if (!(fragments >= 2 && fragments <= 200))
    throw std::invalid_argument(
      "shattered ball: fragments is " + std::to_string(fragments) + ", must be in [2, 200]");
  if (!(spacingMm > 0.0 && radiusMm >= 5.0 * spacingMm && radiusMm <= 200.0 * spacingMm))
    throw std::invalid_argument("shattered ball: radiusMm is " + std::to_string(radiusMm) +
                                ", must be 5 to 200 times spacingMm, which must be > 0");
  FractureSettings settings;
  settings.scanner.blurMm = glm::dvec3(0.25 * spacingMm);
  settings.crackMm = 0.3 * spacingMm;
  const std::vector<glm::dvec3> places = SpreadPlaces(fragments, radiusMm, seed);
  for (int p = 0; p + 1 < fragments; ++p)
  {
    FracturePiece piece{ "piece " + std::to_string(p + 1), 0, {}, {} };
    for (int q = p + 1; q < fragments;
         ++q) // what is nearer to an earlier one is not there any more
    {
      FractureFace face;
      face.point = 0.5 * (places[p] + places[q]);
      face.outward = glm::normalize(places[q] - places[p]);
      face.roughMm = 0.01 * radiusMm;
      face.shortestMm = 4.0 * spacingMm;
      face.longestMm = 12.0 * spacingMm;
      face.seed = seed + 1000ULL * static_cast<std::uint64_t>(p) + static_cast<std::uint64_t>(q);
      piece.faces.push_back(face);
    }
    settings.pieces.push_back(std::move(piece));
  }
  GridGeometry grid;
  grid.spacing = glm::dvec3(spacingMm);
  grid.dims = glm::ivec3(2 * static_cast<int>(std::ceil(radiusMm / spacingMm)) + 7);
  grid.origin = -0.5 * grid.spacing * glm::dvec3(grid.dims - 1);
  const SurfaceStep step(settings.scanner);
  std::vector<std::int16_t> intact;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
      {
        const glm::dvec3 at = grid.IndexToWorld({ i, j, k });
        const double out = glm::length(at);
        const glm::dvec3 outward = out > 0.0 ? at / out : glm::dvec3(0, 0, 1);
        const double share = step(radiusMm - out, outward);
        intact.push_back(RoundedSample(
          settings.scanner.softHU + share * (settings.scanner.boneHU - settings.scanner.softHU)));
      }
  return BreakScan(GridView<const std::int16_t>{ intact.data(), grid }, settings);
}

FracturedScan TinyFragment(const glm::dvec3& spacing)
{
  FracturedScan scan;
  scan.geometry.dims = glm::ivec3(16);
  scan.geometry.spacing = spacing;
  scan.geometry.Validate();
  scan.names = { "block", "tiny fragment" };
  for (int k = 0; k < 16; ++k)
    for (int j = 0; j < 16; ++j)
      for (int i = 0; i < 16; ++i)
      {
        // 12^3 of bone; within it 4^3 of darker bone, and in that the fragment.
        const int low = std::min({ i, j, k }), high = std::max({ i, j, k });
        const bool bone = low >= 2 && high <= 13, dark = low >= 6 && high <= 9;
        const bool tiny = low >= 7 && high <= 8;
        scan.samples.push_back(static_cast<std::int16_t>(!bone ? 40 : dark && !tiny ? 400 : 1000));
        scan.truth.push_back(static_cast<Label>(!bone ? 0 : tiny ? 3 : 2));
      }
  return scan;
}

} // namespace hasp
