#include "Devices/Drivers/DeviceSettings.h"

#include "Devices/TextFile.h"

#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace hasp
{

namespace
{
namespace fs = std::filesystem;

constexpr const char* What = "device settings";
constexpr std::size_t MostBytes = 64 * 1024;

fs::path FromEnvironment(const char* name)
{
  const char* value = std::getenv(name);
  return value != nullptr ? fs::path(value) : fs::path();
}
} // namespace

fs::path DeviceSettingsFile()
{
  const fs::path config = FromEnvironment("XDG_CONFIG_HOME"), home = FromEnvironment("HOME");
  if (config.is_absolute()) // as its standard says: others are to be ignored
    return config / "hasp/devices.json";
  return home.is_absolute() ? home / ".config/hasp/devices.json" : fs::path();
}

DeviceSettings ReadDeviceSettings(const fs::path& file)
{
  std::error_code error;
  if (file.empty() || !fs::exists(file, error))
    return {};
  return ParseDeviceSettings(ReadTextFile(file.string(), MostBytes, What));
}

void WriteDeviceSettings(const fs::path& file, const DeviceSettings& settings)
{
  const std::string text = FormatDeviceSettings(settings);
  if (file.empty())
    throw std::runtime_error("device settings: nothing says where they are kept; set HOME");
  std::error_code error;
  fs::create_directories(file.parent_path(), error); // what fails shows in the next line
  WriteTextFile(file.string(), text, What);
}

#if !HASP_WITH_JSON
namespace
{
[[noreturn]] void Refuse()
{
  throw std::runtime_error("device settings: this build of Hasp was made without their file;"
                           " configure it with HASP_ENABLE_JSON=ON (Debian: nlohmann-json3-dev)");
}
} // namespace

DeviceSettings ParseDeviceSettings(const std::string&)
{
  Refuse();
}

std::string FormatDeviceSettings(const DeviceSettings&)
{
  Refuse();
}
#endif

} // namespace hasp
