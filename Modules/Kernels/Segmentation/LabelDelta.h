#pragma once
#include "Segmentation/VoxelBox.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hasp
{

/// Neighbours in memory that all were of one label and become of another one.
struct LabelRun
{
  std::uint64_t first = 0;  ///< offset of the first voxel in the map, x fastest
  std::uint32_t length = 1; ///< voxels, >= 1; may go on in the next row
  Label before = 0;
  Label after = 0; ///< never `before`
  bool operator==(const LabelRun&) const noexcept = default;
};

/// A change of a label map that can be taken back: what an undo keeps. Runs are in order, apart
/// from each other and as long as they can be, so that equal changes are equal deltas.
///
/// 16 bytes a run. A stroke of 3 mm radius and 30 mm length on voxels of 0.3 mm has some thousand
/// rows: some 10 kB where it paints on one label, and 0.6 MB at the worst, where no two voxels side
/// by side had the same label. A change of a whole volume costs as many runs as its rows
/// cross borders of what changes: some MB for a split of a skull, 16 bytes a voxel at the worst.
struct LabelDelta
{
  glm::ivec3 dims{ 0 }; ///< of the map that it fits
  std::vector<LabelRun> runs;

  bool operator==(const LabelDelta&) const noexcept = default;

  bool Empty() const { return runs.empty(); }
  std::size_t Bytes() const { return sizeof(*this) + runs.capacity() * sizeof(LabelRun); }
  std::uint64_t Voxels() const; ///< how many change
  VoxelBox Box() const;         ///< that holds all that change

  /// Adds a run behind the last one; joins the two where they are one. Runs that change nothing and
  /// runs of no length are left out. Throws std::invalid_argument if it begins before the last one
  /// ends.
  void Append(const LabelRun& run);
};

/// Makes the change, or takes it back. Throws std::invalid_argument, and leaves the map as it is,
/// if the delta does not fit: other dims, runs out of order or out of the map, or a voxel that is
/// not of the label it was (ApplyDelta: `before`; RevertDelta: `after`). Not while others use the
/// map; all cores. O(voxels that change), twice.
void ApplyDelta(const LabelDelta& delta, GridView<Label> labels);
void RevertDelta(const LabelDelta& delta, GridView<Label> labels);

/// What makes `after` of `before`, within the box; outside the box neither is looked at. Throws
/// std::invalid_argument if their dims differ or the box is not in them. Any thread; no state kept;
/// all cores. O(voxels of the box).
LabelDelta DifferenceOf(
  GridView<const Label> before, GridView<const Label> after, const VoxelBox& box);

/// The first change, then the second, as one: a stroke that was painted bit by bit becomes one
/// undo. What the second takes back of the first is in neither. Throws std::invalid_argument if the
/// second does not go on where the first ended. O(runs).
LabelDelta JoinDeltas(const LabelDelta& first, const LabelDelta& second);

} // namespace hasp
