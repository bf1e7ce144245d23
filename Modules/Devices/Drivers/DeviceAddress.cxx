#include "Devices/Drivers/DeviceAddress.h"

#include "Devices/Drivers/DeviceError.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace hasp
{

namespace
{
constexpr std::array<std::string_view, 5> Drivers{ "falcon", "spacemouse", "spacenav", "inverse3",
  "plugin" };
}

DeviceAddress ParseDeviceAddress(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const DeviceAddress address{ text.substr(0, colon),
    colon == std::string::npos ? std::string() : text.substr(colon + 1) };
  if (std::ranges::find(Drivers, address.driver) == Drivers.end())
    throw DeviceError(DeviceTrouble::Address,
      "a device is named falcon, spacemouse, spacenav, inverse3 or plugin:FILE.so, each with more"
      " behind a colon if there are several");
  if (address.driver == "plugin" && address.rest.empty())
    throw DeviceError(DeviceTrouble::Address,
      "a plugin is named with its file: plugin:FILE.so, or plugin:FILE.so:SETTINGS");
  return address;
}

} // namespace hasp
