#include "PlaceChecks.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
/// Recipes are in millimetres and LPS; what people have instead, and what that makes of a place.
constexpr std::pair<const char*, glm::dvec3> Mistakes[] = {
  { "in RAS; turned to LPS (the signs of the first two numbers changed)", { -1.0, -1.0, 1.0 } },
  { "in metres; times 1000", { 1000.0, 1000.0, 1000.0 } },
  { "in centimetres; times 10", { 10.0, 10.0, 10.0 } },
  { "in inches; times 25.4", { 25.4, 25.4, 25.4 } }
};

bool IsIn(const GridGeometry& volume, const glm::dvec3& place, double marginMm)
{
  const glm::dvec3 index = volume.WorldToIndex(place), margin = marginMm / volume.spacing;
  return glm::all(glm::greaterThanEqual(index, -margin)) &&
         glm::all(glm::lessThanEqual(index, glm::dvec3(volume.Cells()) + margin));
}
} // namespace

void CheckInVolume(const char* who, const GridGeometry& volume,
  const std::vector<NamedPlace>& places, double marginMm)
{
  const auto out = std::find_if(places.begin(), places.end(),
    [&](const NamedPlace& place) { return !IsIn(volume, place.point, marginMm); });
  if (out == places.end())
    return;
  const glm::dvec3& p = out->point;
  std::ostringstream text;
  text << who << ": " << out->name << " (" << p.x << ", " << p.y << ", " << p.z
       << ") is outside the volume";
  for (const auto& [words, factor] : Mistakes)
    if (std::all_of(places.begin(), places.end(),
          [&](const NamedPlace& place) { return IsIn(volume, factor * place.point, marginMm); }))
    {
      text << ". The places seem to be " << words << ", all are in it";
      break;
    }
  throw std::runtime_error(text.str());
}

} // namespace hasp
