#pragma once
#include "Grid/GridView.h"

#include <span>
#include <vector>

namespace hasp
{

/// A scan with more voxels around it, so that offsets of what it holds have room. What is beyond
/// the scan counts as outside: bone that goes on there is closed, flat, half a voxel beyond the
/// last samples, where their voxels end.

/// The grid of that: as many voxels more on each side that an offset by `mm` ends before its border
/// (mm / spacing, and one). 0 mm: the same grid. Throws std::invalid_argument on an invalid
/// geometry, a margin that is negative or not finite, and if 2^31 voxels or more come out.
GridGeometry GeometryWithMargin(const GridGeometry& scan, double mm);

/// Shares of voxels on that grid: 0 beyond. Throws as GeometryWithMargin, and if sizes differ.
/// Any thread; O(voxels).
std::vector<float> CoverageWithMargin(
  const GridGeometry& scan, std::span<const float> coverage, double mm);

/// Grey samples less the isovalue on that grid; inside is 0 or more. Beyond, the nearest sample's
/// difference from the isovalue, as a negative number, and ever larger outwards: between the last
/// sample and the first one beyond it is 0 just half way, whatever the sample. The same errors.
std::vector<float> GreyWithMargin(const AnyGridView& scan, double isovalue, double mm);

} // namespace hasp
