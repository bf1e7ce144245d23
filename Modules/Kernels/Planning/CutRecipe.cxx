#include "Planning/CutRecipe.h"

#include "Planning/ValueChecks.h"

#include <algorithm>

namespace hasp
{

namespace
{
constexpr double ThinnestKerfMm = 0.2;
constexpr std::size_t MostEntries = 100;
} // namespace

double CutSpacing(const CutRecipe& recipe)
{
  double spacing = recipe.spacingMm;
  for (const BoneCut& cut : recipe.cuts)
    spacing = std::min(spacing, cut.blade.kerfMm / StepsAKerf);
  return spacing;
}

void ValidateCutRecipe(const CutRecipe& r)
{
  const ValueChecks checks("cut recipe");
  checks.Closed("isovalue", r.isovalue, -1e6, 1e6);
  checks.Closed("spacingMm", r.spacingMm, 0.1, 2.0);
  checks.Closed("ignoreBelowMm3", r.ignoreBelowMm3, 0.0, 1e6);
  checks.Closed("crumbBelowMm3", r.crumbBelowMm3, 0.0, 1e6);
  checks.Closed("the number of cuts", double(r.cuts.size()), 1.0, double(MostEntries));
  checks.Closed("the number of resected", double(r.resected.size()), 0.0, double(MostEntries));
  for (std::size_t n = 0; n < r.cuts.size(); ++n)
  {
    ValidateOsteotomy(r.cuts[n].blade, "cut recipe: " + ListKey("cuts", n));
    checks.Closed(ListKey("cuts", n, "kerfMm"), r.cuts[n].blade.kerfMm, ThinnestKerfMm, 5.0);
    checks.Closed(ListKey("cuts", n, "reachMm"), r.cuts[n].reachMm, 0.0, 500.0);
  }
  for (std::size_t n = 0; n < r.resected.size(); ++n)
    checks.Point(ListKey("resected", n), r.resected[n]);
}

} // namespace hasp
