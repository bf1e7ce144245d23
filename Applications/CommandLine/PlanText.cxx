#include "PlanText.h"

#include "PartReport.h"
#include "PlanInput.h"
#include "RunLabels.h"
#include "Session.h"

#include "Planning/PlanLists.h"

#include <iostream>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;

/// Names are the user's own words: they are shown to whoever asks for them, and to no one else.
Json DescribeObjects(const Plan& plan, bool names)
{
  Json objects = Json::array();
  ForEachPlanList(
    [&](const auto& list)
    {
      for (const auto& object : plan.*list.objects)
      {
        objects.push_back({ { "kind", list.noun }, { "id", object.id } });
        if (names)
          objects.back()["name"] = object.name;
      }
    });
  return objects;
}

/// Parts that are in date with what was found on them; of the others why they are not.
Json DescribeParts(const PlanDocument& document, const std::string& folder)
{
  const Plan& plan = document.history.Current();
  Json parts = Json::array();
  for (const PlanId object : PartObjects(plan))
  {
    const DerivedPart* made = PartInDate(plan, document.parts, object);
    Json& part = parts.emplace_back(Json{
      { "object", object }, { "kind", PlanNoun(plan, object) }, { "in_date", made != nullptr } });
    if (!made)
      part["why"] = WhyNoPart(plan, document.parts, object);
    else if (!made->report.empty())
      try
      {
        const PartReport report = ReadPartReport(ReadBlob(folder, made->report));
        part["verdict"] = report.verdict;
        part["faults"] = report.faults;
        part["warnings"] = WarningsOf(report, CalledObject(plan, object));
        if (report.warnings > 0)
          part["warnings"].push_back(std::to_string(report.warnings) +
                                     " warning(s) when it was made: hasp run says them again");
      }
      catch (const std::exception& error)
      {
        part["verdict"] = nullptr;
        part["warnings"] = { SafeText(error) + "; hasp run makes the part anew" };
      }
  }
  return parts;
}

/// Of segmentations with steps; those without have theirs from elsewhere.
Json DescribeLabelMaps(const PlanDocument& document, const std::string& folder)
{
  const Plan& plan = document.history.Current();
  Json maps = Json::array();
  for (const PlanSegmentation& segmentation : plan.segmentations)
  {
    if (segmentation.recipe.steps.empty())
      continue;
    const DerivedPart* made = PartInDate(plan, document.parts, segmentation.id, PartFormat::Nrrd);
    Json& map = maps.emplace_back(
      Json{ { "segmentation", segmentation.id }, { "in_date", made != nullptr } });
    if (!made)
      map["why"] = WhyNoPart(plan, document.parts, segmentation.id, PartFormat::Nrrd);
    else
      try
      {
        map["warnings"] = KeptWarnings(segmentation, *made, folder);
      }
      catch (const std::exception& error)
      {
        map["warnings"] = { SafeText(error) + "; hasp run makes the label map anew" };
      }
  }
  return maps;
}

/// "the label map of segmentation 2 is in date", and what was found on it, a line each.
std::string LabelMapText(const Plan& plan, const Json& map)
{
  if (!map["in_date"].get<bool>())
    return "the label map of " + map["why"].get<std::string>();
  std::string text =
    "the label map of " + CalledObject(plan, map["segmentation"].get<PlanId>()) + " is in date";
  for (const Json& line : map["warnings"])
    text += "\n  " + line.get<std::string>();
  return text;
}

/// "guide 9 is in date and does not hold", and its faults, a line each.
std::string PartText(const Plan& plan, const Json& part)
{
  if (!part["in_date"].get<bool>())
    return part["why"];
  std::string text = CalledObject(plan, part["object"].get<PlanId>()) + " is in date";
  const Json verdict = part.value("verdict", Json(nullptr));
  text += verdict == "red" ? " and DOES NOT HOLD:" : verdict == "green" ? " and holds" : "";
  for (const char* list : { "faults", "warnings" })
    for (const Json& line : part.value(list, Json::array()))
      text += "\n  " + line.get<std::string>();
  return text;
}
} // namespace

void Say(Session& session, const std::string& line)
{
  if (!session.json)
    std::cout << line << "\n";
}

std::string TextOf(const Plan& before, const std::vector<PlanEdit>& edits)
{
  return edits.empty()
           ? "Nothing"
           : EditLabel(before, edits[0]) +
               (edits.size() > 1 ? " and " + std::to_string(edits.size() - 1) + " more" : "");
}

std::string NextStep(PlanHistory history, bool undo)
{
  if (undo)
    history.Undo(); // to the plan that the step was for; then it is the next to redo
  return history.ToRedo() ? TextOf(history.Current(), history.ToRedo()->edits) : "";
}

void ShowPlan(const PlanDocument& document, const std::string& folder, Session& session)
{
  const Plan& plan = document.history.Current();
  Json& result = session.result;
  result["hash"] = PlanHash(plan);
  result["next_id"] = document.history.NewId();
  result["objects"] = DescribeObjects(plan, session.showNames);
  result["parts"] = DescribeParts(document, folder);
  result["label_maps"] = DescribeLabelMaps(document, folder);
  const std::string undo = document.history.ToUndo() ? NextStep(document.history, true) : "",
                    redo = NextStep(document.history, false);
  result["undo"] = undo.empty() ? Json(nullptr) : Json(undo);
  result["redo"] = redo.empty() ? Json(nullptr) : Json(redo);
  for (const Json& object : result["objects"])
    Say(session, object["kind"].get<std::string>() + " " + object["id"].dump() +
                   (session.showNames ? "  " + object["name"].get<std::string>() : ""));
  for (const Json& part : result["parts"])
    Say(session, PartText(plan, part));
  for (const Json& map : result["label_maps"])
    Say(session, LabelMapText(plan, map));
  Say(session, "the next object is " + std::to_string(document.history.NewId()) +
                 (undo.empty() ? "" : "; to undo: " + undo) +
                 (redo.empty() ? "" : "; to redo: " + redo));
}

} // namespace hasp
