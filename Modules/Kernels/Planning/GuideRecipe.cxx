#include "Planning/GuideRecipe.h"

#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>

namespace hasp
{

namespace
{
const ValueChecks check("guide recipe");

void CheckShown(const std::string& key, double size, double spacing)
{
  if (size < 2.0 * spacing)
  {
    std::ostringstream must;
    must << "at least two grid spacings (spacingMm is " << spacing << ")";
    check.Refuse(key, size, must.str());
  }
}

void CheckLandmarks(const GuideRecipe& r)
{
  const std::size_t least = r.outline == GuideOutline::Open ? 2 : 3, count = r.landmarks.size();
  if (count < least)
    check.Refuse("the number of landmarks", double(count), "at least " + std::to_string(least));
  if (count > 1000)
    check.Refuse("the number of landmarks", double(count), "at most 1000");
  for (std::size_t n = 0; n < count; ++n)
  {
    check.Point(ListKey("landmarks", n), r.landmarks[n]);
    const std::size_t next = (n + 1) % count;
    if (next > 0 || r.outline != GuideOutline::Open)
      if (const double apart = glm::length(r.landmarks[n] - r.landmarks[next]); apart < 0.01)
        check.Refuse(
          "the distance of " + ListKey("landmarks", n) + " and " + ListKey("landmarks", next),
          apart, "at least 0.01 mm");
  }
}
} // namespace

void ValidateGuideRecipe(const GuideRecipe& r)
{
  check.Closed("isovalue", r.isovalue, -1e6, 1e6);
  CheckLandmarks(r);
  check.Unit("withdrawal", r.withdrawal);
  check.Closed("gapMm", r.gapMm, 0.0, 10.0);
  check.AboveUpTo("thicknessMm", r.thicknessMm, 0.0, 50.0);
  check.AboveUpTo("widthMm", r.widthMm, 0.0, 200.0);
  check.Closed("spacingMm", r.spacingMm, 0.05, 2.0);
  check.Closed("ignoreBelowMm3", r.ignoreBelowMm3, 0.0, 1e6);
  CheckShown("thicknessMm", r.thicknessMm, r.spacingMm);
  CheckShown("widthMm", r.widthMm, r.spacingMm);
  for (std::size_t n = 0; n < r.slots.size(); ++n)
  {
    const GuideSlot& slot = r.slots[n];
    check.Point(ListKey("slots", n, "point"), slot.point);
    check.Unit(ListKey("slots", n, "normal"), slot.normal);
    if (const double along = std::abs(glm::dot(slot.normal, r.withdrawal)); along > 0.9)
      check.Refuse(ListKey("slots", n, "normal") + ": its cosine with withdrawal", along,
        "at most 0.9; the saw must come in along the withdrawal direction");
    check.AboveUpTo(ListKey("slots", n, "widthMm"), slot.widthMm, 0.0, 20.0);
    check.AboveUpTo(ListKey("slots", n, "lengthMm"), slot.lengthMm, 0.0, 500.0);
    CheckShown(ListKey("slots", n, "widthMm"), slot.widthMm, r.spacingMm);
  }
  for (std::size_t n = 0; n < r.holes.size(); ++n)
  {
    const GuideHole& hole = r.holes[n];
    check.Point(ListKey("holes", n, "point"), hole.point);
    check.Unit(ListKey("holes", n, "axis"), hole.axis);
    check.AboveUpTo(ListKey("holes", n, "diameterMm"), hole.diameterMm, 0.0, 20.0);
    CheckShown(ListKey("holes", n, "diameterMm"), hole.diameterMm, r.spacingMm);
  }
}

} // namespace hasp
