#include "Planning/TransplantJson.h"

#include "Planning/RecipeFormat.h"
#include "Planning/ValueChecks.h"

namespace hasp
{

namespace
{
constexpr const char* Subject = "transplant";
constexpr const char* Format = "hasp-transplant-1";

Json ToJson(const std::vector<glm::dvec3>& points)
{
  Json json = Json::array();
  for (const glm::dvec3& p : points)
    json.push_back(hasp::ToJson(p));
  return json;
}
} // namespace

Json TransplantToJson(const Transplant& t)
{
  ValidateTransplant(t);
  Json joints = Json::array();
  for (const TransplantJoint& joint : t.joints)
    joints.push_back(
      { { "point", hasp::ToJson(joint.point) }, { "normal", hasp::ToJson(joint.normal) } });
  Json json = { { "format", Format }, { "joints", std::move(joints) },
    { "outward", ToJson(t.outward) },
    { "donor", { { "axis", ToJson(t.donor.axis) }, { "lateral", hasp::ToJson(t.donor.lateral) },
                 { "radiusMm", t.donor.radiusMm }, { "keepMm", t.donor.keepMm } } },
    { "fromLastTip", t.fromLastTip }, { "startOffsetMm", t.startOffsetMm }, { "kerfMm", t.kerfMm },
    { "betweenMm", t.betweenMm }, { "vessel", ToJson(t.vessel) } };
  if (t.paddle)
    json["paddle"] = { { "outline", ToJson(t.paddle->outline) },
      { "perforator", hasp::ToJson(t.paddle->perforator) } };
  return json;
}

Transplant TransplantFromJson(const Json& json)
{
  CheckFormat(json, Subject, { Format });
  const StrictJson top(json, Subject, "",
    { "format", "joints", "outward", "donor", "fromLastTip", "startOffsetMm", "kerfMm", "betweenMm",
      "vessel", "paddle" });
  Transplant t;
  for (const Json& value : top.List("joints"))
  {
    const StrictJson joint(
      value, Subject, ListKey("joints", t.joints.size()), { "point", "normal" });
    t.joints.push_back({ joint.Vector("point"), joint.Vector("normal") });
  }
  t.outward = top.Vectors("outward");
  const StrictJson donor(
    top.Get("donor"), Subject, "donor", { "axis", "lateral", "radiusMm", "keepMm" });
  t.donor = { donor.Vectors("axis"), donor.Vector("lateral"), donor.Number("radiusMm"),
    donor.Number("keepMm") };
  t.fromLastTip = top.Flag("fromLastTip");
  t.startOffsetMm = top.Number("startOffsetMm");
  t.kerfMm = top.Number("kerfMm");
  t.betweenMm = top.Number("betweenMm");
  t.vessel = top.Vectors("vessel");
  if (top.Has("paddle"))
  {
    const StrictJson paddle(top.Get("paddle"), Subject, "paddle", { "outline", "perforator" });
    t.paddle = SkinPaddle{ paddle.Vectors("outline"), paddle.Vector("perforator") };
  }
  ValidateTransplant(t);
  return t;
}

} // namespace hasp
