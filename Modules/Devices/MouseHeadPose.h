#pragma once
#include "Devices/HeadPose.h"

#include <glm/vec2.hpp>

namespace hasp
{

struct MouseHeadSettings
{
  HeadPose rest{};                ///< with the mouse in the middle
  glm::dvec2 reachMm{ 250, 150 }; ///< how far the head is off with the mouse at an edge, >= 0
  double stepFactor = 1.1;        ///< distance from the screen grows by it a wheel step, in (1, 2]
  double nearestMm = 150.0, farthestMm = 3000.0; ///< the wheel stops there; nearest > 0
};

/// Parallax without a tracker: the mouse is the head.
///
/// Right of the middle is right of the screen, up is up; the head goes on looking straight at the
/// screen's plane, so that both eyes stay level. For one viewer at a desk, and to look at what a
/// tracker would show.
/// Threads: RENDER; none of its own. Costs nothing.
class MouseHeadPose : public HeadPoseSource
{
public:
  /// Throws std::invalid_argument if a setting is out of its range.
  explicit MouseHeadPose(const MouseHeadSettings& settings = {});

  /// Where the mouse is in the window: x, y in [-1, 1], (0, 0) the middle, +x right, +y up. Beyond
  /// is the edge; what is not finite leaves the head where it is.
  void SetPosition(const glm::dvec2& position);
  /// The wheel, summed up by the mouse: steps backwards (towards the user) go away from the screen.
  void TurnWheel(double steps);
  /// Back to the rest pose.
  void Reset();

  /// Always there, always of now.
  std::optional<TimedHeadPose> Latest(double nowS) override;
  const char* Name() const noexcept override { return "mouse"; }

private:
  MouseHeadSettings Settings;
  glm::dvec2 Position{ 0.0 };
  double DistanceMm;
};

} // namespace hasp
