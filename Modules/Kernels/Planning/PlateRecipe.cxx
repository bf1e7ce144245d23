#include "Planning/PlateRecipe.h"

#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr std::size_t MostLandmarks = 200, MostScrews = 100, MostFragments = 100;
constexpr double LeastSpacings = 2.0; // what is thinner may fall between the grid's points

void CheckLandmarks(const ValueChecks& check, const std::vector<glm::dvec3>& landmarks)
{
  if (landmarks.size() < 2 || landmarks.size() > MostLandmarks)
    check.Refuse("landmarks", double(landmarks.size()), "2 to 200 points");
  for (std::size_t n = 0; n < landmarks.size(); ++n)
  {
    check.Point(ListKey("landmarks", n), landmarks[n]);
    if (n > 0 && landmarks[n] == landmarks[n - 1])
      check.Refuse(ListKey("landmarks", n), "is the same point as the one before");
  }
}

void CheckScrew(const ValueChecks& check, const PlateRecipe& recipe, std::size_t n)
{
  const PlateScrew& screw = recipe.screws[n];
  const auto key = [&](const char* name) { return ListKey("screws", n, name); };
  check.Point(key("point"), screw.point);
  if (screw.axis)
    check.Unit(key("axis"), *screw.axis);
  check.AboveUpTo(key("diameterMm"), screw.diameterMm, 0.0, 20.0);
  check.Closed(key("headDiameterMm"), screw.headDiameterMm, screw.diameterMm, 30.0);
  check.Closed(key("headDepthMm"), screw.headDepthMm, 0.0, 20.0);
  check.Closed(key("headAngleDeg"), screw.headAngleDeg, 30.0, 150.0);
  check.AboveUpTo(key("lengthMm"), screw.lengthMm, 0.0, 200.0);
  if (const double depth = ScrewHeadDepth(screw); !(depth <= recipe.thicknessMm))
    check.Refuse(key("headDepthMm") + " and the cone's depth", depth, "at most thicknessMm");
  if (!(screw.diameterMm >= LeastSpacings * recipe.spacingMm))
    check.Refuse(key("diameterMm"), screw.diameterMm, "at least two spacingMm");
}

void CheckFragments(const ValueChecks& check, const std::vector<PlateFragment>& fragments)
{
  if (fragments.size() > MostFragments)
    check.Refuse("fragments", double(fragments.size()), "at most 100");
  for (std::size_t n = 0; n < fragments.size(); ++n)
  {
    const PlateFragment& fragment = fragments[n];
    check.Closed(ListKey("fragments", n, "label"), fragment.label, 1, 65535);
    check.Point(ListKey("fragments", n, "position"), fragment.position);
    const double length = glm::length(fragment.orientation);
    if (!(std::abs(length - 1.0) <= 1e-6))
      check.Refuse(ListKey("fragments", n, "orientation") + "'s length", length, "1 within 1e-6");
    for (std::size_t m = 0; m < n; ++m)
      if (fragments[m].label == fragment.label)
        check.Refuse(ListKey("fragments", n, "label"), "is that of " + ListKey("fragments", m));
  }
}

/// 0, or in [low, high].
void CheckOption(const ValueChecks& check, const char* key, double value, double low, double high)
{
  if (value != 0.0)
    check.Closed(key, value, low, high);
}
} // namespace

double ScrewHeadDepth(const PlateScrew& screw)
{
  return screw.headDepthMm + 0.5 * (screw.headDiameterMm - screw.diameterMm) /
                               std::tan(glm::radians(0.5 * screw.headAngleDeg));
}

void ValidatePlateRecipe(const PlateRecipe& recipe)
{
  const ValueChecks check("plate recipe");
  check.Closed("isovalue", recipe.isovalue, -1e6, 1e6);
  check.Closed("ignoreBelowMm3", recipe.ignoreBelowMm3, 0.0, 1e6);
  CheckLandmarks(check, recipe.landmarks);
  check.Closed("spacingMm", recipe.spacingMm, 0.05, 2.0);
  check.Closed("gapMm", recipe.gapMm, 0.0, 5.0);
  check.AboveUpTo("thicknessMm", recipe.thicknessMm, 0.0, 20.0);
  check.AboveUpTo("widthMm", recipe.widthMm, 0.0, 100.0);
  for (const auto& [key, value] :
    { std::pair{ "thicknessMm", recipe.thicknessMm }, std::pair{ "widthMm", recipe.widthMm } })
    if (!(value >= LeastSpacings * recipe.spacingMm))
      check.Refuse(key, value, "at least two spacingMm");
  CheckOption(check, "bevelMm", recipe.bevelMm, recipe.spacingMm,
    std::min(0.8 * recipe.thicknessMm, recipe.widthMm / 3.0));
  CheckOption(check, "bridgeMm", recipe.bridgeMm, recipe.spacingMm, 10.0);
  check.Closed("edgeDistanceMm", recipe.edgeDistanceMm, 0.0, 20.0);
  check.Closed("holeDistanceMm", recipe.holeDistanceMm, 0.0, 20.0);
  if (recipe.screws.size() > MostScrews)
    check.Refuse("screws", double(recipe.screws.size()), "at most 100");
  for (std::size_t n = 0; n < recipe.screws.size(); ++n)
    CheckScrew(check, recipe, n);
  CheckFragments(check, recipe.fragments);
}

} // namespace hasp
