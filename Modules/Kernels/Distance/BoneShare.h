#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hasp
{

struct BoneShareSettings
{
  /// Value of what is around bone. Not given: the median of what is 2 to 5 mm off all labels.
  std::optional<double> softValue = std::nullopt;
  double depthMm = 1.2;    ///< from here on into a label values are bone's own, (0, 20]
  double leastStep = 80.0; ///< between both; with less there is no bone; > 0
};

/// How much of each voxel is bone, and whose.
struct BoneShares
{
  std::vector<float> shares;         ///< [0, 1.3], x fastest: 0.5 at the surface
  std::vector<std::uint16_t> labels; ///< of voxels with half or more; 0 where there is less
  double softValue = 0.0;            ///< that was used
};

/// A scan whose bone is everywhere as bright as bone is just there: share = (value - soft) /
/// (own - soft), with the value `own` of the same label's voxels depthMm in, the nearest to each
/// voxel. Its isosurface at 0.5 is where the scanner saw half: at a step of any height and at any
/// symmetric blur, that is where the surface is. A threshold lies outside of it where bone is dense
/// and inside where it is spongy, by 0.5 mm either way at usual blurs, so that faces of one
/// fracture seem to overlap here and to gape there. What is fitted, is fitted by this.
///
/// labels   of the same grid; 0 is nothing. Another label's voxels are no share of a label
/// Limits: where bone is thinner than two blurs its own value is not seen, and its shares are too
/// large. Shares of marrow that is no brighter than soft tissue (leastStep) are 0: a hole.
/// Throws std::invalid_argument on bad geometry, labels of another grid, settings out of range,
/// std::runtime_error if there is no label or nothing around them to measure soft tissue with;
/// Cancelled. Any thread; all cores, the same with any number of them. O(voxels), 22 bytes a voxel.
BoneShares ShareBone(const AnyGridView& grey, const GridView<const std::uint16_t>& labels,
  const BoneShareSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp
