#include "Planning/CutRecipeFile.h"

#include "Planning/CutRecipeJson.h"
#include "Planning/RecipeFormat.h"
#include "Planning/ValueChecks.h"

namespace hasp
{

namespace
{
constexpr const char* Subject = "cut recipe";
constexpr const char* Format = "hasp-cut-recipe-1";
} // namespace

CutRecipe CutRecipeFromJson(const Json& json)
{
  CheckFormat(json, Subject, { Format });
  const StrictJson top(json, Subject, "",
    { "format", "isovalue", "spacingMm", "ignoreBelowMm3", "crumbBelowMm3", "cuts", "resected" });
  CutRecipe r;
  r.isovalue = top.Number("isovalue");
  r.spacingMm = top.Number("spacingMm");
  r.ignoreBelowMm3 = top.Number("ignoreBelowMm3");
  r.crumbBelowMm3 = top.Number("crumbBelowMm3");
  for (const Json& value : top.List("cuts"))
  {
    const StrictJson cut(value, Subject, ListKey("cuts", r.cuts.size()),
      { "point", "normal", "along", "widthMm", "depthMm", "kerfMm", "reachMm" });
    r.cuts.push_back({ { cut.Vector("point"), cut.Vector("normal"), cut.Vector("along"),
                         cut.Number("widthMm"), cut.Number("depthMm"), cut.Number("kerfMm") },
      cut.Number("reachMm") });
  }
  r.resected = top.Vectors("resected");
  ValidateCutRecipe(r);
  return r;
}

Json CutRecipeToJson(const CutRecipe& r)
{
  ValidateCutRecipe(r);
  Json json = { { "format", Format }, { "isovalue", r.isovalue }, { "spacingMm", r.spacingMm },
    { "ignoreBelowMm3", r.ignoreBelowMm3 }, { "crumbBelowMm3", r.crumbBelowMm3 },
    { "cuts", Json::array() }, { "resected", Json::array() } };
  for (const BoneCut& cut : r.cuts)
  {
    const Osteotomy& blade = cut.blade;
    json["cuts"].push_back({ { "point", ToJson(blade.point) }, { "normal", ToJson(blade.normal) },
      { "along", ToJson(blade.along) }, { "widthMm", blade.widthMm }, { "depthMm", blade.depthMm },
      { "kerfMm", blade.kerfMm }, { "reachMm", cut.reachMm } });
  }
  for (const glm::dvec3& point : r.resected)
    json["resected"].push_back(ToJson(point));
  return json;
}

CutRecipe ParseCutRecipe(const std::string& text)
{
  return ReadJson(text, Subject, CutRecipeFromJson);
}

std::string FormatCutRecipe(const CutRecipe& recipe)
{
  return FormatJson(CutRecipeToJson(recipe), Subject);
}

CutRecipe ReadCutRecipe(const std::string& path)
{
  return ParseCutRecipe(ReadRecipeText(path, Subject));
}

} // namespace hasp
