#pragma once
#include "Devices/Drivers/HapticDriver.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace hasp
{

/// How far a 6-DOF input's cap is pressed. Device axes (HapticDevice.h), each in [-1, 1].
struct SixDofState
{
  glm::dvec3 push{ 0.0 };
  glm::dvec3 turn{ 0.0 };    ///< about the axes, right-hand rule
  std::uint32_t buttons = 0; ///< bit n: button n is held
};

/// What of it was said again, the same or not.
struct SixDofNews
{
  bool push = false, turn = false;
};

/// Where deflections come from: a device, or the daemon that reads one.
///
/// Threads: one at a time, as HapticDriver.
class SixDofSource
{
public:
  SixDofSource() = default;
  virtual ~SixDofSource() = default;
  SixDofSource(const SixDofSource&) = delete;
  SixDofSource& operator=(const SixDofSource&) = delete;

  /// For programs and tables: "spacemouse". Any time, any thread; does not change.
  virtual const char* Name() const noexcept = 0;
  /// Throws DeviceError, and leaves it closed.
  virtual void Open(const DriverOpening& how) = 0;
  /// Waits up to `waitMs` for the first news, then takes all that is there. What was not said stays
  /// in `state` as it is. What is wrong is skipped and counted. Throws DeviceError when there is no
  /// going on; then it wants Close.
  virtual SixDofNews Read(SixDofState& state, int waitMs) = 0;
  /// Nothing if it is not open.
  virtual void Close() noexcept = 0;

  /// In [0, 100] %, if the device said it since Open.
  virtual std::optional<int> BatteryPercent() const noexcept { return {}; }
  /// What was skipped since Open.
  virtual std::uint64_t WrongCount() const noexcept = 0;
};

} // namespace hasp
