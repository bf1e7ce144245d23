#include "Devices/Drivers/DeviceAddress.h"
#include "Devices/Drivers/DeviceError.h"
#include "Devices/Drivers/DeviceSettings.h"
#include "Devices/SettingsCheck.h"

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <type_traits>

namespace hasp
{

namespace
{
using Json = nlohmann::ordered_json;
constexpr const char* What = "device settings";
constexpr const char* Format = "hasp-devices-1";

/// Errors say our own keys and no text of the file.
[[noreturn]] void Refuse(const std::string& why)
{
  throw std::invalid_argument("device settings: " + why);
}

/// An object whose keys are taken out one by one: what is left is known to nobody.
class Section
{
public:
  Section(const Json& json, const std::string& name) : Name(name)
  {
    if (!json.is_object())
      Refuse((name.empty() ? std::string("the file") : name) + " must be an object");
    this->Left = json;
  }
  ~Section() = default;

  void Take(const char* key, std::string& into) { this->Take(key, into, "a text"); }
  void Take(const char* key, bool& into) { this->Take(key, into, "true or false"); }
  void Take(const char* key, double& into) { this->Take(key, into, "a number"); }
  /// A section of its own, empty if it is not there.
  Section Take(const char* key)
  {
    const Json found = this->Left.contains(key) ? this->Left[key] : Json::object();
    this->Left.erase(key);
    return { found, this->Path(key) };
  }
  void End() const
  {
    if (!this->Left.empty())
      Refuse((this->Name.empty() ? std::string("the file") : this->Name) + " has " +
             std::to_string(this->Left.size()) + " keys that nobody knows; take them out");
  }

private:
  template <class Value>
  void Take(const char* key, Value& into, const char* kind)
  {
    const auto found = this->Left.find(key);
    if (found == this->Left.end())
      return;
    bool fits = false;
    if constexpr (std::is_same_v<Value, std::string>)
      fits = found->is_string();
    else if constexpr (std::is_same_v<Value, bool>)
      fits = found->is_boolean();
    else
      fits = found->is_number();
    if (!fits)
      Refuse(this->Path(key) + " must be " + kind);
    into = found->template get<Value>();
    this->Left.erase(key);
  }
  std::string Path(const char* key) const
  {
    return this->Name.empty() ? std::string(key) : this->Name + "." + key;
  }

  std::string Name;
  Json Left;
};

Json Parsed(const std::string& text)
{
  try
  {
    return Json::parse(text);
  }
  catch (const Json::parse_error& error) // its text quotes the file
  {
    throw std::runtime_error(
      "device settings: no JSON: a mistake at byte " + std::to_string(error.byte));
  }
  catch (const Json::exception&)
  {
    throw std::runtime_error("device settings: no JSON: a number is too large for any double");
  }
}

void Validate(const DeviceSettings& settings)
{
  if (!settings.device.empty() && settings.device != "none")
  {
    try
    {
      ParseDeviceAddress(settings.device);
    }
    catch (const DeviceError& error)
    {
      Refuse(std::string("device: ") + error.what());
    }
  }
  CheckRange(What, "falcon.countsPerNm", settings.falcon.countsPerNm, 1.0, 100'000.0);
  CheckRange(What, "spacemouse.fullMmPerS", settings.spaceMouse.fullMmPerS, 0.0, 1000.0);
  CheckRange(What, "spacemouse.fullRadPerS", settings.spaceMouse.fullRadPerS, 0.0, 20.0);
}
} // namespace

DeviceSettings ParseDeviceSettings(const std::string& text)
{
  DeviceSettings settings;
  Section file(Parsed(text), {});
  std::string format;
  file.Take("format", format);
  if (format != Format)
    Refuse(std::string("format must be '") + Format + "'");
  file.Take("device", settings.device);
  Section falcon = file.Take("falcon");
  falcon.Take("firmware", settings.falcon.firmware);
  falcon.Take("countsPerNm", settings.falcon.countsPerNm);
  falcon.Take("lights", settings.falcon.lights);
  falcon.Take("eventCharacter", settings.falcon.eventCharacter);
  falcon.End();
  Section mouse = file.Take("spacemouse");
  mouse.Take("fullMmPerS", settings.spaceMouse.fullMmPerS);
  mouse.Take("fullRadPerS", settings.spaceMouse.fullRadPerS);
  mouse.End();
  Section inverse3 = file.Take("inverse3");
  inverse3.Take("address", settings.inverse3.address);
  inverse3.Take("allowRemote", settings.inverse3.allowRemote);
  inverse3.Take("deviceId", settings.inverse3.deviceId);
  inverse3.Take("grip", settings.inverse3.grip);
  inverse3.End();
  file.End();
  Validate(settings);
  return settings;
}

std::string FormatDeviceSettings(const DeviceSettings& s)
{
  Validate(s);
  const Json json = { { "format", Format }, { "device", s.device },
    { "falcon", { { "firmware", s.falcon.firmware }, { "countsPerNm", s.falcon.countsPerNm },
                  { "lights", s.falcon.lights }, { "eventCharacter", s.falcon.eventCharacter } } },
    { "spacemouse",
      { { "fullMmPerS", s.spaceMouse.fullMmPerS }, { "fullRadPerS", s.spaceMouse.fullRadPerS } } },
    { "inverse3", { { "address", s.inverse3.address }, { "allowRemote", s.inverse3.allowRemote },
                    { "deviceId", s.inverse3.deviceId }, { "grip", s.inverse3.grip } } } };
  return json.dump(2) + "\n";
}

} // namespace hasp
