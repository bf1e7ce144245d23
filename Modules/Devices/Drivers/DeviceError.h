#pragma once
#include <stdexcept>
#include <string>

namespace hasp
{

/// What keeps a device from being used, for programs; the sentence is for people.
enum class DeviceTrouble
{
  Absent,     ///< none is plugged in, or its service does not run
  Permission, ///< there, and the system forbids it: DeviceSearch says the udev rule
  Busy,       ///< another program has it
  Firmware,   ///< the file of firmware is missing, or is none
  Boot,       ///< the firmware could not be loaded; the sentence names the step
  Gone,       ///< it was open, and is no more
  Protocol,   ///< it says what it cannot say
  NotBuilt,   ///< this build has no such driver
  Address     ///< the words that name it are wrong
};

/// A device that cannot be opened or does not go on. what(): one sentence with which device, what
/// happened and what to do; no path of a home folder, no serial number.
struct DeviceError : std::runtime_error
{
  DeviceError(DeviceTrouble what, const std::string& sentence)
    : std::runtime_error(sentence),
      trouble(what)
  {
  }
  DeviceTrouble trouble;
};

} // namespace hasp
