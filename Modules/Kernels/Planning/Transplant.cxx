#include "Planning/Transplant.h"

#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr const char* Subject = "transplant";
constexpr double MostTiltDegrees = 60.0;
constexpr double LeastSegmentMm = 1.0;
constexpr double LeastSine = 0.1; ///< of a direction that turns a body about an axis

/// How far a plane through the axis lies ahead of a square cut, mm along the axis for a mm across
/// it; (p . slope) at the place p from the axis.
glm::dvec3 SlopeOf(const glm::dvec3& normal, const glm::dvec3& axis)
{
  const double along = glm::dot(normal, axis);
  return -(normal - along * axis) / along;
}

/// Columns: a side, upright on the axis, their cross product, the axis. NaN if they are parallel.
glm::dmat3 FrameOf(const glm::dvec3& axis, const glm::dvec3& side)
{
  const glm::dvec3 x = glm::normalize(side - glm::dot(side, axis) * axis);
  return { x, glm::cross(axis, x), axis };
}

/// A polyline by the way along it.
class AxisLine
{
public:
  explicit AxisLine(std::span<const glm::dvec3> places) : Places(places.begin(), places.end())
  {
    this->Way.push_back(0.0);
    for (std::size_t n = 1; n < this->Places.size(); ++n)
      this->Way.push_back(this->Way.back() + glm::distance(this->Places[n], this->Places[n - 1]));
  }
  double Length() const { return this->Way.back(); }

  /// Beyond its ends the line goes on straight.
  glm::dvec3 At(double way) const
  {
    std::size_t n = 1;
    while (n + 1 < this->Way.size() && way > this->Way[n])
      ++n;
    const double share = (way - this->Way[n - 1]) / (this->Way[n] - this->Way[n - 1]);
    return this->Places[n - 1] + share * (this->Places[n] - this->Places[n - 1]);
  }

  /// The first place beyond `way` that is `lengthMm` from the one there, straight; beyond the
  /// line's end on its last piece, continued.
  double ChordEnd(double way, double lengthMm) const
  {
    const glm::dvec3 from = this->At(way);
    for (std::size_t n = 1;; ++n)
    {
      const bool last = n + 1 == this->Places.size();
      if (this->Way[n] <= way && !last)
        continue;
      const glm::dvec3 start = this->Places[n - 1], piece = this->Places[n] - start;
      if (!last && glm::distance(this->Places[n], from) < lengthMm)
        continue;
      // |start + t piece - from| = lengthMm; of the two, the one ahead.
      const double a = glm::dot(piece, piece), b = glm::dot(piece, start - from),
                   c = glm::dot(start - from, start - from) - lengthMm * lengthMm;
      const double t = (-b + std::sqrt(std::max(b * b - a * c, 0.0))) / a;
      return this->Way[n - 1] + t * (this->Way[n] - this->Way[n - 1]);
    }
  }

private:
  std::vector<glm::dvec3> Places;
  std::vector<double> Way;
};

void CheckDonor(const ValueChecks& checks, const DonorBone& donor)
{
  checks.Closed("donor.axis: the number of places", double(donor.axis.size()), 2.0, 10000.0);
  for (std::size_t n = 0; n < donor.axis.size(); ++n)
  {
    checks.Point(ListKey("donor.axis", n), donor.axis[n]);
    if (n > 0)
      if (const double apart = glm::distance(donor.axis[n], donor.axis[n - 1]); apart < 0.01)
        checks.Refuse(
          "the distance of donor.axis[" + std::to_string(n) + "] from the place before it", apart,
          "at least 0.01 mm");
  }
  checks.Unit("donor.lateral", donor.lateral);
  checks.AboveUpTo("donor.radiusMm", donor.radiusMm, 0.0, 50.0);
  checks.Closed("donor.keepMm", donor.keepMm, 0.0, 500.0);
}

