#pragma once
#include "Devices/HeadPath.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

/// Keeps the poses that a source gives, as it gave them: not calibrated, not predicted. What it
/// keeps is a valid HeadPath whose first pose is at 0 s; played back under the same calibration it
/// moves the view as the source did.
///
/// Threads: one at a time; none of its own. Cost: 64 B a pose, MostHeadPathPoses at most (2 h at
/// 120 Hz).
class HeadRecorder
{
public:
  /// Keeps it if it is newer than the one before. The same time as before is nothing new.
  void Take(const TimedHeadPose& given);

  const HeadPath& Path() const noexcept { return this->Kept; }

  /// What is not in the path, in sentences: poses that are none, poses older than the one before,
  /// all that came when it was full.
  std::vector<std::string> Losses() const;

private:
  HeadPath Kept;
  double BeganS = 0.0; ///< the source's time of the first
  double LastS = 0.0;  ///< … and of the last
  std::uint64_t Refused = 0, Older = 0, Late = 0;
};

} // namespace hasp
