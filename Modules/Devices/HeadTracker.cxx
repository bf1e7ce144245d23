#include "Devices/HeadTracker.h"

#include "Devices/HeadPoseFade.h"
#include "Devices/HeadPoseHistory.h"
#include "Devices/HeadRecorder.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double SameTimeS = 1e-6;
constexpr double SamePoseS = 0.005;   ///< the same pose, its time or age rounded: given again
constexpr double GapS = 0.1;          ///< poses further apart break the flow
constexpr double StillAfterS = 0.12;  ///< the same pose so long: the head keeps still
constexpr double ClockWithinS = 0.05; ///< a pose may be stamped while the frame begins
constexpr double BackForGoodS = 0.25; ///< nothing but old poses so long: the clock went back
constexpr double MostStepS = 0.1;     ///< a longer frame moves a fade on by no more
// No head moves so fast; a tracker that finds it elsewhere does.
constexpr double JumpMm = 20.0, JumpMmPerS = 3000.0;
constexpr double JumpRad = 0.17, JumpRadPerS = 10.0;

void Check(const char* what, double value, double least, double most)
{
  if (!(value >= least && value <= most))
    throw std::invalid_argument(std::string("head tracker: ") + what + " is " +
                                std::to_string(value) + ", must be in [" + std::to_string(least) +
                                ", " + std::to_string(most) + "]");
}

HeadTrackerSettings Checked(HeadTrackerSettings s)
{
  ValidateHeadPose(s.rest);
  s.rest.orientation = glm::normalize(s.rest.orientation);
  Check("frameS", s.frameS, 1e-4, 1.0);
  Check("horizonS", s.horizonS, 0.0, 0.2);
  Check("sourceDelayS", s.sourceDelayS, 0.0, 1.0);
  Check("fitS", s.fitS, 0.01, 0.5);
  Check("mostPredictedS", s.mostPredictedS, 0.0, 1.0);
  Check("mostPredictedMm", s.mostPredictedMm, 0.0, 1000.0);
  Check("mostPredictedDegrees", s.mostPredictedDegrees, 0.0, 180.0);
  Check("staleAfterS", s.staleAfterS, 0.05, 10.0);
  Check("toRestS", s.toRestS, 0.05, 10.0);
  Check("backS", s.backS, 0.05, 10.0);
  return s;
}

double AngleBetween(const glm::dquat& a, const glm::dquat& b)
{
  return 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b))));
}

bool Jumps(const HeadPose& from, const HeadPose& to, double stepS)
{
  return glm::length(to.position - from.position) > JumpMm + JumpMmPerS * stepS ||
         AngleBetween(to.orientation, from.orientation) > JumpRad + JumpRadPerS * stepS;
}
} // namespace

struct HeadTracker::Internals
{
  Internals(std::unique_ptr<HeadPoseSource> from, const HeadTrackerSettings& set,
    const TrackerCalibration& with)
    : source(std::move(from)),
      settings(Checked(set)),
      calibration(with),
      history(settings.fitS)
  {
  }

  bool Take(const TimedHeadPose& given, double nowS);
  bool Follow(const TimedHeadPose& pose, double sinceHeardS);
  TrackedHead Want(double nowS) const;

  std::unique_ptr<HeadPoseSource> source;
  HeadTrackerSettings settings;
  TrackerCalibration calibration;
  HeadTrackerCounts counts;
  std::array<bool, 5> warned{};

  HeadPoseHistory history; ///< room
  HeadPose lastGiven;      ///< as the source gave it
  double lastGivenS = 0.0; ///< its time, by the source's clock
  double heardS = -1e300;  ///< when the head was there that the source told of last
  double newsS = -1e300;   ///< when, by our clock, something new came last

  bool began = false; ///< something was drawn
  double nowS = 0.0;
  TrackedHead wanted, drawn;
  HeadPoseFade fade;
  HeadRecorder* recorder = nullptr;
};

/// Takes what the source gave. True if the flow of poses broke.
bool HeadTracker::Internals::Take(const TimedHeadPose& given, double now)
{
  double timeS = given.timeS - this->settings.sourceDelayS;
  if (!std::isfinite(timeS) || FaultOf(given.pose) != HeadPoseFault::None)
  {
    ++this->counts.refused;
    return false;
  }
  bool broke = false;
  const bool any = !this->history.Empty();
  bool same = any && given.pose.position == this->lastGiven.position &&
              given.pose.orientation == this->lastGiven.orientation;
  if (any)
  {
    const double since = given.timeS - this->lastGivenS;
    if (std::abs(since) < SameTimeS || (same && std::abs(since) < SamePoseS))
      return false;
    if (given.timeS < this->lastGivenS)
    {
      if (now - this->newsS < BackForGoodS)
      {
        ++this->counts.outOfOrder;
        return false;
      }
      ++this->counts.clockJumps;
      this->history.Clear();
      broke = true;
      same = false; // there is none to go on from
    }
  }
  if (timeS > now + ClockWithinS)
  {
    ++this->counts.future;
    timeS = now;
  }
  this->counts.stale += now - timeS > this->settings.staleAfterS;
  this->lastGiven = given.pose;
  this->lastGivenS = given.timeS;
  this->newsS = now;
  const double sinceHeard = timeS - this->heardS;
  this->heardS = timeS;
  if (same)
  {
    ++this->counts.still;
    const bool still = timeS - this->history.Newest().timeS >= StillAfterS;
    return still && this->history.KeepStill(timeS) && this->settings.predict;
  }
  return this->Follow({ timeS, ToRoom(this->calibration, given.pose) }, sinceHeard) || broke;
}

