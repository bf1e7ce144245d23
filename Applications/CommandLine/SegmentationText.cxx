#include "SegmentationText.h"

#include "VerbWork.h"

#include <algorithm>

namespace hasp
{
namespace
{
constexpr std::size_t MostNamed = 10; // of strokes; a wrong recipe may have thousands
} // namespace

std::vector<std::string> WarningsOf(
  const SegmentationStep& step, const SegmentationFinding& finding, double voxelMm3)
{
  const auto* split = std::get_if<SplitStep>(&step);
  if (!split)
    return {};
  std::vector<std::string> warnings;
  const std::string label = "label " + std::to_string(split->label);
  const std::size_t beside = finding.besideBone.size(), named = std::min(beside, MostNamed);
  for (std::size_t n = 0; n < named; ++n)
    warnings.push_back(
      "strokes[" + std::to_string(finding.besideBone[n]) + "] touches no voxel of " + label);
  if (beside > named)
    warnings.push_back(std::to_string(beside - named) + " more strokes touch no voxel of " + label);
  if (finding.unreached > 0)
    warnings.push_back(std::to_string(finding.unreached) +
                       Line(" voxels (%.1f mm3)", double(finding.unreached) * voxelMm3) +
                       " that no stroke is connected to keep " + label);
  if (finding.walk && !finding.walk->converged)
    warnings.push_back("the random walk did not converge: " +
                       Line("after %d iterations its probabilities may be %.2g off",
                         finding.walk->iterations, finding.walk->error) +
                       "; look at where its labels meet");
  return warnings;
}

std::vector<std::string> WarningsOf(
  const SegmentationRecipe& recipe, std::span<const SegmentationFinding> findings, double voxelMm3)
{
  std::vector<std::string> warnings;
  for (std::size_t n = 0; n < std::min(findings.size(), recipe.steps.size()); ++n)
    for (const std::string& warning : WarningsOf(recipe.steps[n], findings[n], voxelMm3))
      warnings.push_back("steps[" + std::to_string(n) + "]: " + warning);
  return warnings;
}

} // namespace hasp
