#include "Haptics/PointShell.h"
#include "Grid/Stopwatch.h"
#include "Haptics/EliminationOrder.h"
#include "Haptics/PointArrays.h"
#include "Haptics/SurfaceSamples.h"

#include <glm/common.hpp>
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

constexpr std::uint32_t ClusterPoints = ContactPoints::Lanes;
constexpr int MostPoints = 1 << 24;
/// Points to choose from for each one wanted.
constexpr std::size_t CandidatesPerPoint = 4;

void Check(const PointShellSettings& settings, const glm::dvec3& origin)
{
  if (settings.points < 1 || settings.points > MostPoints)
    throw std::invalid_argument("PointShell: " + std::to_string(settings.points) +
                                " points; must be in [1, " + std::to_string(MostPoints) + "]");
  if (settings.coarsest < 1)
    throw std::invalid_argument("PointShell: a coarsest level of " +
                                std::to_string(settings.coarsest) + " points; must be at least 1");
  if (!std::isfinite(origin.x + origin.y + origin.z))
    throw std::invalid_argument("PointShell: the body's origin must be finite");
}

/// coarsest, times four, and so on up to the last, which is `points`.
std::vector<std::uint32_t> LevelEnds(std::size_t points, const PointShellSettings& settings)
{
  std::vector<std::uint32_t> ends;
  const auto last = std::min<std::uint64_t>(points, settings.points);
  for (std::uint64_t end = settings.coarsest; end < last; end *= 4)
    ends.push_back(static_cast<std::uint32_t>(end));
  if (last > 0)
    ends.push_back(static_cast<std::uint32_t>(last));
  return ends;
}

/// Puts numbers of points into the order of a balanced k-d tree: cut across the longest side, again
/// and again, down to clusters.
void SortIntoClusters(std::span<std::uint32_t> part, std::span<const SurfacePoint> points)
{
  if (part.size() <= ClusterPoints)
  {
    std::sort(part.begin(), part.end());
    return;
  }
  glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
  for (const std::uint32_t p : part)
  {
    low = glm::min(low, points[p].position);
    high = glm::max(high, points[p].position);
  }
  const glm::vec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto before = [&](std::uint32_t a, std::uint32_t b)
  {
    const float at = points[a].position[axis], bt = points[b].position[axis];
    return at != bt ? at < bt : a < b;
  };
  const std::size_t half = (part.size() + ClusterPoints - 1) / ClusterPoints / 2 * ClusterPoints;
  std::nth_element(
    part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(), before);
  SortIntoClusters(part.first(half), points);
  SortIntoClusters(part.subspan(half), points);
}

/// Nearly the smallest ball around some points (Badoiu and Clarkson 2003: a step towards the
/// farthest, shorter each time).
PointCluster BallAround(const PointArrays& arrays, std::uint32_t first, std::uint32_t real)
{
  PointCluster cluster;
  const auto farthest = [&]
  {
    std::uint32_t found = first;
    float most = -1.0F;
    for (std::uint32_t n = first; n < first + real; ++n)
      if (const float far = glm::distance(arrays.Position(n), cluster.center); far > most)
      {
        most = far;
        found = n;
      }
    return std::pair(found, most);
  };
  cluster.center = arrays.Position(first);
  for (int step = 1; step <= 50; ++step)
    cluster.center +=
      (arrays.Position(farthest().first) - cluster.center) / static_cast<float>(step + 1);
  // Rounded up: a position's last digits, and the length's.
  cluster.radius = farthest().second * (1.0F + 1e-6F) + 1e-6F * glm::length(cluster.center);
  cluster.first = first;
  cluster.count = PointArrays::Padded(real);
  return cluster;
}

} // namespace

struct PointShell::Internals
{
  struct OneLevel
  {
    std::uint32_t end = 0;              ///< points up to here, without padding
    std::uint32_t first = 0, count = 0; ///< in the arrays, with padding
    std::vector<PointCluster> clusters; ///< numbered from the level's first point
  };
  PointArrays arrays;
  std::vector<OneLevel> levels;
  double area = 0.0, milliseconds = 0.0;
  float radius = 0.0F;

  static std::unique_ptr<Internals> Make(std::span<const SurfacePoint> points, double area,
    const PointShellSettings& settings, const ProgressFunction& progress);
};

