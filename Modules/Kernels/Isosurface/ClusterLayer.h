#pragma once
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/ClusteredCells.h"

namespace hasp
{

/// Clusters of one layer of blocks before they are joined with the others: firstWord and firstCell
/// count from the layer's beginning; corners have no padding.
struct ClusterLayer
{
  std::vector<CellCluster> clusters;
  std::vector<std::uint32_t> corners;
  std::size_t cells = 0;
};

/// Blocks [from, to) along x and y.
struct BlockRectangle
{
  glm::ivec2 from, to;
};

/// The clusters of blocks (x, y, layer) of the grid with x, y in the rectangle, in raster order.
///
/// grid      a volume, or some slices of it; then `layersBelow` of the volume's layers lie before
/// blocks    of the grid; blocks without surface are not read
/// isovalue  finite
/// Any thread; layers may be made side by side. O(samples of active blocks).
ClusterLayer ExtractLayer(const AnyGridView& grid, const MinMaxBlocks& blocks, float isovalue,
  int layer, const BlockRectangle& rectangle, int layersBelow = 0);

/// Appends the cluster of one block of a coarser grid that has each stride-th sample of this one;
/// its cells are as long as `stride` samples are apart. False, and nothing appended, if no cell of
/// it is active or lies whole in the grid.
///
/// block   its place, in units of 8 cells of the coarser grid; not negative, and it begins in the
/// grid stride  >= 1; 1 is the grid itself Any thread. About 2 us.
bool ExtractCluster(
  const AnyGridView& grid, float isovalue, const glm::ivec3& block, int stride, ClusterLayer& out);

/// Throws std::invalid_argument if 32 bits cannot number so many.
void RefuseTooMany(std::size_t cells, std::size_t cornerWords);

/// Puts a layer after what `cells` has; the padding comes last: FinishCells. Throws as
/// RefuseTooMany does.
void AppendLayer(const ClusterLayer& layer, ClusteredCells& cells);

/// Words after the corners, so that a pair of corners can be read in one go.
constexpr std::size_t PaddingWords = 2;

/// Adds the padding.
void FinishCells(ClusteredCells& cells);

/// What the grid's samples become. Throws std::invalid_argument if the isovalue is not finite as a
/// float or an axis has more than 65,537 samples: the empty beginning of every extraction.
ClusteredCells BeginCells(const AnyGridView& grid, double isovalue);

} // namespace hasp
