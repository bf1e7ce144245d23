#include "Planning/ImplantRecipe.h"

#include "Planning/ValueChecks.h"

namespace hasp
{

namespace
{
constexpr std::size_t MostPoints = 200;
constexpr double LeastSpacings = 2.0; // what is thinner may fall between the grid's points

void CheckOutline(const ValueChecks& check, const std::vector<glm::dvec3>& outline)
{
  if (outline.size() < 3 || outline.size() > MostPoints)
    check.Refuse("outline", double(outline.size()), "3 to 200 points");
  for (std::size_t n = 0; n < outline.size(); ++n)
  {
    check.Point(ListKey("outline", n), outline[n]);
    if (outline[n] == outline[(n + 1) % outline.size()])
      check.Refuse(ListKey("outline", n), "is the same point as the next");
  }
}

void CheckHoles(const ValueChecks& check, const ImplantRecipe& recipe)
{
  check.Closed("holeDiameterMm", recipe.holeDiameterMm, 0.0, 20.0);
  check.Closed("holePitchMm", recipe.holePitchMm, 1.0, 100.0);
  check.Closed("holeEdgeMm", recipe.holeEdgeMm, 0.5, 50.0);
  if (recipe.holeDiameterMm == 0.0)
    return;
  if (!(recipe.holeDiameterMm >= LeastSpacings * recipe.spacingMm))
    check.Refuse("holeDiameterMm", recipe.holeDiameterMm, "0, or at least two spacingMm");
  if (!(recipe.holePitchMm >= recipe.holeDiameterMm + LeastSpacings * recipe.spacingMm))
    check.Refuse("holePitchMm", recipe.holePitchMm, "at least holeDiameterMm and two spacingMm");
}
} // namespace

void ValidateImplantRecipe(const ImplantRecipe& recipe)
{
  const ValueChecks check("implant recipe");
  check.Closed("isovalue", recipe.isovalue, -1e6, 1e6);
  check.Closed("ignoreBelowMm3", recipe.ignoreBelowMm3, 0.0, 1e6);
  if (recipe.mirror)
  {
    check.Point("mirror.point", recipe.mirror->point);
    check.Unit("mirror.normal", recipe.mirror->normal);
  }
  CheckOutline(check, recipe.outline);
  if (recipe.axis)
    check.Unit("axis", *recipe.axis);
  check.Closed("clearanceMm", recipe.clearanceMm, 0.0, 5.0);
  check.Closed("spacingMm", recipe.spacingMm, 0.1, 2.0);
  check.AboveUpTo("thicknessMm", recipe.thicknessMm, 0.0, 20.0);
  if (!(recipe.thicknessMm >= LeastSpacings * recipe.spacingMm))
    check.Refuse("thicknessMm", recipe.thicknessMm, "at least two spacingMm");
  CheckHoles(check, recipe);
}

} // namespace hasp
