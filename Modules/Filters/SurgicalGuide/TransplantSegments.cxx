#include "TransplantSegments.h"

#include "BoneSolid.h"
#include "FragmentPieces.h"

#include "Distance/Csg.h"
#include "Distance/GridSolid.h"
#include "Distance/SharpContour.h"
#include "Distance/SolidShapes.h"
#include "Grid/ProgressPart.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr const char* Who = "transplant";
constexpr double FarthestRadii = 3.0;

void CheckSettings(const SegmentSettings& settings)
{
  std::ostringstream fault;
  fault << Who << ": ";
  if (!(settings.spacingMm >= 0.1 && settings.spacingMm <= 2.0))
    fault << "spacingMm is " << settings.spacingMm << ", must be in [0.1, 2]";
  else if (!(std::abs(settings.isovalue) <= 1e6))
    fault << "isovalue is " << settings.isovalue << ", must be in [-1e6, 1e6]";
  else
    return;
  throw std::invalid_argument(fault.str());
}

/// The middle of a polyline, by the way along it.
glm::dvec3 MiddleOf(std::span<const glm::dvec3> line)
{
  double length = 0.0;
  for (std::size_t n = 1; n < line.size(); ++n)
    length += glm::distance(line[n], line[n - 1]);
  double left = 0.5 * length;
  for (std::size_t n = 1; n < line.size(); ++n)
  {
    const double piece = glm::distance(line[n], line[n - 1]);
    if (left <= piece)
      return glm::mix(line[n - 1], line[n], left / piece);
    left -= piece;
  }
  return line.back();
}

/// A grid in the world's axes around a segment in the defect, and all that its planes may cut.
GridGeometry GridAround(
  const DonorSegment& cut, const PlanPose& pose, double reachMm, double spacingMm)
{
  const glm::dvec3 a = pose.Place(cut.start.point), b = pose.Place(cut.end.point);
  const double tilt = std::max(cut.startTiltRadians, cut.endTiltRadians);
  const glm::dvec3 margin(reachMm * (1.0 + std::tan(tilt)));
  const glm::dvec3 low = glm::min(a, b) - margin, high = glm::max(a, b) + margin;
  GridGeometry grid;
  grid.spacing = glm::dvec3(spacingMm);
  grid.origin = low;
  grid.dims = glm::ivec3(glm::ceil((high - low) / spacingMm)) + 1;
  return grid;
}
} // namespace

struct TransplantSegments::Internals
{
  BoneDistance donor;
  double radiusMm = 0.0, spacingMm = 0.0;
  std::vector<PlacedSegment> placed;
  std::size_t lastCut = 0;

  /// The donor where a pose puts it: its samples move with their grid.
  SolidPointer DonorAt(const PlanPose& pose) const
  {
    GridGeometry moved = this->donor.grid;
    moved.origin = pose.Place(moved.origin);
    moved.direction = glm::mat3_cast(pose.orientation) * moved.direction;
    return MakeGridSolid(this->donor.distance, moved);
  }

  PlacedSegment Cut(const DonorSegment& cut, std::size_t number) const
  {
    const PlanPose& pose = cut.donorToDefect;
    const glm::dvec3 back = pose.orientation * -cut.start.normal,
                     ahead = pose.orientation * cut.end.normal;
    const SolidPointer solid = MakeIntersection({ this->DonorAt(pose),
      MakePlane(pose.Place(cut.start.point), back), MakePlane(pose.Place(cut.end.point), ahead) });
    const double reach = FarthestRadii * this->radiusMm;
    PlacedSegment segment{ cut, SharpContour(*solid, GridAround(cut, pose, reach, this->spacingMm)),
      0.0 };
    segment.volumeMm3 = VolumeOf(segment.mesh);
    const auto fail = [&](const std::string& text)
    { throw std::runtime_error("transplant: segments[" + std::to_string(number) + "] " + text); };
    const std::size_t pieces = FragmentsOf(segment.mesh, 0.0).size();
    if (pieces == 0)
      fail("has no bone; does donor.axis lie in it?");
    if (pieces > 1)
      fail("is in " + std::to_string(pieces) + " pieces; move it along the donor, or shorten it");
    const glm::dvec3 from = pose.Place(cut.start.point),
                     axis = glm::normalize(pose.Place(cut.end.point) - from);
    for (const glm::dvec3& p : segment.mesh.points)
      if (glm::length(glm::cross(p - from, axis)) > reach - 2.0 * this->spacingMm)
        fail("has bone more than three times donor.radiusMm from its axis; give the bone's radius");
    return segment;
  }
};

TransplantSegments::TransplantSegments(const BoneImage& image, const DonorBone& donor,
  const SegmentSettings& settings, const ProgressFunction& progress)
  : Inside(std::make_unique<Internals>())
{
  CheckSettings(settings);
  if (donor.axis.size() < 2)
    throw std::invalid_argument("transplant: donor.axis has " + std::to_string(donor.axis.size()) +
                                " places, must be at least 2");
  const std::vector<std::uint8_t> keep = IslandNear(Who, image, settings.isovalue,
    settings.ignoreBelowMm3, MiddleOf(donor.axis), donor.radiusMm, PartOf(progress, 0.0, 0.2));
  if (keep.empty())
    throw std::invalid_argument(
      "transplant: there is no bone within donor.radiusMm of the middle of "
      "donor.axis: is it in this volume's world, and the isovalue right?");
  this->Inside->donor = DistanceOfBone(
    Who, image.grey, settings.isovalue, keep, settings.spacingMm, PartOf(progress, 0.2, 1.0));
  this->Inside->radiusMm = donor.radiusMm;
  this->Inside->spacingMm = settings.spacingMm;
}

TransplantSegments::~TransplantSegments() = default;

const std::vector<PlacedSegment>& TransplantSegments::Place(const Transplant& transplant)
{
  const std::vector<DonorSegment> cuts = LayOutSegments(transplant);
  std::vector<PlacedSegment> placed;
  std::size_t made = 0;
  for (std::size_t n = 0; n < cuts.size(); ++n)
  {
    const std::vector<PlacedSegment>& before = this->Inside->placed;
    if (n < before.size() && before[n].cut == cuts[n])
      placed.push_back(before[n]);
    else
    {
      placed.push_back(this->Inside->Cut(cuts[n], n));
      ++made;
    }
  }
  this->Inside->placed = std::move(placed);
  this->Inside->lastCut = made;
  return this->Inside->placed;
}

std::size_t TransplantSegments::LastCut() const
{
  return this->Inside->lastCut;
}

} // namespace hasp
