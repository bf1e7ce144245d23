#pragma once
#include "Segmentation/Brush.h"
#include "Segmentation/LabelDelta.h"

namespace hasp
{

/// Edits of a label map. Each changes the map and returns the change. Where one throws
/// (std::invalid_argument, Cancelled) the map is as it was. Not while others use the map; all
/// cores, the same change with any number of them.

/// The voxels become of the label, or nothing (label 0: an eraser). With `only` those alone that
/// have that label; only = 0 paints any. Throws if a voxel is not in the map. O(voxels).
LabelDelta PaintVoxels(GridView<Label> labels, std::span<const VoxelRun> voxels, Label label,
  Label only = 0, const ProgressFunction& progress = {});

/// All voxels of a label become of another, or nothing (into 0). Throws if `from` is 0. Two passes
/// over the map.
LabelDelta MergeLabels(
  GridView<Label> labels, Label from, Label into, const ProgressFunction& progress = {});

} // namespace hasp
