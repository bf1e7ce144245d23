#include "PlateClaims.h"

#include "Planning/PlateRecipe.h"
#include "PlateBuilder.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double LeastBoreMm = 0.5;
constexpr double RimMm = 0.1; // of a bore before its cone: edges are true to less

ClaimedShell ShellOf(const PlateRecipe& recipe, double leastGapShare, double leastWallMm)
{
  ClaimedShell shell;
  shell.gapMm = recipe.gapMm;
  shell.leastGapShare = leastGapShare;
  shell.thicknessMm = recipe.thicknessMm;
  shell.thicknessToleranceMm =
    std::min(recipe.bevelMm + recipe.spacingMm, recipe.thicknessMm - leastWallMm);
  return shell;
}
} // namespace

std::vector<ScrewAxis> FindScrewAxes(const AnyGridView& scan, const PlateRecipe& recipe)
{
  if (!recipe.fragments.empty())
    throw std::invalid_argument("plate claims: the recipe moves fragments, so that the plate does "
                                "not lie on the bone of the scan; there is no gap to measure");
  std::vector<ScrewAxis> axes;
  for (const PlacedScrew& screw : MakePlateSolid({ scan }, recipe).screws)
    axes.push_back({ screw.outer, screw.axis });
  return axes;
}

PartClaims ClaimsOf(
  const PlateRecipe& recipe, std::span<const ScrewAxis> screws, double leastGapShare)
{
  ValidatePlateRecipe(recipe);
  if (screws.size() != recipe.screws.size())
    throw std::invalid_argument("plate claims: there are " + std::to_string(screws.size()) +
                                " axes for " + std::to_string(recipe.screws.size()) + " screws");
  PartClaims claims;
  claims.isovalue = recipe.isovalue;
  claims.ignoreBelowMm3 = recipe.ignoreBelowMm3;
  claims.leastWallMm = std::min(claims.leastWallMm, recipe.thicknessMm - recipe.spacingMm);
  if (recipe.fragments.empty())
    claims.shell = ShellOf(recipe, leastGapShare, claims.leastWallMm);
  for (std::size_t n = 0; n < screws.size(); ++n)
  {
    const PlateScrew& screw = recipe.screws[n];
    const double head = screw.headDiameterMm > screw.diameterMm ? ScrewHeadDepth(screw) : 0.0;
    if (recipe.thicknessMm - head < LeastBoreMm)
      continue;
    ClaimedHole bore{ screws[n].outer, screws[n].axis, screw.diameterMm, 0.1 };
    bore.lowMm = -2.0 * recipe.thicknessMm - screw.diameterMm; // leaning by 45 degrees, too
    bore.highMm = head > 0.0 ? -head - RimMm : screw.diameterMm;
    bore.clearMm = screw.headDiameterMm;
    bore.roomMm = screw.headDiameterMm;
    bore.name = "screws[" + std::to_string(n) + "]";
    claims.holes.push_back(bore);
  }
  return claims;
}

} // namespace hasp
