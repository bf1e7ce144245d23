#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

#include <cstddef>
#include <vector>

namespace hasp
{

struct BodyDistanceSettings
{
  /// Of the grid, the same along its three axes, mm; >= 0. 0: the volume's smallest one, or a 96th
  /// of a mesh's longest side.
  double spacingMm = 0.0;
  double bandMm = 0.0; ///< the grid reaches so far beyond the body; >= 0; 0: sixteen spacings
  std::size_t mostSamples = std::size_t{ 1 } << 26; ///< of the grid: 25 bytes each while it is made
};

/// A body's signed distance, and where its samples lie.
struct BodyDistance
{
  GridGeometry geometry;
  std::vector<float> distances; ///< mm, NEGATIVE INSIDE; x fastest

  GridView<const float> View() const { return { this->distances.data(), this->geometry }; }
};

/// The signed distance to a body, on a grid of its own around it and the band that contact and
/// Snap-to-fit read (what DistanceMap and PointShell are made of): Coverage or MeshCoverage, then
/// CoverageDistance.
///
/// Of a volume: inside is value >= isovalue; the grid has the volume's axes. Where the body is cut
/// off by the volume's border, that is its surface. Of a closed mesh: the grid has the world's
/// axes. Error of samples within three spacings of the surface, in spacings (TestBodyDistance
/// prints and holds it): balls of 20 spacings 0.03 rms, 0.1 at most; flat faces 0.02 rms; within
/// three spacings of sharp edges and corners 0.3 to 0.5 rms, 1.5 at most (1.65 of boxes that are
/// turned otherwise), because CoverageDistance's elements reach over an edge: it says more. What is
/// thinner than a spacing may be missing.
///
/// Throws std::invalid_argument on bad geometry, settings (with value and range), a mesh that
/// MeshCoverage refuses, if there is no body (nothing inside), and if the grid would have more than
/// mostSamples (with the spacing that would do), before memory is taken; Cancelled. Any thread; all
/// cores; the same with any number of them. O(samples of the volume + samples of the grid): about
/// 0.4 us of CPU time a sample of the grid.
BodyDistance DistanceOfVolume(const AnyGridView& volume, double isovalue,
  const BodyDistanceSettings& settings = {}, const ProgressFunction& progress = {});
BodyDistance DistanceOfMesh(const TriangleMesh& mesh, const BodyDistanceSettings& settings = {},
  const ProgressFunction& progress = {});

} // namespace hasp
