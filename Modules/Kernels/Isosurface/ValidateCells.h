#pragma once
#include "Grid/Progress.h"
#include "Isosurface/ClusteredCells.h"

namespace hasp
{

/// Holds cells of unknown origin against all that ClusteredCells and glsl/CellLayout.glsl promise,
/// so that whoever draws or traces them may trust every count and place in them: clusters inside
/// the grid, in raster order, none empty; prefixes that follow from the cells' bits; corners inside
/// the stream, of a legal width, finite, on both sides of the isovalue in each active cell; levels,
/// labels and colours of the right number.
///
/// Whatever the cells hold, this neither reads beyond them nor runs longer than their size asks
/// for. Throws std::invalid_argument with the first fault found, in the order of the clusters;
/// Cancelled. O(cells), all threads, the same fault whatever their number.
void ValidateCells(const ClusteredCells& cells, const ProgressFunction& progress = {});

} // namespace hasp