void Check(const Transplant& t)
{
  const ValueChecks checks(Subject);
  checks.Closed("the number of joints", double(t.joints.size()), 2.0, 9.0);
  const std::size_t segments = t.joints.size() - 1;
  if (t.outward.size() != segments)
    checks.Refuse("the number of outward", double(t.outward.size()),
      "one less than joints: " + std::to_string(segments));
  for (std::size_t n = 0; n < t.joints.size(); ++n)
  {
    checks.Point(ListKey("joints", n, "point"), t.joints[n].point);
    checks.Unit(ListKey("joints", n, "normal"), t.joints[n].normal);
  }
  for (std::size_t n = 0; n < segments; ++n)
  {
    checks.Unit(ListKey("outward", n), t.outward[n]);
    const glm::dvec3 way = t.joints[n + 1].point - t.joints[n].point;
    const double length = glm::length(way);
    if (!(length >= LeastSegmentMm))
      checks.Refuse(ListKey("segments", n) + "'s length", length, "at least 1 mm");
    if (const double sine = glm::length(glm::cross(t.outward[n], way)) / length; sine < LeastSine)
      checks.Refuse(ListKey("outward", n) + ": its sine with the segment", sine,
        "at least 0.1: it says which side looks outward");
    for (const std::size_t joint : { n, n + 1 })
    {
      const double cosine = glm::dot(t.joints[joint].normal, way) / length;
      const double tilt = glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
      if (tilt > MostTiltDegrees)
        checks.Refuse(ListKey("joints", joint, "normal") + ": its angle with segments[" +
                        std::to_string(n) + "]",
          tilt, "at most 60 degrees; it points towards the next segment");
    }
  }
  CheckDonor(checks, t.donor);
  checks.Closed("startOffsetMm", t.startOffsetMm, 0.0, 500.0);
  checks.AboveUpTo("kerfMm", t.kerfMm, 0.0, 5.0);
  checks.Closed("betweenMm", t.betweenMm, 0.0, 100.0);
  if (t.vessel.size() == 1)
    checks.Refuse("the number of vessel's places", 1.0, "none, or two at least");
  for (std::size_t n = 0; n < t.vessel.size(); ++n)
    checks.Point(ListKey("vessel", n), t.vessel[n]);
}

/// A segment's planes, seen from its own axis.
struct Slopes
{
  glm::dvec3 start, end; ///< of the plane's places along the axis; in the frame's x and y
};

Slopes SlopesOf(const Transplant& t, std::size_t n)
{
  const glm::dvec3 axis = glm::normalize(t.joints[n + 1].point - t.joints[n].point);
  const glm::dmat3 toFrame = glm::transpose(FrameOf(axis, t.outward[n]));
  return { toFrame * SlopeOf(t.joints[n].normal, axis),
    toFrame * SlopeOf(t.joints[n + 1].normal, axis) };
}

/// What a kerf beyond a tilted plane takes along the axis.
double KerfAlong(double kerfMm, const glm::dvec3& slope)
{
  return kerfMm * std::sqrt(1.0 + glm::dot(slope, slope));
}

DonorSegment MakeSegment(const Transplant& t, std::size_t n, const AxisLine& axis, double fromMm)
{
  DonorSegment segment;
  const TransplantJoint &first = t.joints[n], &last = t.joints[n + 1];
  const glm::dvec3 way = last.point - first.point;
  segment.lengthMm = glm::length(way);
  segment.fromMm = fromMm;
  segment.toMm = axis.ChordEnd(fromMm, segment.lengthMm);
  const glm::dvec3 from = axis.At(segment.fromMm), to = axis.At(segment.toMm);
  const glm::dmat3 donor = FrameOf(glm::normalize(to - from), t.donor.lateral);
  const glm::dmat3 defect = FrameOf(way / segment.lengthMm, t.outward[n]);
  segment.donorToDefect.orientation =
    glm::normalize(glm::quat_cast(defect * glm::transpose(donor)));
  segment.donorToDefect.position = first.point - segment.donorToDefect.orientation * from;
  const glm::dquat back = glm::conjugate(segment.donorToDefect.orientation);
  segment.start = { from, back * glm::normalize(first.normal) };
  segment.end = { to, back * glm::normalize(last.normal) };
  segment.wedgeRadians = AngleOf(first.normal, last.normal);
  segment.startTiltRadians = AngleOf(first.normal, way);
  segment.endTiltRadians = AngleOf(last.normal, way);
  const Slopes slopes = SlopesOf(t, n);
  const double bend = t.donor.radiusMm * glm::length(slopes.end - slopes.start);
  segment.shortestMm = segment.lengthMm - bend;
  segment.longestMm = segment.lengthMm + bend;
  return segment;
}

