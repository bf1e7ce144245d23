#include "View/FragmentLook.h"

namespace hasp
{
namespace
{

constexpr double ResectedOpacity = 0.3, ResectedShare = 0.7, LockedShare = 0.25;
const glm::dvec3 ResectedColour{ 0.85, 0.20, 0.15 };
const glm::dvec3 LockedColour{ 0.55, 0.65, 0.85 };

} // namespace

SceneLook LookOf(const PlanFragment& fragment, bool selected)
{
  const glm::dvec3 colour =
    glm::dvec3(fragment.colour[0], fragment.colour[1], fragment.colour[2]) / 255.0;
  if (fragment.state == FragmentState::Resected)
    return { Mixed(colour, ResectedColour, ResectedShare), ResectedOpacity, selected };
  return { fragment.locked ? Mixed(colour, LockedColour, LockedShare) : colour, 1.0, selected };
}

} // namespace hasp
