#include "Devices/HeadRecorder.h"

#include <cmath>

namespace hasp
{

void HeadRecorder::Take(const TimedHeadPose& given)
{
  if (!std::isfinite(given.timeS) || FaultOf(given.pose) != HeadPoseFault::None)
  {
    ++this->Refused;
    return;
  }
  const bool first = this->Kept.empty();
  if (first)
    this->BeganS = given.timeS;
  else if (given.timeS == this->LastS)
    return;
  else if (given.timeS < this->LastS)
  {
    ++this->Older;
    return;
  }
  const double timeS = given.timeS - this->BeganS;
  // Newer by less than the difference can show, or a clock that leapt out of what a path can hold.
  if (timeS > MostHeadPathTimeS || (!first && !(timeS > this->Kept.back().timeS)))
  {
    ++this->Refused;
    return;
  }
  if (this->Kept.size() == MostHeadPathPoses)
  {
    ++this->Late;
    return;
  }
  this->LastS = given.timeS;
  this->Kept.push_back({ timeS, given.pose });
}

std::vector<std::string> HeadRecorder::Losses() const
{
  const struct
  {
    std::uint64_t count;
    const char* what;
  } kinds[] = {
    { this->Refused, "poses that are none" },
    { this->Older, "poses older than the one before; was a clock set back?" },
    { this->Late, "poses after the most that a recording holds" },
  };
  std::vector<std::string> losses;
  for (const auto& [count, what] : kinds)
    if (count > 0)
      losses.push_back("not in the recording: " + std::to_string(count) + " " + what);
  return losses;
}

} // namespace hasp
