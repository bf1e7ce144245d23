#include "Studies/SimulatedStrokes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

void CheckLimits(const StrokeLimits& limits)
{
  const auto require = [](bool holds, const char* name, double value, const char* range)
  {
    if (!holds)
      throw std::invalid_argument("simulated stroke: " + std::string(name) + " is " +
                                  std::to_string(value) + ", must be " + range);
  };
  require(limits.strokes >= 1, "strokes", limits.strokes, ">= 1");
  require(
    limits.radiusMm > 0.0 && limits.radiusMm <= 50.0, "radiusMm", limits.radiusMm, "in (0, 50]");
  require(limits.lengthMm >= 0.0, "lengthMm", limits.lengthMm, ">= 0");
}

bool IsSurface(GridView<const Label> bone, const glm::ivec3& at)
{
  if (bone(at.x, at.y, at.z) == 0)
    return false;
  for (int a = 0; a < 3; ++a)
    for (const int side : { -1, 1 })
    {
      glm::ivec3 to = at;
      to[a] += side;
      if (to[a] >= 0 && to[a] < bone.geometry.dims[a] && bone(to.x, to.y, to.z) == 0)
        return true;
    }
  return false;
}

/// The centre of the nearest surface voxel within a distance, if there is one.
std::optional<glm::dvec3> NearestSurface(
  GridView<const Label> bone, const glm::dvec3& point, double withinMm)
{
  const GridGeometry& grid = bone.geometry;
  const glm::dvec3 index = grid.WorldToIndex(point), reach = withinMm / grid.spacing;
  const glm::dvec3 last(grid.dims - 1);
  const glm::ivec3 low(glm::clamp(glm::ceil(index - reach), glm::dvec3(0.0), last));
  const glm::ivec3 high(glm::clamp(glm::floor(index + reach), glm::dvec3(0.0), last));
  std::optional<glm::dvec3> nearest;
  double least = withinMm;
  for (int k = low.z; k <= high.z; ++k)
    for (int j = low.y; j <= high.y; ++j)
      for (int i = low.x; i <= high.x; ++i)
      {
        const double away = glm::length(grid.spacing * (glm::dvec3(i, j, k) - index));
        if (away <= least && IsSurface(bone, { i, j, k }))
        {
          least = away;
          nearest = grid.IndexToWorld({ i, j, k });
        }
      }
  return nearest;
}

/// Surface voxels from `from` along a direction, without `from`, no further than lengthMm.
std::vector<glm::dvec3> Walk(
  GridView<const Label> bone, const glm::dvec3& from, const glm::dvec3& along, double lengthMm)
{
  const glm::dvec3& spacing = bone.geometry.spacing;
  // A step must leave the voxel, whichever way it goes.
  const double stepMm = std::max({ 1.0, 1.2 * spacing.x, 1.2 * spacing.y, 1.2 * spacing.z });
  std::vector<glm::dvec3> points;
  glm::dvec3 at = from;
  for (double left = lengthMm; left > 0.0;)
  {
    const std::optional<glm::dvec3> next = NearestSurface(bone, at + stepMm * along, 1.5 * stepMm);
    // The bone's edge: the nearest surface is where the stroke already is.
    if (!next || glm::dot(*next - at, along) < 0.3 * stepMm || glm::distance(*next, at) > left)
      break;
    left -= glm::distance(*next, at);
    at = *next;
    points.push_back(at);
  }
  return points;
}

/// Surface voxels from `from` along places one after the other, as Walk goes.
std::vector<glm::dvec3> Follow(GridView<const Label> bone, const glm::dvec3& from,
  const std::vector<glm::dvec3>& places, double lengthMm)
{
  std::vector<glm::dvec3> points;
  glm::dvec3 at = from;
  for (std::size_t n = 1; n < places.size(); ++n)
  {
    const glm::dvec3 along = glm::normalize(places[n] - places[n - 1]);
    const double left = glm::dot(places[n] - at, along);
    if (left <= 0.0)
      continue;
    const std::vector<glm::dvec3> more = Walk(bone, at, along, std::min(left, lengthMm));
    for (const glm::dvec3& point : more)
    {
      lengthMm -= glm::distance(point, at);
      at = point;
      points.push_back(at);
    }
  }
  return points;
}

} // namespace

BrushStroke DrawStroke(
  GridView<const Label> bone, const CoarseHint& hint, const StrokeLimits& limits)
{
  CheckLimits(limits);
  bone.geometry.Validate();
  std::optional<glm::dvec3> start;
  for (double withinMm = 3.0; !start && withinMm < 31.0; withinMm += 3.0)
    start = NearestSurface(bone, hint.near, withinMm);
  if (!start)
    throw std::runtime_error(
      "simulated stroke: no bone within 30 mm of the hint; is the bone of this scan?");
  BrushStroke stroke;
  stroke.label = hint.label;
  stroke.radiusMm = std::min(limits.radiusMm, hint.reachMm / 3.0);
  std::vector<glm::dvec3> back, ahead;
  if (hint.way.empty())
  {
    const double half =
      std::clamp(0.5 * hint.reachMm - stroke.radiusMm, 0.0, 0.5 * limits.lengthMm);
    back = Walk(bone, *start, -hint.along, half);
    ahead = Walk(bone, *start, hint.along, half);
  }
  else
  {
    const auto nearest = std::min_element(hint.way.begin(), hint.way.end(),
      [&](const glm::dvec3& a, const glm::dvec3& b)
      { return glm::distance(a, hint.near) < glm::distance(b, hint.near); });
    back = Follow(bone, *start, { std::make_reverse_iterator(nearest + 1), hint.way.rend() },
      0.5 * limits.lengthMm);
    ahead = Follow(bone, *start, { nearest, hint.way.end() }, 0.5 * limits.lengthMm);
  }
  stroke.points.assign(back.rbegin(), back.rend());
  stroke.points.push_back(*start);
  stroke.points.insert(stroke.points.end(), ahead.begin(), ahead.end());
  return stroke;
}

SimulatedUser SimulateUser(GridView<const Label> bone, const CoarseTruth& known,
  const StrokeLimits& limits, const SplitByStrokes& split)
{
  CheckLimits(limits);
  const std::vector<CoarseHint> hints = known.Hints();
  if (hints.size() > static_cast<std::size_t>(limits.strokes))
    throw std::invalid_argument("simulated user: " + std::to_string(limits.strokes) +
                                " strokes for " + std::to_string(hints.size()) +
                                " fragments, must be one each at least");
  SimulatedUser user;
  for (const CoarseHint& hint : hints)
    user.strokes.push_back(DrawStroke(bone, hint, limits));
  while (true)
  {
    user.labels = split(user.strokes);
    ++user.splits;
    if (user.labels.size() != bone.geometry.Size())
      throw std::invalid_argument("simulated user: the split gave " +
                                  std::to_string(user.labels.size()) +
                                  " labels, must be one a voxel");
    const std::optional<CoarseHint> wrong =
      known.LargestError({ user.labels.data(), bone.geometry }, bone, user.splits);
    user.content = !wrong;
    if (user.content || user.strokes.size() == static_cast<std::size_t>(limits.strokes))
      return user;
    user.strokes.push_back(DrawStroke(bone, *wrong, limits));
  }
}

double LengthOf(const BrushStroke& stroke)
{
  double length = 0.0;
  for (std::size_t n = 1; n < stroke.points.size(); ++n)
    length += glm::distance(stroke.points[n - 1], stroke.points[n]);
  return length;
}

} // namespace hasp
