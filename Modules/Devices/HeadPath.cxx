#include "Devices/HeadPath.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{

void ValidateHeadPath(std::span<const TimedHeadPose> path)
{
  if (path.empty())
    throw std::invalid_argument("head path: it has no pose; one is the least");
  for (std::size_t n = 0; n < path.size(); ++n)
  {
    const auto refuse = [&](const std::string& why)
    { throw std::invalid_argument("head path: pose " + std::to_string(n + 1) + ": " + why); };
    if (!(std::abs(path[n].timeS) <= MostHeadPathTimeS))
      refuse("its time must be finite and within 1e9 s of 0");
    if (n > 0 && !(path[n].timeS > path[n - 1].timeS))
      refuse("its time is " + std::to_string(path[n - 1].timeS - path[n].timeS) +
             " s before the one above or the same; times must increase");
    try
    {
      ValidateHeadPose(path[n].pose);
    }
    catch (const std::invalid_argument& error)
    {
      refuse(error.what());
    }
  }
}

HeadPose MixHeadPoses(const HeadPose& a, const HeadPose& b, double share)
{
  return { glm::mix(a.position, b.position, share),
    glm::normalize(
      glm::slerp(glm::normalize(a.orientation), glm::normalize(b.orientation), share)) };
}

HeadPose HeadPoseAt(std::span<const TimedHeadPose> path, double timeS)
{
  const auto after = std::upper_bound(path.begin(), path.end(), timeS,
    [](double t, const TimedHeadPose& pose) { return t < pose.timeS; });
  if (after == path.begin())
    return path.front().pose;
  if (after == path.end())
    return path.back().pose;
  const TimedHeadPose &a = *(after - 1), &b = *after;
  return MixHeadPoses(a.pose, b.pose, (timeS - a.timeS) / (b.timeS - a.timeS));
}

} // namespace hasp
