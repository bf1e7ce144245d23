#pragma once
#include "Devices/Drivers/HapticDriver.h"

#include <functional>
#include <string>
#include <vector>

namespace hasp::test
{

/// A device on which a test plays: where it is, whether it is plugged in and homed, what it throws.
/// It outlives its driver.
struct ScriptedDevice
{
  DeviceProfile profile = FalconProfile();
  bool there = true, homed = true, fresh = true, open = false;
  DriverSample sample{};
  DeviceTrouble trouble = DeviceTrouble::Absent; ///< of an Open where it is not there
  Wrench force{};                                ///< what its motors do now
  std::vector<Wrench> said;                      ///< by each exchange
  int opens = 0, closes = 0;
  std::function<void(const DriverOpening&)> opening = [](const DriverOpening&) {};
  std::function<void()> exchanging = [] {};
};

class ScriptedDriver : public HapticDriver
{
public:
  explicit ScriptedDriver(ScriptedDevice& device) : Device(device) {}
  const DeviceProfile& Profile() const noexcept override { return this->Device.profile; }
  void Open(const DriverOpening& how) override
  {
    ++this->Device.opens;
    this->Device.opening(how);
    if (!this->Device.there)
      throw DeviceError(this->Device.trouble, "the scripted device is not there; plug it in");
    this->Device.open = true;
  }
  DriverSample Exchange(const Wrench& wrench, std::int64_t) override
  {
    this->Device.exchanging();
    if (!this->Device.there)
      throw DeviceError(DeviceTrouble::Gone, "the scripted device is gone");
    this->Device.force = wrench;
    this->Device.said.push_back(wrench);
    DriverSample sample = this->Device.sample;
    sample.homed = this->Device.homed;
    sample.fresh = this->Device.fresh;
    return sample;
  }
  void Close() noexcept override
  {
    if (this->Device.open)
      ++this->Device.closes;
    this->Device.open = false;
    this->Device.force = {}; // without power, or told so
  }
  std::string Advice() const override { return "move the grip"; }

private:
  ScriptedDevice& Device;
};

} // namespace hasp::test
