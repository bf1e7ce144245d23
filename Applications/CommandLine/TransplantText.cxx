#include "TransplantText.h"

#include "VerbWork.h"

#include <glm/trigonometric.hpp>

#include <iostream>

namespace hasp
{

namespace
{
using Json = nlohmann::ordered_json;

Json Place(const glm::dvec3& p)
{
  return { p.x, p.y, p.z };
}

Json Places(const std::vector<glm::dvec3>& places)
{
  Json json = Json::array();
  for (const glm::dvec3& place : places)
    json.push_back(Place(place));
  return json;
}
} // namespace

std::string SegmentFile(std::size_t segment)
{
  return "segment-" + std::to_string(segment + 1) + ".stl";
}

std::string DonorSegmentFile(std::size_t segment)
{
  return "donor-" + SegmentFile(segment);
}

std::string StumpFile(const BoneFragment& fragment)
{
  return "fragment-" + std::to_string(fragment.number) + ".stl";
}

bool IsStump(const BoneFragment& fragment)
{
  return !fragment.resected && !fragment.crumb;
}

Json DescribeSegment(const DonorSegment& cut, double volumeMm3, std::size_t triangles)
{
  const PlanPose& pose = cut.donorToDefect;
  const glm::dquat& turn = pose.orientation;
  return { { "length_mm", cut.lengthMm }, { "shortest_mm", cut.shortestMm },
    { "longest_mm", cut.longestMm }, { "wedge_deg", glm::degrees(cut.wedgeRadians) },
    { "start_tilt_deg", glm::degrees(cut.startTiltRadians) },
    { "end_tilt_deg", glm::degrees(cut.endTiltRadians) }, { "volume_mm3", volumeMm3 },
    { "donor_from_mm", cut.fromMm }, { "donor_to_mm", cut.toMm },
    { "position_mm", Place(pose.position) }, { "orientation", { turn.w, turn.x, turn.y, turn.z } },
    { "triangles", triangles } };
}

Json DescribeJoint(const MadeJoint& joint)
{
  return { { "point_mm", Place(joint.joint.point) }, { "normal", Place(joint.joint.normal) },
    { "bend_deg", glm::degrees(joint.bendRadians) },
    { "wedge_deg", glm::degrees(joint.wedgeRadians) }, { "gap_mm", joint.gapMm },
    { "overlap_mm", joint.overlapMm }, { "contact_mm2", joint.fit.contactMm2 },
    { "gap_mm2", joint.fit.gapMm2 }, { "overlap_mm2", joint.fit.overlapMm2 },
    { "step_mm2", joint.fit.stepMm2 } };
}

Json DescribeTransplant(const MadeTransplant& made)
{
  Json json{ { "segments", Json::array() }, { "joints", Json::array() },
    { "donor_cuts", Json::array() }, { "fragments", Json::array() }, { "vessel", Json::array() } };
  for (std::size_t n = 0; n < made.segments.size(); ++n)
  {
    const PlacedSegment& segment = made.segments[n];
    Json described{ { "file", SegmentFile(n) }, { "donor_file", DonorSegmentFile(n) } };
    described.update(
      DescribeSegment(segment.cut, segment.volumeMm3, segment.mesh.triangles.size()));
    json["segments"].push_back(std::move(described));
  }
  for (const MadeJoint& joint : made.joints)
    json["joints"].push_back(DescribeJoint(joint));
  for (const Osteotomy& cut : made.donorCuts)
    json["donor_cuts"].push_back({ { "point_mm", Place(cut.point) },
      { "normal", Place(cut.normal) }, { "along", Place(cut.along) }, { "kerf_mm", cut.kerfMm } });
  for (const BoneFragment& fragment : made.recipient.fragments)
    if (IsStump(fragment))
      json["fragments"].push_back({ { "file", StumpFile(fragment) },
        { "volume_mm3", fragment.volumeMm3 }, { "triangles", fragment.mesh.triangles.size() } });
  for (const PlacedVessel& part : made.vessel)
    json["vessel"].push_back({ { "segment", part.segment }, { "line_mm", Places(part.line) } });
  if (made.paddle)
    json["paddle"] = { { "segment", made.paddle->segment },
      { "outline_mm", Places(made.paddle->paddle.outline) },
      { "perforator_mm", Place(made.paddle->paddle.perforator) } };
  json["warnings"] = made.warnings;
  return json;
}

void PrintTransplant(const MadeTransplant& made)
{
  std::cout << "             length  (shortest, longest)   wedge        volume   on the donor\n";
  for (std::size_t n = 0; n < made.segments.size(); ++n)
  {
    const DonorSegment& cut = made.segments[n].cut;
    std::cout << Line(
      "segments[%zu]  %6.2f  (%6.2f, %6.2f) mm  %6.2f deg  %7.1f mm3  %.2f to %.2f mm\n", n,
      cut.lengthMm, cut.shortestMm, cut.longestMm, glm::degrees(cut.wedgeRadians),
      made.segments[n].volumeMm3, cut.fromMm, cut.toMm);
  }
  std::cout << "             bend        wedge       gap      overlap  contact     step\n";
  for (std::size_t n = 0; n < made.joints.size(); ++n)
  {
    const MadeJoint& joint = made.joints[n];
    std::cout << Line(
      "joints[%zu]    %6.2f deg  %6.2f deg  %5.2f mm  %5.2f mm  %5.0f mm2  %5.0f mm2\n", n,
      glm::degrees(joint.bendRadians), glm::degrees(joint.wedgeRadians), joint.gapMm,
      joint.overlapMm, joint.fit.contactMm2, joint.fit.stepMm2);
  }
}

} // namespace hasp
