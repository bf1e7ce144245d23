#include "Planning/GuideRecipeFile.h"

#include "Planning/GuideRecipeJson.h"
#include "Planning/ValueChecks.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr const char* Subject = "guide recipe";
constexpr const char* Format = "hasp-guide-recipe-1";

constexpr std::pair<GuideOutline, const char*> Outlines[] = { { GuideOutline::Open, "open" },
  { GuideOutline::Closed, "closed" }, { GuideOutline::Filled, "filled" } };
} // namespace

GuideRecipe GuideRecipeFromJson(const Json& json)
{
  const StrictJson top(json, Subject, "",
    { "format", "note", "isovalue", "landmarks", "outline", "withdrawal", "gapMm", "thicknessMm",
      "widthMm", "spacingMm", "ignoreBelowMm3", "slots", "holes" });
  if (top.Text("format") != Format)
    top.Fail("format", std::string("is of another kind, must be '") + Format + "'");
  GuideRecipe r;
  if (top.Has("note"))
    r.note = top.Text("note");
  r.isovalue = top.Number("isovalue");
  r.landmarks = top.Vectors("landmarks");
  r.outline = top.Named("outline", Outlines);
  r.withdrawal = top.Vector("withdrawal");
  r.gapMm = top.Number("gapMm");
  r.thicknessMm = top.Number("thicknessMm");
  r.widthMm = top.Number("widthMm");
  r.spacingMm = top.Number("spacingMm");
  r.ignoreBelowMm3 = top.Number("ignoreBelowMm3");
  for (const Json& value : top.List("slots"))
  {
    const StrictJson slot(value, Subject, ListKey("slots", r.slots.size()),
      { "point", "normal", "widthMm", "lengthMm" });
    r.slots.push_back({ slot.Vector("point"), slot.Vector("normal"), slot.Number("widthMm"),
      slot.Number("lengthMm") });
  }
  for (const Json& value : top.List("holes"))
  {
    const StrictJson hole(
      value, Subject, ListKey("holes", r.holes.size()), { "point", "axis", "diameterMm" });
    r.holes.push_back({ hole.Vector("point"), hole.Vector("axis"), hole.Number("diameterMm") });
  }
  ValidateGuideRecipe(r);
  return r;
}
Json GuideRecipeToJson(const GuideRecipe& r)
{
  ValidateGuideRecipe(r);
  Json json = { { "format", Format } };
  if (!r.note.empty())
    json["note"] = r.note;
  json["isovalue"] = r.isovalue;
  json["landmarks"] = Json::array();
  for (const glm::dvec3& p : r.landmarks)
    json["landmarks"].push_back(ToJson(p));
  json["outline"] = NameOf(r.outline, Outlines);
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
  return json;
}

GuideRecipe ParseGuideRecipe(const std::string& json)
{
  return GuideRecipeFromJson(ParseJson(json, Subject));
}

std::string FormatGuideRecipe(const GuideRecipe& recipe)
{
  return FormatJson(GuideRecipeToJson(recipe), Subject);
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
