#pragma once
#include "Grid/MinMaxBlocks.h"
#include "Grid/Progress.h"
#include "Isosurface/ClusteredCells.h"

namespace hasp
{

/// The active cells of an isosurface: those with corners on both sides of the isovalue, where
/// inside is sample >= isovalue. A cell with a NaN or infinite corner has no polynomial and is not
/// active.
///
/// blocks    of the same grid; whole blocks without surface are never touched
/// isovalue  finite. It is rounded to float first: the same number decides here and in the shader.
/// Throws std::invalid_argument if the isovalue is not finite, if blocks and grid do not match, or
/// if an axis has more than 524,288 samples (16-bit cluster origins) or there are 2^23 clusters or
/// more; Cancelled if progress says so. O(samples of active blocks), all threads, the same bytes
/// whatever their number.
ClusteredCells ExtractActiveCells(const AnyGridView& grid, const MinMaxBlocks& blocks,
  double isovalue, const ProgressFunction& progress = {});

} // namespace hasp
