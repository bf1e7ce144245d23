#pragma once
#include "Segmentation/LabelMap.h"

#include <glm/common.hpp>

namespace hasp
{

/// The voxels low <= index < high of a grid, axis by axis. Empty where high <= low. A value type.
struct VoxelBox
{
  glm::ivec3 low{ 0 };
  glm::ivec3 high{ 0 };

  bool operator==(const VoxelBox&) const noexcept = default;

  bool Empty() const { return high.x <= low.x || high.y <= low.y || high.z <= low.z; }
  glm::ivec3 Size() const { return glm::max(high - low, glm::ivec3(0)); }

  /// With room around it; may reach out of the grid.
  VoxelBox Grown(const glm::ivec3& steps) const { return { low - steps, high + steps }; }

  /// What of it lies in a grid of these dims; empty where nothing does.
  VoxelBox In(const glm::ivec3& dims) const
  {
    return { glm::clamp(low, glm::ivec3(0), dims), glm::clamp(high, glm::ivec3(0), dims) };
  }
};

/// The smallest box that holds all voxels of a label; an empty one at 0 if there are none. Throws
/// Cancelled. Any thread; no state kept; all cores. One pass over the map.
VoxelBox BoxOfLabel(
  GridView<const Label> labels, Label label, const ProgressFunction& progress = {});

} // namespace hasp
