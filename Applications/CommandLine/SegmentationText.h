#pragma once
#include "Segmenter.h"

#include <span>
#include <string>
#include <vector>

/// What `hasp segment` and `hasp run` say of label maps that they made.
namespace hasp
{

/// What a user must know of a step that was done: strokes that mark nothing, voxels that no stroke
/// is connected to, a walk that did not converge. "strokes[1] touches no voxel of label 1": keys as
/// they stand in the file, labels by their numbers, no text of the user's. Empty if all is well.
/// Of strokes beside the bone the first ten are named and the others counted.
std::vector<std::string> WarningsOf(
  const SegmentationStep& step, const SegmentationFinding& finding, double voxelMm3);

/// The same of all steps of a recipe, each begun with its place: "steps[2]: strokes[1] …".
/// `findings`: one a step.
std::vector<std::string> WarningsOf(
  const SegmentationRecipe& recipe, std::span<const SegmentationFinding> findings, double voxelMm3);

} // namespace hasp
