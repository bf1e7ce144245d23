#pragma once
#include "Segmentation/LabelDelta.h"

namespace hasp
{

/// A change of a label map as few bytes as an undo can do with. Where only bone changes its label,
/// runs are counted in voxels of bone and go on behind what lies between: a fragment that is shared
/// out costs its border and not its rows.
///
/// Some 4 bytes a run. A stroke that shares out a skull of 8 M voxels changes some 100,000 runs of
/// bone, 0.4 MB, where a LabelDelta of the same change has millions (bin/BenchKernelLabelEdits).
struct PackedDelta
{
  glm::ivec3 dims{ 0 };   ///< of the map that it fits
  bool inBone = false;    ///< offsets and lengths count voxels that have a label, and no others
  std::uint64_t bone = 0; ///< so many voxels of the map have a label; 0 if not inBone
  std::uint64_t runs = 0; ///< of `bytes`
  std::vector<std::uint8_t> bytes;

  std::size_t Bytes() const { return sizeof(*this) + bytes.capacity(); }
  bool operator==(const PackedDelta&) const noexcept = default;
};

/// `after`: the map with the change made; only asked for its voxels of label 0. Throws
/// std::invalid_argument if dims differ, or the change is one of bone alone and a voxel of it has
/// no label there. Any thread; no state kept. O(runs), and one pass over the map where the change
/// is one of bone alone.
PackedDelta PackDelta(const LabelDelta& delta, GridView<const Label> after);

/// The same delta again, of the same map, or of one that has label 0 in the same places. Throws
/// std::invalid_argument if dims differ, if it is a change of bone alone and the map has more
/// voxels of bone or fewer, or if the bytes are no runs of such a map. Cost as above. Limit: of
/// another map with as many voxels of bone it is another delta, or, where not of bone alone, the
/// same one: RevertDelta, which looks at each voxel's label, tells.
LabelDelta UnpackDelta(const PackedDelta& packed, GridView<const Label> after);

} // namespace hasp
