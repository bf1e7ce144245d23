#include "GuideClaims.h"

#include "Planning/GuideRecipe.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <stdexcept>

namespace hasp
{

namespace
{
/// By how much the shell may be thinner than the recipe says.
double ThinnerMm(const GuideRecipe& recipe)
{
  double cut = 0.0;
  for (const GuideLabel& label : recipe.labels)
    if (label.engraved)
      cut = std::max(cut, label.depthMm);
  return std::max(0.2, 0.5 * recipe.spacingMm) + 0.25 * recipe.edgeRadiusMm + cut;
}
/// What stands on the shell, at most: the walls of boxes, flanges and sleeves above it.
double BesideMm3(const GuideRecipe& recipe)
{
  const double shell = recipe.gapMm + recipe.thicknessMm, wall = recipe.wallMm;
  double sum = 0.0;
  for (const GuideSlot& slot : recipe.slots)
  {
    const double width = SlotWidthMm(recipe, slot.kerfMm);
    const double section = (slot.lengthMm + 2 * wall) * (width + 2 * wall) - slot.lengthMm * width;
    sum += section * std::max(slot.guidingHeightMm - shell, 0.0);
  }
  for (const GuideFlange& flange : recipe.flanges)
    sum += flange.lengthMm * wall * std::max(flange.heightMm - shell, 0.0);
  for (const GuideHole& hole : recipe.holes)
    sum += glm::pi<double>() * recipe.sleeveWallMm * (hole.diameterMm + recipe.sleeveWallMm) *
           std::max(hole.sleeveHeightMm - shell, 0.0);
  return sum;
}
} // namespace

PartClaims ClaimsOf(
  const GuideRecipe& recipe, double leastGapShare, const std::optional<glm::dvec3>& insertionAxis)
{
  ValidateGuideRecipe(recipe);
  if (recipe.axisSearchDeg > 0.0 && !insertionAxis)
    throw std::invalid_argument("guide claims: axisSearchDeg asks for a search of the insertion "
                                "axis; say the axis that the guide was made with");
  PartClaims claims;
  claims.isovalue = recipe.isovalue;
  claims.ignoreBelowMm3 = recipe.ignoreBelowMm3;
  claims.withdrawal = glm::normalize(insertionAxis.value_or(recipe.withdrawal));
  ClaimedShell shell;
  shell.gapMm = recipe.gapMm;
  shell.leastGapShare = leastGapShare;
  shell.thicknessMm = recipe.thicknessMm;
  claims.leastWallMm = std::min(claims.leastWallMm, recipe.thicknessMm - recipe.spacingMm);
  shell.thicknessToleranceMm = ThinnerMm(recipe);
  shell.besideMm3 = BesideMm3(recipe);
  claims.shell = shell;
  for (const GuideSlot& slot : recipe.slots)
  {
    const glm::dmat3 axes = SawAxes(slot.normal, *claims.withdrawal);
    claims.slots.push_back(
      { slot.point, axes[0], axes[1], SlotWidthMm(recipe, slot.kerfMm), slot.lengthMm, 0.1 });
  }
  for (const GuideHole& hole : recipe.holes)
    claims.holes.push_back({ hole.point, glm::normalize(hole.axis), hole.diameterMm, 0.1 });
  return claims;
}

} // namespace hasp