/// A pose that moved. True if it came too late to go on from the ones before.
bool HeadTracker::Internals::Follow(const TimedHeadPose& pose, double sinceHeardS)
{
  ++this->counts.followed;
  bool broke = false;
  if (!this->history.Empty())
  {
    // Two clocks, or poses taken as of now: no time to make a velocity of.
    const bool together = pose.timeS - this->history.Newest().timeS < SameTimeS;
    if (together)
      this->history.Clear();
    broke = together || sinceHeardS > GapS;
  }
  this->history.Add(pose);
  return broke;
}

/// What should be drawn if nothing had to be faded.
TrackedHead HeadTracker::Internals::Want(double now) const
{
  TrackedHead want;
  want.pose = this->settings.rest;
  if (this->history.Empty())
    return want;
  const double seenS = now + this->settings.horizonS;
  want.latencyS = seenS - this->history.Newest().timeS;
  want.latencyFrames = want.latencyS / this->settings.frameS;
  if (now - this->heardS > this->settings.staleAfterS)
  {
    want.state = HeadTrackerState::Resting;
    return want;
  }
  const PredictionLimits limits{ this->settings.mostPredictedS, this->settings.mostPredictedMm,
    glm::radians(this->settings.mostPredictedDegrees) };
  want.pose = this->history.Newest().pose;
  if (this->settings.predict)
  {
    want.pose = this->history.Predict(seenS, limits);
    want.predictedS = std::clamp(want.latencyS, 0.0, limits.timeS);
  }
  const bool nothingNew = now - this->heardS > std::max(GapS, limits.timeS);
  want.state = nothingNew ? HeadTrackerState::Holding : HeadTrackerState::Tracking;
  return want;
}

HeadTracker::HeadTracker(std::unique_ptr<HeadPoseSource> source,
  const HeadTrackerSettings& settings, const TrackerCalibration& calibration)
{
  if (!source)
    throw std::invalid_argument("head tracker: there is no source of poses");
  ValidateTrackerCalibration(calibration);
  this->Inside = std::make_unique<Internals>(std::move(source), settings, calibration);
}

HeadTracker::~HeadTracker() = default;

TrackedHead HeadTracker::At(double nowS)
{
  Internals& in = *this->Inside;
  if (!std::isfinite(nowS) || (in.began && nowS == in.nowS))
    return in.drawn;
  const double step = in.began ? std::clamp(nowS - in.nowS, 0.0, MostStepS) : 0.0;
  bool broke = false;
  if (in.began && nowS < in.nowS) // what is known is of times yet to come
  {
    ++in.counts.clockJumps;
    in.history.Clear();
    in.newsS = in.heardS = nowS;
    broke = true;
  }
  if (const auto given = in.source->Latest(nowS))
  {
    if (in.recorder)
      in.recorder->Take(*given);
    broke = in.Take(*given, nowS) || broke;
  }

  const TrackedHead before = in.wanted;
  in.wanted = in.Want(nowS);
  const auto toRest = [](HeadTrackerState s)
  { return s == HeadTrackerState::Waiting || s == HeadTrackerState::Resting; };
  const bool rest = toRest(in.wanted.state);
  if (in.began &&
      (broke || rest != toRest(before.state) || Jumps(before.pose, in.wanted.pose, step)))
    in.fade.Begin(in.drawn.pose, in.wanted.pose, rest ? in.settings.toRestS : in.settings.backS);
  in.fade.Advance(step);
  in.drawn = in.wanted;
  in.drawn.pose = in.fade.Apply(in.wanted.pose);
  if (const double away = glm::length(in.drawn.pose.position); away > MostHeadDistanceMm)
    in.drawn.pose.position *=
      (1.0 - 1e-12) * MostHeadDistanceMm / away; // a line through wild poses
  if (in.fade.Active())
    in.drawn.state = rest ? HeadTrackerState::Easing : HeadTrackerState::Returning;
  in.began = true;
  in.nowS = nowS;
  return in.drawn;
}

void HeadTracker::RecordTo(HeadRecorder* recorder) noexcept
{
  this->Inside->recorder = recorder;
}

HeadPoseSource& HeadTracker::Source() noexcept
{
  return *this->Inside->source;
}

const HeadTrackerCounts& HeadTracker::Counts() const noexcept
{
  return this->Inside->counts;
}

const HeadTrackerSettings& HeadTracker::Settings() const noexcept
{
  return this->Inside->settings;
}

std::vector<std::string> HeadTracker::TakeWarnings()
{
  Internals& in = *this->Inside;
  std::vector<std::string> warnings = in.source->TakeWarnings();
  const struct
  {
    std::uint64_t count;
    const char* what;
  } kinds[] = {
    { in.counts.outOfOrder, "poses older than the one before; they are left out" },
    { in.counts.future, "poses of a time yet to come; do tracker and program share a clock?" },
    { in.counts.stale,
      "poses that were stale as they came; do tracker and program share a clock?" },
    { in.counts.clockJumps, "times a clock went back" },
    { in.counts.refused, "poses that are none: not finite, further than 10 m or not unit" },
  };
  for (std::size_t k = 0; k < std::size(kinds); ++k)
    if (kinds[k].count > 0 && !in.warned[k])
    {
      in.warned[k] = true;
      warnings.push_back("head tracker: " + std::to_string(kinds[k].count) + " " + kinds[k].what);
    }
  return warnings;
}

} // namespace hasp