/// The same transplant from the other end: its first segment is the donor's first, too.
Transplant Turned(Transplant t)
{
  std::reverse(t.joints.begin(), t.joints.end());
  for (TransplantJoint& joint : t.joints)
    joint.normal = -joint.normal;
  std::reverse(t.outward.begin(), t.outward.end());
  return t;
}

std::vector<DonorSegment> LayOutInOrder(const Transplant& t)
{
  const AxisLine axis(t.donor.axis);
  const double radius = t.donor.radiusMm;
  std::vector<DonorSegment> segments;
  double at = t.donor.keepMm + t.startOffsetMm;
  glm::dvec3 before(0.0); // the slope of the plane before, none at the end that is kept
  for (std::size_t n = 0; n + 1 < t.joints.size(); ++n)
  {
    const Slopes slopes = SlopesOf(t, n);
    at += radius * glm::length(slopes.start - before) + KerfAlong(t.kerfMm, slopes.start);
    segments.push_back(MakeSegment(t, n, axis, at));
    if (!(segments.back().shortestMm > 0.0))
      ValueChecks(Subject).Refuse(ListKey("segments", n) + "'s shortest side",
        segments.back().shortestMm,
        "above 0 mm: its planes meet within the donor; make it longer, or its joints less tilted");
    at = segments.back().toMm + KerfAlong(t.kerfMm, slopes.end) + t.betweenMm;
    before = slopes.end;
  }
  // Between the last cut and the end that is kept nothing needs to be left over.
  const double end = at - t.betweenMm + radius * glm::length(before) + t.donor.keepMm;
  if (end > axis.Length())
  {
    std::ostringstream text;
    text << Subject << ": the donor is " << end - axis.Length() << " mm too short: its "
         << segments.size() << " segments, " << t.startOffsetMm << " mm before them and "
         << t.donor.keepMm << " mm that stay at each tip need " << end << " mm, its axis has "
         << axis.Length() << " mm";
    throw std::runtime_error(text.str());
  }
  return segments;
}
} // namespace