/// Orders the points, and within each level puts them into clusters.
std::unique_ptr<PointShell::Internals> PointShell::Internals::Make(
  std::span<const SurfacePoint> points, double area, const PointShellSettings& settings,
  const ProgressFunction& progress)
{
  auto made = std::make_unique<Internals>();
  made->area = area;
  const std::vector<std::uint32_t> ends = LevelEnds(points.size(), settings);
  std::vector<std::uint32_t> order = EliminationOrder(points, area, ends, progress);
  std::uint32_t begin = 0, padded = 0;
  for (const std::uint32_t end : ends)
  {
    made->levels.push_back({ end, padded, PointArrays::Padded(end - begin), {} });
    padded += made->levels.back().count;
    begin = end;
  }
  made->arrays = PointArrays(padded, false);
  begin = 0;
  for (OneLevel& level : made->levels)
  {
    const std::span<std::uint32_t> part(&order[begin], level.end - begin);
    SortIntoClusters(part, points);
    for (std::uint32_t n = 0; n < part.size(); ++n)
    {
      const SurfacePoint& p = points[part[n]];
      made->arrays.Set(level.first + n, p.position, p.normal);
      made->radius = std::max(made->radius, glm::length(p.position) * (1.0F + 1e-6F));
    }
    for (std::uint32_t n = 0; n < part.size(); n += ClusterPoints)
    {
      const auto real = std::min<std::uint32_t>(ClusterPoints, part.size() - n);
      level.clusters.push_back(BallAround(made->arrays, level.first + n, real));
      level.clusters.back().first = n;
    }
    begin = level.end;
  }
  return made;
}

PointShell::PointShell(std::unique_ptr<Internals> made) : Inside(std::move(made)) {}

PointShell::~PointShell() = default;

std::shared_ptr<const PointShell> PointShell::OfSurface(const GridView<const float>& distances,
  const glm::dvec3& origin, const PointShellSettings& settings, const ProgressFunction& progress)
{
  const Stopwatch stopwatch;
  distances.geometry.Validate();
  Check(settings, origin);
  const auto part = [&](double from, double to) -> ProgressFunction
  {
    return [=, &progress](double share)
    { return !progress || progress(from + share * (to - from)); };
  };
  const SurfaceSamples samples = SampleSurface(
    distances, origin, CandidatesPerPoint * settings.points, settings.seed, part(0.0, 0.4));
  auto made = Internals::Make(samples.points, samples.area, settings, part(0.4, 1.0));
  ReportProgress(progress, 1.0);
  made->milliseconds = stopwatch.Milliseconds();
  return std::shared_ptr<const PointShell>(new PointShell(std::move(made)));
}

std::shared_ptr<const PointShell> PointShell::OfPoints(std::span<const SurfacePoint> points,
  double surfaceArea, const glm::dvec3& origin, const PointShellSettings& settings)
{
  const Stopwatch stopwatch;
  Check(settings, origin);
  if (!points.empty() && !(std::isfinite(surfaceArea) && surfaceArea > 0.0))
    throw std::invalid_argument("PointShell: points that stand for " + std::to_string(surfaceArea) +
                                " mm^2; must be finite and > 0");
  std::vector<SurfacePoint> placed(points.begin(), points.end());
  for (std::size_t n = 0; n < placed.size(); ++n)
  {
    SurfacePoint& p = placed[n];
    p.position = glm::dvec3(p.position) - origin;
    if (!std::isfinite(p.position.x + p.position.y + p.position.z))
      throw std::invalid_argument("PointShell: point " + std::to_string(n) + " is not finite");
    if (!(std::abs(glm::length(p.normal) - 1.0F) <= 1e-3F))
      throw std::invalid_argument("PointShell: the normal of point " + std::to_string(n) + " is " +
                                  std::to_string(glm::length(p.normal)) +
                                  " long; must be 1 within 1e-3");
  }
  auto made = Internals::Make(placed, points.empty() ? 0.0 : surfaceArea, settings, {});
  made->milliseconds = stopwatch.Milliseconds();
  return std::shared_ptr<const PointShell>(new PointShell(std::move(made)));
}

int PointShell::Levels() const noexcept
{
  return static_cast<int>(this->Inside->levels.size());
}

std::uint32_t PointShell::LevelEnd(int level) const noexcept
{
  return this->Inside->levels[level].end;
}

ContactPoints PointShell::Level(int level) const noexcept
{
  const Internals::OneLevel& l = this->Inside->levels[level];
  return this->Inside->arrays.View(
    l.first, l.count, static_cast<float>(this->Inside->area / l.end));
}

std::span<const PointCluster> PointShell::Clusters(int level) const noexcept
{
  return this->Inside->levels[level].clusters;
}

double PointShell::SurfaceArea() const noexcept
{
  return this->Inside->area;
}

float PointShell::Radius() const noexcept
{
  return this->Inside->radius;
}

void PointShell::ListResources(ResourceList& list) const
{
  std::size_t bytes = this->Inside->arrays.Bytes();
  for (const Internals::OneLevel& level : this->Inside->levels)
    bytes += level.clusters.size() * sizeof(PointCluster);
  list.push_back({ "point shell", bytes, this->Inside->milliseconds,
    this->Levels() > 0 ? "a body to touch with" : "the body has no surface" });
}

} // namespace hasp
