#include "InsertionAxis.h"

#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double StepDeg = 5.0;
constexpr double TurnedCost = 0.01;   // of the area: what a turn by the full angle must gain
constexpr double GrazingCosine = 0.1; // a surface more along the direction is not reached

/// A sample of bone with a side open.
struct SurfaceSample
{
  glm::dvec3 place;
  glm::dvec3 area; ///< vector sum of its open sides', outwards, mm^2
  bool inRegion;
};

std::vector<SurfaceSample> SurfaceOf(
  const GridGeometry& g, const std::vector<std::uint8_t>& keep, const ImplicitSolid& region)
{
  const glm::dvec3 h = g.spacing;
  const glm::dvec3 side(h.y * h.z, h.z * h.x, h.x * h.y);
  const std::size_t step[] = { 1, std::size_t(g.dims.x), std::size_t(g.dims.x) * g.dims.y };
  std::vector<SurfaceSample> samples;
  std::size_t n = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i, ++n)
      {
        if (!keep[n])
          continue;
        const glm::ivec3 at(i, j, k);
        glm::dvec3 out(0.0);
        bool open = false;
        for (int a = 0; a < 3; ++a)
          for (const int way : { -1, 1 })
          {
            const bool border = way < 0 ? at[a] == 0 : at[a] == g.dims[a] - 1;
            if (border || !keep[way < 0 ? n - step[a] : n + step[a]])
            {
              out[a] += way * side[a];
              open = true;
            }
          }
        if (open)
        {
          const glm::dvec3 place = g.IndexToWorld(at);
          samples.push_back({ place, g.direction * out, region.At(place) < 0.0 });
        }
      }
  return samples;
}

/// `start`, then rings around it.
std::vector<glm::dvec3> Directions(const glm::dvec3& start, double mostDeg)
{
  const glm::dvec3 other = std::abs(start.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(start, other)), y = glm::cross(start, x);
  std::vector<glm::dvec3> all{ start };
  const int rings = std::max(1, static_cast<int>(std::round(mostDeg / StepDeg)));
  for (int ring = 1; ring <= rings; ++ring)
  {
    const double turn = glm::radians(mostDeg * ring / rings);
    const int count = std::max(6, static_cast<int>(std::round(360.0 * std::sin(turn) / StepDeg)));
    for (int n = 0; n < count; ++n)
    {
      const double around = glm::two_pi<double>() * n / count;
      all.push_back(
        std::cos(turn) * start + std::sin(turn) * (std::cos(around) * x + std::sin(around) * y));
    }
  }
  return all;
}

/// Which of the region's samples, in their order, a direction reaches: one byte each.
std::vector<std::uint8_t> ReachedAlong(
  const std::vector<SurfaceSample>& samples, const glm::dvec3& direction, double pixel)
{
  const glm::dvec3 other = std::abs(direction.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(direction, other)), y = glm::cross(direction, x);
  const auto pixelOf = [&](const glm::dvec3& place)
  { return glm::floor(glm::dvec2(glm::dot(place, x), glm::dot(place, y)) / pixel); };
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const SurfaceSample& s : samples)
    if (s.inRegion)
    {
      low = glm::min(low, pixelOf(s.place));
      high = glm::max(high, pixelOf(s.place));
    }
  const glm::dvec2 size = glm::max(high - low + 1.0, glm::dvec2(0.0));
  std::vector<double> highest( // bone in each pixel, as far as the region reaches
    std::size_t(size.x) * std::size_t(size.y), -std::numeric_limits<double>::infinity());
  const auto heightAt = [&](const glm::dvec2& at) -> double&
  { return highest[std::size_t(at.y - low.y) * std::size_t(size.x) + std::size_t(at.x - low.x)]; };
  for (const SurfaceSample& s : samples)
    if (const glm::dvec2 at = pixelOf(s.place);
        at.x >= low.x && at.y >= low.y && at.x <= high.x && at.y <= high.y)
      heightAt(at) = std::max(heightAt(at), glm::dot(s.place, direction));
  std::vector<std::uint8_t> reached;
  for (const SurfaceSample& s : samples)
    if (s.inRegion)
    {
      const double area = glm::length(s.area);
      const double facing = area > 0.0 ? glm::dot(s.area, direction) / area : 0.0;
      // Within its pixel a sloping surface rises by so much.
      const double slope = std::sqrt(std::max(0.0, 1.0 - facing * facing)) / facing;
      reached.push_back(
        facing > GrazingCosine &&
        glm::dot(s.place, direction) > heightAt(pixelOf(s.place)) - pixel * (1.0 + 1.5 * slope));
    }
  return reached;
}
} // namespace

InsertionAxis FindInsertionAxis(const AnyGridView& ct, const std::vector<std::uint8_t>& keep,
  const ImplicitSolid& region, const glm::dvec3& start, double mostDeg)
{
  const GridGeometry& g = GeometryOf(ct);
  const std::vector<SurfaceSample> samples = SurfaceOf(g, keep, region);
  const std::vector<glm::dvec3> directions = Directions(start, mostDeg);
  const double pixel = std::max({ g.spacing.x, g.spacing.y, g.spacing.z });
  std::vector<std::vector<std::uint8_t>> reached(directions.size());
  ParallelFor(0, std::int64_t(directions.size()), 1,
    [&](std::int64_t n, std::int64_t)
    { reached[std::size_t(n)] = ReachedAlong(samples, directions[std::size_t(n)], pixel); });

  std::vector<double> areas; // of what can be reached at all
  double all = 0.0;
  std::size_t count = 0;
  for (const SurfaceSample& s : samples)
    if (s.inRegion)
    {
      const bool any = std::any_of(
        reached.begin(), reached.end(), [&](const auto& along) { return along[count] != 0; });
      areas.push_back(any ? glm::length(s.area) : 0.0);
      all += areas.back();
      ++count;
    }
  if (!(all > 0.0))
    throw std::runtime_error("guide: no bone around the landmarks can be reached within "
                             "axisSearchDeg of withdrawal; turn withdrawal away from the bone");
  InsertionAxis best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < directions.size(); ++n)
  {
    double missed = 0.0;
    for (std::size_t s = 0; s < count; ++s)
      missed += reached[n][s] ? 0.0 : areas[s];
    const double turned = std::acos(glm::clamp(glm::dot(directions[n], start), -1.0, 1.0));
    const double cost = missed / all + TurnedCost * turned / glm::radians(mostDeg);
    if (cost < least - 1e-12)
    {
      least = cost;
      best = { directions[n], missed / all };
    }
  }
  return best;
}

} // namespace hasp
