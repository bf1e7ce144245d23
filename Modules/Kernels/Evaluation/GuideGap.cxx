#include "Evaluation/GuideGap.h"

#include "Evaluation/AreaShares.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
void Validate(const GuideGapSettings& s)
{
  if (!(s.gapMm >= 0.0 && s.toleranceMm > 0.0 && s.nearMm > s.gapMm && s.facing > 0.0 &&
        s.facing < 1.0 && s.nearMm <= 100.0))
    throw std::invalid_argument(
      "guide gap: needs gapMm >= 0, toleranceMm > 0, gapMm < nearMm <= 100, facing in (0, 1)");
}
} // namespace

GuideGap MeasureGuideGap(std::span<const MeshSample> samples,
  std::span<const std::optional<NearestSurface>> nearest, const GuideGapSettings& s,
  const CountsAsBone& counts)
{
  Validate(s);
  if (samples.size() != nearest.size())
    throw std::invalid_argument("guide gap: " + std::to_string(samples.size()) + " samples and " +
                                std::to_string(nearest.size()) + " distances");
  GuideGap gap;
  gap.leastAnywhere = std::numeric_limits<double>::infinity();
  gap.histogramMm2.assign(std::size_t(std::ceil(2.0 * s.nearMm / GuideGap::BinMm)), 0.0);
  AreaShares walls;
  double within = 0.0, closer = 0.0, worst = -1.0;
  for (std::size_t n = 0; n < nearest.size(); ++n)
  {
    if (!nearest[n])
      continue;
    const double distance = nearest[n]->distance, area = samples[n].areaMm2;
    if (distance < s.gapMm - s.toleranceMm && counts && !counts(nearest[n]->closest))
      continue;
    if (distance < gap.leastAnywhere)
    {
      gap.leastAnywhere = distance;
      gap.leastAnywhereAt = samples[n].point;
    }
    if (!(glm::dot(samples[n].normal, nearest[n]->outward) < -s.facing))
      continue;
    walls.Add(distance, area);
    within += std::abs(distance - s.gapMm) <= s.toleranceMm ? area : 0.0;
    closer += distance < s.gapMm - s.toleranceMm ? area : 0.0;
    if (std::abs(distance - s.gapMm) > worst)
    {
      worst = std::abs(distance - s.gapMm);
      gap.worstAt = samples[n].point;
    }
    const auto bin = static_cast<std::size_t>((distance + s.nearMm) / GuideGap::BinMm);
    gap.histogramMm2[std::min(bin, gap.histogramMm2.size() - 1)] += area;
  }
  if (walls.Empty())
    return gap;
  walls.Sort();
  gap.innerWallMm2 = walls.Area();
  gap.share = within / walls.Area();
  gap.closer = closer / walls.Area();
  gap.least = walls.Below(0.0);
  gap.p5 = walls.Below(0.05);
  gap.p50 = walls.Below(0.50);
  gap.p95 = walls.Below(0.95);
  gap.most = walls.Most();
  return gap;
}

GuideGap MeasureGuideGap(const AnyGridView& volume, const TriangleMesh& guide,
  const GuideGapSettings& settings, const ProgressFunction& progress)
{
  Validate(settings);
  const std::vector<MeshSample> samples = SampleMesh(guide, GapSampleMm);
  std::vector<glm::dvec3> places;
  places.reserve(samples.size());
  for (const MeshSample& sample : samples)
    places.push_back(sample.point);
  const auto nearest =
    DistanceToIsosurface(volume, settings.isovalue, places, settings.nearMm, progress);
  return MeasureGuideGap(samples, nearest, settings);
}

} // namespace hasp
