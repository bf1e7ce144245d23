#include "Isosurface/ActiveCells.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ClusterLayer.h"
#include "Isosurface/CompactCells.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace hasp
{

namespace
{

void RefuseOtherBlocks(const AnyGridView& grid, const MinMaxBlocks& blocks, const char* who)
{
  if (blocks.Blocks() != (GeometryOf(grid).Cells() + MinMaxBlocks::Side - 1) / MinMaxBlocks::Side)
    throw std::invalid_argument(std::string(who) + ": the min-max blocks are of another grid");
}

/// Layers [from, to), each restricted to the rectangle of blocks.
std::vector<ClusterLayer> ExtractLayers(const AnyGridView& grid, const MinMaxBlocks& blocks,
  float isovalue, int from, int to, const BlockRectangle& rectangle)
{
  std::vector<ClusterLayer> layers(to - from);
  ParallelFor(from, to, 1,
    [&](std::int64_t z, std::int64_t)
    { layers[z - from] = ExtractLayer(grid, blocks, isovalue, int(z), rectangle); });
  return layers;
}

/// Blocks [from, to) along each axis.
struct BlockBox
{
  glm::ivec3 from, to;
};

bool Inside(const BlockBox& box, const CellCluster& cluster)
{
  const glm::ivec3 block = cluster.Origin() / MinMaxBlocks::Side;
  return glm::all(glm::greaterThanEqual(block, box.from)) && glm::all(glm::lessThan(block, box.to));
}

bool RasterBefore(const CellCluster& a, const CellCluster& b)
{
  const glm::ivec3 p = a.Origin(), q = b.Origin();
  return std::tie(p.z, p.y, p.x) < std::tie(q.z, q.y, q.x);
}

/// Where a cluster's corners end, in words.
std::size_t EndWord(const ClusteredCells& cells, std::size_t cluster)
{
  return cluster + 1 < cells.clusters.size() ? cells.clusters[cluster + 1].firstWord
                                             : cells.corners.size() - PaddingWords;
}

/// One cluster of `from` after what `layer` has.
void AppendCluster(const ClusteredCells& from, std::size_t n, ClusterLayer& layer)
{
  CellCluster cluster = from.clusters[n];
  const auto words = from.corners.begin();
  const auto first = words + cluster.firstWord, end = words + std::ptrdiff_t(EndWord(from, n));
  cluster.firstWord = static_cast<std::uint32_t>(layer.corners.size());
  cluster.firstCell = static_cast<std::uint32_t>(layer.cells);
  layer.corners.insert(layer.corners.end(), first, end);
  layer.clusters.push_back(cluster);
  layer.cells += (n + 1 < from.clusters.size() ? from.clusters[n + 1].firstCell : from.count) -
                 from.clusters[n].firstCell;
}

/// Puts `middle` in the place of [from, to).
template <typename T>
void Splice(std::vector<T>& values, std::size_t from, std::size_t to, const std::vector<T>& middle)
{
  const std::size_t common = std::min(to - from, middle.size());
  const auto at = std::copy_n(middle.begin(), common, values.begin() + std::ptrdiff_t(from));
  if (common < middle.size())
    values.insert(at, middle.begin() + std::ptrdiff_t(common), middle.end());
  else
    values.erase(at, values.begin() + std::ptrdiff_t(to));
}

/// Puts the clusters of `fresh`, all in the box, in the place of those of `cells` there. What lies
/// before the box stays where it is, what lies behind is moved as a whole.
void Replace(ClusteredCells& cells, const ClusteredCells& fresh, const BlockBox& box)
{
  const std::size_t count = cells.clusters.size();
  const auto before = [&](const glm::ivec3& block)
  {
    CellCluster place;
    place.place = { block.x | block.y << 13, block.z };
    const auto at =
      std::lower_bound(cells.clusters.begin(), cells.clusters.end(), place, RasterBefore);
    return static_cast<std::size_t>(at - cells.clusters.begin());
  };
  const auto firstWord = [&](std::size_t n)
  { return n < count ? cells.clusters[n].firstWord : cells.corners.size() - PaddingWords; };
  const auto firstCell = [&](std::size_t n)
  { return n < count ? cells.clusters[n].firstCell : cells.count; };
  const std::size_t begin = before(box.from);
  std::size_t end = before(box.to - 1);
  end += end < count && Inside(box, cells.clusters[end]);

  ClusterLayer middle;
  middle.clusters.reserve(end - begin + fresh.clusters.size());
  middle.corners.reserve(firstWord(end) - firstWord(begin) + fresh.corners.size());
  for (std::size_t old = begin, next = 0; old < end || next < fresh.clusters.size();)
    if (old < end && Inside(box, cells.clusters[old]))
      ++old;
    else if (next == fresh.clusters.size() ||
             (old < end && RasterBefore(cells.clusters[old], fresh.clusters[next])))
      AppendCluster(cells, old++, middle);
    else
      AppendCluster(fresh, next++, middle);

  const std::size_t wordsFrom = firstWord(begin), wordsTo = firstWord(end);
  const std::size_t cellsFrom = firstCell(begin), cellsTo = firstCell(end);
  RefuseTooMany(cells.count + middle.cells - (cellsTo - cellsFrom),
    cells.corners.size() + middle.corners.size() - (wordsTo - wordsFrom));
  const auto shiftOf = [](std::size_t from, std::size_t to, std::size_t now)
  { return static_cast<std::uint32_t>(from + now - to); }; // wraps where it is less than 0
  const std::uint32_t moreWords = shiftOf(wordsFrom, wordsTo, middle.corners.size());
  const std::uint32_t moreCells = shiftOf(cellsFrom, cellsTo, middle.cells);
  for (CellCluster& cluster : middle.clusters)
  {
    cluster.firstWord += static_cast<std::uint32_t>(wordsFrom);
    cluster.firstCell += static_cast<std::uint32_t>(cellsFrom);
  }
  for (std::size_t n = end; n < count; ++n)
  {
    cells.clusters[n].firstWord += moreWords;
    cells.clusters[n].firstCell += moreCells;
  }
  cells.count += middle.cells - (cellsTo - cellsFrom);
  Splice(cells.corners, wordsFrom, wordsTo, middle.corners);
  Splice(cells.clusters, begin, end, middle.clusters);
}

} // namespace

ClusteredCells ExtractActiveCells(const AnyGridView& grid, const MinMaxBlocks& blocks,
  double isovalue, CellPrecision precision, const ProgressFunction& progress)
{
  ClusteredCells cells = BeginCells(grid, isovalue);
  RefuseOtherBlocks(grid, blocks, "ExtractActiveCells");
  const glm::ivec3 n = blocks.Blocks();
  constexpr int layersAtATime = 8; // progress and cancel between them
  for (int z = 0; z < n.z; z += layersAtATime)
  {
    ReportProgress(progress, double(z) / n.z);
    const int end = std::min(n.z, z + layersAtATime);
    for (const ClusterLayer& layer :
      ExtractLayers(grid, blocks, cells.isovalue, z, end, { { 0, 0 }, { n.x, n.y } }))
      AppendLayer(layer, cells);
  }
  FinishCells(cells);
  if (precision == CellPrecision::Compact)
    cells = CompactCells(cells);
  ReportProgress(progress, 1.0);
  return cells;
}

void UpdateActiveCells(ClusteredCells& cells, const AnyGridView& grid, MinMaxBlocks& blocks,
  const glm::ivec3& low, const glm::ivec3& high)
{
  ClusteredCells fresh = BeginCells(grid, cells.isovalue);
  RefuseOtherBlocks(grid, blocks, "UpdateActiveCells");
  if (cells.geometry.dims != fresh.geometry.dims || cells.cornerType != fresh.cornerType)
    throw std::invalid_argument("UpdateActiveCells: the cells are of another grid");
  blocks.Update(grid, low, high);
  cells.geometry = fresh.geometry;
  const auto [from, to] = blocks.Touched(low, high);
  if (from == to)
    return;
  const BlockBox box{ from, to };
  const BlockRectangle rectangle{ glm::ivec2(from), glm::ivec2(to) };
  for (const ClusterLayer& layer :
    ExtractLayers(grid, blocks, cells.isovalue, from.z, to.z, rectangle))
    AppendLayer(layer, fresh);
  FinishCells(fresh);

  if (cells.precision == CellPrecision::Compact)
  {
    int exponent = CompactExponent(fresh);
    for (const CellCluster& cluster : cells.clusters)
      if (!Inside(box, cluster))
        exponent = std::max(exponent, CompactExponent(cluster));
    if (cells.levels != CompactLevels(std::ldexp(1.0, exponent)))
    {
      cells = ExtractActiveCells(grid, blocks, cells.isovalue, CellPrecision::Compact);
      return;
    }
    fresh = CompactCells(fresh, exponent);
  }
  cells.labels.clear();
  cells.colors.clear();
  cells.firstColors.clear();
  Replace(cells, fresh, box);
}

} // namespace hasp
