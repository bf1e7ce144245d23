#include "TransplantBuilder.h"

#include "BoneSolid.h"
#include "DonorAxis.h"
#include "Grid/ProgressPart.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
const TriangleMesh Nothing;

/// With the donor's axis found, where that is asked for.
TransplantRecipe WithAxis(
  const BoneImage& donor, TransplantRecipe recipe, const ProgressFunction& progress)
{
  if (!recipe.findAxis)
    return recipe;
  recipe.donor.axis = FindDonorAxis(donor, recipe.donorIsovalue, recipe.resection.ignoreBelowMm3,
    recipe.donor.axis.at(0), recipe.donor.axis.at(1), recipe.donor.radiusMm, progress);
  recipe.findAxis = false;
  return recipe;
}

/// The stump that a cut leaves: the largest piece with a face of it on the side away from the
/// defect that stays in the patient. `outward`: of the joint, away from the defect.
const TriangleMesh& StumpOf(
  const CutBone& jaw, const CutRecipe& recipe, std::size_t cut, const glm::dvec3& outward)
{
  const bool inFront = glm::dot(recipe.cuts[cut].blade.normal, outward) > 0.0;
  std::vector<int> numbers = inFront ? jaw.cuts[cut].front : jaw.cuts[cut].back;
  std::sort(numbers.begin(), numbers.end()); // the largest first
  for (const int number : numbers)
    if (const BoneFragment& f = jaw.fragments[std::size_t(number - 1)]; !f.resected && !f.crumb)
      return f.mesh;
  return Nothing;
}

/// In the order of the joints: the axes' angle, and that of the wedge between the donor's cuts.
void SayAngles(const std::vector<PlacedSegment>& segments, std::vector<MadeJoint>& joints)
{
  const auto wayOf = [&](std::size_t n)
  { return joints[n + 1].joint.point - joints[n].joint.point; };
  joints.front().wedgeRadians = segments.front().cut.startTiltRadians;
  joints.back().wedgeRadians = segments.back().cut.endTiltRadians;
  for (std::size_t n = 1; n + 1 < joints.size(); ++n)
  {
    joints[n].wedgeRadians = AngleOf(segments[n - 1].cut.end.normal, segments[n].cut.start.normal);
    joints[n].bendRadians = AngleOf(wayOf(n - 1), wayOf(n));
  }
}

void Warn(const TransplantRecipe& recipe, MadeTransplant& made)
{
  const auto say = [&](const auto&... words)
  {
    std::ostringstream text;
    (text << ... << words);
    made.warnings.push_back(text.str());
  };
  for (std::size_t n = 0; n < made.recipient.cuts.size(); ++n)
    if (!made.recipient.cuts[n].parted)
      say("resection.cuts[", n, "] does not part the bone: still one piece");
  if (std::none_of(made.recipient.fragments.begin(), made.recipient.fragments.end(),
        [](const BoneFragment& f) { return f.resected; }))
    say("resection.resected names no fragment: the bone in the defect is still there");
  for (std::string& warning : JointWarnings(made.joints, recipe.mostGapMm, recipe.mostOverlapMm))
    made.warnings.push_back(std::move(warning));
}

void CarrySoftTissue(const TransplantRecipe& recipe, MadeTransplant& made)
{
  std::vector<DonorSegment> cuts;
  for (const PlacedSegment& segment : made.segments)
    cuts.push_back(segment.cut);
  made.vessel = PlaceVessel(cuts, recipe.vessel);
  if (!recipe.vessel.empty())
    for (std::size_t n = 0; n < cuts.size(); ++n)
      if (std::none_of(made.vessel.begin(), made.vessel.end(),
            [&](const PlacedVessel& part) { return part.segment == n; }))
        made.warnings.push_back(
          "segments[" + std::to_string(n) + "] has none of donor.vessel along it");
  if (!recipe.paddle)
    return;
  try
  {
    made.paddle = PlacePaddle(cuts, *recipe.paddle);
  }
  catch (const std::invalid_argument& fault)
  {
    made.warnings.push_back(fault.what()); // the bone is made all the same
  }
}

