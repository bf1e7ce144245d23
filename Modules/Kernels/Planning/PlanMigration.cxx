#include "Planning/PlanMigration.h"

#include "Planning/PlanLists.h"

namespace hasp
{

namespace
{
/// Calls visit(entry) for each entry of json[key], if that is a list.
template <typename Visit>
void ForEachEntry(Json& json, const char* key, Visit visit)
{
  if (json.is_object() && json.contains(key) && json[key].is_array())
    for (Json& entry : json[key])
      visit(entry);
}

void MigratePlan(Json& holder, const char* key, const PlanMigration& step)
{
  if (!holder.is_object() || !holder.contains(key) || !holder[key].is_object())
    return;
  Json& plan = holder[key];
  if (step.plan)
    step.plan(plan);
  if (step.object)
    ForEachPlanList([&](const auto& list)
      { ForEachEntry(plan, list.key, [&](Json& object) { step.object(list.noun, object); }); });
}

void MigrateEdit(Json& edit, const PlanMigration& step)
{
  if (!step.object || !edit.is_object() || !edit.contains("object"))
    return;
  for (const char* verb : { "add", "change" })
    if (edit.contains(verb) && edit[verb].is_string())
      step.object(edit[verb].get<std::string>(), edit["object"]);
}

void SetIfMissing(Json& object, const char* key, const Json& value)
{
  if (object.is_object() && !object.contains(key))
    object[key] = value;
}

/// Version 2 has plates, implants and transplants …
void AddListsOf2(Json& plan)
{
  for (const char* key : { "plates", "implants", "transplants" })
    SetIfMissing(plan, key, Json::array());
}

/// … says which side a guide is for, and what was a constant: how far a saw reaches, what of a
/// label is bone, how fine a mesh is …
void MendObjectOf1(const std::string& noun, Json& object)
{
  if (noun == "cut")
    SetIfMissing(object, "reachMm", 8.0);
  if (noun == "guide")
    SetIfMissing(object, "side", "none");
  if (noun != "fragment" || !object.is_object() || !object.contains("source"))
    return;
  Json& source = object["source"];
  if (!source.is_object() || source.contains("fragment"))
    return;
  if (source.contains("segmentation"))
    SetIfMissing(source, "isovalue", 226.0);
  SetIfMissing(source, "spacingMm", 0.5);
}

/// … and keeps what was measured on a part.
void MendPartOf1(Json& part)
{
  SetIfMissing(part, "report", "");
}

/// Version 3 has mitre guides …
void AddListOf3(Json& plan)
{
  SetIfMissing(plan, "mitreGuides", Json::array());
}

/// … and says which joints are warned of.
void MendObjectOf2(const std::string& noun, Json& object)
{
  if (noun != "transplant")
    return;
  SetIfMissing(object, "mostGapMm", 0.5);
  SetIfMissing(object, "mostOverlapMm", 0.5);
}

/// What is measured on a part, and the recipe that goes with it, is kept more fully: it is made
/// anew.
void MendPartOf2(Json& part)
{
  if (part.is_object())
    part["report"] = "";
}

/// Version 4 has the recipe of a segmentation: without steps it is what it was.
void MendObjectOf3(const std::string& noun, Json& object)
{
  if (noun == "segmentation")
    SetIfMissing(object, "recipe",
      { { "format", "hasp-segmentation-1" }, { "steps", Json::array() },
        { "names", Json::array() } });
}

/// Version 5 has surfaces and mirrors.
void AddListsOf5(Json& plan)
{
  for (const char* key : { "surfaces", "mirrors" })
    SetIfMissing(plan, key, Json::array());
}
} // namespace

void MigratePlanFile(Json& file, std::size_t version, std::span<const PlanMigration> steps)
{
  for (const PlanMigration& step : steps.subspan(version - 1))
  {
    MigratePlan(file, "plan", step);
    if (step.part)
      ForEachEntry(file, "parts", step.part);
    if (!file.is_object() || !file.contains("history"))
      continue;
    Json& history = file["history"];
    MigratePlan(history, "start", step);
    ForEachEntry(history, "steps",
      [&](Json& done)
      { ForEachEntry(done, "edits", [&](Json& edit) { MigrateEdit(edit, step); }); });
  }
}

std::size_t ReadFormatVersion(const StrictJson& file, const std::string& begin)
{
  const std::string format = file.Text("format");
  const std::size_t newest = PlanMigrations().size() + 1;
  for (std::size_t version = 1; version <= newest; ++version)
    if (format == begin + std::to_string(version))
      return version;
  file.Fail("format",
    "is none that this version of Hasp reads: " + begin + "1 to " + std::to_string(newest));
}

std::span<const PlanMigration> PlanMigrations()
{
  static constexpr PlanMigration steps[] = { { AddListsOf2, MendObjectOf1, MendPartOf1 },
    { AddListOf3, MendObjectOf2, MendPartOf2 }, { nullptr, MendObjectOf3, nullptr },
    { AddListsOf5, nullptr, nullptr } };
  return steps;
}

} // namespace hasp
