#pragma once
#include "Segmentation/LabelDelta.h"

namespace hasp
{

struct ComponentsSettings
{
  double leastMm3 = 0.0;         ///< smaller pieces become label 0, the largest too; [0, 1e9]
  bool keepLargestAlone = false; ///< all other pieces become label 0
};

/// Pieces of a label (voxels whose faces touch) become labels of their own: the largest keeps the
/// label, the others get the numbers that follow the largest label of the map, large before small
/// and, of one size, in the order of their first voxels (x fastest). Numbers below that are not
/// used again: a user may have named them.
///
/// Changes the map and returns the change. Throws std::invalid_argument for label 0, leastMm3 out
/// of range, or where numbers beyond MaxLabel would be needed (it says how many, and what to do);
/// std::runtime_error for 2^32 - 1 runs of voxels or more; Cancelled. The map is then as it was.
/// Not while others use the map; all cores, the same with any number. O(voxels of the map), 12
/// bytes a run of the label along x.
LabelDelta SeparateComponents(GridView<Label> labels, Label label,
  const ComponentsSettings& settings = {}, const ProgressFunction& progress = {});

/// Voxels of label 0 from which no way leads out of the scan but through the label become of it.
/// A way goes from face to face, through label 0 and through all other labels: what is shut in
/// between two fragments, or between a fragment and the border of the scan, is no cavity of either.
/// Other labels within a cavity stay.
///
/// Changes the map and returns the change. Errors, threads and cost as SeparateComponents; 12 bytes
/// a run along x of what is not of the label, within the label's box.
LabelDelta FillCavities(GridView<Label> labels, Label label, const ProgressFunction& progress = {});

} // namespace hasp
