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
constexpr double ReachDeg = 60.0, ReachStepDeg = 15.0; // what counts as reachable at all
constexpr double TurnedCost = 0.01;   // of the area: what a turn by the full angle must gain
constexpr double GrazingCosine = 0.1; // a surface more along the direction is not reached

/// A sample of bone with a side open.
struct SurfaceSample
{
  glm::dvec3 place;
  bool inRegion;
  double area = 0.0;        ///< of its open sides as one facet, mm^2
  glm::dvec3 normal{ 0.0 }; ///< outwards, unit; these two in the region alone
};

/// The bone's samples as a mask that is open all around.
class BoneMask
{
public:
  BoneMask(const GridGeometry& grid, const std::vector<std::uint8_t>& keep) : Grid(grid), Keep(keep)
  {
  }
  bool At(const glm::ivec3& p) const
  {
    if (glm::any(glm::lessThan(p, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(p, this->Grid.dims)))
      return false;
    return this->Keep[(std::size_t(p.z) * this->Grid.dims.y + p.y) * this->Grid.dims.x + p.x] != 0;
  }
  /// Sum of the open sides' areas, as vectors outwards along the grid's axes; 0 if none is open, or
  /// if opposite ones are.
  glm::dvec3 OpenSides(const glm::ivec3& p, bool& open) const
  {
    const glm::dvec3 h = this->Grid.spacing, side(h.y * h.z, h.z * h.x, h.x * h.y);
    glm::dvec3 out(0.0);
    for (int a = 0; a < 3; ++a)
      for (const int way : { -1, 1 })
      {
        glm::ivec3 next = p;
        next[a] += way;
        if (!this->At(next))
        {
          out[a] += way * side[a];
          open = true;
        }
      }
    return out;
  }
  /// Away from the bone within two samples all around: smoother than one sample's sides.
  glm::dvec3 Normal(const glm::ivec3& p) const
  {
    glm::dvec3 away(0.0);
    for (int k = -2; k <= 2; ++k)
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i)
          if (const glm::dvec3 step = glm::dvec3(i, j, k) * this->Grid.spacing;
              !this->At(p + glm::ivec3(i, j, k)))
            away += step;
    const double length = glm::length(away);
    return length > 0.0 ? this->Grid.direction * (away / length) : glm::dvec3(0.0);
  }

private:
  const GridGeometry& Grid;
  const std::vector<std::uint8_t>& Keep;
};

std::vector<SurfaceSample> SurfaceOf(
  const GridGeometry& g, const std::vector<std::uint8_t>& keep, const ImplicitSolid& region)
{
  const BoneMask bone(g, keep);
  std::vector<SurfaceSample> samples;
  std::size_t n = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i, ++n)
      {
        if (!keep[n])
          continue;
        const glm::ivec3 at(i, j, k);
        bool open = false;
        const glm::dvec3 sides = bone.OpenSides(at, open);
        if (!open)
          continue;
        SurfaceSample sample{ g.IndexToWorld(at), false };
        if (region.At(sample.place) < 0.0)
        {
          sample.inRegion = true;
          sample.area = glm::length(sides);
          sample.normal = bone.Normal(at);
        }
        samples.push_back(sample);
      }
  return samples;
}

/// Takes out what no direction within ReachDeg of `start` meets before the region: what is not in
/// front of the ball around it, in a cone.
void KeepWhatMayBeInTheWay(std::vector<SurfaceSample>& samples, const glm::dvec3& start)
{
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const SurfaceSample& s : samples)
    if (s.inRegion)
    {
      low = glm::min(low, s.place);
      high = glm::max(high, s.place);
    }
  const glm::dvec3 middle = 0.5 * (low + high);
  const double radius = 0.5 * glm::distance(low, high), tangent = std::tan(glm::radians(ReachDeg));
  std::erase_if(samples,
    [&](const SurfaceSample& s)
    {
      const glm::dvec3 v = s.place - middle;
      const double before = glm::dot(v, start) + radius;
      return !s.inRegion && (before < 0.0 || glm::length(v - glm::dot(v, start) * start) >
                                               radius + tangent * before);
    });
}

/// `start`, then rings around it.
std::vector<glm::dvec3> Directions(const glm::dvec3& start, double mostDeg, double stepDeg)
{
  const glm::dvec3 other = std::abs(start.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(start, other)), y = glm::cross(start, x);
  std::vector<glm::dvec3> all{ start };
  const int rings = std::max(1, static_cast<int>(std::round(mostDeg / stepDeg)));
  for (int ring = 1; ring <= rings; ++ring)
  {
    const double turn = glm::radians(mostDeg * ring / rings);
    const int count = std::max(6, static_cast<int>(std::round(360.0 * std::sin(turn) / stepDeg)));
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
      const double facing = glm::dot(s.normal, direction);
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
  std::vector<SurfaceSample> samples = SurfaceOf(g, keep, region);
  KeepWhatMayBeInTheWay(samples, start);
  std::vector<glm::dvec3> directions = Directions(start, mostDeg, StepDeg);
  const std::size_t candidates = directions.size();
  const std::vector<glm::dvec3> others = Directions(start, ReachDeg, ReachStepDeg);
  directions.insert(directions.end(), others.begin(), others.end());
  const double pixel = std::max({ g.spacing.x, g.spacing.y, g.spacing.z });
  std::vector<std::vector<std::uint8_t>> reached(directions.size());
  ParallelFor(0, std::int64_t(directions.size()), 1,
    [&](std::int64_t n, std::int64_t)
    { reached[std::size_t(n)] = ReachedAlong(samples, directions[std::size_t(n)], pixel); });

  std::vector<double> areas; // of what can be reached at all
  double all = 0.0;
  for (const SurfaceSample& s : samples)
    if (s.inRegion)
    {
      const std::size_t at = areas.size();
      const bool any = std::any_of(
        reached.begin(), reached.end(), [&](const auto& along) { return along[at] != 0; });
      areas.push_back(any ? s.area : 0.0);
      all += areas.back();
    }
  InsertionAxis best{ start };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < candidates; ++n)
  {
    double missed = 0.0;
    for (std::size_t s = 0; s < areas.size(); ++s)
      missed += reached[n][s] ? 0.0 : areas[s];
    const double turned = std::acos(glm::clamp(glm::dot(directions[n], start), -1.0, 1.0));
    const double cost = missed / all + TurnedCost * turned / glm::radians(mostDeg);
    if (cost < least - 1e-12)
    {
      least = cost;
      best = { directions[n], missed / all };
    }
  }
  if (!(all > 0.0 && best.undercut < 1.0))
    throw std::runtime_error("guide: no bone around the landmarks can be reached within "
                             "axisSearchDeg of withdrawal; turn withdrawal away from the bone");
  return best;
}

} // namespace hasp
