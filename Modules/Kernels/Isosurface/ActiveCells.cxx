#include "Isosurface/ActiveCells.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ClusterLayer.h"
#include "Isosurface/CompactCells.h"

#include <algorithm>
#include <cmath>
#include <ranges>
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

/// The first cluster not before a block in raster order; the number of clusters if there is none.
std::size_t ClusterAt(const ClusteredCells& cells, const glm::ivec3& block)
{
  const auto before = [](const CellCluster& cluster, const glm::ivec3& other)
  {
    const glm::ivec3 own = cluster.Origin() / MinMaxBlocks::Side;
    return std::tie(own.z, own.y, own.x) < std::tie(other.z, other.y, other.x);
  };
  const auto begin = cells.clusters.begin(), end = cells.clusters.end();
  return static_cast<std::size_t>(std::lower_bound(begin, end, block, before) - begin);
}

/// Numbers of clusters, words of corners and cells: a size, or a place among them.
struct Extent
{
  std::size_t clusters = 0, words = 0, cells = 0;
};

Extent ExtentBefore(const ClusteredCells& cells, std::size_t cluster)
{
  if (cluster == cells.clusters.size())
    return { cluster, cells.corners.size() - PaddingWords, cells.count };
  return { cluster, cells.clusters[cluster].firstWord, cells.clusters[cluster].firstCell };
}

/// Clusters in a row, kept or fresh, and the place they go to.
struct Run
{
  bool fresh;
  Extent from, to, place;
};

/// What cells are made of when the fresh ones take the place of all in the box, in raster order;
/// `size` becomes the size of it all.
std::vector<Run> RunsOf(
  const ClusteredCells& cells, const ClusteredCells& fresh, const BlockBox& box, Extent& size)
{
  std::vector<Run> runs;
  const auto add = [&](bool isFresh, std::size_t first, std::size_t last)
  {
    const ClusteredCells& source = isFresh ? fresh : cells;
    const Extent from = ExtentBefore(source, first), to = ExtentBefore(source, last);
    runs.push_back({ isFresh, from, to, size });
    size.clusters += to.clusters - from.clusters;
    size.words += to.words - from.words;
    size.cells += to.cells - from.cells;
  };
  std::size_t kept = 0, next = 0;
  for (int z = box.from.z; z < box.to.z; ++z)
    for (int y = box.from.y; y < box.to.y; ++y)
    {
      const std::size_t freshEnd = ClusterAt(fresh, { box.to.x, y, z });
      const std::size_t begin = ClusterAt(cells, { box.from.x, y, z });
      const std::size_t end = ClusterAt(cells, { box.to.x, y, z });
      if (begin == end && next == freshEnd)
        continue;
      add(false, kept, begin);
      add(true, next, freshEnd);
      kept = end;
      next = freshEnd;
    }
  add(false, kept, cells.clusters.size());
  return runs;
}

/// Moves each run of values to its place. What moves to the front goes first, from the front, then
/// what moves to the back, from the back: so nothing is overwritten that is still needed.
template <typename T>
void MoveRuns(std::vector<T>& values, const std::vector<T>& fresh, const std::vector<Run>& runs,
  std::size_t Extent::*unit, std::size_t size)
{
  const auto at = [](auto& vector, std::size_t n) { return vector.begin() + std::ptrdiff_t(n); };
  values.resize(std::max(values.size(), size));
  for (const Run& run : runs)
    if (!run.fresh && run.place.*unit < run.from.*unit)
      std::copy(at(values, run.from.*unit), at(values, run.to.*unit), at(values, run.place.*unit));
  for (const Run& run : runs | std::views::reverse)
    if (!run.fresh && run.place.*unit > run.from.*unit)
      std::copy_backward(at(values, run.from.*unit), at(values, run.to.*unit),
        at(values, run.place.*unit + run.to.*unit - run.from.*unit));
  for (const Run& run : runs)
    if (run.fresh)
      std::copy(at(fresh, run.from.*unit), at(fresh, run.to.*unit), at(values, run.place.*unit));
  values.resize(size);
}

/// Where the words and cells of each cluster begin, once all are in place.
void NumberClusters(std::vector<CellCluster>& clusters, const std::vector<Run>& runs)
{
  for (const Run& run : runs)
  {
    // Differences of unsigned numbers, right also where they wrap.
    const auto words = static_cast<std::uint32_t>(run.place.words - run.from.words);
    const auto count = static_cast<std::uint32_t>(run.place.cells - run.from.cells);
    if (words == 0 && count == 0)
      continue;
    const std::size_t end = run.place.clusters + run.to.clusters - run.from.clusters;
    for (std::size_t n = run.place.clusters; n < end; ++n)
    {
      clusters[n].firstWord += words;
      clusters[n].firstCell += count;
    }
  }
}

/// Puts the clusters of `fresh`, all in the box, in the place of those of `cells` there.
void Replace(ClusteredCells& cells, const ClusteredCells& fresh, const BlockBox& box)
{
  Extent size;
  const std::vector<Run> runs = RunsOf(cells, fresh, box, size);
  RefuseTooMany(size.cells, size.words);
  cells.count = size.cells;
  const auto moveCorners = [&]
  {
    MoveRuns(cells.corners, fresh.corners, runs, &Extent::words, size.words);
    FinishCells(cells);
  };
  const auto moveClusters = [&]
  {
    MoveRuns(cells.clusters, fresh.clusters, runs, &Extent::clusters, size.clusters);
    NumberClusters(cells.clusters, runs);
  };
  ParallelFor(
    0, 2, 1, [&](std::int64_t n, std::int64_t) { n == 0 ? moveCorners() : moveClusters(); });
}

/// The clusters in the box, its blocks read anew first.
std::vector<ClusterLayer> UpdateLayers(
  const AnyGridView& grid, MinMaxBlocks& blocks, float isovalue, const BlockBox& box)
{
  const glm::ivec3 from = box.from, to = box.to;
  std::vector<ClusterLayer> layers(to.z - from.z);
  ParallelFor(from.z, to.z, 1,
    [&](std::int64_t z, std::int64_t)
    {
      blocks.Read(grid, { from.x, from.y, int(z) }, { to.x, to.y, int(z) + 1 });
      layers[z - from.z] = ExtractLayer(grid, blocks, isovalue, int(z), { from, to });
    });
  return layers;
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
    std::vector<ClusterLayer> layers(end - z);
    ParallelFor(z, end, 1,
      [&](std::int64_t layer, std::int64_t)
      {
        layers[layer - z] =
          ExtractLayer(grid, blocks, cells.isovalue, int(layer), { { 0, 0 }, { n.x, n.y } });
      });
    for (const ClusterLayer& layer : layers)
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
  cells.geometry = fresh.geometry;
  const auto [from, to] = blocks.Touched(low, high);
  if (from == to)
    return;
  const BlockBox box{ from, to };
  for (const ClusterLayer& layer : UpdateLayers(grid, blocks, cells.isovalue, box))
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
