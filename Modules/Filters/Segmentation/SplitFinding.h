#pragma once
#include "Segmenter.h"

#include "Segmentation/LabelSplit.h"

#include <span>

namespace hasp
{

/// Fills in what there is to say of a split that was shared out among these strokes. Private to
/// this module. O(voxels of the strokes), and a bit for each voxel of the split.
void FindSplit(
  const LabelSplit& split, std::span<const SeedVoxels> strokes, SegmentationFinding& found);

} // namespace hasp
