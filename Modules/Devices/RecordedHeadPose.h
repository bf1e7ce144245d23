#pragma once
#include "Devices/HeadPath.h"

namespace hasp
{

struct PlaybackSettings
{
  double startS = 0.0;     ///< when on the asker's clock the first pose is
  bool loop = false;       ///< begin again after the last pose; the head jumps there
  bool interpolate = true; ///< false: only the poses of the path, as its tracker gave them
  double delayS = 0.0;     ///< >= 0: each pose comes that late; its time still says when it was
};

/// A recorded path as a tracker: what was, once more, at the same pace.
///
/// Threads: as HeadPoseSource; none of its own. Cost: O(log n) a call; keeps the path.
class RecordedHeadPose : public HeadPoseSource
{
public:
  /// Throws std::invalid_argument as ValidateHeadPath does, and if startS or delayS is not finite
  /// or delayS < 0.
  explicit RecordedHeadPose(HeadPath path, const PlaybackSettings& settings = {});

  /// Nothing before startS + delayS. After the last pose that one, with its time: it grows old. A
  /// loop of one pose is that pose as of nowS - delayS.
  std::optional<TimedHeadPose> Latest(double nowS) override;
  const char* Name() const noexcept override { return "recorded path"; }

  double DurationS() const { return this->Path.back().timeS - this->Path.front().timeS; }

private:
  HeadPath Path;
  PlaybackSettings Settings;
};

} // namespace hasp
