#include "Planning/GuideSlots.h"

#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr double MostMm = 500.0; // of a slot's length and depth
} // namespace

GuideSlot SlotOfBlade(
  const Osteotomy& blade, const glm::dvec3& withdrawal, const std::string& subject)
{
  const ValueChecks check(subject);
  ValidateOsteotomy(blade, subject);
  check.Unit("withdrawal", withdrawal);
  if (const double along = std::abs(glm::dot(blade.normal, withdrawal)); along > MostSawCosine)
    check.Refuse("the cosine of the blade's normal with withdrawal", along,
      "at most 0.9; the saw must come in along the withdrawal direction");
  const glm::dmat3 axes = SawAxes(blade.normal, withdrawal);
  const glm::dvec3 width = blade.widthMm * glm::normalize(blade.along);
  const glm::dvec3 depth = blade.depthMm * glm::normalize(glm::cross(blade.normal, blade.along));
  const auto reach = [&](const glm::dvec3& axis)
  { return std::abs(glm::dot(width, axis)) + std::abs(glm::dot(depth, axis)); };
  GuideSlot slot;
  slot.point = blade.point;
  slot.normal = axes[0];
  slot.kerfMm = blade.kerfMm;
  slot.lengthMm = std::min(MostMm, reach(axes[1]));
  slot.depthMm = 0.5 * reach(axes[2]);
  return slot;
}

GuideSlot MovedSlot(const GuideSlot& slot, const glm::dvec3& withdrawal, double upMm)
{
  if (!(upMm > -slot.depthMm))
    ValueChecks("guide slot").Refuse("upMm", upMm, "above -depthMm");
  GuideSlot moved = slot;
  moved.point += upMm * SawAxes(slot.normal, withdrawal)[2];
  moved.depthMm = std::min(MostMm, slot.depthMm + upMm);
  return moved;
}

} // namespace hasp
