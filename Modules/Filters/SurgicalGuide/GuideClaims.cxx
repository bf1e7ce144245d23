#include "GuideClaims.h"

#include "Planning/GuideRecipe.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace hasp
{

PartClaims ClaimsOf(const GuideRecipe& recipe, double leastGapShare)
{
  ValidateGuideRecipe(recipe);
  const double h = recipe.spacingMm;
  PartClaims claims;
  claims.isovalue = recipe.isovalue;
  claims.ignoreBelowMm3 = recipe.ignoreBelowMm3;
  claims.withdrawal = glm::normalize(recipe.withdrawal);
  ClaimedShell shell;
  shell.gapMm = recipe.gapMm;
  shell.leastGapShare = leastGapShare;
  shell.thicknessMm = recipe.thicknessMm;
  claims.leastWallMm = std::min(claims.leastWallMm, recipe.thicknessMm - h);
  shell.thicknessToleranceMm = recipe.thicknessMm - claims.leastWallMm;
  claims.shell = shell;
  for (const GuideSlot& slot : recipe.slots)
  {
    const glm::dvec3 normal = glm::normalize(slot.normal);
    // As GuideFrame::Slot has it: across the withdrawal direction.
    claims.slots.push_back({ slot.point, normal,
      glm::normalize(glm::cross(normal, *claims.withdrawal)), slot.widthMm, slot.lengthMm, 0.1 });
  }
  for (const GuideHole& hole : recipe.holes)
    claims.holes.push_back(
      { hole.point, glm::normalize(hole.axis), hole.diameterMm, 0.1 + h * h / hole.diameterMm });
  return claims;
}

} // namespace hasp
