#include "ImplantClaims.h"

#include "ImplantBuilder.h"

#include "Planning/ImplantRecipe.h"

#include <algorithm>
#include <utility>

namespace hasp
{

PlacedImplant PlaceImplant(const AnyGridView& scan, const ImplantRecipe& recipe)
{
  ImplantSolid made = MakeImplantSolid(scan, recipe);
  return { made.axis, std::move(made.holes) };
}

PartClaims ClaimsOf(
  const ImplantRecipe& recipe, const glm::dvec3& axis, std::span<const glm::dvec3> holes)
{
  ValidateImplantRecipe(recipe);
  PartClaims claims;
  claims.isovalue = recipe.isovalue;
  claims.ignoreBelowMm3 = recipe.ignoreBelowMm3;
  claims.withdrawal = axis;
  const double bevel = 0.5 * recipe.spacingMm;
  double least = recipe.thicknessMm;
  claims.leastUncutMm = std::max(least - bevel, 0.0);
  if (!holes.empty())
    least = std::min({ least, recipe.holePitchMm - recipe.holeDiameterMm, recipe.holeEdgeMm });
  claims.leastWallMm = std::max(least - bevel, 0.0);
  for (const glm::dvec3& p : holes)
    claims.holes.push_back({ p, axis, recipe.holeDiameterMm, 0.1 });
  return claims;
}

} // namespace hasp
