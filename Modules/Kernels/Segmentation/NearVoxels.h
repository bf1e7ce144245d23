#pragma once
#include "Grid/ParallelFor.h"
#include "Segmentation/VoxelBox.h"

#include <cstdint>
#include <vector>

namespace hasp
{

/// Yes or no for each voxel of a box, a byte each. The box may reach out of the scan.
struct BoxMask
{
  VoxelBox box;
  std::vector<std::uint8_t> inside; ///< 0 or 1, x fastest

  std::size_t Offset(int i, int j, int k) const
  {
    const glm::ivec3 size = this->box.Size();
    return (std::size_t(k - this->box.low.z) * size.y + (j - this->box.low.y)) * size.x +
           (i - this->box.low.x);
  }
  bool At(int i, int j, int k) const { return this->inside[this->Offset(i, j, k)] != 0; }
};

/// Whole voxels along each axis that a radius reaches over. Throws std::invalid_argument, beginning
/// with `what`, unless the radius is in (0, 50] mm and reaches over at most 1,000 voxels.
glm::ivec3 StepsWithin(const glm::dvec3& spacing, double radiusMm, const char* what);

/// The voxels of `box` within radiusMm of one of the mask's, from centre to centre: exact Euclidean
/// distances on anisotropic grids, but for one part in a million of the radius, which is forgiven.
///
/// Along x and y the nearest is found by its squared distance (lower envelope of parabolas,
/// Felzenszwalb and Huttenlocher 2012); along z each slice then covers an interval, and nothing has
/// to be compared. Only slices within the radius are held: 4 bytes a voxel of
/// 2 radii + 32 slices. Throws Cancelled. All cores, the same with any number. O(voxels).
BoxMask Dilated(const BoxMask& mask, const VoxelBox& box, const glm::dvec3& spacing,
  double radiusMm, const ProgressFunction& progress);

/// Memory for a mask of the box. Throws std::runtime_error where it would have 2^33 voxels or more.
BoxMask EmptyMask(const VoxelBox& box);

/// Where is(label) is true, in a box that lies in the map.
template <typename Is>
BoxMask MaskOf(GridView<const Label> labels, const VoxelBox& box, Is&& is)
{
  BoxMask mask = EmptyMask(box);
  ParallelFor(box.low.z, box.high.z, 1,
    [&](std::int64_t first, std::int64_t)
    {
      const int k = static_cast<int>(first);
      for (int j = box.low.y; j < box.high.y; ++j)
      {
        const Label* from = &labels(box.low.x, j, k);
        std::uint8_t* to = &mask.inside[mask.Offset(box.low.x, j, k)];
        for (int i = 0; i < box.Size().x; ++i)
          to[i] = is(from[i]);
      }
    });
  return mask;
}

} // namespace hasp
