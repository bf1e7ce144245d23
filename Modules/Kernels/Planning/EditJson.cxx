#include "Planning/PlanJson.h"

#include "Planning/PlanEditsFile.h"
#include "Planning/PlanLists.h"
#include "Planning/PlanMigration.h"
#include "Planning/SegmentationJson.h"
#include "Planning/ValueChecks.h"

namespace hasp
{

namespace
{
constexpr std::pair<PartFormat, const char*> PartFormats[] = { { PartFormat::Stl, "stl" },
  { PartFormat::ThreeMf, "3mf" }, { PartFormat::Ply, "ply" }, { PartFormat::Obj, "obj" },
  { PartFormat::Nrrd, "nrrd" } };
constexpr std::pair<PartFacet, const char*> PartFacets[] = { { PartFacet::Shape, "shape" },
  { PartFacet::Place, "place" }, { PartFacet::CaseLabel, "caseLabel" } };
constexpr const char* EditsSubject = "edits";
const std::string EditsFormat = "hasp-edits-";
constexpr std::size_t MostEntries = 100'000'000; // a file's own limit comes first

StrictJson Read(const Json& json, const std::string& name, std::initializer_list<const char*> keys)
{
  return StrictJson(json, "plan", name, keys);
}

PlanId ReadId(const StrictJson& object, const char* key)
{
  return static_cast<PlanId>(object.Count(key, 1, MaxPlanId));
}

struct ToEditJson
{
  template <typename T>
  Json operator()(const AddObject<T>& edit) const
  {
    return { { "add", PlanListOf<T>().noun }, { "object", ObjectToJson(edit.object) } };
  }
  template <typename T>
  Json operator()(const ChangeObject<T>& edit) const
  {
    return { { "change", PlanListOf<T>().noun }, { "object", ObjectToJson(edit.object) } };
  }
  Json operator()(const RemoveObject& edit) const { return { { "remove", edit.id } }; }
  Json operator()(const RenameObject& edit) const
  {
    return { { "rename", edit.id }, { "name", edit.name } };
  }
  Json operator()(const PoseFragments& edit) const
  {
    Json poses = Json::array();
    for (const FragmentPose& pose : edit.poses)
      poses.push_back(
        { { "fragment", pose.fragment }, { "scanToPlanned", PoseToJson(pose.scanToPlanned) } });
    return { { "pose", std::move(poses) } };
  }
  Json operator()(const SetFragmentState& edit) const
  {
    return { { "state", NameOf(edit.state, FragmentStates) }, { "fragments", edit.fragments } };
  }
  Json operator()(const AddSegmentationStep& edit) const
  {
    return { { "addStep", edit.segmentation }, { "step", StepToJson(edit.step) } };
  }
  Json operator()(const AddSegmentationStroke& edit) const
  {
    return { { "addStroke", edit.segmentation }, { "stroke", StrokeToJson(edit.stroke) } };
  }
  Json operator()(const SetCaseLabel& edit) const { return { { "caseLabel", edit.caseLabel } }; }
};

template <template <typename> typename Edit>
PlanEdit ReadObjectEdit(const Json& json, const std::string& name, const char* verb)
{
  const StrictJson read = Read(json, name, { verb, "object" });
  const std::string noun = read.Text(verb);
  PlanEdit edit;
  bool known = false;
  ForEachPlanList(
    [&]<typename T>(const PlanList<T>& list)
    {
      if (noun != list.noun)
        return;
      Edit<T> found;
      ReadObject(read.Get("object"), Below(name, "object"), found.object);
      edit = std::move(found);
      known = true;
    });
  if (!known)
    read.Fail(verb, "is of no kind that a plan holds");
  return edit;
}

PlanEdit ReadPoses(const Json& json, const std::string& name)
{
  PoseFragments edit;
  for (const Json& value : Read(json, name, { "pose" }).List("pose"))
  {
    const std::string place = Below(name, ListKey("pose", edit.poses.size()));
    const StrictJson pose = Read(value, place, { "fragment", "scanToPlanned" });
    edit.poses.push_back({ ReadId(pose, "fragment"),
      PoseFromJson(pose.Get("scanToPlanned"), Below(place, "scanToPlanned")) });
  }
  return edit;
}

PlanStep ReadStep(const Json& json, const std::string& name)
{
  const StrictJson read = Read(json, name, { "label", "edits" });
  PlanStep step{ read.Text("label"), {} };
  for (const Json& edit : read.List("edits", MostEntries))
    step.edits.push_back(EditFromJson(edit, Below(name, ListKey("edits", step.edits.size()))));
  return step;
}
} // namespace

const char* NameOf(PartFacet facet)
{
  return NameOf(facet, PartFacets);
}

Json EditToJson(const PlanEdit& edit)
{
  return std::visit(ToEditJson{}, edit);
}

PlanEdit EditFromJson(const Json& json, const std::string& name)
{
  if (json.contains("add"))
    return ReadObjectEdit<AddObject>(json, name, "add");
  if (json.contains("change"))
    return ReadObjectEdit<ChangeObject>(json, name, "change");
  if (json.contains("remove"))
    return RemoveObject{ ReadId(Read(json, name, { "remove" }), "remove") };
  if (json.contains("pose"))
    return ReadPoses(json, name);
  if (json.contains("rename"))
  {
    const StrictJson read = Read(json, name, { "rename", "name" });
    return RenameObject{ ReadId(read, "rename"), read.Text("name") };
  }
  if (json.contains("state"))
  {
    const StrictJson read = Read(json, name, { "state", "fragments" });
    return SetFragmentState{ read.Counts("fragments", 1, MaxPlanId),
      read.Named("state", FragmentStates) };
  }
  if (json.contains("addStep"))
  {
    const StrictJson read = Read(json, name, { "addStep", "step" });
    return AddSegmentationStep{ ReadId(read, "addStep"),
      StepFromJson(read.Get("step"), "plan", Below(name, "step")) };
  }
  if (json.contains("addStroke"))
  {
    const StrictJson read = Read(json, name, { "addStroke", "stroke" });
    return AddSegmentationStroke{ ReadId(read, "addStroke"),
      StrokeFromJson(read.Get("stroke"), "plan", Below(name, "stroke")) };
  }
  return SetCaseLabel{ Read(json, name, { "caseLabel" }).Text("caseLabel") };
}

std::vector<PlanEdit> ParseEdits(const std::string& text)
{
  Json json = ParseJson(text, EditsSubject);
  std::size_t version = 0;
  {
    const StrictJson file(json, EditsSubject, "", { "format", "edits" });
    version = ReadFormatVersion(file, EditsFormat);
    file.List("edits", MostEntries);
  }
  // Older ones go the way of a history's.
  Json history = { { "history", { { "steps", Json::array({ std::move(json) }) } } } };
  MigratePlanFile(history, version, PlanMigrations());
  std::vector<PlanEdit> edits;
  for (const Json& edit : history["history"]["steps"][0]["edits"])
    edits.push_back(EditFromJson(edit, ListKey("edits", edits.size())));
  return edits;
}

std::string FormatEdits(const std::vector<PlanEdit>& edits)
{
  Json list = Json::array();
  for (const PlanEdit& edit : edits)
    list.push_back(EditToJson(edit));
  return FormatJson({ { "format", EditsFormat + std::to_string(PlanMigrations().size() + 1) },
                      { "edits", std::move(list) } },
    EditsSubject);
}

Json HistoryToJson(const PlanHistory& history)
{
  Json steps = Json::array();
  for (const PlanStep& step : history.Steps())
  {
    Json edits = Json::array();
    for (const PlanEdit& edit : step.edits)
      edits.push_back(EditToJson(edit));
    steps.push_back({ { "label", step.label }, { "edits", std::move(edits) } });
  }
  return { { "start", PlanToJson(history.Start()) }, { "nextId", history.NewId() },
    { "done", history.Done() }, { "steps", std::move(steps) } };
}

PlanHistory HistoryFromJson(const Json& json)
{
  const std::string name = "history";
  const StrictJson read = Read(json, name, { "start", "nextId", "done", "steps" });
  std::vector<PlanStep> steps;
  for (const Json& step : read.List("steps", MostEntries))
    steps.push_back(ReadStep(step, Below(name, ListKey("steps", steps.size()))));
  return PlanHistory(PlanFromJson(read.Get("start"), Below(name, "start")), std::move(steps),
    read.Count("done", 0, MostEntries),
    static_cast<PlanId>(read.Count("nextId", 1, std::uint64_t(MaxPlanId) + 1)));
}

Json PartToJson(const DerivedPart& part)
{
  Json inputs = Json::array();
  for (const PartInput& input : part.inputs)
    inputs.push_back(
      { { "id", input.id }, { "facet", NameOf(input.facet) }, { "hash", input.hash } });
  return { { "object", part.object }, { "format", NameOf(part.format, PartFormats) },
    { "inputs", std::move(inputs) }, { "bytes", part.bytes }, { "report", part.report } };
}

DerivedPart PartFromJson(const Json& json, const std::string& name)
{
  const StrictJson read = Read(json, name, { "object", "format", "inputs", "bytes", "report" });
  DerivedPart part{ ReadId(read, "object"), read.Named("format", PartFormats), {},
    read.Text("bytes"), read.Text("report") };
  const ValueChecks check("plan: " + name);
  check.Hash("bytes", part.bytes);
  if (!part.report.empty())
    check.Hash("report", part.report);
  for (const Json& value : read.List("inputs", MostEntries))
  {
    const std::string place = ListKey("inputs", part.inputs.size());
    const StrictJson input = Read(value, Below(name, place), { "id", "facet", "hash" });
    const PartFacet facet = input.Named("facet", PartFacets);
    const bool ofPlan = facet == PartFacet::CaseLabel;
    part.inputs.push_back({ ofPlan ? PlanId(input.Count("id", 0, 0)) : ReadId(input, "id"), facet,
      input.Text("hash") });
    check.Hash(place + ".hash", part.inputs.back().hash);
  }
  return part;
}

} // namespace hasp
