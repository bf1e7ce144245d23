#include "Planning/GuideRecipeJson.h"

#include "Planning/RecipeFormat.h"
#include "Planning/ValueChecks.h"

namespace hasp
{

namespace
{
constexpr const char* Subject = "guide recipe";
constexpr const char* Format = "hasp-guide-recipe-2";
constexpr const char* FirstFormat = "hasp-guide-recipe-1";

constexpr std::pair<GuideOutline, const char*> Outlines[] = { { GuideOutline::Open, "open" },
  { GuideOutline::Closed, "closed" }, { GuideOutline::Filled, "filled" } };

constexpr std::pair<GuideLabelKind, const char*> LabelKinds[] = { { GuideLabelKind::Text, "text" },
  { GuideLabelKind::Case, "case" } };

/// Everything that both formats have.
void ReadCommon(const StrictJson& top, GuideRecipe& r)
{
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
}

/// The first format: slots and holes without ends, boxes, sleeves and clearance; sharp edges.
GuideRecipe FromFirstFormat(const Json& json)
{
  const StrictJson top(json, Subject, "",
    { "format", "note", "isovalue", "landmarks", "outline", "withdrawal", "gapMm", "thicknessMm",
      "widthMm", "spacingMm", "ignoreBelowMm3", "slots", "holes" });
  constexpr double Through = 500.0;
  GuideRecipe r;
  ReadCommon(top, r);
  r.clearanceMm = 0.0; // widthMm had it
  r.edgeRadiusMm = 0.0;
  for (const Json& value : top.List("slots"))
  {
    const StrictJson slot(value, Subject, ListKey("slots", r.slots.size()),
      { "point", "normal", "widthMm", "lengthMm" });
    r.slots.push_back({ slot.Vector("point"), slot.Vector("normal"), slot.Number("widthMm"),
      slot.Number("lengthMm"), Through, 0.0 });
  }
  for (const Json& value : top.List("holes"))
  {
    const StrictJson hole(
      value, Subject, ListKey("holes", r.holes.size()), { "point", "axis", "diameterMm" });
    r.holes.push_back(
      { hole.Vector("point"), hole.Vector("axis"), hole.Number("diameterMm"), Through, 0.0 });
  }
  return r;
}

void ReadBlades(const StrictJson& top, GuideRecipe& r)
{
  for (const Json& value : top.List("slots"))
  {
    const StrictJson slot(value, Subject, ListKey("slots", r.slots.size()),
      { "point", "normal", "kerfMm", "lengthMm", "depthMm", "guidingHeightMm" });
    r.slots.push_back({ slot.Vector("point"), slot.Vector("normal"), slot.Number("kerfMm"),
      slot.Number("lengthMm"), slot.Number("depthMm"), slot.Number("guidingHeightMm") });
  }
  for (const Json& value : top.List("flanges"))
  {
    const StrictJson flange(value, Subject, ListKey("flanges", r.flanges.size()),
      { "point", "normal", "kerfMm", "lengthMm", "heightMm", "depthMm", "freeMm" });
    r.flanges.push_back({ flange.Vector("point"), flange.Vector("normal"), flange.Number("kerfMm"),
      flange.Number("lengthMm"), flange.Number("heightMm"), flange.Number("depthMm"),
      flange.Number("freeMm") });
  }
}

void ReadHolesAndLabels(const StrictJson& top, GuideRecipe& r)
{
  for (const Json& value : top.List("holes"))
  {
    const StrictJson hole(value, Subject, ListKey("holes", r.holes.size()),
      { "point", "axis", "diameterMm", "depthMm", "sleeveHeightMm" });
    r.holes.push_back({ hole.Vector("point"), hole.Vector("axis"), hole.Number("diameterMm"),
      hole.Number("depthMm"), hole.Number("sleeveHeightMm") });
  }
  for (const Json& value : top.List("labels"))
  {
    const StrictJson label(value, Subject, ListKey("labels", r.labels.size()),
      { "kind", "text", "point", "right", "heightMm", "depthMm", "engraved" });
    const GuideLabelKind kind =
      label.Has("kind") ? label.Named("kind", LabelKinds) : GuideLabelKind::Text;
    r.labels.push_back({ kind == GuideLabelKind::Case ? "" : label.Text("text"),
      label.Vector("point"), label.Vector("right"), label.Number("heightMm"),
      label.Number("depthMm"), label.Flag("engraved"), kind });
    if (kind == GuideLabelKind::Case && label.Has("text"))
      label.Fail(
        "text", "must not be there: what a label of the kind case says is told when it is made");
  }
}

GuideRecipe FromPresentFormat(const Json& json)
{
  const StrictJson top(json, Subject, "",
    { "format", "note", "isovalue", "landmarks", "outline", "strokes", "withdrawal",
      "axisSearchDeg", "gapMm", "thicknessMm", "widthMm", "edgeRadiusMm", "clearanceMm", "wallMm",
      "sleeveWallMm", "spacingMm", "ignoreBelowMm3", "slots", "flanges", "holes", "labels" });
  GuideRecipe r;
  ReadCommon(top, r);
  r.axisSearchDeg = top.Number("axisSearchDeg");
  r.edgeRadiusMm = top.Number("edgeRadiusMm");
  r.clearanceMm = top.Number("clearanceMm");
  r.wallMm = top.Number("wallMm");
  r.sleeveWallMm = top.Number("sleeveWallMm");
  for (const Json& value : top.List("strokes"))
  {
    const StrictJson stroke(
      value, Subject, ListKey("strokes", r.strokes.size()), { "points", "radiusMm", "erased" });
    r.strokes.push_back(
      { stroke.Vectors("points"), stroke.Number("radiusMm"), stroke.Flag("erased") });
  }
  ReadBlades(top, r);
  ReadHolesAndLabels(top, r);
  return r;
}

Json ToJson(const std::vector<glm::dvec3>& points)
{
  Json json = Json::array();
  for (const glm::dvec3& p : points)
    json.push_back(hasp::ToJson(p));
  return json;
}

template <typename Item, typename Write>
Json ListOf(const std::vector<Item>& items, const Write& write)
{
  Json json = Json::array();
  for (const Item& item : items)
    json.push_back(write(item));
  return json;
}
} // namespace

GuideRecipe GuideRecipeFromJson(const Json& json)
{
  CheckFormat(json, Subject, { Format, FirstFormat });
  const bool first = json.is_object() && json.contains("format") && json["format"] == FirstFormat;
  const GuideRecipe r = first ? FromFirstFormat(json) : FromPresentFormat(json);
  ValidateGuideRecipe(r);
  return r;
}

Json GuideRecipeToJson(const GuideRecipe& r)
{
  ValidateGuideRecipe(r);
  Json json = { { "format", Format } };
  if (!r.note.empty())
    json["note"] = r.note;
  json.update({ { "isovalue", r.isovalue }, { "landmarks", ToJson(r.landmarks) },
    { "outline", NameOf(r.outline, Outlines) } });
  json["strokes"] = ListOf(r.strokes,
    [](const GuideStroke& s) -> Json {
      return { { "points", ToJson(s.points) }, { "radiusMm", s.radiusMm }, { "erased", s.erased } };
    });
  json.update({ { "withdrawal", hasp::ToJson(r.withdrawal) }, { "axisSearchDeg", r.axisSearchDeg },
    { "gapMm", r.gapMm }, { "thicknessMm", r.thicknessMm }, { "widthMm", r.widthMm },
    { "edgeRadiusMm", r.edgeRadiusMm }, { "clearanceMm", r.clearanceMm }, { "wallMm", r.wallMm },
    { "sleeveWallMm", r.sleeveWallMm }, { "spacingMm", r.spacingMm },
    { "ignoreBelowMm3", r.ignoreBelowMm3 } });
  json["slots"] = ListOf(r.slots,
    [](const GuideSlot& s) -> Json
    {
      return { { "point", hasp::ToJson(s.point) }, { "normal", hasp::ToJson(s.normal) },
        { "kerfMm", s.kerfMm }, { "lengthMm", s.lengthMm }, { "depthMm", s.depthMm },
        { "guidingHeightMm", s.guidingHeightMm } };
    });
  json["flanges"] = ListOf(r.flanges,
    [](const GuideFlange& f) -> Json
    {
      return { { "point", hasp::ToJson(f.point) }, { "normal", hasp::ToJson(f.normal) },
        { "kerfMm", f.kerfMm }, { "lengthMm", f.lengthMm }, { "heightMm", f.heightMm },
        { "depthMm", f.depthMm }, { "freeMm", f.freeMm } };
    });
  json["holes"] = ListOf(r.holes,
    [](const GuideHole& h) -> Json
    {
      return { { "point", hasp::ToJson(h.point) }, { "axis", hasp::ToJson(h.axis) },
        { "diameterMm", h.diameterMm }, { "depthMm", h.depthMm },
        { "sleeveHeightMm", h.sleeveHeightMm } };
    });
  json["labels"] = ListOf(r.labels,
    [](const GuideLabel& l) -> Json
    {
      Json label = Json::object();
      if (l.kind == GuideLabelKind::Text)
        label["text"] = l.text;
      else
        label["kind"] = NameOf(l.kind, LabelKinds);
      label.update({ { "point", hasp::ToJson(l.point) }, { "right", hasp::ToJson(l.right) },
        { "heightMm", l.heightMm }, { "depthMm", l.depthMm }, { "engraved", l.engraved } });
      return label;
    });
  return json;
}

} // namespace hasp
