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
/// Throws std::invalid_argument if the isovalue is not finite, if blocks and grid do not match, if
/// an axis has more than 65,537 samples or 32 bits cannot number the cells; Cancelled if progress
/// says so. O(samples of active blocks), all threads, the same bytes whatever their number.
ClusteredCells ExtractActiveCells(const AnyGridView& grid, const MinMaxBlocks& blocks,
  double isovalue, CellPrecision precision = CellPrecision::Exact,
  const ProgressFunction& progress = {});

/// Brings cells and blocks up to date after samples in a box have changed (sculpting, CSG): only
/// the blocks that touch the box are read. The result is, byte for byte, what ExtractActiveCells
/// gives for the whole volume. Attributes (labels, colours) are dropped: add them again.
///
/// cells     of this grid's size and sample type; its place in the world becomes theirs
/// blocks    of the grid before the change; updated
/// low, high first and last sample that changed, clamped to the grid
/// Compact cells are made anew in whole if the change moves the power of two above the largest
/// distance of a corner from the isovalue, for then all levels change.
/// Throws std::invalid_argument if cells, blocks and grid do not match, before anything is changed,
/// or if 32 bits cannot number the cells; then, and where memory ends, blocks and cells are between
/// two states and must be made anew. Nobody may read the cells meanwhile. O(samples in the box) and
/// moving the bytes behind it, all threads.
void UpdateActiveCells(ClusteredCells& cells, const AnyGridView& grid, MinMaxBlocks& blocks,
  const glm::ivec3& low, const glm::ivec3& high);

} // namespace hasp
