#pragma once
#include "Devices/Drivers/Falcon/FalconDriver.h"
#include "Devices/Drivers/Haply/HaplyDriver.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseDriver.h"

#include <filesystem>
#include <string>

namespace hasp
{

/// What a user has set once for his devices.
struct DeviceSettings
{
  std::string device; ///< DeviceAddress.h; empty: the first that pushes; "none": the mouse alone
  FalconSettings falcon{};
  SpaceMouseSettings spaceMouse{};
  HaplySettings inverse3{};
};

/// hasp/devices.json below XDG_CONFIG_HOME, or below ~/.config. Empty where nothing says where.
std::filesystem::path DeviceSettingsFile();

///@{
/// The file's text: JSON, at most 64 KiB. What is not there has its default; what nobody knows is
/// refused, so that a slip of the pen is not taken for a default.
///
///   { "format": "hasp-devices-1", "device": "falcon",
///     "falcon": { "firmware": "FILE", "countsPerNm": 5000, "lights": true,
///                 "eventCharacter": false },
///     "spacemouse": { "fullMmPerS": 60, "fullRadPerS": 1.5 },
///     "inverse3": { "address": "ws://localhost:10001", "allowRemote": false, "deviceId": "",
///                   "grip": true } }
///
/// Throws std::runtime_error (no JSON, or a build without HASP_ENABLE_JSON) and
/// std::invalid_argument with the key. Any thread.
DeviceSettings ParseDeviceSettings(const std::string& text);
std::string FormatDeviceSettings(const DeviceSettings& settings);
///@}

/// The defaults where there is no such file. Throws as ParseDeviceSettings.
DeviceSettings ReadDeviceSettings(const std::filesystem::path& file);
/// Atomic; makes its folder. Throws std::runtime_error.
void WriteDeviceSettings(const std::filesystem::path& file, const DeviceSettings& settings);

} // namespace hasp
