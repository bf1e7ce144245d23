#include "Planning/TransplantRecipe.h"

#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace hasp
{

namespace
{
const ValueChecks check("transplant recipe");
constexpr double MostTiltDegrees = 60.0;
constexpr double LeastLegMm = 1.0;

void CheckPoints(const char* list, const std::vector<glm::dvec3>& points)
{
  for (std::size_t n = 0; n < points.size(); ++n)
    check.Point(ListKey(list, n), points[n]);
}

/// "the distance of LIST[n] from the place before it"
void CheckApart(const char* list, const std::vector<glm::dvec3>& points, double leastMm)
{
  for (std::size_t n = 1; n < points.size(); ++n)
    if (const double apart = glm::distance(points[n], points[n - 1]); !(apart >= leastMm))
      check.Refuse("the distance of " + ListKey(list, n) + " from the place before it", apart,
        "at least " + std::to_string(int(leastMm)) + " mm");
}

void CheckDefect(const TransplantRecipe& r)
{
  ValidateCutRecipe(r.resection);
  check.Closed("the number of resection.cuts", double(r.resection.cuts.size()), 2.0, 100.0);
  check.Closed("the number of path's places", double(r.path.size()), 2.0, 6.0);
  CheckPoints("path", r.path);
  CheckApart("path", r.path, LeastLegMm);
  const std::size_t segments = r.path.size() - 1;
  if (r.outward.size() != 1 && r.outward.size() != segments)
    check.Refuse("the number of outward", double(r.outward.size()),
      "1, or that of the segments: " + std::to_string(segments));
  for (std::size_t n = 0; n < r.outward.size(); ++n)
    check.Unit(ListKey("outward", n), r.outward[n]);
  check.Closed("rollDeg", r.rollDeg, -180.0, 180.0);
  check.AboveUpTo("leastSegmentMm", r.leastSegmentMm, 0.0, 200.0);
  check.Closed("mostGapMm", r.mostGapMm, 0.0, 10.0);
  check.Closed("mostOverlapMm", r.mostOverlapMm, 0.0, 10.0);
}

void CheckDonor(const TransplantRecipe& r)
{
  check.Closed("donor.isovalue", r.donorIsovalue, -1e6, 1e6);
  const double most = r.findAxis ? 2.0 : 10000.0;
  check.Closed("the number of donor.axis' places", double(r.donor.axis.size()), 2.0, most);
  CheckPoints("donor.axis", r.donor.axis);
  CheckApart("donor.axis", r.donor.axis, LeastLegMm);
  check.Unit("donor.lateral", r.donor.lateral);
  check.AboveUpTo("donor.radiusMm", r.donor.radiusMm, 0.0, 50.0);
  check.Closed("donor.keepMm", r.donor.keepMm, 0.0, 500.0);
  check.Closed("donor.startOffsetMm", r.startOffsetMm, 0.0, 500.0);
  check.AboveUpTo("donor.kerfMm", r.kerfMm, 0.0, 5.0);
  check.Closed("donor.betweenMm", r.betweenMm, 0.0, 100.0);
  if (r.vessel.size() == 1)
    check.Refuse("the number of donor.vessel's places", 1.0, "none, or two at least");
  check.Closed("the number of donor.vessel's places", double(r.vessel.size()), 0.0, 10000.0);
  CheckPoints("donor.vessel", r.vessel);
  if (!r.paddle)
    return;
  check.Closed(
    "the number of donor.paddle.outline's places", double(r.paddle->outline.size()), 3.0, 10000.0);
  CheckPoints("donor.paddle.outline", r.paddle->outline);
  check.Point("donor.paddle.perforator", r.paddle->perforator);
}

/// The face of the stump that a cut leaves, where the leg from `inner` to `outer` passes it; its
/// normal looks along that leg.
TransplantJoint StumpFace(
  const BoneCut& cut, const std::string& name, const glm::dvec3& inner, const glm::dvec3& outer)
{
  const glm::dvec3 leg = glm::normalize(outer - inner);
  glm::dvec3 normal = glm::normalize(cut.blade.normal);
  if (glm::dot(normal, leg) < 0.0)
    normal = -normal;
  const double cosine = glm::dot(normal, leg);
  if (const double tilt = glm::degrees(std::acos(std::min(cosine, 1.0))); tilt > MostTiltDegrees)
    check.Refuse(name + ": its angle with the path", tilt, "at most 60 degrees");
  const glm::dvec3 face = cut.blade.point + 0.5 * cut.blade.kerfMm * normal;
  return { outer + glm::dot(face - outer, normal) / cosine * leg, normal };
}

/// Upright on the segment, and turned about it.
glm::dvec3 Rolled(const glm::dvec3& outward, const glm::dvec3& way, double degrees)
{
  return degrees == 0.0 ? outward
                        : glm::angleAxis(glm::radians(degrees), glm::normalize(way)) * outward;
}
} // namespace

/// What a guide asks besides is GuideRecipe's to say, when one is made.
void ValidateMitreGuideChoices(
  const MitreGuideChoices& g, const std::string& subject, const std::string& where)
{
  const ValueChecks asked(subject);
  asked.Closed(where + "gapMm", g.gapMm, 0.0, 10.0);
  asked.AboveUpTo(where + "thicknessMm", g.thicknessMm, 0.0, 50.0);
  asked.AboveUpTo(where + "widthMm", g.widthMm, 0.0, 200.0);
  asked.Closed(where + "clearanceMm", g.clearanceMm, 0.0, 2.0);
  asked.AboveUpTo(where + "wallMm", g.wallMm, 0.0, 20.0);
  asked.AboveUpTo(where + "slotLengthMm", g.slotLengthMm, 0.0, 500.0);
  asked.AboveUpTo(where + "guidingHeightMm", g.guidingHeightMm, 0.0, 100.0);
  asked.Closed(where + "beyondMm", g.beyondMm, 5.0, 100.0);
  asked.Closed(where + "pinDiameterMm", g.pinDiameterMm, 0.0, 20.0);
  asked.Closed(where + "spacingMm", g.spacingMm, 0.05, 2.0);
}

void ValidateTransplantRecipe(const TransplantRecipe& recipe)
{
  CheckDefect(recipe);
  CheckDonor(recipe);
  ValidateMitreGuideChoices(recipe.guide, "transplant recipe", "guide.");
}

Transplant JointsOf(const TransplantRecipe& recipe)
{
  ValidateTransplantRecipe(recipe);
  const std::vector<BoneCut>& cuts = recipe.resection.cuts;
  std::vector<glm::dvec3> line = recipe.path;
  const std::size_t last = line.size() - 1;
  TransplantJoint first = StumpFace(cuts[0], "resection.cuts[0]", line[1], line[0]);
  const TransplantJoint end =
    StumpFace(cuts.back(), ListKey("resection.cuts", cuts.size() - 1), line[last - 1], line[last]);
  first.normal = -first.normal;
  const std::vector<glm::dvec3> given = line;
  line[0] = first.point;
  line[last] = end.point;
  for (std::size_t n = 0; n < last; ++n)
  {
    // Against the leg as it was given: a stump's face may lie behind the place that it leads to.
    const double length = glm::dot(line[n + 1] - line[n], glm::normalize(given[n + 1] - given[n]));
    if (!(length >= recipe.leastSegmentMm))
    {
      std::ostringstream must;
      must << "at least leastSegmentMm (" << recipe.leastSegmentMm
           << " mm); move the path's places or the cuts apart";
      check.Refuse(ListKey("segments", n) + "'s length", length, must.str());
    }
  }
  Transplant transplant;
  transplant.joints = MitreJoints(line);
  transplant.joints[0] = first;
  transplant.joints[last] = end;
  for (std::size_t n = 0; n < last; ++n)
    transplant.outward.push_back(Rolled(
      recipe.outward[recipe.outward.size() == 1 ? 0 : n], line[n + 1] - line[n], recipe.rollDeg));
  transplant.donor = recipe.donor;
  transplant.fromLastTip = recipe.fromLastTip;
  transplant.startOffsetMm = recipe.startOffsetMm;
  transplant.kerfMm = recipe.kerfMm;
  transplant.betweenMm = recipe.betweenMm;
  transplant.vessel = recipe.vessel;
  transplant.paddle = recipe.paddle;
  return transplant;
}

std::vector<Osteotomy> DonorCuts(
  const Transplant& transplant, const std::vector<DonorSegment>& segments)
{
  const double sizeMm = 4.0 * transplant.donor.radiusMm;
  std::vector<Osteotomy> cuts;
  for (const DonorSegment& segment : segments)
    for (const auto& [plane, out] :
      { std::pair(&segment.start, -1.0), std::pair(&segment.end, 1.0) })
    {
      const glm::dvec3 normal = glm::normalize(plane->normal);
      const glm::dvec3 along = glm::normalize(glm::cross(normal, transplant.donor.lateral));
      cuts.push_back({ plane->point + 0.5 * out * transplant.kerfMm * normal, normal, along, sizeMm,
        sizeMm, transplant.kerfMm });
    }
  return cuts;
}

} // namespace hasp
