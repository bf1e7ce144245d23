#pragma once
#include "Isosurface/ClusteredCells.h"

#include <functional>
#include <span>

namespace hasp
{

/// Gives each active cell a label: the most frequent one, 0 not counted, of the samples at its
/// corners that are inside; the smaller of two that are as frequent; 0 if there is none.
///
/// labels  one a sample, of the cells' own geometry; whole numbers in [0, 65535]. 0: no label.
/// Throws std::invalid_argument, and leaves the cells as they were, if the geometries differ, if
/// the labels are floats or if one that counts is negative. Replaces what labels there were. 2
/// bytes a cell. O(cells), all threads, the same bytes whatever their number.
void AddLabels(ClusteredCells& cells, const AnyGridView& labels);

/// Some of the active cells: [first, end), by their numbers.
struct CellRange
{
  std::size_t first = 0, end = 0;
  bool Empty() const { return first >= end; }
};

/// The same after labels of samples low to high (both included; clamped) have changed, of cells
/// that have labels: reads the clusters alone that touch these samples. Returns a range that holds
/// every cell whose label is another than before, as short as it can be. Errors as AddLabels';
/// std::invalid_argument, too, if the cells have no labels. O(clusters + cells of those clusters),
/// all threads.
CellRange UpdateLabels(
  ClusteredCells& cells, const AnyGridView& labels, const glm::ivec3& low, const glm::ivec3& high);

/// The sample, x fastest in the cells' grid, that each stored corner is: cluster by cluster, in the
/// order of ClusteredCells::corners and ::colors. O(corners), all threads.
std::vector<std::int64_t> SamplesOfCorners(const ClusteredCells& cells);

/// The colours of samples: fills `colors` with RGBA, 8 bits each, red lowest, one for each of
/// `samples` (see SamplesOfCorners). Called once, by the thread that called AddColors.
using ColorFunction =
  std::function<void(std::span<const std::int64_t> samples, std::span<std::uint32_t> colors)>;

/// Gives each stored corner a colour. Replaces what colours there were; leaves them as they were if
/// colorOf throws. 4 bytes a corner and 4 a cluster; while it works, 8 more a corner.
void AddColors(ClusteredCells& cells, const ColorFunction& colorOf);

/// The same from colours of all samples of the cells' grid. Throws std::invalid_argument if the
/// geometries differ. O(corners), all threads, the same bytes whatever their number.
void AddColors(ClusteredCells& cells, const GridView<const std::uint32_t>& colors);

} // namespace hasp
