#include "LensFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hasp
{
namespace
{
using Json = nlohmann::json;

constexpr std::array Keys{ "format", "note", "coefficients", "leftCenter", "rightCenter",
  "colorScale" };

[[noreturn]] void Fail(const std::string& key, const std::string& text)
{
  throw std::invalid_argument("lens file: " + key + " " + text);
}

const Json& Get(const Json& json, const char* key)
{
  const auto found = json.find(key);
  if (found == json.end())
    Fail(key,
      "is missing; format, coefficients, leftCenter, rightCenter and colorScale must be there");
  return *found;
}

template <int Count>
glm::vec<Count, double> Numbers(const Json& json, const char* key)
{
  const Json& list = Get(json, key);
  const std::string count = std::to_string(Count);
  if (!list.is_array() || list.size() != Count)
    Fail(key, "must be " + count + " numbers");
  glm::vec<Count, double> numbers;
  for (int n = 0; n < Count; ++n)
  {
    if (!list[n].is_number())
      Fail(key, "must be " + count + " numbers");
    numbers[n] = list[n].template get<double>();
  }
  return numbers;
}

} // namespace

LensModel ParseLens(const std::string& text)
{
  Json json;
  try
  {
    json = Json::parse(text);
  }
  catch (const Json::parse_error& error) // its text quotes the file
  {
    throw std::runtime_error("lens file: no JSON: a mistake at byte " + std::to_string(error.byte));
  }
  catch (const Json::exception&)
  {
    throw std::runtime_error("lens file: no JSON: a number is too large for any double");
  }
  if (!json.is_object())
    Fail("all of it", "must be an object");
  int number = 0;
  for (const auto& [key, value] : json.items())
    if (++number; std::none_of(Keys.begin(), Keys.end(), [&](const char* k) { return key == k; }))
      Fail("key " + std::to_string(number) + " in alphabetical order",
        "is unknown; known are format, note, coefficients, leftCenter, rightCenter, colorScale");
  const Json& format = Get(json, "format");
  if (!format.is_string() || format != "hasp-lens-1")
    Fail("format", "is of another kind, must be 'hasp-lens-1'");
  if (json.contains("note") && !json["note"].is_string())
    Fail("note", "must be text");
  LensModel lens;
  lens.coefficients = Numbers<3>(json, "coefficients");
  lens.centers = { Numbers<2>(json, "leftCenter"), Numbers<2>(json, "rightCenter") };
  lens.colorScale = Numbers<3>(json, "colorScale");
  for (int n = 0; n < 3; ++n)
    if (!(lens.colorScale[n] > 0.0))
      Fail("colorScale", "has " + std::to_string(lens.colorScale[n]) + ", must be > 0");
  return lens;
}

LensModel ReadLens(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file)
    throw std::runtime_error("lens file: the file cannot be read");
  return ParseLens(text.str());
}

} // namespace hasp
