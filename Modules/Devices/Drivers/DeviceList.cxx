#include "Devices/Drivers/DeviceList.h"

#include "Devices/Drivers/CrashGuard.h"
#include "Devices/Drivers/DeviceAddress.h"
#include "Devices/Drivers/Plugin/PluginDriver.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseHid.h"
#include "Devices/Drivers/SpaceMouse/SpacenavSocket.h"
#if HASP_WITH_LIBUSB
#include "Devices/Drivers/Falcon/LibusbTransport.h"
#endif
#if HASP_WITH_HIDAPI
#include "Devices/Drivers/SpaceMouse/HidapiTransport.h"
#endif

namespace hasp
{

namespace
{
[[maybe_unused]] [[noreturn]] void RefuseUnbuilt(const char* what, const char* option)
{
  throw DeviceError(DeviceTrouble::NotBuilt,
    std::string("this build of Hasp has no driver for ") + what + "; configure it with " + option);
}

std::unique_ptr<HapticDriver> MakeFalcon(
  [[maybe_unused]] const std::string& port, [[maybe_unused]] const FalconSettings& settings)
{
#if HASP_WITH_LIBUSB
  return std::make_unique<FalconDriver>(std::make_unique<LibusbTransport>(port), settings);
#else
  RefuseUnbuilt("a Novint Falcon", "HASP_ENABLE_LIBUSB=ON (Debian: libusb-1.0-0-dev)");
#endif
}

std::unique_ptr<HapticDriver> MakeSpaceMouse(
  [[maybe_unused]] const std::string& node, [[maybe_unused]] const SpaceMouseSettings& settings)
{
#if HASP_WITH_HIDAPI
  const std::string path = node.empty() || node.starts_with('/') ? node : "/dev/" + node;
  return std::make_unique<SpaceMouseDriver>(
    std::make_unique<SpaceMouseHid>(std::make_unique<HidapiTransport>(path)), settings);
#else
  RefuseUnbuilt(
    "a SpaceMouse", "HASP_ENABLE_HIDAPI=ON (Debian: libhidapi-dev), or use the spacenavd daemon");
#endif
}

std::unique_ptr<HapticDriver> MakeInverse3(
  [[maybe_unused]] const std::string& url, [[maybe_unused]] HaplySettings settings)
{
#if HASP_WITH_BEAST && HASP_WITH_JSON
  if (!url.empty())
    settings.address = url;
  return std::make_unique<HaplyDriver>(settings);
#else
  RefuseUnbuilt("a Haply Inverse3", "HASP_ENABLE_BEAST=ON and HASP_ENABLE_JSON=ON (Debian:"
                                    " libboost-dev, nlohmann-json3-dev)");
#endif
}
} // namespace

std::unique_ptr<HapticDriver> MakeDriver(const std::string& address, const DeviceSettings& settings)
{
  const auto [driver, rest] = ParseDeviceAddress(address);
  if (driver == "falcon")
    return MakeFalcon(rest, settings.falcon);
  if (driver == "spacemouse")
    return MakeSpaceMouse(rest, settings.spaceMouse);
  if (driver == "spacenav")
    return std::make_unique<SpaceMouseDriver>(
      std::make_unique<SpacenavSocket>(rest.empty() ? SpacenavSocket::StandardPath : rest),
      settings.spaceMouse);
  if (driver == "inverse3")
    return MakeInverse3(rest, settings.inverse3);
  const std::size_t colon = rest.find(':');
  return std::make_unique<PluginDriver>(
    rest.substr(0, colon), colon == std::string::npos ? std::string() : rest.substr(colon + 1));
}

std::unique_ptr<HapticDriver> MakeGuardedDriver(
  const std::string& address, const DeviceSettings& settings, const std::filesystem::path& guard)
{
#if HASP_WITH_JSON
  const std::string text = FormatDeviceSettings(settings);
#else
  const std::string text; // there is no file to have them from either
#endif
  return std::make_unique<CrashGuard>(MakeDriver(address, settings), guard, address, text);
}

std::filesystem::path BesideProgram()
{
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none)
    .replace_filename("hasp-device-guard");
}

} // namespace hasp