double AngleOf(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::vector<TransplantJoint> MitreJoints(std::span<const glm::dvec3> line)
{
  const ValueChecks checks(Subject);
  if (line.size() < 2)
    checks.Refuse("the number of places of the line", double(line.size()), "at least 2");
  std::vector<glm::dvec3> ways;
  for (std::size_t n = 0; n + 1 < line.size(); ++n)
  {
    const double apart = glm::distance(line[n], line[n + 1]);
    if (!(apart >= LeastSegmentMm))
      checks.Refuse(ListKey("segments", n) + "'s length", apart, "at least 1 mm");
    ways.push_back((line[n + 1] - line[n]) / apart);
  }
  std::vector<TransplantJoint> joints;
  for (std::size_t n = 0; n < line.size(); ++n)
  {
    const glm::dvec3 sum = ways[n == 0 ? 0 : n - 1] + ways[std::min(n, ways.size() - 1)];
    if (!(glm::length(sum) > 0.01))
      checks.Refuse(ListKey("joints", n), "must not lie where the line turns back");
    joints.push_back({ line[n], glm::normalize(sum) });
  }
  return joints;
}

void ValidateTransplant(const Transplant& transplant)
{
  Check(transplant);
  for (std::size_t n = 1; n < transplant.donor.axis.size(); ++n)
  {
    const glm::dvec3 piece =
      glm::normalize(transplant.donor.axis[n] - transplant.donor.axis[n - 1]);
    if (glm::length(glm::cross(piece, transplant.donor.lateral)) < LeastSine)
      ValueChecks(Subject).Refuse("donor.lateral", "must not lie along the donor's axis");
  }
  if (!transplant.paddle)
    return;
  const ValueChecks checks(Subject);
  checks.Point("paddle.perforator", transplant.paddle->perforator);
  for (std::size_t n = 0; n < transplant.paddle->outline.size(); ++n)
    checks.Point(ListKey("paddle.outline", n), transplant.paddle->outline[n]);
}

std::vector<DonorSegment> LayOutSegments(const Transplant& transplant)
{
  ValidateTransplant(transplant);
  if (!transplant.fromLastTip)
    return LayOutInOrder(transplant);
  // The last joint comes first on the donor; told in the order of the joints all the same, with
  // normals that point from start to end.
  std::vector<DonorSegment> segments = LayOutInOrder(Turned(transplant));
  std::reverse(segments.begin(), segments.end());
  for (DonorSegment& segment : segments)
  {
    std::swap(segment.start, segment.end);
    std::swap(segment.startTiltRadians, segment.endTiltRadians);
    std::swap(segment.fromMm, segment.toMm);
    segment.start.normal = -segment.start.normal;
    segment.end.normal = -segment.end.normal;
  }
  return segments;
}

glm::dvec3 PlaceOnAxis(const DonorBone& donor, double wayMm)
{
  return AxisLine(donor.axis).At(wayMm);
}

std::vector<PlacedVessel> PlaceVessel(
  std::span<const DonorSegment> segments, std::span<const glm::dvec3> vessel)
{
  std::vector<PlacedVessel> placed;
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    const DonorSegment& segment = segments[s];
    for (std::size_t n = 0; n + 1 < vessel.size(); ++n)
    {
      // What of the piece is ahead of the start's plane and behind the end's.
      double first = 0.0, last = 1.0;
      const auto clip = [&](const TransplantJoint& plane, double side)
      {
        const double a = side * glm::dot(vessel[n] - plane.point, plane.normal),
                     b = side * glm::dot(vessel[n + 1] - plane.point, plane.normal);
        if (a < 0.0 && b < 0.0)
          last = -1.0;
        else if (a < 0.0)
          first = std::max(first, a / (a - b));
        else if (b < 0.0)
          last = std::min(last, a / (a - b));
      };
      clip(segment.start, 1.0);
      clip(segment.end, -1.0);
      if (!(first < last))
        continue;
      const glm::dvec3 way = vessel[n + 1] - vessel[n];
      const glm::dvec3 from = segment.donorToDefect.Place(vessel[n] + first * way),
                       to = segment.donorToDefect.Place(vessel[n] + last * way);
      const bool goesOn = first == 0.0 && !placed.empty() && placed.back().segment == s &&
                          placed.back().line.back() == from;
      if (!goesOn)
        placed.push_back({ s, { from } });
      placed.back().line.push_back(to);
    }
  }
  return placed;
}

PlacedPaddle PlacePaddle(std::span<const DonorSegment> segments, const SkinPaddle& paddle)
{
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    const auto ahead = [&](const TransplantJoint& plane)
    { return glm::dot(paddle.perforator - plane.point, plane.normal); };
    if (ahead(segments[s].start) < 0.0 || ahead(segments[s].end) > 0.0)
      continue;
    PlacedPaddle placed{ s, paddle };
    placed.paddle.perforator = segments[s].donorToDefect.Place(paddle.perforator);
    for (glm::dvec3& place : placed.paddle.outline)
      place = segments[s].donorToDefect.Place(place);
    return placed;
  }
  throw std::invalid_argument(std::string(Subject) +
                              ": paddle.perforator lies along none of the segments: its skin would "
                              "have no vessel; move the segments, or take another perforator");
}

} // namespace hasp
