#include "Devices/TrackerCalibration.h"

#include <nlohmann/json.hpp>

#include <array>
#include <stdexcept>

namespace hasp
{

namespace
{
using Json = nlohmann::ordered_json;
constexpr const char* Format = "hasp-tracker-calibration-1";
constexpr const char* Keys[] = { "format", "trackerToRoom", "trackerInRoomMm", "eyesInMarkerMm",
  "headToMarker" };

/// Errors say our own keys and no text of the file.
[[noreturn]] void Refuse(const std::string& why)
{
  throw std::invalid_argument("tracker calibration: " + why);
}

template <std::size_t Size>
std::array<double, Size> Numbers(const Json& json, const char* key)
{
  std::array<double, Size> numbers{};
  const Json& list = json.at(key);
  if (!list.is_array() || list.size() != Size)
    Refuse(std::string(key) + " must be " + std::to_string(Size) + " numbers");
  for (std::size_t n = 0; n < Size; ++n)
  {
    if (!list[n].is_number())
      Refuse(std::string(key) + " must be " + std::to_string(Size) + " numbers");
    numbers[n] = list[n].get<double>();
  }
  return numbers;
}

glm::dvec3 Vector(const Json& json, const char* key)
{
  const auto v = Numbers<3>(json, key);
  return { v[0], v[1], v[2] };
}

glm::dquat Quaternion(const Json& json, const char* key)
{
  const auto q = Numbers<4>(json, key);
  return { q[0], q[1], q[2], q[3] };
}
} // namespace

TrackerCalibration ParseTrackerCalibration(const std::string& text)
{
  Json json;
  try
  {
    json = Json::parse(text);
  }
  catch (const Json::parse_error& error) // its text quotes the file
  {
    throw std::runtime_error(
      "tracker calibration: no JSON: a mistake at byte " + std::to_string(error.byte));
  }
  catch (const Json::exception&)
  {
    throw std::runtime_error("tracker calibration: no JSON: a number is too large for any double");
  }
  if (!json.is_object())
    Refuse("must be an object");
  for (const char* key : Keys)
    if (!json.contains(key))
      Refuse(std::string(key) + " is missing");
  if (json.size() != std::size(Keys))
    Refuse("there are " + std::to_string(json.size()) + " keys, must be " +
           std::to_string(std::size(Keys)) + "; take the others out");
  if (json["format"] != Format)
    Refuse(std::string("format is of another kind, must be '") + Format + "'");
  const TrackerCalibration calibration{ Quaternion(json, "trackerToRoom"),
    Vector(json, "trackerInRoomMm"), Vector(json, "eyesInMarkerMm"),
    Quaternion(json, "headToMarker") };
  ValidateTrackerCalibration(calibration);
  return calibration;
}

std::string FormatTrackerCalibration(const TrackerCalibration& c)
{
  ValidateTrackerCalibration(c);
  const auto list = [](const glm::dvec3& v) { return Json{ v.x, v.y, v.z }; };
  const auto turn = [](const glm::dquat& q) { return Json{ q.w, q.x, q.y, q.z }; };
  const Json json = { { "format", Format }, { "trackerToRoom", turn(c.trackerToRoom) },
    { "trackerInRoomMm", list(c.trackerInRoomMm) }, { "eyesInMarkerMm", list(c.eyesInMarkerMm) },
    { "headToMarker", turn(c.headToMarker) } };
  return json.dump(2) + "\n";
}

} // namespace hasp
