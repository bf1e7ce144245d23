#include "Planning/TransplantRecipeFile.h"

#include "Planning/CutRecipeJson.h"
#include "Planning/MitreGuideJson.h"
#include "Planning/RecipeFormat.h"

namespace hasp
{

namespace
{
constexpr const char* Subject = "transplant recipe";
constexpr const char* Format = "hasp-transplant-recipe-1";

Json PointsToJson(const std::vector<glm::dvec3>& points)
{
  Json json = Json::array();
  for (const glm::dvec3& point : points)
    json.push_back(ToJson(point));
  return json;
}

void DonorFromJson(const Json& value, TransplantRecipe& r)
{
  const StrictJson json(value, Subject, "donor",
    { "isovalue", "axis", "findAxis", "lateral", "radiusMm", "keepMm", "fromLastTip",
      "startOffsetMm", "kerfMm", "betweenMm", "vessel", "paddle" });
  r.donorIsovalue = json.Number("isovalue");
  r.donor.axis = json.Vectors("axis");
  r.findAxis = json.Flag("findAxis");
  r.donor.lateral = json.Vector("lateral");
  r.donor.radiusMm = json.Number("radiusMm");
  r.donor.keepMm = json.Number("keepMm");
  r.fromLastTip = json.Flag("fromLastTip");
  r.startOffsetMm = json.Number("startOffsetMm");
  r.kerfMm = json.Number("kerfMm");
  r.betweenMm = json.Number("betweenMm");
  r.vessel = json.Vectors("vessel");
  if (!json.Has("paddle"))
    return;
  const StrictJson paddle(json.Get("paddle"), Subject, "donor.paddle", { "outline", "perforator" });
  r.paddle = SkinPaddle{ paddle.Vectors("outline"), paddle.Vector("perforator") };
}

Json DonorToJson(const TransplantRecipe& r)
{
  Json json = { { "isovalue", r.donorIsovalue }, { "axis", PointsToJson(r.donor.axis) },
    { "findAxis", r.findAxis }, { "lateral", ToJson(r.donor.lateral) },
    { "radiusMm", r.donor.radiusMm }, { "keepMm", r.donor.keepMm },
    { "fromLastTip", r.fromLastTip }, { "startOffsetMm", r.startOffsetMm }, { "kerfMm", r.kerfMm },
    { "betweenMm", r.betweenMm }, { "vessel", PointsToJson(r.vessel) } };
  if (r.paddle)
    json["paddle"] = { { "outline", PointsToJson(r.paddle->outline) },
      { "perforator", ToJson(r.paddle->perforator) } };
  return json;
}

TransplantRecipe RecipeFromJson(const Json& json)
{
  CheckFormat(json, Subject, { Format });
  const StrictJson top(json, Subject, "",
    { "format", "resection", "path", "outward", "rollDeg", "leastSegmentMm", "mostGapMm",
      "mostOverlapMm", "donor", "guide" });
  TransplantRecipe r;
  r.resection = CutRecipeFromJson(top.Get("resection"));
  r.path = top.Vectors("path");
  r.outward = top.Vectors("outward");
  r.rollDeg = top.Number("rollDeg");
  r.leastSegmentMm = top.Number("leastSegmentMm");
  r.mostGapMm = top.Number("mostGapMm");
  r.mostOverlapMm = top.Number("mostOverlapMm");
  DonorFromJson(top.Get("donor"), r);
  r.guide = MitreGuideFromJson(top.Get("guide"), Subject, "guide");
  ValidateTransplantRecipe(r);
  return r;
}
} // namespace

TransplantRecipe ParseTransplantRecipe(const std::string& text)
{
  return ReadJson(text, Subject, RecipeFromJson);
}

std::string FormatTransplantRecipe(const TransplantRecipe& r)
{
  ValidateTransplantRecipe(r);
  return FormatJson({ { "format", Format }, { "resection", CutRecipeToJson(r.resection) },
                      { "path", PointsToJson(r.path) }, { "outward", PointsToJson(r.outward) },
                      { "rollDeg", r.rollDeg }, { "leastSegmentMm", r.leastSegmentMm },
                      { "mostGapMm", r.mostGapMm }, { "mostOverlapMm", r.mostOverlapMm },
                      { "donor", DonorToJson(r) }, { "guide", MitreGuideToJson(r.guide) } },
    Subject);
}

TransplantRecipe ReadTransplantRecipe(const std::string& path)
{
  return ParseTransplantRecipe(ReadRecipeText(path, Subject));
}

} // namespace hasp