/// Where a segment was before it was moved.
TriangleMesh MovedBack(const PlacedSegment& segment)
{
  TriangleMesh mesh = segment.mesh;
  for (glm::dvec3& p : mesh.points)
    p = segment.cut.donorToDefect.PlaceBack(p);
  return mesh;
}
} // namespace

std::vector<MadeJoint> JointsBetween(const Transplant& plan,
  const std::vector<PlacedSegment>& segments, const TriangleMesh& before, const TriangleMesh& after)
{
  const std::size_t last = plan.joints.size() - 1;
  const double reach = std::min(3.0 * plan.donor.radiusMm, 100.0);
  std::vector<MadeJoint> joints;
  for (std::size_t n = 0; n <= last; ++n)
  {
    MadeJoint joint;
    joint.joint = plan.joints[n];
    joint.fit = MeasureJoint(joint.joint, n > 0 ? segments[n - 1].mesh : before,
      n < last ? segments[n].mesh : after, reach);
    const double shared = joint.fit.contactMm2 + joint.fit.gapMm2 + joint.fit.overlapMm2;
    if (shared > 0.0)
    {
      joint.gapMm = joint.fit.gapMm3 / shared;
      joint.overlapMm = joint.fit.overlapMm3 / shared;
    }
    joints.push_back(joint);
  }
  SayAngles(segments, joints);
  return joints;
}

std::vector<std::string> JointWarnings(
  const std::vector<MadeJoint>& joints, double mostGapMm, double mostOverlapMm)
{
  std::vector<std::string> warnings;
  const auto say = [&](const auto&... words)
  {
    std::ostringstream text;
    (text << ... << words);
    warnings.push_back(text.str());
  };
  for (std::size_t n = 0; n < joints.size(); ++n)
  {
    const MadeJoint& joint = joints[n];
    if (joint.fit.contactMm2 + joint.fit.gapMm2 + joint.fit.overlapMm2 == 0.0)
      say("joints[", n, "]: its bones do not meet: their faces lie side by side");
    if (joint.gapMm > mostGapMm)
      say(
        "joints[", n, "]: a gap of ", joint.gapMm, " mm, at most ", mostGapMm, " mm are asked for");
    if (joint.overlapMm > mostOverlapMm)
      say("joints[", n, "]: an overlap of ", joint.overlapMm, " mm, at most ", mostOverlapMm,
        " mm are asked for");
  }
  return warnings;
}

MadeTransplant MakeTransplant(const BoneImage& recipient, const BoneImage& donor,
  const TransplantRecipe& given, const ProgressFunction& progress)
{
  // What needs no voxel is refused before any is looked at.
  const Transplant draft = JointsOf(given);
  if (!given.findAxis)
    LayOutSegments(draft);
  const TransplantRecipe recipe = WithAxis(donor, given, PartOf(progress, 0.0, 0.1));
  MadeTransplant made;
  made.plan = JointsOf(recipe);
  const std::vector<DonorSegment> cuts = LayOutSegments(made.plan);
  TransplantSegments bone(donor, recipe.donor,
    { recipe.donorIsovalue, recipe.resection.spacingMm, recipe.resection.ignoreBelowMm3 },
    PartOf(progress, 0.1, 0.3));
  made.segments = bone.Place(made.plan);
  ReportProgress(progress, 0.5);
  made.recipient = CutFragments(recipient, recipe.resection, PartOf(progress, 0.5, 0.9));
  for (const PlacedSegment& segment : made.segments)
    made.onDonor.push_back(MovedBack(segment));
  const std::vector<TransplantJoint>& joints = made.plan.joints;
  made.joints = JointsBetween(made.plan, made.segments,
    StumpOf(made.recipient, recipe.resection, 0, -joints.front().normal),
    StumpOf(
      made.recipient, recipe.resection, recipe.resection.cuts.size() - 1, joints.back().normal));
  made.donorCuts = DonorCuts(made.plan, cuts);
  Warn(recipe, made);
  CarrySoftTissue(recipe, made);
  ReportProgress(progress, 1.0);
  return made;
}

} // namespace hasp
