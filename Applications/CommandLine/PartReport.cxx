#include "PartReport.h"

#include "Planning/GuideRecipeFile.h"
#include "Planning/ImplantRecipeFile.h"
#include "Planning/PlanLists.h"
#include "Planning/PlateRecipeFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <regex>
#include <stdexcept>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr std::array Verdicts{ "green", "red", "not certified" };
/// In parts of run.json.
constexpr std::array Keys{ "triangles", "volume_mm3", "cuts", "segments", "joints", "most_gap_mm",
  "most_overlap_mm", "warnings", "held_to_fragment", "verdict", "faults", "certificate", "program",
  "intended_use" };

/// What a fault's kind says, of a part that nobody measured just now.
constexpr std::array<std::pair<FitFaultKind, const char*>, 16> Words{ {
  { FitFaultKind::NotClosed, "the mesh is not closed" },
  { FitFaultKind::NotManifold, "the mesh is not 2-manifold" },
  { FitFaultKind::Turned, "triangles are turned" },
  { FitFaultKind::NoArea, "triangles have no area" },
  { FitFaultKind::MeetsItself, "the mesh meets itself" },
  { FitFaultKind::NotChecked, "it could not be measured" },
  { FitFaultKind::Pieces, "it has another number of pieces" },
  { FitFaultKind::ThinWall, "a wall is too thin" },
  { FitFaultKind::Gap, "the gap to the bone is another" },
  { FitFaultKind::TouchesBone, "it is in bone" },
  { FitFaultKind::Slot, "a slot is not as claimed" },
  { FitFaultKind::Hole, "a hole is not as claimed" },
  { FitFaultKind::Undercut, "it cannot be put on" },
  { FitFaultKind::Mirrored, "it is mirrored" },
  { FitFaultKind::Units, "it is in other units" },
  { FitFaultKind::Space, "it is in another patient space" },
} };

FitFaultKind KindOf(const std::string& name)
{
  const auto known = std::find_if(
    Words.begin(), Words.end(), [&](const auto& word) { return FitFaultName(word.first) == name; });
  return known == Words.end() ? FitFaultKind::SaidRed : known->first;
}

const char* WordsFor(FitFaultKind kind)
{
  const auto known =
    std::find_if(Words.begin(), Words.end(), [&](const auto& word) { return word.first == kind; });
  return known == Words.end() ? "it does not hold" : known->second;
}

FitFault FaultOf(const Json& fault)
{
  FitFault read{ KindOf(fault.at("kind").get<std::string>()), {}, std::nullopt };
  std::string& text = read.text;
  static const std::regex object("^(slots|holes|screws)\\[[0-9]{1,4}\\]");
  const auto said = fault.at("text").get<std::string>();
  if (std::smatch found; std::regex_search(said, found, object))
    text = found.str() + ": ";
  text += WordsFor(read.kind);
  if (!fault.at("at").is_null())
  {
    const auto at = fault.at("at").get<std::array<double, 3>>();
    std::array<char, 100> place;
    std::snprintf(place.data(), place.size(), " at (%.1f, %.1f, %.1f) mm", at[0], at[1], at[2]);
    text += place.data();
    read.at = glm::dvec3(at[0], at[1], at[2]);
  }
  return read;
}

/// Whether a text of a report is one that Hasp writes.
bool IsOurs(const std::string& text)
{
  static const std::regex forms("(slots|holes|screws)\\[[0-9]{1,4}\\]|"
                                "hasp [0-9.]{1,12}, commit ([0-9a-f]{1,40}\\+?|unknown)");
  static constexpr std::array Said{ "green", "red", "not certified", "holds", "does not hold",
    "hasp-certificate-1", "research use only, not a medical device" };
  return std::find(Said.begin(), Said.end(), text) != Said.end() ||
         std::any_of(Words.begin(), Words.end(),
           [&](const auto& word) { return FitFaultName(word.first) == text; }) ||
         std::regex_match(text, forms);
}

/// Takes out texts and keys that Hasp does not write, and says faults in words of ours.
void KeepOurs(Json& json)
{
  static const std::regex key("[a-z0-9_]{1,32}");
  if (json.is_object() && json.contains("kind") && json.contains("text") && json.contains("at"))
  {
    const std::string text = FaultOf(json).text;
    json.erase("text");
    KeepOurs(json);
    json["text"] = text;
  }
  else if (json.is_string() && !IsOurs(json.get<std::string>()))
    json = nullptr;
  else if (json.is_array())
    for (Json& value : json)
      KeepOurs(value);
  else if (json.is_object())
    for (auto entry = json.begin(); entry != json.end();)
      if (std::regex_match(entry.key(), key))
        KeepOurs(*entry++);
      else
        entry = json.erase(entry);
}

