#pragma once
#include "Devices/Drivers/DeviceSettings.h"
#include "Devices/Drivers/HapticDriver.h"

#include <memory>
#include <string>

namespace hasp
{

/// The driver of a named device (DeviceAddress.h), closed: nothing is touched yet. Throws
/// DeviceError: Address, NotBuilt with the option that was off; for a plugin as PluginDriver does.
/// Any thread.
std::unique_ptr<HapticDriver> MakeDriver(
  const std::string& address, const DeviceSettings& settings = {});

/// The same with a CrashGuard: `guard` is hasp-device-guard, BesideProgram() as a rule.
std::unique_ptr<HapticDriver> MakeGuardedDriver(
  const std::string& address, const DeviceSettings& settings, const std::filesystem::path& guard);
/// hasp-device-guard in the folder of the program that runs.
std::filesystem::path BesideProgram();

} // namespace hasp
