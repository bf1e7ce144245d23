#pragma once
#include "Grid/AnalyticVolumes.h"

#include <cstdint>
#include <random>
#include <vector>

namespace hasp
{

/// Bodies of closed form, between samples in every way, and images of them. Lengths in mm; voxels
/// of `TrialVoxelMm`. Any thread; images take all cores.

inline constexpr double TrialVoxelMm = 0.4;

/// n^3 voxels, the middle at the origin.
GridGeometry TrialGrid(int samples, double voxelMm = TrialVoxelMm);

/// All within `radius` of the segment a b; its value is minus the signed distance.
AnalyticVolume AnalyticCapsule(const glm::dvec3& a, const glm::dvec3& b, double radius);

/// Where centres of shapes lie, voxels: thirds of a voxel along each axis, n in [0, 27), moved by
/// less than a third, the same for all n of a seed.
glm::dvec3 SubVoxelCentre(int n, std::uint64_t seed);
/// Unit, evenly on the sphere.
glm::dvec3 AnyDirection(std::mt19937_64& random);

/// Minus the shape's value at each voxel's centre, mm, NEGATIVE INSIDE.
std::vector<double> TrueDistances(const AnalyticVolume& shape, const GridGeometry& grid);

/// The share of each voxel, a cube, that is inside: voxels are halved along the surface to an
/// eighth of a side (`halvings` 3); of such a piece the share counts that a plane along its faces
/// would leave. Right to 4e-4 of a voxel rms on average over directions (TestDistanceTrials).
std::vector<float> ExactCoverage(
  const AnalyticVolume& shape, const GridGeometry& grid, int halvings = 3);

/// The same by counting: `perAxis`^3 places a voxel.
std::vector<float> SampledCoverage(
  const AnalyticVolume& shape, const GridGeometry& grid, int perAxis);

/// What a scanner makes of it: 1 inside, 0 outside, blurred by a Gaussian of `blurVoxels` (sigma),
/// with white noise of the standard deviation `noise`. Right to 2e-3 without noise.
std::vector<float> ScannedImage(const AnalyticVolume& shape, const GridGeometry& grid,
  double blurVoxels, double noise, std::uint64_t seed);

/// 1 where coverage is 0.5 and more, else 0.
std::vector<std::uint8_t> MaskOf(const std::vector<float>& coverage);
std::vector<float> BinaryOf(const std::vector<float>& coverage);

} // namespace hasp
