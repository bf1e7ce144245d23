#include "Planning/PlateRecipeFile.h"

#include "Planning/PlateRecipeJson.h"
#include "Planning/RecipeFormat.h"
#include "Planning/ValueChecks.h"

#include <algorithm>

namespace hasp
{

namespace
{
constexpr const char* Subject = "plate recipe";
constexpr const char* Format = "hasp-plate-recipe-1";

PlateScrew ScrewFromJson(const Json& value, std::size_t n)
{
  const StrictJson json(value, Subject, ListKey("screws", n),
    { "point", "axis", "diameterMm", "headDiameterMm", "headDepthMm", "headAngleDeg", "lengthMm" });
  PlateScrew screw;
  screw.point = json.Vector("point");
  if (json.Has("axis"))
    screw.axis = json.Vector("axis");
  screw.diameterMm = json.Number("diameterMm");
  screw.headDiameterMm = json.Number("headDiameterMm");
  screw.headDepthMm = json.Number("headDepthMm");
  screw.headAngleDeg = json.Number("headAngleDeg");
  screw.lengthMm = json.Number("lengthMm");
  return screw;
}

Json ScrewToJson(const PlateScrew& screw)
{
  Json json = { { "point", ToJson(screw.point) } };
  if (screw.axis)
    json["axis"] = ToJson(*screw.axis);
  json.update({ { "diameterMm", screw.diameterMm }, { "headDiameterMm", screw.headDiameterMm },
    { "headDepthMm", screw.headDepthMm }, { "headAngleDeg", screw.headAngleDeg },
    { "lengthMm", screw.lengthMm } });
  return json;
}

PlateFragment FragmentFromJson(const Json& value, std::size_t n)
{
  const StrictJson json(
    value, Subject, ListKey("fragments", n), { "label", "position", "orientation" });
  PlateFragment fragment;
  fragment.label = int(json.Count("label", 1, 65535));
  fragment.position = json.Vector("position");
  const Json& turn = json.Get("orientation");
  const auto isNumber = [](const Json& part) { return part.is_number(); };
  if (!turn.is_array() || turn.size() != 4 || !std::all_of(turn.begin(), turn.end(), isNumber))
    json.Fail("orientation", "must be four numbers: w, x, y, z");
  fragment.orientation = { turn[0].get<double>(), turn[1].get<double>(), turn[2].get<double>(),
    turn[3].get<double>() };
  return fragment;
}

Json FragmentToJson(const PlateFragment& fragment)
{
  const glm::dquat& turn = fragment.orientation;
  return { { "label", fragment.label }, { "position", ToJson(fragment.position) },
    { "orientation", { turn.w, turn.x, turn.y, turn.z } } };
}
} // namespace

PlateRecipe PlateRecipeFromJson(const Json& json)
{
  CheckFormat(json, Subject, { Format });
  const StrictJson top(json, Subject, "",
    { "format", "note", "isovalue", "ignoreBelowMm3", "landmarks", "gapMm", "thicknessMm",
      "widthMm", "bevelMm", "bridgeMm", "edgeDistanceMm", "holeDistanceMm", "spacingMm", "screws",
      "fragments" });
  PlateRecipe r;
  if (top.Has("note"))
    r.note = top.Text("note");
  r.isovalue = top.Number("isovalue");
  r.ignoreBelowMm3 = top.Number("ignoreBelowMm3");
  r.landmarks = top.Vectors("landmarks");
  r.gapMm = top.Number("gapMm");
  r.thicknessMm = top.Number("thicknessMm");
  r.widthMm = top.Number("widthMm");
  r.bevelMm = top.Number("bevelMm");
  r.bridgeMm = top.Number("bridgeMm");
  r.edgeDistanceMm = top.Number("edgeDistanceMm");
  r.holeDistanceMm = top.Number("holeDistanceMm");
  r.spacingMm = top.Number("spacingMm");
  for (const Json& value : top.List("screws"))
    r.screws.push_back(ScrewFromJson(value, r.screws.size()));
  for (const Json& value : top.List("fragments"))
    r.fragments.push_back(FragmentFromJson(value, r.fragments.size()));
  ValidatePlateRecipe(r);
  return r;
}

Json PlateRecipeToJson(const PlateRecipe& r)
{
  ValidatePlateRecipe(r);
  Json json = { { "format", Format } };
  if (!r.note.empty())
    json["note"] = r.note;
  json.update({ { "isovalue", r.isovalue }, { "ignoreBelowMm3", r.ignoreBelowMm3 },
    { "landmarks", Json::array() }, { "gapMm", r.gapMm }, { "thicknessMm", r.thicknessMm },
    { "widthMm", r.widthMm }, { "bevelMm", r.bevelMm }, { "bridgeMm", r.bridgeMm },
    { "edgeDistanceMm", r.edgeDistanceMm }, { "holeDistanceMm", r.holeDistanceMm },
    { "spacingMm", r.spacingMm }, { "screws", Json::array() }, { "fragments", Json::array() } });
  for (const glm::dvec3& p : r.landmarks)
    json["landmarks"].push_back(ToJson(p));
  for (const PlateScrew& screw : r.screws)
    json["screws"].push_back(ScrewToJson(screw));
  for (const PlateFragment& fragment : r.fragments)
    json["fragments"].push_back(FragmentToJson(fragment));
  return json;
}

PlateRecipe ParsePlateRecipe(const std::string& json)
{
  return ReadJson(json, Subject, PlateRecipeFromJson);
}

std::string FormatPlateRecipe(const PlateRecipe& recipe)
{
  return FormatJson(PlateRecipeToJson(recipe), Subject);
}

PlateRecipe ReadPlateRecipe(const std::string& path)
{
  return ParsePlateRecipe(ReadRecipeText(path, Subject));
}

} // namespace hasp
