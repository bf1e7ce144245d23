#pragma once
#include "Segmentation/VoxelBox.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hasp
{

/// Neighbours along x.
struct VoxelRun
{
  std::uint64_t first = 0;  ///< offset of the first voxel in the grid, x fastest
  std::uint32_t length = 1; ///< voxels, >= 1; within the row
  bool operator==(const VoxelRun&) const noexcept = default;
};

/// A set of voxels: in order, apart from each other and as long as they can be within their rows.
using VoxelRuns = std::vector<VoxelRun>;

/// How many voxels; the box that holds them.
std::uint64_t CountVoxels(std::span<const VoxelRun> runs);
VoxelBox BoxOfVoxels(const glm::ivec3& dims, std::span<const VoxelRun> runs);

/// The voxels that a brush marks on its way: those whose centre is within radiusMm of the line
/// through `points`, and, so that a thin brush never marks nothing, those that the line itself goes
/// through (borders count to both sides). What lies out of the grid is not marked; a stroke next to
/// the grid marks what of it reaches in, which may be nothing.
///
/// geometry  any, rotated and anisotropic; radiusMm is a length in the world
/// points    of the line, world mm, at least one, each within 1e6 mm of the origin on each axis;
/// one
///           point is a ball. They need not be apart
/// radiusMm  > 0 and finite; one part in 1e9 is forgiven, so that 3 voxels of 0.3 mm are 0.9 mm
/// Throws std::invalid_argument, Cancelled. Any thread; no state kept; all cores, the same runs
/// with any number of them. Boxes of voxels are halved until all or nothing of them is marked, so
/// that time goes with the brush's surface and what it marks, not with the grid.
VoxelRuns RasterizeStroke(const GridGeometry& geometry, std::span<const glm::dvec3> points,
  double radiusMm, const ProgressFunction& progress = {});

/// Those of the voxels where the mask is not 0. Throws std::invalid_argument if a run is not in the
/// mask. O(voxels of the runs).
VoxelRuns KeepInMask(std::span<const VoxelRun> runs, GridView<const std::uint8_t> mask);

/// Those of the voxels that have a label and lie within depthMm of a voxel of label 0, from centre
/// to centre: a brush on a surface does not paint through to the other side. The border of the scan
/// is no surface. depthMm in (0, 50]; one part in a million is forgiven. Throws
/// std::invalid_argument, Cancelled. All cores; O(voxels of the runs' box and depthMm around it).
VoxelRuns KeepSurfaceLayer(std::span<const VoxelRun> runs, GridView<const Label> labels,
  double depthMm, const ProgressFunction& progress = {});

} // namespace hasp
