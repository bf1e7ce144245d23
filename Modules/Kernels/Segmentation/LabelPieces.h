#pragma once
#include "Segmentation/VoxelBox.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace hasp
{

/// Connected pieces (faces touch) of some voxels of a box, as runs along x.
struct LabelPieces
{
  struct Run
  {
    std::int32_t begin = 0, end = 0; ///< begin <= i < end
    std::uint32_t piece = 0;         ///< counted from 0 in the order of their first voxels
  };

  VoxelBox box;
  std::vector<std::uint64_t> rowStart; ///< first run of each row, and one more element
  std::vector<Run> runs;               ///< row by row, j before k
  std::uint32_t count = 0;             ///< pieces

  /// Calls visit(run, j, k) for all runs in order, on the calling thread.
  template <typename Visit>
  void ForEach(Visit&& visit) const
  {
    std::size_t row = 0;
    for (int k = this->box.low.z; k < this->box.high.z; ++k)
      for (int j = this->box.low.y; j < this->box.high.y; ++j, ++row)
        for (std::uint64_t r = this->rowStart[row]; r < this->rowStart[row + 1]; ++r)
          visit(this->runs[r], j, k);
  }
};

/// The pieces of the voxels that have the label (`of` true), or of those that do not (false), in a
/// box that lies in the map. Runs are joined slab by slab, all cores at once, then across slabs
/// (union-find whose root is always the earlier run, so that threads do not matter). Throws
/// std::runtime_error for 2^32 - 1 runs or more, Cancelled. O(voxels of the box); 12 bytes a run.
LabelPieces FindLabelPieces(GridView<const Label> labels, const VoxelBox& box, Label label, bool of,
  const ProgressFunction& progress);

} // namespace hasp
