#pragma once
#include "Devices/HapticDevice.h"

#include <memory>
#include <utility>

namespace hasp
{

/// A device that somebody else keeps, for as long as this is there: a tool takes it in hand and
/// gives it back without force. One at a time. Threads: as HapticDevice.
class LentHapticDevice : public HapticDevice
{
public:
  explicit LentHapticDevice(std::shared_ptr<HapticDevice> device) : Device(std::move(device)) {}
  ~LentHapticDevice() override { this->Device->Write({}); }

  const DeviceProfile& Profile() const noexcept override { return this->Device->Profile(); }
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override
  {
    return this->Device->Read(nowNs, sample);
  }
  DeviceStatus Write(const Wrench& wrench) noexcept override { return this->Device->Write(wrench); }

private:
  std::shared_ptr<HapticDevice> Device;
};

} // namespace hasp
