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
} // namespace

void MigratePlanFile(Json& file, std::size_t version, std::span<const PlanMigration> steps)
{
  for (const PlanMigration& step : steps.subspan(version - 1))
  {
    MigratePlan(file, "plan", step);
    if (!file.is_object() || !file.contains("history"))
      continue;
    Json& history = file["history"];
    MigratePlan(history, "start", step);
    ForEachEntry(history, "steps",
      [&](Json& done)
      { ForEachEntry(done, "edits", [&](Json& edit) { MigrateEdit(edit, step); }); });
  }
}

std::span<const PlanMigration> PlanMigrations()
{
  return {}; // version 1 is the first
}

} // namespace hasp
