#pragma once
#include "Distance/BoneShare.h"
#include "Reduction/FitBody.h"

namespace hasp
{

struct FitBakeSettings
{
  double spacingMm = 0.6; ///< of the grid that distances are on, [0.05, 5]
  double rangeMm = 8.0;   ///< how far faces see each other at most, [1, 40]; at least 4 spacings
  std::size_t mostSamples = std::size_t{ 200'000'000 }; ///< of a grid: 25 bytes each
  FitBodySettings body{};
};

struct BakedFitBody
{
  std::shared_ptr<const FitBody> body;
  /// What the body was made of, in its axes: to touch the fragment by (HapticScene).
  std::shared_ptr<const DistanceMap> map;
  std::shared_ptr<const PointShell> shell;
  /// Of its own axes, where it was scanned: the middle of the box that holds it. The pose
  /// bodyInWorld of a fragment that stands where it was scanned is this place, not turned.
  glm::dvec3 origin{ 0.0 };
};

/// One label of a scan as a body to be fitted: coverage at half a share, anti-aliased distances, a
/// pointshell.
///
/// scan    geometry of the shares
/// shares  of ShareBone, or made otherwise: bone is where a share is 0.5 and more and has the label
/// Throws std::invalid_argument on settings, sizes, and a grid of more than mostSamples (says which
/// spacing would do); std::runtime_error, beginning with the label, if there is none of it or it is
/// thinner than the spacing; Cancelled. Any thread; all cores; O(voxels of the scan + samples of
/// the grid): 1 s for a fragment of 50 cm3 at 0.6 mm.
BakedFitBody BakeFitBody(const GridGeometry& scan, const BoneShares& shares, std::uint16_t label,
  const FitBakeSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp
