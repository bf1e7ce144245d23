#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

/// Where a viewer's head is. Room coordinates: millimetres, origin in the middle of the screen, x
/// to the viewer's right, y up, z out of the screen towards the viewer. A head's own axes: x from
/// the left eye to the right one, y up, z backwards; so the identity looks straight at the screen.
namespace hasp
{

struct HeadPose
{
  glm::dvec3 position{ 0, 0, 600 };     ///< between the eyes, mm; no further than 10 m from 0
  glm::dquat orientation{ 1, 0, 0, 0 }; ///< headToRoom (w, x, y, z); unit within 1e-3
};

/// Turns about y, then x, then z (the head's own axes, one after the other), radians: yaw to the
/// left, pitch up, roll to the left (the left ear down) are positive.
glm::dquat HeadOrientation(double yaw, double pitch, double roll);

/// A pose and when the head was there: seconds of a steady clock (SteadySeconds, or a test's own).
struct TimedHeadPose
{
  double timeS = 0.0;
  HeadPose pose;
};

/// Why a pose is refused.
enum class HeadPoseFault
{
  None,
  NotFinite,
  TooFar, ///< further than MostHeadDistanceMm
  NotUnit ///< the quaternion
};

constexpr double MostHeadDistanceMm = 10'000.0;

/// Any thread; never throws: what a source asks before it passes a pose on.
HeadPoseFault FaultOf(const HeadPose& pose) noexcept;

/// Throws std::invalid_argument unless FaultOf is None; says the value and the legal range.
void ValidateHeadPose(const HeadPose& pose);

/// Seconds of std::chrono::steady_clock: what sources with a thread stamp their poses with, so what
/// they must be asked with.
double SteadySeconds() noexcept;

/// Where poses come from: a file, a mouse, a tracker. Whoever draws asks once a frame.
///
/// Time is always passed in: a source that has no clock of its own can be run in virtual time.
/// Threads: RENDER, or whoever owns it; one at a time. Sources that need a thread of their own keep
/// it to themselves; neither it nor a socket is there before the source is, nor after.
class HeadPoseSource
{
public:
  HeadPoseSource() = default;
  virtual ~HeadPoseSource() = default;
  HeadPoseSource(const HeadPoseSource&) = delete;
  HeadPoseSource& operator=(const HeadPoseSource&) = delete;

  /// The newest pose there is at `nowS`, however old; nothing before the first. The same pose with
  /// the same time: nothing new came. Never throws for what a tracker or a sender did wrong: that
  /// is a warning, and the pose before stays.
  virtual std::optional<TimedHeadPose> Latest(double nowS) = 0;

  /// What it is, for people: "recorded path", "mouse", "opentrack", "plugin".
  virtual const char* Name() const noexcept = 0;

  /// What went wrong since the last call, in sentences; each kind of fault once in the life of the
  /// source. Fixed phrases and numbers: no file's name, no text out of files, packets or plugins.
  virtual std::vector<std::string> TakeWarnings() { return {}; }
};

} // namespace hasp
