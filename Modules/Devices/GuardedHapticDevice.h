#pragma once
#include "Devices/HapticDevice.h"
#include "Realtime/Watchdog.h"

#include <memory>

namespace hasp
{

struct GuardCounts
{
  std::uint64_t badPoses = 0;    ///< with a number that is not finite, or no rotation
  std::uint64_t badWrenches = 0; ///< with a number that is not finite
  std::uint64_t ramps = 0;       ///< times that nobody had written for too long
};

/// A device behind a watchdog: what every loop puts between itself and motors.
///
/// A wrench is finite and within the profile, or zero. If ticks read and do not write any more, the
/// wrench goes to zero as Watchdog says; so it does where poses are stale for that long, whatever
/// is written: a wrench is as old as the pose it was made of. A device that is gone, not homed or
/// at fault gets zero at that tick, and stays at zero until it is written to again. A pose that is
/// no pose is not handed on: the last good one is, with Fault. The end of this leaves a zero.
/// Limits: a loop that does not read either cannot be helped here; a driver with a thread of its
/// own asks a Watchdog there. And what was zero comes back as it is written: who writes grows it
/// from nothing then (HapticStep::Place, ForceLimiter::Restart).
/// Threads: as HapticDevice. Costs about 50 ns a tick.
class GuardedHapticDevice : public HapticDevice
{
public:
  /// Throws std::invalid_argument if there is no device, or a setting is out of its range.
  explicit GuardedHapticDevice(
    std::unique_ptr<HapticDevice> device, const WatchdogSettings& settings = {});
  ~GuardedHapticDevice() override;

  const DeviceProfile& Profile() const noexcept override { return this->Device->Profile(); }
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override;
  DeviceStatus Write(const Wrench& wrench) noexcept override;

  HapticDevice& Guarded() noexcept { return *this->Device; }
  GuardCounts Counts() const noexcept;
  /// False once a wrench was let out in part or not at all because it was too old.
  bool Whole() const noexcept { return !this->Cut; }

private:
  DeviceStatus Send() noexcept;

  std::unique_ptr<HapticDevice> Device;
  Watchdog Dog;
  DeviceSample Good;
  DeviceStatus Status = DeviceStatus::NotHomed; ///< of the last Read
  std::int64_t NowNs = 0;                       ///< of the last Read
  std::int64_t PoseNs = 0;                      ///< of the last Read that was not Stale
  bool AnyGood = false, Written = false, Cut = false;
  std::uint64_t BadPoses = 0;
};

} // namespace hasp
