#pragma once
#include "Devices/HapticDevice.h"
#include "Realtime/TripleBuffer.h"

#include <cstdint>

namespace hasp
{

struct InputDeviceSettings
{
  glm::dvec3 workspaceMm{ 100.0 }; ///< half of the box that poses stay in
  double followS = 0.015; ///< time constant with which the pose follows: events come 60 times a
                          ///< second, ticks 1000; 0: at once; in [0, 1]
  double staleS = 0.1;    ///< rates that are older count as zero; in (0, 10]
};

/// Mouse, keyboard and 6-DOF input devices as a haptic device without force: whoever has a window
/// feeds it on RENDER, ticks read it on HAPTIC.
///
/// Mouse drags and keys are steps (MoveBy, TurnBy): each arrives, however seldom ticks look. What a
/// SpaceMouse says are rates: they are integrated in ticks, for as long as they are fresh. Poses
/// stay in the workspace's box; steps beyond it are lost, as a mouse's at the screen's edge.
/// Threads: the feeding functions on RENDER, or whoever owns the window; Read and Write on HAPTIC;
/// they meet in a TripleBuffer, and neither waits. Costs about 60 ns a tick.
class InputHapticDevice : public HapticDevice
{
public:
  /// Throws std::invalid_argument if a setting is out of its range.
  explicit InputHapticDevice(const InputDeviceSettings& settings = {});

  // RENDER. Device axes, mm, radians. What has a number that is not finite, or beyond 1e6, is
  // ignored.
  void MoveBy(const glm::dvec3& mm) noexcept;
  void TurnBy(const glm::dvec3& radians) noexcept; ///< about fixed axes
  /// There at the next tick, however slowly steps are followed; forgets all steps before.
  void MoveTo(const RigidPose& pose) noexcept;
  /// `nowNs`: on the loop's clock (MonotonicClock). Say rates again as long as they hold.
  void SetRates(const glm::dvec3& mmPerS, const glm::dvec3& radPerS, std::int64_t nowNs) noexcept;
  /// A button that is let go before the next tick was not pressed.
  void SetButtons(std::uint32_t held) noexcept;

  // HAPTIC.
  const DeviceProfile& Profile() const noexcept override { return this->Is; }
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override;
  /// There is nothing to feel.
  DeviceStatus Write(const Wrench&) noexcept override { return DeviceStatus::Ok; }

private:
  /// All that RENDER has ever said, summed up: what is lost in between is in the next.
  struct Input
  {
    RigidPose place; ///< of the last MoveTo
    std::uint64_t placed = 0;
    glm::dvec3 moved{ 0.0 };         ///< since then
    glm::dquat turned{ 1, 0, 0, 0 }; ///< …
    glm::dvec3 mmPerS{ 0.0 }, radPerS{ 0.0 };
    std::int64_t ratesNs = 0;
    std::uint32_t buttons = 0;
  };
  void TakeSteps(const Input& input) noexcept;
  void Follow(double dtS) noexcept;

  InputDeviceSettings Settings;
  DeviceProfile Is;
  TripleBuffer<Input> Exchange;
  Input Said;  ///< RENDER's
  Input Heard; ///< HAPTIC's, as all below
  RigidPose Goal, Pose;
  std::int64_t NowNs = 0;
  bool Any = false;
};

} // namespace hasp
