#include "PlanText.h"

#include "PartReport.h"
#include "PlanInput.h"
#include "RunLabels.h"
#include "Session.h"
#include "VerbWork.h"

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

/// "surface 2, a sheet of 3 mm"
std::string CalledSource(const Plan& plan, const PlanFragment& fragment)
{
  if (const auto* label = std::get_if<LabelSource>(&fragment.source))
    return "label " + std::to_string(label->label) + " of " +
           CalledObject(plan, label->segmentation);
  if (const auto* piece = std::get_if<PieceSource>(&fragment.source))
    return "a piece of " + CalledObject(plan, piece->fragment);
  if (const auto* surface = std::get_if<SurfaceSource>(&fragment.source))
    return CalledObject(plan, surface->surface) +
           (surface->thicknessMm > 0.0 ? Line(", a sheet of %g mm", surface->thicknessMm)
                                       : ", closed");
  return "bone of " + CalledObject(plan, std::get<ComponentSource>(fragment.source).volume);
}

/// What fragments are, and how they stand.
Json DescribeFragments(const Plan& plan)
{
  Json fragments = Json::array();
  for (const PlanFragment& fragment : plan.fragments)
  {
    const glm::dvec3& p = fragment.scanToPlanned.position;
    const glm::dquat& q = fragment.scanToPlanned.orientation;
    fragments.push_back({ { "fragment", fragment.id }, { "of", CalledSource(plan, fragment) },
      { "kept", fragment.state == FragmentState::Kept }, { "locked", fragment.locked },
      { "position", { p.x, p.y, p.z } }, { "orientation", { q.w, q.x, q.y, q.z } } });
  }
  return fragments;
}

Json DescribeMirrors(const Plan& plan)
{
  Json mirrors = Json::array();
  for (const PlanMirror& mirror : plan.mirrors)
  {
    mirrors.push_back({ { "mirror", mirror.id }, { "volume", nullptr },
      { "fragments", mirror.fragments }, { "plane", nullptr } });
    if (mirror.volume != 0)
      mirrors.back()["volume"] = mirror.volume;
    if (mirror.plane)
    {
      const glm::dvec3 &p = mirror.plane->point, &n = mirror.plane->normal;
      mirrors.back()["plane"] = { { "point", { p.x, p.y, p.z } }, { "normal", { n.x, n.y, n.z } } };
    }
  }
  return mirrors;
}

/// "mirror 7: bone of volume 1, at a plane of its own"
std::string MirrorText(const Plan& plan, const PlanMirror& mirror)
{
  std::string of = mirror.volume != 0 ? "bone of " + CalledObject(plan, mirror.volume) : "";
  for (const PlanId fragment : mirror.fragments)
    of += (of.empty() ? "" : ", ") + CalledObject(plan, fragment);
  std::string text = CalledObject(plan, mirror.id) + ": " + of;
  if (!mirror.plane)
    return text + ", at the plane of best symmetry";
  const glm::dvec3 &p = mirror.plane->point, &n = mirror.plane->normal;
  return text + Line(", at the plane through (%.2f, %.2f, %.2f) mm, normal (%.4f, %.4f, %.4f)", p.x,
                  p.y, p.z, n.x, n.y, n.z);
}

/// "fragment 4: surface 2, closed; locked"
std::string FragmentText(const Plan& plan, const PlanFragment& fragment)
{
  std::string text = CalledObject(plan, fragment.id) + ": " + CalledSource(plan, fragment);
  if (!(fragment.scanToPlanned == PlanPose{}))
    text += "; moved";
  if (fragment.locked)
    text += "; locked";
  return text + (fragment.state == FragmentState::Resected ? "; resected" : "");
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
  result["fragments"] = DescribeFragments(plan);
  result["mirrors"] = DescribeMirrors(plan);
  result["parts"] = DescribeParts(document, folder);
  result["label_maps"] = DescribeLabelMaps(document, folder);
  const std::string undo = document.history.ToUndo() ? NextStep(document.history, true) : "",
                    redo = NextStep(document.history, false);
  result["undo"] = undo.empty() ? Json(nullptr) : Json(undo);
  result["redo"] = redo.empty() ? Json(nullptr) : Json(redo);
  for (const Json& object : result["objects"])
    Say(session, object["kind"].get<std::string>() + " " + object["id"].dump() +
                   (session.showNames ? "  " + object["name"].get<std::string>() : ""));
  for (const PlanFragment& fragment : plan.fragments)
    Say(session, FragmentText(plan, fragment));
  for (const PlanMirror& mirror : plan.mirrors)
    Say(session, MirrorText(plan, mirror));
  for (const Json& part : result["parts"])
    Say(session, PartText(plan, part));
  for (const Json& map : result["label_maps"])
    Say(session, LabelMapText(plan, map));
  Say(session, "the next object is " + std::to_string(document.history.NewId()) +
                 (undo.empty() ? "" : "; to undo: " + undo) +
                 (redo.empty() ? "" : "; to redo: " + redo));
}

} // namespace hasp
