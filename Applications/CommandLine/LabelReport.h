#pragma once
#include "Segmenter.h"

#include <span>
#include <string>
#include <vector>

/// What was found when a label map was made, as the plan keeps it beside the map: JSON. Who can
/// write the plan's folder can write such a report, so that it is numbers alone, and what is said
/// of them are words of ours (SegmentationWarnings.h).
namespace hasp
{

/// `findings`: one a step, of which what WarningsOf asks for is kept.
std::string FormatLabelReport(std::span<const SegmentationFinding> findings, double voxelMm3);

/// The warnings of a recipe whose label map has this report. Throws std::runtime_error, with no
/// text of it, if it is none that Hasp writes for such a recipe.
std::vector<std::string> WarningsOfReport(
  const SegmentationRecipe& recipe, const std::string& report);

} // namespace hasp
