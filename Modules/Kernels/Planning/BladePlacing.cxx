#include "Planning/BladePlacing.h"

#include "Planning/ValueChecks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <string>

namespace hasp
{

namespace
{
const ValueChecks check("blade");
constexpr double LeastApartMm = 1.0;
constexpr double LeastSine =
  0.05; // about 3 degrees: below that hands do not say which way they mean
constexpr double MostSizeMm = 500.0; // ValidateOsteotomy's

void CheckPlaces(std::span<const glm::dvec3> places)
{
  if (places.size() != 2 && places.size() != 3)
    check.Refuse("the number of places", double(places.size()), "2 or 3");
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    check.Point(ListKey("places", n), places[n]);
    for (std::size_t m = 0; m < n; ++m)
      if (const double apart = glm::distance(places[n], places[m]); apart < LeastApartMm)
        check.Refuse("the distance of " + ListKey("places", m) + " and " + ListKey("places", n),
          apart, "at least 1 mm");
  }
}

glm::dvec3 LongestSide(std::span<const glm::dvec3> places)
{
  glm::dvec3 longest = places[1] - places[0];
  if (places.size() == 3)
    for (const glm::dvec3& side : { places[2] - places[1], places[2] - places[0] })
      if (glm::length(side) > glm::length(longest))
        longest = side;
  return glm::normalize(longest);
}

glm::dvec3 PlaneNormal(
  std::span<const glm::dvec3> places, const glm::dvec3& view, const glm::dvec3& along)
{
  const double length = glm::length(view);
  if (!(length > 0.0))
    check.Refuse("view", "must have a length");
  const glm::dvec3 seen = glm::cross(view / length, along);
  if (places.size() == 2)
  {
    if (!(glm::length(seen) >= LeastSine))
      check.Refuse("view", "lies along the line between the two places; turn the view, or touch a "
                           "third place");
    return glm::normalize(seen);
  }
  const glm::dvec3 first = glm::normalize(places[1] - places[0]),
                   second = glm::normalize(places[2] - places[0]);
  const glm::dvec3 normal = glm::cross(first, second);
  if (!(glm::length(normal) >= LeastSine))
    check.Refuse("places", "lie on a line; touch the third one beside it");
  return glm::normalize(glm::dot(normal, seen) < 0.0 ? -normal : normal);
}
} // namespace

glm::dmat3 BladeAxes(const Osteotomy& blade)
{
  const glm::dvec3 normal = glm::normalize(blade.normal), along = glm::normalize(blade.along);
  return { along, glm::cross(normal, along), normal };
}

Osteotomy BladeThrough(
  std::span<const glm::dvec3> places, const glm::dvec3& view, const Osteotomy& sizes)
{
  CheckPlaces(places);
  Osteotomy blade = sizes;
  blade.along = LongestSide(places);
  blade.normal = PlaneNormal(places, view, blade.along);
  const glm::dvec3 across = glm::cross(blade.normal, blade.along);
  glm::dvec2 low(1e9), high(-1e9);
  for (const glm::dvec3& place : places)
  {
    const glm::dvec3 from = place - places[0];
    const glm::dvec2 at(glm::dot(from, blade.along), glm::dot(from, across));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  const glm::dvec2 middle = 0.5 * (low + high), size = high - low + 2.0 * BeyondPlacesMm;
  blade.point = places[0] + middle.x * blade.along + middle.y * across;
  blade.widthMm = std::min(std::max(sizes.widthMm, size.x), MostSizeMm);
  blade.depthMm = std::min(std::max(sizes.depthMm, size.y), MostSizeMm);
  return blade;
}

Osteotomy ShiftedBlade(Osteotomy blade, const glm::dvec3& mm)
{
  blade.point += BladeAxes(blade) * mm;
  return blade;
}

Osteotomy TurnedBlade(Osteotomy blade, const glm::dquat& turn)
{
  const glm::dquat unit = glm::normalize(turn);
  blade.normal = glm::normalize(unit * blade.normal);
  const glm::dvec3 along = unit * blade.along;
  blade.along = glm::normalize(along - glm::dot(along, blade.normal) * blade.normal);
  return blade;
}

std::optional<glm::dvec3> MeanDirection(std::span<const glm::dvec3> directions)
{
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& direction : directions)
    sum += direction;
  if (!(glm::length(sum) >= 0.1 * double(directions.size())) || directions.empty())
    return std::nullopt;
  return glm::normalize(sum);
}

} // namespace hasp
