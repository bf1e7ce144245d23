#include "GuideSlots.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double LeastSine = 0.1; ///< of a saw plane's normal with the withdrawal direction

/// Of the places that are said to lie on the bone, the one nearest to a blade's plane; of several
/// within a millimetre of it the one nearest to the blade's middle.
glm::dvec3 PlaceOnBone(const Osteotomy& blade, const GuideRecipe& recipe)
{
  glm::dvec3 nearest = blade.point;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const glm::dvec3& place)
  {
    const glm::dvec3 way = place - blade.point;
    const double off = std::abs(glm::dot(way, blade.normal));
    const double away = 1000.0 * std::floor(off) + glm::length(way);
    if (away < least)
      least = away, nearest = place;
  };
  for (const glm::dvec3& place : recipe.landmarks)
    look(place);
  for (const GuideStroke& stroke : recipe.strokes)
    for (const glm::dvec3& place : stroke.points)
      look(place);
  return nearest;
}
} // namespace

std::vector<GuideSlot> SlotsOf(std::span<const Osteotomy> blades, const GuideRecipe& recipe)
{
  std::vector<GuideSlot> slots;
  for (const Osteotomy& blade : blades)
  {
    const auto refuse = [&](const std::string& text)
    { throw std::invalid_argument("blades[" + std::to_string(slots.size()) + "] " + text); };
    if (glm::length(glm::cross(blade.normal, recipe.withdrawal)) < LeastSine)
      refuse("is upright on the withdrawal direction: no saw comes in along it");
    const glm::dmat3 axes = SawAxes(blade.normal, recipe.withdrawal);
    const glm::dvec3 across = glm::cross(blade.normal, blade.along);
    const auto half = [&](const glm::dvec3& direction)
    {
      return 0.5 * (std::abs(glm::dot(blade.along, direction)) * blade.widthMm +
                     std::abs(glm::dot(across, direction)) * blade.depthMm);
    };
    const double rise = glm::dot(PlaceOnBone(blade, recipe) - blade.point, axes[2]);
    GuideSlot slot;
    slot.point = blade.point + rise * axes[2];
    slot.normal = blade.normal;
    slot.kerfMm = blade.kerfMm;
    slot.lengthMm = std::min(2.0 * half(axes[1]), 500.0);
    slot.depthMm = std::min(half(axes[2]) + rise, 500.0);
    if (!(slot.depthMm > 0.0))
      refuse("ends above the guide's landmarks: it cuts none of the bone below them");
    slots.push_back(slot);
  }
  return slots;
}

} // namespace hasp
