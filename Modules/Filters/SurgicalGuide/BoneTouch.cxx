#include "BoneTouch.h"

#include "Grid/Trilinear.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hasp
{

namespace
{
constexpr double LeastGradient = 1e-6; // grey values a mm: below is flat

double LeastSpacing(const GridGeometry& grid)
{
  return std::min({ grid.spacing.x, grid.spacing.y, grid.spacing.z });
}

std::optional<double> ValueAt(const AnyGridView& scan, const glm::dvec3& place)
{
  return std::visit([&](const auto& view)
    { return SampleTrilinear(view, view.geometry.WorldToIndex(place)); },
    scan);
}

std::vector<glm::dvec3> Directions(const std::optional<glm::dvec3>& normal)
{
  std::vector<glm::dvec3> directions;
  if (normal)
    directions = { *normal, -*normal };
  for (int n = 0; n < 27; ++n)
    if (n != 13)
      directions.push_back(glm::normalize(glm::dvec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1)));
  return directions;
}

/// How far along a unit direction the isovalue is first crossed.
std::optional<double> WayToSurface(const AnyGridView& scan, double isovalue,
  const glm::dvec3& place, const glm::dvec3& direction, double reachMm)
{
  const double step = 0.25 * LeastSpacing(GeometryOf(scan));
  std::optional<double> before = ValueAt(scan, place);
  for (double way = step; before && way < reachMm + step; way += step)
  {
    const std::optional<double> here = ValueAt(scan, place + way * direction);
    if (!here)
      return std::nullopt;
    if ((*before >= isovalue) != (*here >= isovalue))
    {
      const double crossing = way - step * (*here - isovalue) / (*here - *before);
      return crossing <= reachMm ? std::optional(crossing) : std::nullopt;
    }
    before = here;
  }
  return std::nullopt;
}
} // namespace

std::optional<glm::dvec3> BoneNormal(const AnyGridView& scan, const glm::dvec3& place)
{
  const GridGeometry& grid = GeometryOf(scan);
  glm::dvec3 perStep(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 step(0.0);
    step[axis] = 1.0;
    const glm::dvec3 index = grid.WorldToIndex(place);
    const auto ahead = ValueAt(scan, grid.IndexToWorld(index + step)),
               behind = ValueAt(scan, grid.IndexToWorld(index - step));
    if (!ahead || !behind)
      return std::nullopt;
    perStep[axis] = 0.5 * (*ahead - *behind);
  }
  const glm::dvec3 gradient = grid.GradientToWorld(perStep);
  if (!(glm::length(gradient) > LeastGradient))
    return std::nullopt;
  return -glm::normalize(gradient);
}

std::optional<TouchedBone> TouchBone(
  const AnyGridView& scan, double isovalue, const glm::dvec3& place, double reachMm)
{
  double nearest = reachMm;
  std::optional<glm::dvec3> found;
  for (const glm::dvec3& direction : Directions(BoneNormal(scan, place)))
    if (const auto way = WayToSurface(scan, isovalue, place, direction, nearest))
      nearest = *way, found = place + *way * direction;
  if (!found)
    return std::nullopt;
  const auto normal = BoneNormal(scan, *found);
  if (!normal)
    return std::nullopt;
  return TouchedBone{ *found, *normal };
}

bool IsInBone(const AnyGridView& scan, double isovalue, const glm::dvec3& place)
{
  const auto value = ValueAt(scan, place);
  return value && *value >= isovalue;
}

std::optional<glm::dvec3> MiddleOfBone(const AnyGridView& scan, double isovalue,
  const glm::dvec3& place, const glm::dvec3& into, double reachMm)
{
  const double step = 0.25 * LeastSpacing(GeometryOf(scan));
  std::optional<double> first;
  double last = 0.0;
  for (double way = -step; way <= reachMm; way += step) // it may have been touched from within
  {
    const std::optional<double> value = ValueAt(scan, place + way * into);
    if (!value)
      break;
    if (*value < isovalue)
      continue;
    first = first.value_or(way);
    last = way;
  }
  if (!first)
    return std::nullopt;
  return place + 0.5 * (*first + last) * into;
}

} // namespace hasp
