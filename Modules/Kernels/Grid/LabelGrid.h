#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <cstdint>

/// Are labels of a scan's samples, and if they are of some of them only, of which?
namespace hasp
{

/// Throws std::invalid_argument, beginning with `who`, unless labels are of a scan's samples: as
/// many along each axis, and each within a hundredth of the scan's least spacing of the place of
/// its own, which is more than decimals of a header lose. Says which of size, spacing, direction
/// and origin is another.
void CheckLabelGrid(const char* who, const GridGeometry& scan, const GridGeometry& labels);

/// Puts labels of a part of a scan in their places: a label map that was cropped, or reaches beyond
/// the scan, or has its axes in another order or against the scan's.
///
/// labels  each sample within a hundredth of the scan's least spacing of a place of the scan's
///         lattice, inside of the scan or not
/// scan    the scan's geometry; the samples become labels, and 0 where there are none
///
/// Throws std::invalid_argument, beginning with `who`, if labels lie beside the lattice (with what
/// differs: nothing is ever resampled) or a label that is not 0 lies outside of the scan (with how
/// many do), and as GridGeometry::Validate; Cancelled. Then the scan's samples are undefined. Any
/// thread; no state kept; O(samples of both), on all cores.
void PlaceLabels(const char* who, GridView<const std::uint16_t> labels,
  GridView<std::uint16_t> scan, const ProgressFunction& progress = {});

} // namespace hasp
