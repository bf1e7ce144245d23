#pragma once
#include "Devices/Drivers/DeviceError.h"
#include "Devices/HapticDevice.h"

#include <cstdint>
#include <functional>
#include <string>

namespace hasp
{

/// What a driver is opened with.
struct DriverOpening
{
  /// Long openings ask it between steps (a boot: some times a second) and leave by Cancelled.
  std::function<bool()> cancelled = [] { return false; };
  /// False: a device that has to be set up first (firmware) is left as it is, by Cancelled.
  bool setUp = true;
  /// What is being done now, for people: "loading the firmware, try 2 of 10".
  std::function<void(const std::string&)> says = [](const std::string&) {};
  /// What is wrong and does not keep it from being used: a sentence.
  std::function<void(const std::string&)> warns = [](const std::string&) {};
};

/// What a device said in one exchange.
struct DriverSample
{
  RigidPose pose{};          ///< device axes (HapticDevice.h)
  std::uint32_t buttons = 0; ///< bit n: button n is held
  bool fresh = true;         ///< false: nothing new came, this is what was before
  bool homed = true;         ///< false: the pose is not where it is
  bool sane = true;          ///< false: it says what cannot be, so no pose is known
};

/// The part of a device that knows how to talk to it, and nothing else: no threads, no safety, no
/// plugging in and out. DrivenHapticDevice has those, in one place for all drivers.
///
/// A driver may wait, for milliseconds, and throw. It is opened and closed many times: after an
/// exception of Exchange comes Close, and then perhaps Open.
/// Threads: one at a time; the thread of DrivenHapticDevice as a rule.
class HapticDriver
{
public:
  HapticDriver() = default;
  virtual ~HapticDriver() = default;
  HapticDriver(const HapticDriver&) = delete;
  HapticDriver& operator=(const HapticDriver&) = delete;

  /// Any time, any thread; does not change.
  virtual const DeviceProfile& Profile() const noexcept = 0;

  /// Throws DeviceError, and leaves it closed; Cancelled (Grid/Progress.h) if it was asked to
  /// leave.
  virtual void Open(const DriverOpening& how) = 0;

  /// Says the wrench (device axes; finite and within the profile: DrivenHapticDevice sees to it)
  /// and gives what the device answers. Waits no more than about 20 ms. A packet that is wrong is
  /// skipped and counted; Throws DeviceError (Gone, Protocol) when there is no going on.
  /// `nowNs`: on the clock of LoopThread.
  virtual DriverSample Exchange(const Wrench& wrench, std::int64_t nowNs) = 0;

  /// Zero force as far as the device still hears, within 100 ms; then it is let go. Nothing if it
  /// is not open.
  virtual void Close() noexcept = 0;

  /// What the user has to do now, a sentence; empty where there is nothing (homing). Asked ten
  /// times a second, on the thread of Exchange.
  virtual std::string Advice() const { return {}; }
};

} // namespace hasp
