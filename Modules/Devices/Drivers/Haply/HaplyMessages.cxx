#include "Devices/Drivers/Haply/HaplyMessages.h"

#include "Grid/FinitePose.h"

#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>

namespace hasp
{

namespace
{
using Json = nlohmann::json;
constexpr std::size_t MostId = 64;
constexpr const char* Buttons[] = { "a", "b", "c" };
constexpr double MostDistanceMm = 2000.0, UnitWithin = 0.01;

/// Errors say our own keys and no text of the service.
[[noreturn]] void Refuse(const std::string& why)
{
  throw std::invalid_argument("Haply message: " + why);
}

/// nullptr where there is no such key, or `json` is no object.
const Json* Find(const Json& json, const char* key)
{
  if (!json.is_object())
    return nullptr;
  const auto found = json.find(key);
  return found == json.end() ? nullptr : &*found;
}

const Json& Object(const Json& json, const char* key)
{
  const Json* found = Find(json, key);
  if (!found || !found->is_object())
    Refuse(std::string(key) + " is missing, or is no object");
  return *found;
}

double Number(const Json& json, const char* what, const char* key)
{
  const Json* found = Find(json, key);
  if (!found || !found->is_number())
    Refuse(std::string(what) + "." + key + " is missing, or is no number");
  return found->get<double>();
}

/// The array behind a key; nullptr where there is none, or an empty one.
const Json* Devices(const Json& json, const char* key)
{
  const Json* found = Find(json, key);
  if (!found || found->is_null())
    return nullptr;
  if (!found->is_array())
    Refuse(std::string(key) + " is no list");
  return found->empty() ? nullptr : found;
}

std::string DeviceId(const Json& device)
{
  const Json* id = Find(device, "device_id");
  if (!id || !id->is_string())
    Refuse("device_id is missing, or is no text");
  const auto& text = id->get_ref<const std::string&>();
  if (text.empty() || text.size() > MostId)
    Refuse("device_id has " + std::to_string(text.size()) + " bytes, must be 1 to 64");
  return text;
}

/// A key that may be missing, but not of another type.
std::optional<bool> Flag(const Json& json, const char* key)
{
  const Json* found = Find(json, key);
  if (!found)
    return std::nullopt;
  if (!found->is_boolean())
    Refuse(std::string(key) + " is neither true nor false");
  return found->get<bool>();
}

std::string Text(const Json* json, const char* key)
{
  const Json* found = json ? Find(*json, key) : nullptr;
  return found && found->is_string() ? found->get<std::string>() : std::string();
}

void ReadArm(const Json& device, HaplyState& state)
{
  state.deviceId = DeviceId(device);
  constexpr const char* Position = "cursor_position";
  const Json& p = Object(Object(device, "state"), Position);
  const double x = Number(p, Position, "x"), y = Number(p, Position, "y"),
               z = Number(p, Position, "z");
  state.positionMm = 1000.0 * glm::dvec3(x, z, -y);
  if (!IsFinite(state.positionMm) || !(glm::length(state.positionMm) <= MostDistanceMm))
    Refuse("cursor_position is further than 2 m away");
  if (const Json* status = Find(device, "status"))
    state.calibrated = Flag(*status, "calibrated");
  if (const Json* config = Find(device, "config"))
  {
    state.centred = Text(config, "preset").ends_with("_centered");
    const std::string basis = Text(Find(*config, "basis"), "permutation");
    state.turnedAxes = !basis.empty() && basis != "XYZ" && basis != "+X+Y+Z";
  }
}

void ReadTurn(const Json& grip, HaplyState& state)
{
  constexpr const char* Key = "orientation";
  const Json& q = Object(grip, Key);
  const glm::dquat turn(Number(q, Key, "w"), Number(q, Key, "x"), Number(q, Key, "z"),
    -Number(q, Key, "y")); // the axis as any vector
  const double length = glm::length(turn);
  if (length == 0.0)
    return;
  if (!(std::abs(length - 1.0) <= UnitWithin))
    Refuse("orientation is no unit quaternion");
  state.orientation = turn / length;
}

void ReadGrip(const Json& json, HaplyState& state)
{
  if (const Json* grips = Devices(json, "wireless_verse_grip"))
  {
    const Json& grip = Object(grips->front(), "state");
    ReadTurn(grip, state);
    if (const Json* buttons = Find(grip, "buttons"))
      for (std::size_t n = 0; n < std::size(Buttons); ++n)
        if (Flag(*buttons, Buttons[n]).value_or(false))
          state.buttons |= 1u << n;
  }
  else if (const Json* wired = Devices(json, "verse_grip"))
  {
    const Json& grip = Object(wired->front(), "state");
    ReadTurn(grip, state);
    state.buttons = Flag(grip, "button").value_or(false) ? 1u : 0u;
  }
}
} // namespace

std::optional<HaplyState> ReadHaplyState(std::string_view text, std::string_view deviceId)
{
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded())
    Refuse("it is no JSON");
  if (!json.is_object())
    Refuse("it is no object");
  const Json* arms = Devices(json, "inverse3");
  if (!arms)
    return std::nullopt;
  for (const Json& arm : *arms)
    if (deviceId.empty() || DeviceId(arm) == deviceId)
    {
      HaplyState state;
      ReadArm(arm, state);
      ReadGrip(json, state);
      return state;
    }
  return std::nullopt;
}

std::string WriteHaplyForce(std::string_view deviceId, const glm::dvec3& forceN)
{
  if (!IsFinite(forceN))
    Refuse("a force must be finite");
  const Json values = { { "x", forceN.x }, { "y", -forceN.z }, { "z", forceN.y } };
  const Json command = { { "inverse3",
    Json::array({ { { "device_id", deviceId },
      { "commands", { { "set_cursor_force", { { "values", values } } } } } } }) } };
  try
  {
    return command.dump();
  }
  catch (const Json::exception&)
  {
    Refuse("device_id is no UTF-8");
  }
}

} // namespace hasp
