#pragma once
#include "Devices/HeadTracker.h"

#include <glm/geometric.hpp>

#include <deque>
#include <functional>

namespace hasp
{

/// A source that gives what a test says, in virtual time.
class ScriptedSource : public HeadPoseSource
{
public:
  using Script = std::function<std::optional<TimedHeadPose>(double nowS)>;
  explicit ScriptedSource(Script script) : Given(std::move(script)) {}
  std::optional<TimedHeadPose> Latest(double nowS) override { return this->Given(nowS); }
  const char* Name() const noexcept override { return "script"; }

private:
  Script Given;
};

inline HeadTracker Track(ScriptedSource::Script script, const HeadTrackerSettings& settings = {})
{
  return HeadTracker(std::make_unique<ScriptedSource>(std::move(script)), settings);
}

inline double AngleDegrees(const glm::dquat& a, const glm::dquat& b)
{
  return glm::degrees(2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b)))));
}

/// The largest step of what is drawn, from frame to frame.
struct Steps
{
  std::optional<HeadPose> last;
  double mostMm = 0.0, mostDegrees = 0.0;
  bool finite = true;

  void Add(const HeadPose& pose)
  {
    this->finite &= FaultOf(pose) == HeadPoseFault::None;
    if (this->last)
    {
      this->mostMm = std::max(this->mostMm, glm::length(pose.position - this->last->position));
      this->mostDegrees =
        std::max(this->mostDegrees, AngleDegrees(pose.orientation, this->last->orientation));
    }
    this->last = pose;
  }
};

} // namespace hasp
