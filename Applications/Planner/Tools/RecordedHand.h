#pragma once
#include "Devices/HapticRecording.h"

#include <memory>

namespace hasp
{

/// A recording in place of a device, played at its own times from the first Read on, however seldom
/// it is read: a hand that goes its way, whatever it is to feel (ReplayHapticDevice gives each tick
/// again). Afterwards it is Ended. Threads: as HapticDevice; shares the recording.
class RecordedHand : public HapticDevice
{
public:
  /// Throws std::invalid_argument if there is no record.
  explicit RecordedHand(std::shared_ptr<const HapticRecording> recording);

  const DeviceProfile& Profile() const noexcept override { return this->Is; }
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override;
  DeviceStatus Write(const Wrench& wrench) noexcept override;

private:
  std::shared_ptr<const HapticRecording> Recording;
  DeviceProfile Is;
  std::size_t Next = 0;
  std::int64_t BeganNs = 0;
  bool Began = false;
};

} // namespace hasp
