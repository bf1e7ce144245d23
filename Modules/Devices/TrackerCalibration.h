#pragma once
#include "Devices/HeadPose.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hasp
{

/// From what a tracker says to where the head is: how the tracker stands in the room, and how what
/// it tracks (a marker, a face) sits on the head. A plain value; the default changes nothing.
struct TrackerCalibration
{
  glm::dquat trackerToRoom{ 1, 0, 0, 0 }; ///< unit
  glm::dvec3 trackerInRoomMm{ 0.0 };      ///< the tracker's origin
  glm::dvec3 eyesInMarkerMm{ 0.0 };       ///< between the eyes, along the marker's axes
  glm::dquat headToMarker{ 1, 0, 0, 0 };  ///< unit
};

/// Throws std::invalid_argument unless quaternions are unit within 1e-3, the tracker stands within
/// 10 m and the eyes are within 1 m of the marker.
void ValidateTrackerCalibration(const TrackerCalibration& calibration);

/// The head in the room for a marker's pose as its tracker says. Any thread; never throws.
HeadPose ToRoom(const TrackerCalibration& calibration, const HeadPose& marker) noexcept;

/// One place, said twice: by the tracker and by who measured the room.
struct CalibrationPair
{
  glm::dvec3 trackerMm{ 0.0 };
  glm::dvec3 roomMm{ 0.0 };
};

/// Pairs as text: a line that names the columns, then a line a pair, as HeadPath.h's:
///
///   trackerXMm,trackerYMm,trackerZMm,roomXMm,roomYMm,roomZMm
///   12.5,-80,1020,-260,160,0
///
/// Errors are std::runtime_error (file) or std::invalid_argument (content, at most 10,000 pairs and
/// 4 MiB); they say the line, never the file's name or text. Any thread.
std::vector<CalibrationPair> ParseCalibrationPairs(std::string_view text);
std::vector<CalibrationPair> ReadCalibrationPairs(const std::string& file);

struct CalibrationFit
{
  TrackerCalibration calibration;  ///< what was not fitted is as before
  std::vector<double> residualsMm; ///< of each pair: how far the fit leaves the two apart
  double rmsMm = 0.0;              ///< root mean square of these
  double spreadRatio = 1.0; ///< how wide the points lie in the room / for the tracker: 1, but for
                            ///< noise; 1000 says metres, 25.4 inches
};

/// Where the tracker stands, from points both know (hold the marker to the screen's corners): the
/// rotation and translation with the least sum of squared residuals (Kabsch 1976, Umeyama 1991
/// without scale), by Eigen's SVD.
///
/// With N points of independent noise s along each axis, the mean of rms^2 is 3 s^2 (1 - 2 / N)
/// (Fitzpatrick, West & Maurer 1998): a small residual of few points says little. Three points fit
/// always well; take four or more.
/// Throws std::invalid_argument, with figures and what to do, for fewer than three pairs or more
/// than 10,000; numbers not finite or beyond 1e6 mm; points that lie on a line or almost (their
/// width less than 1/50 of their length, in either); and points of which one side is the other's
/// mirror image (a left-handed tracker, an axis turned round). Throws std::runtime_error if this
/// build has no Eigen. Any thread; O(N).
CalibrationFit FitTrackerToRoom(std::span<const CalibrationPair> pairs);

/// A marker's pose as the tracker says and the head's in the room at the same moment (the user
/// sits where it was measured and looks straight at the screen).
struct MarkerSighting
{
  HeadPose marker;
  HeadPose head;
};

/// Sightings as text, as the pairs above: what the tracker says of the marker (its orientation
/// takes the marker's axes to the tracker's) and where the middle between the eyes is in the room.
/// The head's orientation is the identity: the user looks straight at the screen's plane.
///
///   trackerXMm,trackerYMm,trackerZMm,qw,qx,qy,qz,roomXMm,roomYMm,roomZMm
///   12.5,-80,1020,1,0,0,0,0,40,610
///
/// Errors as there; poses that ValidateHeadPose refuses are some, too, and eyes less than 50 mm in
/// front of the screen, as metres are. Any thread.
std::vector<MarkerSighting> ParseMarkerSightings(std::string_view text);
std::vector<MarkerSighting> ReadMarkerSightings(const std::string& file);

/// How the marker sits on the head, for a tracker whose place is known from FitTrackerToRoom: the
/// mean over all sightings. Residuals are those of the point between the eyes.
/// Throws std::invalid_argument if there is no sighting, a pose is not valid, or the fitted eyes
/// are more than 1 m from the marker. Any thread; O(N).
CalibrationFit FitMarkerToHead(
  const TrackerCalibration& tracker, std::span<const MarkerSighting> sightings);

/// Calibrations as JSON, readable by people:
///
///   { "format": "hasp-tracker-calibration-1", "trackerToRoom": [w,x,y,z],
///     "trackerInRoomMm": [x,y,z], "eyesInMarkerMm": [x,y,z], "headToMarker": [w,x,y,z] }
///
/// Strict: every key must be there, and no other; ValidateTrackerCalibration holds. Errors are
/// std::runtime_error (file, syntax, a build without HASP_ENABLE_JSON) or std::invalid_argument
/// (content) and hold neither the file's name nor its text. At most 64 KiB. Any thread.
TrackerCalibration ParseTrackerCalibration(const std::string& json);
std::string FormatTrackerCalibration(const TrackerCalibration& calibration);
TrackerCalibration ReadTrackerCalibration(const std::string& file);
/// The old file or the new one, never half.
void WriteTrackerCalibration(const std::string& file, const TrackerCalibration& calibration);

} // namespace hasp
