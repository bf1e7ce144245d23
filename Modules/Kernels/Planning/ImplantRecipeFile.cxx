#include "Planning/ImplantRecipeFile.h"

#include "Planning/ImplantRecipeJson.h"
#include "Planning/RecipeFormat.h"

namespace hasp
{

namespace
{
constexpr const char* Subject = "implant recipe";
constexpr const char* Format = "hasp-implant-recipe-1";

struct NumberKey
{
  const char* key;
  double ImplantRecipe::*member;
};
constexpr NumberKey Numbers[] = { { "isovalue", &ImplantRecipe::isovalue },
  { "ignoreBelowMm3", &ImplantRecipe::ignoreBelowMm3 },
  { "clearanceMm", &ImplantRecipe::clearanceMm }, { "thicknessMm", &ImplantRecipe::thicknessMm },
  { "spacingMm", &ImplantRecipe::spacingMm }, { "holeDiameterMm", &ImplantRecipe::holeDiameterMm },
  { "holePitchMm", &ImplantRecipe::holePitchMm }, { "holeEdgeMm", &ImplantRecipe::holeEdgeMm } };
} // namespace

ImplantRecipe ImplantRecipeFromJson(const Json& json)
{
  CheckFormat(json, Subject, { Format });
  const StrictJson top(json, Subject, "",
    { "format", "note", "isovalue", "ignoreBelowMm3", "mirror", "outline", "axis", "clearanceMm",
      "thicknessMm", "spacingMm", "holeDiameterMm", "holePitchMm", "holeEdgeMm" });
  ImplantRecipe r;
  if (top.Has("note"))
    r.note = top.Text("note");
  if (top.Has("mirror"))
  {
    const StrictJson mirror(top.Get("mirror"), Subject, "mirror", { "point", "normal" });
    r.mirror = MirrorPlane{ mirror.Vector("point"), mirror.Vector("normal") };
  }
  if (top.Has("axis"))
    r.axis = top.Vector("axis");
  r.outline = top.Vectors("outline");
  for (const NumberKey& number : Numbers)
    r.*number.member = top.Number(number.key);
  ValidateImplantRecipe(r);
  return r;
}

Json ImplantRecipeToJson(const ImplantRecipe& r)
{
  ValidateImplantRecipe(r);
  Json json = { { "format", Format } };
  if (!r.note.empty())
    json["note"] = r.note;
  if (r.mirror)
    json["mirror"] = { { "point", ToJson(r.mirror->point) },
      { "normal", ToJson(r.mirror->normal) } };
  json["outline"] = Json::array();
  for (const glm::dvec3& p : r.outline)
    json["outline"].push_back(ToJson(p));
  if (r.axis)
    json["axis"] = ToJson(*r.axis);
  for (const NumberKey& number : Numbers)
    json[number.key] = r.*number.member;
  return json;
}

ImplantRecipe ParseImplantRecipe(const std::string& json)
{
  return ReadJson(json, Subject, ImplantRecipeFromJson);
}

std::string FormatImplantRecipe(const ImplantRecipe& recipe)
{
  return FormatJson(ImplantRecipeToJson(recipe), Subject);
}

ImplantRecipe ReadImplantRecipe(const std::string& path)
{
  return ParseImplantRecipe(ReadRecipeText(path, Subject));
}

} // namespace hasp
