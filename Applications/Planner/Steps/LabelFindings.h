#pragma once
#include "Segmenter.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace hasp
{

/// What a planner must know of a label map that was made, in whole sentences.
struct LabelNotes
{
  QStringList faults; ///< what was painted and does not show, or may show at the wrong place
  QStringList others; ///< what was left out, strokes beside bone, steps that change nothing
};

/// Of the findings, one a step; voxelMm3: of the scan. Labels are called by their numbers: names
/// are the user's own and are not said. Any thread.
LabelNotes NotesOf(const SegmentationRecipe& recipe,
  const std::vector<SegmentationFinding>& findings, double voxelMm3);

} // namespace hasp
