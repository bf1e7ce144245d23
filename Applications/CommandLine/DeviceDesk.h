#pragma once
#include "Devices/Drivers/DeviceSettings.h"
#include "Devices/Drivers/DeviceTrial.h"
#include "Devices/Drivers/DrivenHapticDevice.h"

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

namespace hasp
{

/// A device on the table: opened, looked at, felt and measured by whoever sits before it.
///
/// Threads: the one that made it; the device's and a loop of 1 kHz beside. Errors: Failure.
class DeviceDesk
{
public:
  /// says  what goes on, a line each
  DeviceDesk(const std::string& address, const DeviceSettings& settings,
    std::function<void(const std::string&)> says);
  ~DeviceDesk();

  const DeviceProfile& Profile() const noexcept { return this->Device->Profile(); }

  /// Waits until it runs, or, unless it has to be `homed`, until it is open.
  /// Throws Failure with the device's own sentence as soon as it cannot be opened, and after two
  /// minutes of waiting for hands.
  void UntilReady(bool homed);
  /// Its pose, buttons and force for so long, a line whenever they change, ten times a second.
  /// Throws Failure if it is not there at the end.
  void Watch(double seconds, const ForceTrial& trial);
  /// Asks for forces along z, and `in` for what a spring scale reads; `out` says what to do.
  ScaleFit MeasureScale(std::istream& in, std::ostream& out);

  DeviceSight Look() noexcept { return this->Trial->Look(); }
  DeviceNews News() const { return this->Device->News(); }

private:
  void UntilGiven(double newton);

  std::function<void(const std::string&)> Says;
  std::unique_ptr<DrivenHapticDevice> Device;
  std::unique_ptr<DeviceTrial> Trial;
};

/// "x 1.2 y 3.4 z 5.6 mm, buttons 1, force x 0.5 y 0.0 z 0.0 N", or what is wrong with it.
std::string SightLine(const DeviceSight& seen);

} // namespace hasp
