#include "Planning/GuideRecipeFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
using Json = nlohmann::ordered_json;
constexpr const char* Format = "hasp-guide-recipe-1";

/// One object of the file: every key is asked for once, unknown ones are refused. Errors say our
/// own keys and no text of the file: it may name a patient.
class Object
{
public:
  Object(const Json& json, std::string name, std::initializer_list<const char*> keys)
    : Members(json),
      Name(std::move(name))
  {
    if (!json.is_object())
      this->Fail("", "must be an object");
    int number = 0;
    for (const auto& [key, value] : json.items())
      if (++number; std::none_of(keys.begin(), keys.end(), [&](const char* k) { return key == k; }))
        this->Fail("key " + std::to_string(number), "is unknown; mend its spelling or take it out");
  }

  const Json& Get(const char* key) const
  {
    const auto found = this->Members.find(key);
    if (found == this->Members.end())
      this->Fail(key, "is missing");
    return *found;
  }
  double Number(const char* key) const { return this->AsNumber(key, this->Get(key)); }
  std::string Text(const char* key) const
  {
    const Json& value = this->Get(key);
    if (!value.is_string())
      this->Fail(key, "must be text");
    return value.get<std::string>();
  }
  glm::dvec3 Vector(const char* key) const { return this->AsVector(key, this->Get(key)); }
  std::vector<glm::dvec3> Vectors(const char* key) const
  {
    std::vector<glm::dvec3> vectors;
    for (const Json& value : this->List(key))
      vectors.push_back(
        this->AsVector(std::string(key) + "[" + std::to_string(vectors.size()) + "]", value));
    return vectors;
  }
  const Json& List(const char* key) const
  {
    const Json& value = this->Get(key);
    if (!value.is_array())
      this->Fail(key, "must be a list");
    return value;
  }
  [[noreturn]] void Fail(const std::string& key, const std::string& text) const
  {
    throw std::invalid_argument("guide recipe: " + this->Name + key + " " + text);
  }

private:
  double AsNumber(const std::string& key, const Json& value) const
  {
    if (!value.is_number())
      this->Fail(key, "must be a number");
    return value.get<double>();
  }
  glm::dvec3 AsVector(const std::string& key, const Json& value) const
  {
    if (!value.is_array() || value.size() != 3)
      this->Fail(key, "must be three numbers");
    return { this->AsNumber(key, value[0]), this->AsNumber(key, value[1]),
      this->AsNumber(key, value[2]) };
  }

  const Json& Members;
  std::string Name;
};

struct OutlineName
{
  GuideOutline outline;
  const char* name;
};
constexpr OutlineName Outlines[] = { { GuideOutline::Open, "open" },
  { GuideOutline::Closed, "closed" }, { GuideOutline::Filled, "filled" } };

std::string Item(const char* list, std::size_t n)
{
  return std::string(list) + "[" + std::to_string(n) + "].";
}

Json ToJson(const glm::dvec3& v)
{
  return { v.x, v.y, v.z };
}

GuideRecipe FromJson(const Json& json)
{
  const Object top(json, "",
    { "format", "note", "isovalue", "landmarks", "outline", "withdrawal", "gapMm", "thicknessMm",
      "widthMm", "spacingMm", "ignoreBelowMm3", "slots", "holes" });
  if (top.Text("format") != Format)
    top.Fail("format", std::string("is of another kind, must be '") + Format + "'");
  GuideRecipe r;
  if (json.contains("note"))
    r.note = top.Text("note");
  r.isovalue = top.Number("isovalue");
  r.landmarks = top.Vectors("landmarks");
  const std::string outline = top.Text("outline");
  const auto* named = std::find_if(std::begin(Outlines), std::end(Outlines),
    [&](const OutlineName& o) { return outline == o.name; });
  if (named == std::end(Outlines))
    top.Fail("outline", "must be open, closed or filled");
  r.outline = named->outline;
  r.withdrawal = top.Vector("withdrawal");
  r.gapMm = top.Number("gapMm");
  r.thicknessMm = top.Number("thicknessMm");
  r.widthMm = top.Number("widthMm");
  r.spacingMm = top.Number("spacingMm");
  r.ignoreBelowMm3 = top.Number("ignoreBelowMm3");
  for (const Json& value : top.List("slots"))
  {
    const Object slot(
      value, Item("slots", r.slots.size()), { "point", "normal", "widthMm", "lengthMm" });
    r.slots.push_back({ slot.Vector("point"), slot.Vector("normal"), slot.Number("widthMm"),
      slot.Number("lengthMm") });
  }
  for (const Json& value : top.List("holes"))
  {
    const Object hole(value, Item("holes", r.holes.size()), { "point", "axis", "diameterMm" });
    r.holes.push_back({ hole.Vector("point"), hole.Vector("axis"), hole.Number("diameterMm") });
  }
  ValidateGuideRecipe(r);
  return r;
}
} // namespace

GuideRecipe ParseGuideRecipe(const std::string& json)
{
  Json parsed;
  try
  {
    parsed = Json::parse(json);
  }
  catch (const Json::parse_error& error) // its text quotes the file
  {
    throw std::runtime_error(
      "guide recipe: no JSON: a mistake at byte " + std::to_string(error.byte));
  }
  catch (const Json::exception&)
  {
    throw std::runtime_error("guide recipe: no JSON: a number is too large for any double");
  }
  return FromJson(parsed);
}

std::string FormatGuideRecipe(const GuideRecipe& r)
{
  ValidateGuideRecipe(r);
  Json json = { { "format", Format } };
  if (!r.note.empty())
    json["note"] = r.note;
  json["isovalue"] = r.isovalue;
  json["landmarks"] = Json::array();
  for (const glm::dvec3& p : r.landmarks)
    json["landmarks"].push_back(ToJson(p));
  json["outline"] = Outlines[static_cast<int>(r.outline)].name;
  json["withdrawal"] = ToJson(r.withdrawal);
  json["gapMm"] = r.gapMm;
  json["thicknessMm"] = r.thicknessMm;
  json["widthMm"] = r.widthMm;
  json["spacingMm"] = r.spacingMm;
  json["ignoreBelowMm3"] = r.ignoreBelowMm3;
  json["slots"] = Json::array();
  for (const GuideSlot& s : r.slots)
    json["slots"].push_back({ { "point", ToJson(s.point) }, { "normal", ToJson(s.normal) },
      { "widthMm", s.widthMm }, { "lengthMm", s.lengthMm } });
  json["holes"] = Json::array();
  for (const GuideHole& h : r.holes)
    json["holes"].push_back(
      { { "point", ToJson(h.point) }, { "axis", ToJson(h.axis) }, { "diameterMm", h.diameterMm } });
  return json.dump(2) + "\n";
}

GuideRecipe ReadGuideRecipe(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file)
    throw std::runtime_error("guide recipe: the file cannot be read");
  return ParseGuideRecipe(text.str());
}

void WriteGuideRecipe(const std::string& path, const GuideRecipe& recipe)
{
  const std::string text = FormatGuideRecipe(recipe), temporary = path + ".part";
  {
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file << text;
    if (!file.flush())
    {
      std::remove(temporary.c_str());
      throw std::runtime_error("guide recipe: the file cannot be written");
    }
  }
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error)
  {
    std::remove(temporary.c_str());
    throw std::runtime_error("guide recipe: the file cannot be put in place: " + error.message());
  }
}

} // namespace hasp
