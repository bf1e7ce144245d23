#ifndef SegmentationWarnings_h
#define SegmentationWarnings_h

#include "Segmenter.h"                        // for what is found
#include "vtkHaspFiltersSegmentationModule.h" // for export macro

#include <span>   // for findings
#include <string> // for return values
#include <vector> // for return values

/// What a user must know of steps that were done, in words: keys as they stand in a file, labels by
/// their numbers, no text of the user's. Any thread.
namespace hasp
{

/// What a user calls a step and its strokes.
struct StepPlace
{
  std::string step; ///< "steps[2]"
  /// Of each of its strokes, as the file that they were read from has it (Seeds::places). Empty:
  /// "steps[2].strokes[0]" and so on.
  std::vector<std::string> strokes = {};
};

/// Of one step: that it changes nothing, which of its strokes mark nothing, which labels get no
/// voxel, what no stroke is connected to, a walk that did not converge. "steps[2]: changes nothing:
/// no voxel has label 4", "steps[1].strokes[0] touches no voxel of label 1". Of strokes beside the
/// bone the first ten are named and the others counted. Empty if all is well.
VTKHASPFILTERSSEGMENTATION_EXPORT std::vector<std::string> WarningsOf(const SegmentationStep& step,
  const SegmentationFinding& finding, const StepPlace& place, double voxelMm3);

/// The same of all steps of a recipe. `findings`: one a step.
VTKHASPFILTERSSEGMENTATION_EXPORT std::vector<std::string> WarningsOf(
  const SegmentationRecipe& recipe, std::span<const SegmentationFinding> findings, double voxelMm3);

} // namespace hasp

#endif
