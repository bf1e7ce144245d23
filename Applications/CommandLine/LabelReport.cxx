#include "LabelReport.h"

#include "SegmentationWarnings.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr char Format[] = "hasp-label-report-1";

SegmentationFinding ReadFinding(const Json& json)
{
  SegmentationFinding finding;
  finding.changed = json.at("changed").get<std::uint64_t>();
  finding.changedNothing = json.at("changed_nothing").get<bool>();
  if (json.contains("cycles"))
  {
    finding.walk.emplace();
    finding.walk->iterations = json.at("cycles").get<int>();
    finding.walk->error = json.at("error").get<double>();
    finding.walk->converged = json.at("converged").get<bool>();
    finding.besideBone = json.at("beside_bone").get<std::vector<std::size_t>>();
    finding.withoutSeeds = json.at("without_seeds").get<std::vector<std::uint16_t>>();
    finding.unreached = json.at("unreached").get<std::uint64_t>();
  }
  return finding;
}
} // namespace

std::string FormatLabelReport(std::span<const SegmentationFinding> findings, double voxelMm3)
{
  Json json{ { "format", Format }, { "voxel_mm3", voxelMm3 }, { "steps", Json::array() } };
  for (const SegmentationFinding& finding : findings)
  {
    Json& step = json["steps"].emplace_back(
      Json{ { "changed", finding.changed }, { "changed_nothing", finding.changedNothing } });
    if (finding.walk)
      step.update({ { "cycles", finding.walk->iterations }, { "error", finding.walk->error },
        { "converged", finding.walk->converged }, { "beside_bone", finding.besideBone },
        { "without_seeds", finding.withoutSeeds }, { "unreached", finding.unreached } });
  }
  return json.dump(1) + "\n";
}

std::vector<std::string> WarningsOfReport(
  const SegmentationRecipe& recipe, const std::string& report)
{
  const std::runtime_error none("its report is none that Hasp writes");
  try
  {
    const Json json = Json::parse(report);
    std::vector<SegmentationFinding> findings;
    for (const Json& step : json.at("steps"))
      findings.push_back(ReadFinding(step));
    if (json.at("format").get<std::string>() != Format || findings.size() != recipe.steps.size())
      throw none;
    return WarningsOf(recipe, findings, json.at("voxel_mm3").get<double>());
  }
  catch (const Json::exception&) // quotes it
  {
    throw none;
  }
}

} // namespace hasp
