#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/Progress.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hasp
{

/// The nearest seed of every voxel, by exact Euclidean distance between voxel centres.
struct FeatureTransform
{
  std::vector<float> squared;      ///< mm^2; +infinity where there is no seed at all
  std::vector<std::uint32_t> seed; ///< index of the nearest seed voxel; NoSeed if there is none
  static constexpr std::uint32_t NoSeed = 0xffffffffU;
};

/// Exact anisotropic Euclidean feature transform (Felzenszwalb and Huttenlocher 2012: lower
/// envelope of parabolas, one pass per axis, 16 lines at a time).
///
/// seeds    dims.x*dims.y*dims.z values, x fastest; non-zero marks a seed
/// spacing  taken from `geometry`, mm; may differ per axis
/// Throws std::invalid_argument if the sizes differ, the geometry is invalid or it has 2^32 - 1
/// voxels or more; Cancelled. Any thread; uses all cores; the same result with any number of them.
/// O(voxels); 8 bytes a voxel.
FeatureTransform NearestSeeds(const GridGeometry& geometry, std::span<const std::uint8_t> seeds,
  const ProgressFunction& progress = {});

/// Signed distance to a binary mask, mm, negative inside: from a voxel's centre to the nearest
/// centre of the other kind, less half the smallest spacing, so that the surface lies between the
/// two. An empty mask gives +infinity everywhere, a full one -infinity. Errors and cost as
/// NearestSeeds, twice. Limit: the surface is known to half a voxel only; see CoverageDistance.h
/// for the anti-aliased one.
std::vector<float> SignedEuclideanDistance(const GridGeometry& geometry,
  std::span<const std::uint8_t> inside, const ProgressFunction& progress = {});

} // namespace hasp
