#include "Evaluation/GuideGap.h"

#include "Evaluation/SurfaceDistance.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{

namespace
{
/// Distance below which the given share of the area lies; `walls` sorted by distance.
double Percentile(const std::vector<std::pair<double, double>>& walls, double area, double share)
{
  double sum = 0.0;
  for (const auto& [distance, part] : walls)
    if ((sum += part) >= share * area)
      return distance;
  return walls.back().first;
}
} // namespace

GuideGap MeasureGuideGap(const AnyGridView& volume, const TriangleMesh& guide,
  const GuideGapSettings& s, const ProgressFunction& progress)
{
  if (!(s.gapMm >= 0.0 && s.toleranceMm > 0.0 && s.nearMm > s.gapMm && s.facing > 0.0 &&
        s.facing < 1.0))
    throw std::invalid_argument(
      "guide gap: needs gapMm >= 0, toleranceMm > 0, nearMm > gapMm, facing in (0, 1)");
  std::vector<glm::dvec3> centers;
  centers.reserve(guide.triangles.size());
  for (const glm::uvec3& t : guide.triangles)
  {
    if (std::max({ t.x, t.y, t.z }) >= guide.points.size())
      throw std::invalid_argument("guide gap: a triangle names point " +
                                  std::to_string(std::max({ t.x, t.y, t.z })) + " of " +
                                  std::to_string(guide.points.size()));
    centers.push_back((guide.points[t.x] + guide.points[t.y] + guide.points[t.z]) / 3.0);
  }
  const auto nearest = DistanceToIsosurface(volume, s.isovalue, centers, s.nearMm, progress);

  GuideGap gap;
  gap.leastAnywhere = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, double>> walls; // distance, area
  for (std::size_t n = 0; n < nearest.size(); ++n)
  {
    if (!nearest[n])
      continue;
    const double distance = nearest[n]->distance;
    gap.leastAnywhere = std::min(gap.leastAnywhere, distance);
    const glm::uvec3& t = guide.triangles[n];
    const glm::dvec3 normal =
      glm::cross(guide.points[t.y] - guide.points[t.x], guide.points[t.z] - guide.points[t.x]);
    const double twiceArea = glm::length(normal);
    if (!(glm::dot(normal, nearest[n]->outward) < -s.facing * twiceArea))
      continue;
    const double area = 0.5 * twiceArea;
    walls.emplace_back(distance, area);
    gap.innerWallMm2 += area;
    gap.share += std::abs(distance - s.gapMm) <= s.toleranceMm ? area : 0.0;
    gap.closer += distance < s.gapMm - s.toleranceMm ? area : 0.0;
  }
  if (walls.empty())
    return gap;
  gap.share /= gap.innerWallMm2;
  gap.closer /= gap.innerWallMm2;
  std::sort(walls.begin(), walls.end());
  gap.least = walls.front().first;
  gap.p5 = Percentile(walls, gap.innerWallMm2, 0.05);
  gap.p50 = Percentile(walls, gap.innerWallMm2, 0.50);
  gap.p95 = Percentile(walls, gap.innerWallMm2, 0.95);
  gap.most = walls.back().first;
  return gap;
}

} // namespace hasp
