#pragma once
#include "Planning/PlanPose.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace hasp
{

/// Where two bones meet in the defect: a donor segment and the next one, or the jaw.
struct TransplantJoint
{
  glm::dvec3 point{ 0.0 };            ///< where the donor's axis passes the plane, mm
  glm::dvec3 normal{ 0.0, 0.0, 1.0 }; ///< unit; towards the next segment

  bool operator==(const TransplantJoint&) const noexcept = default;
};

/// A bone that segments are taken from, in the world of its own scan.
struct DonorBone
{
  std::vector<glm::dvec3> axis;        ///< its middle line from tip to tip, mm; two places or more
  glm::dvec3 lateral{ 1.0, 0.0, 0.0 }; ///< unit; the side that is known again in the defect
  double radiusMm = 9.0;               ///< of the bone around its axis, (0, 50]
  double keepMm = 75.0; ///< of it that stays at both tips, for ankle and knee, [0, 500]

  bool operator==(const DonorBone&) const noexcept = default;
};

/// Skin that comes with the bone.
struct SkinPaddle
{
  std::vector<glm::dvec3> outline; ///< on the donor, closed, mm
  glm::dvec3 perforator{ 0.0 };    ///< where its vessel reaches the bone: it goes with that segment

  bool operator==(const SkinPaddle&) const noexcept = default;
};

/// A defect of n segments between n + 1 joints, and the bone that fills it. World of the defect =
/// patient LPS of the head's scan, mm; that of the donor likewise of its own. A plain value.
struct Transplant
{
  std::vector<TransplantJoint> joints; ///< in order; 2 to 9. The first and last are the jaw's
  std::vector<glm::dvec3> outward;     ///< n unit directions: where `lateral` looks in the defect
  DonorBone donor;
  bool fromLastTip = false; ///< the first segment is the one nearest to the axis' last place, and
                            ///< the donor's axis runs against the joints' order
  double startOffsetMm =
    0.0;                  ///< bone left over before the first cut, besides what is kept, [0, 500]
  double kerfMm = 1.0;    ///< of the donor's saw, (0, 5]; taken from what is between the segments
  double betweenMm = 1.5; ///< bone between the saw cuts of two segments, at least, [0, 100]
  std::vector<glm::dvec3> vessel; ///< the pedicle along the donor, mm; none or two places or more
  std::optional<SkinPaddle> paddle;

  bool operator==(const Transplant&) const noexcept = default;
};

/// Throws std::invalid_argument unless every number is finite and in its range, directions are unit
/// within 1e-3, there is one outward less than joints, and each plane is within 60 degrees of a
/// square cut. The message names the key, its value and the legal range.
void ValidateTransplant(const Transplant& transplant);

/// A segment of the donor: what is between two planes on it, and where it goes.
struct DonorSegment
{
  TransplantJoint start, end; ///< on the donor, mm; normals from start to end
  PlanPose donorToDefect;
  double lengthMm = 0.0;   ///< along the axis
  double shortestMm = 0.0; ///< of its sides, radiusMm from the axis
  double longestMm = 0.0;
  double wedgeRadians = 0.0;                           ///< between its two planes
  double startTiltRadians = 0.0, endTiltRadians = 0.0; ///< of its planes from a square cut
  double fromMm = 0.0, toMm = 0.0; ///< along the donor's axis, from its first place

  bool operator==(const DonorSegment&) const noexcept = default;
};

/// Between two vectors of any length but 0, [0, pi]; exact near 0, too.
double AngleOf(const glm::dvec3& a, const glm::dvec3& b);

/// Joints for a line of places: square at its ends, and half way between two segments inside, so
/// that both are cut at the same angle (a mitre). Throws std::invalid_argument on fewer than two
/// places, and on neighbours closer than 1 mm.
std::vector<TransplantJoint> MitreJoints(std::span<const glm::dvec3> line);

/// Where on the donor its segments are cut: the joints' planes, moved back by the pose that puts
/// the donor's axis on the line between two joints and its lateral side outward. Segments stand one
/// after the other along the axis, as close as kerfs, betweenMm and tilted planes allow, keepMm
/// (and startOffsetMm, at the first) from the tips. Where the axis is bowed a segment's chord lies
/// on it at both ends.
///
/// Pure mathematics of planes and poses; when the plan moves, ask again.
/// Throws std::invalid_argument on numbers out of their range (key, value, range), on a plane more
/// than 60 degrees off a square cut, on a segment whose planes meet within the donor; and
/// std::runtime_error if the donor is too short (by how much). Segments are numbered from 0, as
/// "segments[1]". Any thread. O(segments x places of the axis).
std::vector<DonorSegment> LayOutSegments(const Transplant& transplant);

/// Where the donor's axis is `wayMm` from its first place; beyond its ends straight on. The axis
/// has two places at least. O(places).
glm::dvec3 PlaceOnAxis(const DonorBone& donor, double wayMm);

/// The parts of the vessel along each segment, in the defect: between the segment's planes. Empty
/// for segments that it does not run along.
struct PlacedVessel
{
  std::size_t segment = 0;
  std::vector<glm::dvec3> line; ///< mm
};
std::vector<PlacedVessel> PlaceVessel(
  std::span<const DonorSegment> segments, std::span<const glm::dvec3> vessel);

/// The paddle in the defect, carried by the segment that its perforator is on. Throws
/// std::invalid_argument if it is on none: then it cannot come with the bone.
struct PlacedPaddle
{
  std::size_t segment = 0;
  SkinPaddle paddle;
};
PlacedPaddle PlacePaddle(std::span<const DonorSegment> segments, const SkinPaddle& paddle);

} // namespace hasp
