#pragma once
#include "Segmentation/LabelDelta.h"

namespace hasp
{

/// A label and a ball of radiusMm, in (0, 50] and at most 1,000 voxels: exact Euclidean distances
/// between voxel centres, on anisotropic grids too; one part in a million of the radius is
/// forgiven. What grows, grows into label 0 alone, and what shrinks leaves label 0. The border of
/// the scan is no edge of the label: nothing shrinks from it. Other labels are not of the label, so
/// it shrinks from them as it does from label 0.
///
/// Each changes the map and returns the change; a label without voxels changes nothing. Throws
/// std::invalid_argument for label 0 or a radius out of range, std::runtime_error where the box
/// below would have 2^33 voxels or more, Cancelled; the map is then as it was. Not while others use
/// the map; all cores, the same change with any number of them. Time and memory go with the box of
/// the label, grown by the radius: 1 to 2 bytes a voxel of it, and 4 bytes a voxel of 2 radii + 32
/// slices.

/// Voxels of label 0 within the radius of the label become of it.
LabelDelta DilateLabel(
  GridView<Label> labels, Label label, double radiusMm, const ProgressFunction& progress = {});

/// Voxels of the label within the radius of one that is not of it become 0.
LabelDelta ErodeLabel(
  GridView<Label> labels, Label label, double radiusMm, const ProgressFunction& progress = {});

/// Eroded, then dilated: what no ball within the label reaches becomes 0. Never grows; twice is as
/// once.
LabelDelta OpenLabel(
  GridView<Label> labels, Label label, double radiusMm, const ProgressFunction& progress = {});

/// Dilated, then eroded: voxels of label 0 that no ball outside the label reaches become of it. The
/// ball may pass over other labels and lie beyond the border of the scan, where there is nothing:
/// no gap between the label and the border is closed. Never shrinks.
LabelDelta CloseLabel(
  GridView<Label> labels, Label label, double radiusMm, const ProgressFunction& progress = {});

} // namespace hasp
