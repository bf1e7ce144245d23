#include "SegmentationWarnings.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <utility>
#include <variant>

namespace hasp
{
namespace
{

constexpr std::size_t MostNamed = 10; // of strokes; a wrong recipe may have thousands

std::string Text(const char* format, auto... figures)
{
  char text[200];
  std::snprintf(text, sizeof text, format, figures...);
  return text;
}

std::string Counted(std::uint64_t count, const char* noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string Called(std::uint16_t label)
{
  return "label " + std::to_string(label);
}

/// Why a step of this kind changes nothing.
struct Reason
{
  std::string operator()(const GaussianStep&) const { return this->Filter("sigmaMm"); }
  std::string operator()(const MedianStep&) const { return this->Filter("radiusMm"); }
  std::string operator()(const EdgePreservingStep&) const
  {
    return "all differences from voxel to voxel are above edge, or there are none";
  }
  std::string operator()(const ConeBeamStep&) const { return "there is no shading"; }
  std::string operator()(const ThresholdStep& step) const
  {
    return Text("no value is in [%g, %g]", step.lowest, step.highest) +
           ", or the labels before it are those that it makes";
  }
  std::string operator()(const SplitStep& step) const
  {
    return "no voxel has " + Called(step.label) + ", or all goes to strokes of that label";
  }
  std::string operator()(const PaintStep& step) const
  {
    const std::string inside = "within the stroke there is no voxel";
    return step.only == 0 ? inside + " that does not have " + Called(step.stroke.label) + " already"
                          : inside + " of " + Called(step.only) + " to be painted";
  }
  std::string operator()(const MergeStep& step) const
  {
    return "no voxel has " + Called(step.from);
  }
  std::string operator()(const ComponentsStep& step) const
  {
    return Called(step.label) + " is one piece, or no voxel has it";
  }
  std::string operator()(const FillStep& step) const
  {
    return Called(step.label) + " has no cavity, or no voxel has it";
  }
  std::string operator()(const MorphologyStep& step) const
  {
    return "no voxel has " + Called(step.label) + ", or " + Text("%g", step.radiusMm) +
           " mm reach nothing that would change";
  }

private:
  std::string Filter(const std::string& length) const
  {
    return "the samples are even, or " + length + " is small against their spacing";
  }
};

std::vector<std::string> WarningsOfSplit(const SplitStep& step, const SegmentationFinding& finding,
  const StepPlace& place, double voxelMm3)
{
  std::vector<std::string> warnings;
  const std::string label = Called(step.label), begin = place.step + ": ";
  const std::size_t beside = finding.besideBone.size(), named = std::min(beside, MostNamed);
  for (std::size_t n = 0; n < named; ++n)
  {
    const std::size_t stroke = finding.besideBone[n];
    warnings.push_back(
      (stroke < place.strokes.size() ? place.strokes[stroke]
                                     : place.step + ".strokes[" + std::to_string(stroke) + "]") +
      " touches no voxel of " + label);
  }
  if (beside > named)
    warnings.push_back(
      begin + std::to_string(beside - named) + " more of its strokes touch no voxel of " + label);
  for (const std::uint16_t lost : finding.withoutSeeds)
    warnings.push_back(begin + Called(lost) + " gets no voxel: its strokes touch none of " + label +
                       ", or later ones paint over them");
  if (finding.unreached > 0)
    warnings.push_back(begin + Counted(finding.unreached, "voxel") +
                       Text(" (%.1f mm3)", double(finding.unreached) * voxelMm3) +
                       " that no stroke is connected to " +
                       (finding.unreached == 1 ? "keeps " : "keep ") + label);
  if (finding.walk && !finding.walk->converged)
    warnings.push_back(begin + "the random walk did not converge: " +
                       Text("after %d iterations its probabilities may be %.2g off",
                         finding.walk->iterations, finding.walk->error) +
                       "; look at where its labels meet");
  return warnings;
}

} // namespace

std::vector<std::string> WarningsOf(const SegmentationStep& step,
  const SegmentationFinding& finding, const StepPlace& place, double voxelMm3)
{
  std::vector<std::string> warnings;
  if (const auto* split = std::get_if<SplitStep>(&step))
    warnings = WarningsOfSplit(*split, finding, place, voxelMm3);
  if (finding.changedNothing && warnings.empty()) // else they are why
    warnings.push_back(place.step + ": changes nothing: " + std::visit(Reason(), step));
  return warnings;
}

std::vector<std::string> WarningsOf(
  const SegmentationRecipe& recipe, std::span<const SegmentationFinding> findings, double voxelMm3)
{
  std::vector<std::string> warnings;
  for (std::size_t n = 0; n < std::min(findings.size(), recipe.steps.size()); ++n)
  {
    const StepPlace place{ "steps[" + std::to_string(n) + "]" };
    std::vector<std::string> some = WarningsOf(recipe.steps[n], findings[n], place, voxelMm3);
    std::move(some.begin(), some.end(), std::back_inserter(warnings));
  }
  return warnings;
}

} // namespace hasp
