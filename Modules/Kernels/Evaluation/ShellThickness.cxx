#include "Evaluation/ShellThickness.h"

#include "Evaluation/AreaShares.h"
#include "Evaluation/ThinPlaces.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace hasp
{

namespace
{
bool RunsAlong(const glm::dvec3& normal, const std::optional<glm::dvec3>& direction)
{
  return direction && std::abs(glm::dot(normal, *direction)) < std::sin(glm::radians(10.0));
}
} // namespace

ShellThickness MeasureShell(std::span<const MeshSample> samples, std::span<const Chord> chords,
  std::span<const std::optional<NearestSurface>> nearest, const ShellSettings& s)
{
  if (samples.size() != chords.size() || samples.size() != nearest.size())
    throw std::invalid_argument("shell thickness: samples, chords and distances differ in number");
  const double opposite = -std::cos(glm::radians(30.0));
  ShellThickness shell;
  AreaShares shares;
  std::vector<ThinPlace> places;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const glm::dvec3& normal = samples[n].normal;
    if (!nearest[n] || !(chords[n].mm > 0.0) ||
        !(glm::dot(normal, nearest[n]->outward) < -s.facing) ||
        !(glm::dot(normal, chords[n].normal) < opposite) ||
        RunsAlong(chords[n].normal, s.withdrawal))
      continue;
    double mm = chords[n].mm;
    if (RunsAlong(normal, s.withdrawal))
    {
      if (std::abs(nearest[n]->distance - s.gapMm) > s.gapToleranceMm)
        continue;
      mm += std::max(0.0, nearest[n]->distance - s.gapMm);
    }
    shares.Add(mm, samples[n].areaMm2);
    places.push_back({ mm, samples[n].areaMm2, samples[n].point - 0.5 * chords[n].mm * normal });
  }
  const ThinPlace least = ThinnestPlace(std::move(places), 1);
  shell.leastMm = least.mm;
  shell.leastAt = least.at;
  shares.Sort();
  shell.shellMm2 = shares.Area();
  shell.p5Mm = shares.Below(0.05);
  shell.p50Mm = shares.Below(0.50);
  return shell;
}

} // namespace hasp
