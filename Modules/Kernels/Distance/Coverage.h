#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hasp
{

struct CoverageSettings
{
  double isovalue = 226.0; ///< inside is value >= isovalue; finite
  int samplesPerAxis = 5;  ///< sub-samples a voxel and axis, in [1, 16]
  /// One byte for each sample of the source, or empty for "all". An inside point counts only if
  /// the heaviest inside corner of its cell is marked non-zero: how specks are left out.
  std::span<const std::uint8_t> keep = {};
};

/// Share in [0,1] of each voxel of `target` that lies inside the trilinear isosurface of `source`
/// (thesis 2.1.3, Fig. 2.4: binary to coverage, by supersampling).
///
/// source   any geometry, two samples at least along each axis; outside it nothing is inside
/// target   any other geometry: rotated, finer, coarser. A voxel is the box of one spacing a side
///          around its sample.
/// Voxels wholly in cells without the isosurface, and those farther from it than the cell's
/// gradient allows, are not supersampled. NaN samples count as outside. Throws
/// std::invalid_argument on bad geometry or settings (names the value and the range); Cancelled.
/// Any thread; all cores; O(target voxels) + samplesPerAxis^3 per voxel on the surface.
std::vector<float> Coverage(const AnyGridView& source, const GridGeometry& target,
  const CoverageSettings& settings, const ProgressFunction& progress = {});

/// Marks the samples >= isovalue of `source` that belong to a connected piece (26 neighbours) of at
/// least `leastMm3`; one byte a sample, for CoverageSettings::keep. The volume of a piece is its
/// samples times the volume of a voxel. Errors and threads as above. O(samples), one core.
std::vector<std::uint8_t> KeepLargePieces(const AnyGridView& source, double isovalue,
  double leastMm3, const ProgressFunction& progress = {});

/// Marks the samples of one fragment, value `label` of `labels`, one byte a sample, for
/// CoverageSettings::keep. Coverage is then that of a segmentation mask (thesis 2.1.3, Fig. 2.4):
/// grey values say where in a voxel the surface passes, labels whose it is. A point belongs to the
/// label of the heaviest inside corner of its cell, so a neighbouring fragment counts as outside,
/// half way between the two, and so does what is above the isovalue and has no label. `labels` has
/// the source's geometry. std::invalid_argument if its geometry is invalid. O(samples).
std::vector<std::uint8_t> KeepLabel(const AnyGridView& labels, int label);

} // namespace hasp
