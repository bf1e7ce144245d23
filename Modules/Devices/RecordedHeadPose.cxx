#include "Devices/RecordedHeadPose.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{

RecordedHeadPose::RecordedHeadPose(HeadPath path, const PlaybackSettings& settings)
  : Path(std::move(path)),
    Settings(settings)
{
  ValidateHeadPath(this->Path);
  if (!std::isfinite(settings.startS))
    throw std::invalid_argument("head path: the time it starts at must be finite");
  if (!(settings.delayS >= 0.0 && std::isfinite(settings.delayS)))
    throw std::invalid_argument("head path: the delay is " + std::to_string(settings.delayS) +
                                " s, must be finite and at least 0");
}

std::optional<TimedHeadPose> RecordedHeadPose::Latest(double nowS)
{
  const double since = nowS - this->Settings.delayS - this->Settings.startS;
  if (!(since >= 0.0)) // NaN, too
    return std::nullopt;
  const double first = this->Path.front().timeS, duration = this->DurationS();
  if (this->Settings.loop && duration == 0.0) // one pose, again and again: the head keeps still
    return TimedHeadPose{ nowS - this->Settings.delayS, this->Path.front().pose };
  const double round = this->Settings.loop ? std::floor(since / duration) * duration : 0.0;
  // Rounding may place it an ulp before the round.
  const double onPath = first + std::clamp(since - round, 0.0, duration);
  TimedHeadPose found{ onPath, {} };
  if (this->Settings.interpolate)
    found.pose = HeadPoseAt(this->Path, onPath);
  else
    found = *(std::upper_bound(this->Path.begin(), this->Path.end(), onPath,
                [](double t, const TimedHeadPose& pose) { return t < pose.timeS; }) -
              1);
  found.timeS += this->Settings.startS + round - first;
  return found;
}

} // namespace hasp