/// What `hasp run` needs of each.
void CheckSegments(const Json& segments)
{
  for (const Json& segment : segments)
  {
    segment.at("triangles").get<std::size_t>();
    segment.at("position_mm").get<std::array<double, 3>>();
    segment.at("orientation").get<std::array<double, 4>>();
  }
}

PartReport Read(const Json& json)
{
  PartReport report;
  const auto verdict =
    std::find(Verdicts.begin(), Verdicts.end(), json.at("verdict").get<std::string>());
  if (verdict == Verdicts.end())
    throw std::runtime_error("verdict");
  report.verdict = *verdict;
  report.volumeMm3 = json.at("volume_mm3").get<double>();
  if (report.verdict == "red")
  {
    for (const Json& fault : json.at("certificate").at("faults"))
      report.faults.push_back(FaultOf(fault).text);
    if (report.faults.empty())
      report.faults.push_back("it does not hold");
  }
  if (json.contains("cuts"))
    for (const Json& cut : json.at("cuts"))
      if (!cut.at("parted").get<bool>())
        report.cutsThatPartNothing.push_back(cut.at("cut").get<PlanId>());
  if (json.contains("segments"))
    CheckSegments(json.at("segments"));
  report.heldTo = json.value("held_to_fragment", PlanId(0));
  report.warnings = json.value("warnings", std::size_t(0));
  return report;
}

/// What `work` throws, in words that hold nothing of the file.
template <typename Work>
auto OfOurs(const Work& work)
{
  try
  {
    return work();
  }
  catch (const std::exception&)
  {
    throw std::runtime_error("the report on it is none that Hasp wrote");
  }
}
} // namespace

PartReport ReadPartReport(const std::string& report)
{
  return OfOurs([&] { return Read(Json::parse(report)); });
}

FitFault ReadFault(const nlohmann::ordered_json& fault)
{
  return OfOurs([&] { return FaultOf(fault); });
}

std::vector<std::string> WarningsOf(const PartReport& report, const std::string& part)
{
  std::vector<std::string> warnings;
  for (const PlanId cut : report.cutsThatPartNothing)
    warnings.push_back("cut " + std::to_string(cut) + " does not part the bone: " + part +
                       " has what is on both of its sides; make its blade wider or deeper, or move "
                       "it");
  return warnings;
}

std::string VerdictOf(const PartReport& report)
{
  return report.verdict + (report.heldTo == 0
                              ? ""
                              : ", held to fragment " + std::to_string(report.heldTo) + " alone");
}

void AddReport(const std::string& report, nlohmann::ordered_json& part)
{
  OfOurs(
    [&]
    {
      Json json = Json::parse(report);
      const std::vector<std::string> faults = Read(json).faults;
      KeepOurs(json);
      json["faults"] = faults;
      for (const char* key : Keys)
        if (json.contains(key) && !part.contains(key))
          part[key] = json[key];
    });
}

std::string RecipeText(const PartCheck& check)
{
  if (const auto* guide = std::get_if<GuideRecipe>(&check.recipe))
    return FormatGuideRecipe(*guide);
  if (const auto* plate = std::get_if<PlateRecipe>(&check.recipe))
    return FormatPlateRecipe(*plate);
  if (const auto* implant = std::get_if<ImplantRecipe>(&check.recipe))
    return FormatImplantRecipe(*implant);
  return {};
}

std::string RecipeOfReport(const std::string& report)
{
  return OfOurs(
    [&]() -> std::string
    {
      const Json json = Json::parse(report);
      if (!json.contains("recipe"))
        return {};
      const std::string text = json.at("recipe").dump(), format = json.at("recipe").at("format");
      if (format.starts_with("hasp-plate-"))
        return FormatPlateRecipe(ParsePlateRecipe(text));
      if (format.starts_with("hasp-implant-"))
        return FormatImplantRecipe(ParseImplantRecipe(text));
      return FormatGuideRecipe(ParseGuideRecipe(text));
    });
}

std::string StemOfPart(const Plan& plan, PlanId object)
{
  return std::string(PlanNoun(plan, object)) + "-" + std::to_string(object);
}

} // namespace hasp
