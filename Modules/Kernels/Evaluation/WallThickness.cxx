#include "Evaluation/WallThickness.h"

#include "Evaluation/AreaShares.h"
#include "Evaluation/ThinPlaces.h"
#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <utility>

namespace hasp
{

std::vector<Chord> MeasureChords(const TriangleTree& tree, std::span<const MeshSample> samples)
{
  std::vector<Chord> chords(samples.size());
  ParallelFor(0, static_cast<std::int64_t>(samples.size()), 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const glm::dvec3 into = -samples[n].normal;
        // Its own triangle, and what floats leave of its neighbours, lie at 0.
        const auto hit = tree.First(samples[n].point, into, 1e-6);
        if (hit && glm::dot(hit->normal, into) > 0.0)
          chords[n] = { hit->t, hit->normal };
      }
    });
  return chords;
}

WallThickness MeasureWalls(std::span<const MeshSample> samples, std::span<const Chord> chords)
{
  const double opposite = -std::cos(glm::radians(WallThickness::WallDegrees));
  WallThickness walls;
  AreaShares shares;
  std::vector<ThinPlace> places;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    if (!(chords[n].mm > 0.0 && glm::dot(samples[n].normal, chords[n].normal) < opposite))
      continue;
    shares.Add(chords[n].mm, samples[n].areaMm2);
    places.push_back({ chords[n].mm, samples[n].areaMm2,
      samples[n].point - 0.5 * chords[n].mm * samples[n].normal });
  }
  const ThinPlace least = ThinnestPlace(std::move(places), 2);
  walls.leastMm = least.mm;
  walls.leastAt = least.at;
  shares.Sort();
  walls.wallMm2 = shares.Area();
  walls.p5Mm = shares.Below(0.05);
  walls.p50Mm = shares.Below(0.50);
  return walls;
}

} // namespace hasp
