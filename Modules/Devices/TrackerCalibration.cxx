#include "Devices/TrackerCalibration.h"

#include "Devices/RigidFit.h"
#include "Devices/TextFile.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr double MostEyesMm = 1000.0;
constexpr const char* What = "tracker calibration";

[[noreturn]] void Refuse(const std::string& why)
{
  throw std::invalid_argument(std::string(What) + ": " + why);
}
} // namespace

void ValidateTrackerCalibration(const TrackerCalibration& c)
{
  const auto check = [](const HeadPose& pose, const char* what)
  {
    try
    {
      ValidateHeadPose(pose);
    }
    catch (const std::invalid_argument& error)
    {
      Refuse(std::string(what) + ": " + error.what());
    }
  };
  check({ c.trackerInRoomMm, c.trackerToRoom }, "where the tracker stands");
  check({ c.eyesInMarkerMm, c.headToMarker }, "how the marker sits on the head");
  if (const double apart = glm::length(c.eyesInMarkerMm); apart > MostEyesMm)
    Refuse("the eyes are " + std::to_string(apart) + " mm from the marker, must be at most " +
           std::to_string(MostEyesMm));
}

HeadPose ToRoom(const TrackerCalibration& c, const HeadPose& marker) noexcept
{
  const glm::dquat trackerToRoom = glm::normalize(c.trackerToRoom),
                   markerToTracker = glm::normalize(marker.orientation);
  const glm::dvec3 eyesInTracker = marker.position + markerToTracker * c.eyesInMarkerMm;
  return { c.trackerInRoomMm + trackerToRoom * eyesInTracker,
    glm::normalize(trackerToRoom * markerToTracker * c.headToMarker) };
}

CalibrationFit FitTrackerToRoom(std::span<const CalibrationPair> pairs)
{
  std::vector<PointPair> points;
  for (const CalibrationPair& pair : pairs)
    points.push_back({ pair.trackerMm, pair.roomMm });
  RigidFit fit = FitRigid(points, { What, "for the tracker", "in the room", "the tracker" });
  return { { .trackerToRoom = fit.turn, .trackerInRoomMm = fit.shift }, std::move(fit.residualsMm),
    fit.rmsMm, fit.spreadRatio };
}

CalibrationFit FitMarkerToHead(
  const TrackerCalibration& tracker, std::span<const MarkerSighting> sightings)
{
  ValidateTrackerCalibration(tracker);
  if (sightings.empty())
    Refuse("there is no sighting of the marker; one is the least");
  const glm::dquat roomToTracker = glm::conjugate(glm::normalize(tracker.trackerToRoom));
  CalibrationFit fit{ tracker, {}, 0.0, 1.0 };
  glm::dvec3 eyes(0.0);
  glm::dquat turn(0, 0, 0, 0), first(1, 0, 0, 0);
  for (const MarkerSighting& s : sightings)
  {
    ValidateHeadPose(s.marker);
    ValidateHeadPose(s.head);
    const glm::dquat trackerToMarker = glm::conjugate(glm::normalize(s.marker.orientation));
    const glm::dvec3 inTracker = roomToTracker * (s.head.position - tracker.trackerInRoomMm);
    eyes += trackerToMarker * (inTracker - s.marker.position);
    const glm::dquat one = trackerToMarker * roomToTracker * glm::normalize(s.head.orientation);
    if (&s == &sightings.front())
      first = one;
    turn += glm::dot(first, one) < 0.0 ? -one : one; // q and -q are one turn
  }
  fit.calibration.eyesInMarkerMm = eyes / static_cast<double>(sightings.size());
  fit.calibration.headToMarker = glm::normalize(turn);
  ValidateTrackerCalibration(fit.calibration);
  double sum = 0.0;
  for (const MarkerSighting& s : sightings)
  {
    fit.residualsMm.push_back(
      glm::length(ToRoom(fit.calibration, s.marker).position - s.head.position));
    sum += fit.residualsMm.back() * fit.residualsMm.back();
  }
  fit.rmsMm = std::sqrt(sum / static_cast<double>(sightings.size()));
  return fit;
}

TrackerCalibration ReadTrackerCalibration(const std::string& file)
{
  return ParseTrackerCalibration(ReadTextFile(file, std::size_t(64) << 10, What));
}

void WriteTrackerCalibration(const std::string& file, const TrackerCalibration& calibration)
{
  WriteTextFile(file, FormatTrackerCalibration(calibration), What);
}

} // namespace hasp
