#pragma once
#include "Devices/HeadPose.h"
#include "Devices/TrackerCalibration.h"

#include <cstdint>
#include <memory>

namespace hasp
{

class HeadRecorder;

struct HeadTrackerSettings
{
  HeadPose rest{};            ///< what is drawn without a tracker
  double frameS = 1.0 / 60;   ///< time from frame to frame, in (0, 1]; only counts latency
  double horizonS = 2.0 / 60; ///< from the call of At until the picture is seen, in [0, 0.2]; what
                              ///< is drawn is the head's place then. 0: as it was
  double sourceDelayS = 0.0;  ///< how much older poses are than their times say, in [0, 1]
  bool predict = true;        ///< false: the newest pose as it is, neither fitted nor moved on
  double fitS = 0.07;         ///< poses of so long make the velocity, in [0.01, 0.5]
  double mostPredictedS = 0.15;       ///< no prediction goes further, in time …
  double mostPredictedMm = 80.0;      ///< … in length …
  double mostPredictedDegrees = 20.0; ///< … or in angle; all >= 0
  double staleAfterS = 0.5;           ///< an older pose is no pose, in [0.05, 10]
  double toRestS = 1.5; ///< then the head goes back to `rest` in this time, in [0.05, 10]
  double backS = 0.4;   ///< and so long does it take to follow again, in [0.05, 10]
};

enum class HeadTrackerState
{
  Waiting,  ///< no pose ever came: the rest pose
  Tracking, ///< follows
  Holding,  ///< nothing new for longer than a prediction reaches: stays where it is
  Easing,   ///< the newest pose is stale: on the way to the rest pose
  Resting,  ///< there
  Returning ///< poses come again: on the way to them
};

/// What to draw now, and how good it is.
struct TrackedHead
{
  HeadPose pose; ///< room; always one that ValidateHeadPose lets pass
  HeadTrackerState state = HeadTrackerState::Waiting;
  double latencyS = 0.0; ///< from the newest pose until the picture is seen: now + horizon - pose
  double latencyFrames = 0.0; ///< the same in frames
  double predictedS = 0.0;    ///< how much of that the prediction bridges
};

/// What became of the poses the source gave.
struct HeadTrackerCounts
{
  std::uint64_t followed = 0;
  std::uint64_t still = 0; ///< newer, but the same to the last bit: a head that keeps still, or
                           ///< a sender faster than its camera
  std::uint64_t outOfOrder = 0; ///< older than the one before
  std::uint64_t future = 0;     ///< of a time yet to come: taken as of now
  std::uint64_t stale = 0;      ///< older than staleAfterS as they came
  std::uint64_t clockJumps = 0; ///< time went back for good, of the source or of the asker
  std::uint64_t refused = 0;    ///< not a valid pose
};

/// From a source of poses to the head that is drawn: calibration, a robust fit over the last poses
/// (FitEvenMotion), prediction with constant velocity and angular velocity, and a view that never
/// jumps: whatever breaks the flow (poses that stop, come back, a clock that jumps) is faded over.
///
/// Fading: at a break, what was drawn last stays drawn, and its distance from what should be drawn
/// shrinks to nothing along a smooth step over toRestS or backS. Frames more than 0.1 s apart count
/// as 0.1 s, so that a pause ends without a jump, too.
/// Threads: RENDER, or whoever owns it; one at a time. No thread of its own.
/// Cost: the source's, 1 us a call at 60 Hz, 14 us where a 1 kHz tracker is asked at 1 kHz
/// (bin/BenchHeadTracker), 4 KiB; takes no memory after construction.
class HeadTracker
{
public:
  /// Throws std::invalid_argument if there is no source or a setting is out of its range.
  explicit HeadTracker(std::unique_ptr<HeadPoseSource> source,
    const HeadTrackerSettings& settings = {}, const TrackerCalibration& calibration = {});
  ~HeadTracker();

  /// Where the head will be at `nowS` + horizonS. Asks the source once: poses that came and went
  /// between two calls are not seen. The same nowS again gives the same pose again; so does
  /// nowS that is not finite.
  TrackedHead At(double nowS);

  /// Hands what the source gives to `recorder` from now on, before anything is made of it; it must
  /// outlive this. Null: no more.
  void RecordTo(HeadRecorder* recorder) noexcept;

  HeadPoseSource& Source() noexcept; ///< its mouse, its counts
  const HeadTrackerCounts& Counts() const noexcept;
  const HeadTrackerSettings& Settings() const noexcept;
  /// The source's and its own: clocks that disagree, poses out of order; each kind once.
  std::vector<std::string> TakeWarnings();

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp
