#include "Planning/PlanJson.h"

#include "Planning/GuideRecipeJson.h"
#include "Planning/ImplantRecipeJson.h"
#include "Planning/MitreGuideJson.h"
#include "Planning/PlanLists.h"
#include "Planning/PlateRecipeJson.h"
#include "Planning/SegmentationJson.h"
#include "Planning/TransplantJson.h"
#include "Planning/ValueChecks.h"

#include <stdexcept>

namespace hasp
{

namespace
{
constexpr std::pair<MeasureKind, const char*> MeasureKinds[] = {
  { MeasureKind::Distance, "distance" }, { MeasureKind::Angle, "angle" }
};
constexpr std::pair<BodySide, const char*> BodySides[] = { { BodySide::None, "none" },
  { BodySide::Left, "left" }, { BodySide::Right, "right" } };

constexpr std::pair<SheetSide, const char*> SheetSides[] = { { SheetSide::Behind, "behind" },
  { SheetSide::Both, "both" } };

StrictJson Read(const Json& json, const std::string& name, std::initializer_list<const char*> keys)
{
  return StrictJson(json, "plan", name, keys);
}

PlanId ReadId(const StrictJson& object, const char* key, PlanId least = 1)
{
  return static_cast<PlanId>(object.Count(key, least, MaxPlanId));
}

std::vector<PlanId> ReadIds(const StrictJson& object, const char* key)
{
  return object.Counts(key, 1, MaxPlanId);
}

struct SourceToJson
{
  Json operator()(const LabelSource& source) const
  {
    return { { "segmentation", source.segmentation }, { "label", source.label },
      { "isovalue", source.isovalue }, { "spacingMm", source.spacingMm } };
  }
  Json operator()(const ComponentSource& source) const
  {
    return { { "volume", source.volume }, { "isovalue", source.isovalue },
      { "seed", ToJson(source.seed) }, { "spacingMm", source.spacingMm } };
  }
  Json operator()(const PieceSource& source) const
  {
    return { { "fragment", source.fragment }, { "seed", ToJson(source.seed) } };
  }
  Json operator()(const SurfaceSource& source) const
  {
    return { { "surface", source.surface }, { "thicknessMm", source.thicknessMm },
      { "side", NameOf(source.side, SheetSides) }, { "spacingMm", source.spacingMm } };
  }
};

FragmentSource ReadSource(const Json& json, const std::string& name)
{
  if (json.contains("surface"))
  {
    const StrictJson source = Read(json, name, { "surface", "thicknessMm", "side", "spacingMm" });
    return SurfaceSource{ ReadId(source, "surface"), source.Number("thicknessMm"),
      source.Named("side", SheetSides), source.Number("spacingMm") };
  }
  if (json.contains("segmentation"))
  {
    const StrictJson source =
      Read(json, name, { "segmentation", "label", "isovalue", "spacingMm" });
    return LabelSource{ ReadId(source, "segmentation"),
      static_cast<std::uint32_t>(source.Count("label", 1, 65535)), source.Number("isovalue"),
      source.Number("spacingMm") };
  }
  if (json.contains("fragment"))
  {
    const StrictJson source = Read(json, name, { "fragment", "seed" });
    return PieceSource{ ReadId(source, "fragment"), source.Vector("seed") };
  }
  const StrictJson source = Read(json, name, { "volume", "isovalue", "seed", "spacingMm" });
  return ComponentSource{ ReadId(source, "volume"), source.Number("isovalue"),
    source.Vector("seed"), source.Number("spacingMm") };
}

Osteotomy ReadBlade(const Json& json, const std::string& name)
{
  const StrictJson blade =
    Read(json, name, { "point", "normal", "along", "widthMm", "depthMm", "kerfMm" });
  return { blade.Vector("point"), blade.Vector("normal"), blade.Vector("along"),
    blade.Number("widthMm"), blade.Number("depthMm"), blade.Number("kerfMm") };
}

/// What one of the recipes' readers makes of a member. They say the recipe's key and not where the
/// recipe is.
template <typename Recipe>
Recipe ReadRecipe(const StrictJson& object, const char* key, Recipe (*read)(const Json&))
{
  try
  {
    return read(object.Get(key));
  }
  catch (const std::invalid_argument& error)
  {
    object.Fail(key, std::string("is refused: ") + error.what());
  }
}

Json FaceToJson(const JawFace& face)
{
  return { { "cut", face.cut }, { "fragment", face.fragment } };
}

JawFace ReadFace(const Json& json, const std::string& name)
{
  const StrictJson face = Read(json, name, { "cut", "fragment" });
  return { ReadId(face, "cut", 0), ReadId(face, "fragment", 0) };
}
} // namespace

Json PoseToJson(const PlanPose& pose)
{
  const glm::dquat& q = pose.orientation;
  return { { "position", ToJson(pose.position) }, { "orientation", { q.w, q.x, q.y, q.z } } };
}

PlanPose PoseFromJson(const Json& json, const std::string& name)
{
  const StrictJson pose = Read(json, name, { "position", "orientation" });
  const std::vector<double> q = pose.Numbers("orientation", 4);
  return { pose.Vector("position"), { q[0], q[1], q[2], q[3] } };
}

Json ObjectToJson(const PlanVolume& object)
{
  return { { "id", object.id }, { "name", object.name }, { "hash", object.hash } };
}

void ReadObject(const Json& json, const std::string& name, PlanVolume& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "hash" });
  object = { ReadId(read, "id"), read.Text("name"), read.Text("hash") };
}

Json ObjectToJson(const PlanSegmentation& object)
{
  return { { "id", object.id }, { "name", object.name }, { "volume", object.volume },
    { "labels", object.labels }, { "recipe", SegmentationRecipeToJson(object.recipe) } };
}

void ReadObject(const Json& json, const std::string& name, PlanSegmentation& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "volume", "labels", "recipe" });
  object = { ReadId(read, "id"), read.Text("name"), ReadId(read, "volume"), read.Text("labels"),
    ReadRecipe(read, "recipe", SegmentationRecipeFromJson) };
}

Json ObjectToJson(const PlanSurface& object)
{
  return { { "id", object.id }, { "name", object.name }, { "hash", object.hash } };
}

void ReadObject(const Json& json, const std::string& name, PlanSurface& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "hash" });
  object = { ReadId(read, "id"), read.Text("name"), read.Text("hash") };
}

Json ObjectToJson(const PlanFragment& object)
{
  return { { "id", object.id }, { "name", object.name },
    { "source", std::visit(SourceToJson{}, object.source) },
    { "colour", ColourText(object.colour) }, { "state", NameOf(object.state, FragmentStates) },
    { "scanToPlanned", PoseToJson(object.scanToPlanned) }, { "locked", object.locked } };
}

void ReadObject(const Json& json, const std::string& name, PlanFragment& object)
{
  const StrictJson read =
    Read(json, name, { "id", "name", "source", "colour", "state", "scanToPlanned", "locked" });
  object = { ReadId(read, "id"), read.Text("name"),
    ReadSource(read.Get("source"), Below(name, "source")), read.Colour("colour"),
    read.Named("state", FragmentStates),
    PoseFromJson(read.Get("scanToPlanned"), Below(name, "scanToPlanned")), read.Flag("locked") };
}

Json ObjectToJson(const PlanGroup& object)
{
  return { { "id", object.id }, { "name", object.name }, { "fragments", object.fragments } };
}

void ReadObject(const Json& json, const std::string& name, PlanGroup& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "fragments" });
  object = { ReadId(read, "id"), read.Text("name"), ReadIds(read, "fragments") };
}

Json ObjectToJson(const PlanCut& object)
{
  const Osteotomy& blade = object.blade;
  return { { "id", object.id }, { "name", object.name },
    { "blade", { { "point", ToJson(blade.point) }, { "normal", ToJson(blade.normal) },
                 { "along", ToJson(blade.along) }, { "widthMm", blade.widthMm },
                 { "depthMm", blade.depthMm }, { "kerfMm", blade.kerfMm } } },
    { "fragments", object.fragments }, { "reachMm", object.reachMm } };
}

void ReadObject(const Json& json, const std::string& name, PlanCut& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "blade", "fragments", "reachMm" });
  object = { ReadId(read, "id"), read.Text("name"),
    ReadBlade(read.Get("blade"), Below(name, "blade")), ReadIds(read, "fragments"),
    read.Number("reachMm") };
}

Json ObjectToJson(const PlanGuide& object)
{
  return { { "id", object.id }, { "name", object.name }, { "bone", object.bone },
    { "recipe", GuideRecipeToJson(object.recipe) }, { "cuts", object.cuts },
    { "side", NameOf(object.side, BodySides) } };
}

void ReadObject(const Json& json, const std::string& name, PlanGuide& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "bone", "recipe", "cuts", "side" });
  object.id = ReadId(read, "id");
  object.name = read.Text("name");
  object.bone = ReadId(read, "bone");
  object.recipe = ReadRecipe(read, "recipe", GuideRecipeFromJson);
  object.cuts = ReadIds(read, "cuts");
  object.side = read.Named("side", BodySides);
}

Json ObjectToJson(const PlanPlate& object)
{
  return { { "id", object.id }, { "name", object.name }, { "volume", object.volume },
    { "fragments", object.fragments }, { "recipe", PlateRecipeToJson(object.recipe) } };
}

void ReadObject(const Json& json, const std::string& name, PlanPlate& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "volume", "fragments", "recipe" });
  object = { ReadId(read, "id"), read.Text("name"), ReadId(read, "volume", 0),
    ReadIds(read, "fragments"), ReadRecipe(read, "recipe", PlateRecipeFromJson) };
}

Json ObjectToJson(const PlanImplant& object)
{
  return { { "id", object.id }, { "name", object.name }, { "volume", object.volume },
    { "recipe", ImplantRecipeToJson(object.recipe) } };
}

void ReadObject(const Json& json, const std::string& name, PlanImplant& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "volume", "recipe" });
  object = { ReadId(read, "id"), read.Text("name"), ReadId(read, "volume"),
    ReadRecipe(read, "recipe", ImplantRecipeFromJson) };
}

Json ObjectToJson(const PlanTransplant& object)
{
  return { { "id", object.id }, { "name", object.name }, { "donor", object.donor },
    { "first", FaceToJson(object.first) }, { "last", FaceToJson(object.last) },
    { "transplant", TransplantToJson(object.transplant) }, { "mostGapMm", object.mostGapMm },
    { "mostOverlapMm", object.mostOverlapMm } };
}

void ReadObject(const Json& json, const std::string& name, PlanTransplant& object)
{
  const StrictJson read = Read(json, name,
    { "id", "name", "donor", "first", "last", "transplant", "mostGapMm", "mostOverlapMm" });
  object = { ReadId(read, "id"), read.Text("name"), ReadId(read, "donor"),
    ReadFace(read.Get("first"), Below(name, "first")),
    ReadFace(read.Get("last"), Below(name, "last")),
    ReadRecipe(read, "transplant", TransplantFromJson), read.Number("mostGapMm"),
    read.Number("mostOverlapMm") };
}

Json ObjectToJson(const PlanMitreGuide& object)
{
  return { { "id", object.id }, { "name", object.name }, { "transplant", object.transplant },
    { "choices", MitreGuideToJson(object.choices) } };
}

void ReadObject(const Json& json, const std::string& name, PlanMitreGuide& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "transplant", "choices" });
  object = { ReadId(read, "id"), read.Text("name"), ReadId(read, "transplant"),
    MitreGuideFromJson(read.Get("choices"), "plan", Below(name, "choices")) };
}

Json ObjectToJson(const PlanMeasure& object)
{
  Json points = Json::array();
  for (const MeasurePoint& point : object.points)
    points.push_back({ { "fragment", point.fragment }, { "point", ToJson(point.point) } });
  return { { "id", object.id }, { "name", object.name },
    { "kind", NameOf(object.kind, MeasureKinds) }, { "points", std::move(points) } };
}

void ReadObject(const Json& json, const std::string& name, PlanMeasure& object)
{
  const StrictJson read = Read(json, name, { "id", "name", "kind", "points" });
  object = { ReadId(read, "id"), read.Text("name"), read.Named("kind", MeasureKinds), {} };
  for (const Json& value : read.List("points"))
  {
    const StrictJson point =
      Read(value, Below(name, ListKey("points", object.points.size())), { "fragment", "point" });
    object.points.push_back({ ReadId(point, "fragment", 0), point.Vector("point") });
  }
}

Json ObjectToJson(const PlanMirror& object)
{
  Json plane = nullptr;
  if (object.plane)
    plane = { { "point", ToJson(object.plane->point) },
      { "normal", ToJson(object.plane->normal) } };
  return { { "id", object.id }, { "name", object.name }, { "volume", object.volume },
    { "fragments", object.fragments }, { "isovalue", object.isovalue },
    { "plane", std::move(plane) } };
}

void ReadObject(const Json& json, const std::string& name, PlanMirror& object)
{
  const StrictJson read =
    Read(json, name, { "id", "name", "volume", "fragments", "isovalue", "plane" });
  object = { ReadId(read, "id"), read.Text("name"), ReadId(read, "volume", 0),
    ReadIds(read, "fragments"), read.Number("isovalue"), std::nullopt };
  if (read.Get("plane").is_null())
    return;
  const StrictJson plane = Read(read.Get("plane"), Below(name, "plane"), { "point", "normal" });
  object.plane = MirrorPlane{ plane.Vector("point"), plane.Vector("normal") };
}

Json PlanToJson(const Plan& plan)
{
  Json json = { { "caseLabel", plan.caseLabel }, { "nextId", plan.nextId } };
  ForEachPlanList(
    [&](const auto& list)
    {
      Json& objects = json[list.key] = Json::array();
      for (const auto& object : plan.*list.objects)
        objects.push_back(ObjectToJson(object));
    });
  return json;
}

Plan PlanFromJson(const Json& json, const std::string& name)
{
  const StrictJson read = std::apply(
    [&](const auto&... list) {
      return Read(json, name, { "caseLabel", "nextId", list.key... });
    },
    PlanLists);
  Plan plan;
  plan.caseLabel = read.Text("caseLabel");
  plan.nextId = static_cast<PlanId>(read.Count("nextId", 1, std::uint64_t(MaxPlanId) + 1));
  ForEachPlanList(
    [&](const auto& list)
    {
      auto& objects = plan.*list.objects;
      for (const Json& value : read.List(list.key, MaxPlanObjects))
      {
        const std::string place = Below(name, ListKey(list.key, objects.size()));
        ReadObject(value, place, objects.emplace_back());
      }
    });
  return plan;
}

} // namespace hasp
