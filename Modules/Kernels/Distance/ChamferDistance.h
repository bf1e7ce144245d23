#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/Progress.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hasp
{

/// Weighted <3,4,5> distance transform (Borgefors 1996), signed and anti-aliased: what the papers
/// behind Hasp use (thesis 2.1.4, Eq. 2.2). Here to be compared with; guides use CoverageDistance.
///
/// coverage   dims.x*dims.y*dims.z values in [0,1], x fastest; 1 inside. A mask of 0 and 1 gives
///            the binary transform.
/// Returns mm, NEGATIVE INSIDE, same shape. +infinity everywhere if nothing is covered, -infinity
/// if all is. Partial voxels have their own distance, (0.5 - coverage) voxels along the axis on
/// which coverage changes most. Others have the least sum of steps to a voxel that is not of their
/// kind, plus what is known there: steps to faces, edges and corners cost 3, 4 and 5 thirds of a
/// voxel, of stretched voxels the same share of the step's length, but no less than a shorter step.
/// Internal and external transform run side by side, in two raster passes.
///
/// Error: that of the metric, +10.55 % (along 3,1,1) to -5.72 % (along 1,1,0) of the distance, or
/// 0.118 of the largest coordinate. Voxels stretched S times cannot be walked around by steps of
/// one voxel: the error grows to +41 %. Voxels that the surface hardly touches, covered by less
/// than 1/128, are told half a voxel, and are farther off: two voxels outside a sphere the error is
/// 0.090 voxel rms with them, 0.076 without, 0.18 of the binary transform. Throws
/// std::invalid_argument if sizes differ, the geometry is invalid or a value is not in [0,1];
/// Cancelled. Any thread; all cores, the same result with any number of them. O(voxels), 8 bytes a
/// voxel.
std::vector<float> ChamferDistance(const GridGeometry& geometry, std::span<const float> coverage,
  const ProgressFunction& progress = {});

} // namespace hasp
