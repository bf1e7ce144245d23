#include "Isosurface/ActiveCells.h"
#include "Grid/ParallelFor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace hasp
{

namespace
{

constexpr int Side = MinMaxBlocks::Side;
constexpr std::size_t MaxClusters = std::size_t{ 1 } << 23;

template <typename T>
constexpr CornerType CornersOf = std::is_same_v<T, float>          ? CornerType::Float32
                                 : std::is_same_v<T, std::int16_t> ? CornerType::Int16
                                                                   : CornerType::UInt16;

template <typename T>
void AppendCorners(const GridView<const T>& grid, const glm::ivec3& cell, ClusteredCells& out)
{
  const T* p = &grid(cell.x, cell.y, cell.z);
  const std::size_t row = grid.geometry.dims.x, slice = row * grid.geometry.dims.y;
  for (const std::size_t pair : { std::size_t{ 0 }, row, slice, slice + row })
  {
    if constexpr (std::is_same_v<T, float>)
    {
      out.words.push_back(std::bit_cast<std::uint32_t>(p[pair]));
      out.words.push_back(std::bit_cast<std::uint32_t>(p[pair + 1]));
    }
    else
      out.words.push_back(
        static_cast<std::uint16_t>(p[pair]) |
        static_cast<std::uint32_t>(static_cast<std::uint16_t>(p[pair + 1])) << 16);
  }
}

/// One bit per sample of a row: which are inside, and which are NaN or infinite.
struct RowBits
{
  std::uint32_t inside = 0, notFinite = 0;
};

template <typename T>
RowBits ReadRow(const T* row, int count, float isovalue)
{
  RowBits bits;
  for (int i = 0; i < count; ++i)
  {
    bits.inside |= static_cast<std::uint32_t>(static_cast<float>(row[i]) >= isovalue) << i;
    if constexpr (std::is_same_v<T, float>)
      bits.notFinite |= static_cast<std::uint32_t>(!std::isfinite(row[i])) << i;
  }
  return bits;
}

/// One bit per cell of the row between four sample rows: corners on both sides, and all finite.
std::uint32_t ActiveInRow(const RowBits& a, const RowBits& b, const RowBits& c, const RowBits& d)
{
  const std::uint32_t any = a.inside | b.inside | c.inside | d.inside;
  const std::uint32_t all = a.inside & b.inside & c.inside & d.inside;
  const std::uint32_t bad = a.notFinite | b.notFinite | c.notFinite | d.notFinite;
  return (any | any >> 1) & ~(all & all >> 1) & ~(bad | bad >> 1);
}

template <typename T>
void ExtractBlock(
  const GridView<const T>& grid, const glm::ivec3& block, float isovalue, ClusteredCells& out)
{
  const glm::ivec3 origin = block * Side;
  const glm::ivec3 cells = glm::min(glm::ivec3(Side), grid.geometry.Cells() - origin);
  RowBits rows[Side + 1][Side + 1];
  for (int k = 0; k <= cells.z; ++k)
    for (int j = 0; j <= cells.y; ++j)
      rows[k][j] = ReadRow(&grid(origin.x, origin.y + j, origin.z + k), cells.x + 1, isovalue);

  const std::uint32_t inBlock = (1U << cells.x) - 1U;
  const auto cluster = static_cast<std::uint32_t>(out.clusters.size());
  bool used = false;
  for (int k = 0; k < cells.z; ++k)
    for (int j = 0; j < cells.y; ++j)
    {
      std::uint32_t active =
        inBlock & ActiveInRow(rows[k][j], rows[k][j + 1], rows[k + 1][j], rows[k + 1][j + 1]);
      for (; active != 0; active &= active - 1)
      {
        const int i = std::countr_zero(active);
        out.words.push_back(cluster << 9 | static_cast<std::uint32_t>(k << 6 | j << 3 | i));
        AppendCorners(grid, origin + glm::ivec3(i, j, k), out);
        used = true;
      }
    }
  if (!used)
    return;
  out.clusters.emplace_back(static_cast<std::uint32_t>(block.x | block.y << 16), block.z);
  out.firstCells.push_back(static_cast<std::uint32_t>(out.Count()));
}

/// Puts the layers, in order, into one structure; cluster indices count on.
void Join(std::vector<ClusteredCells>& layers, ClusteredCells& whole)
{
  std::size_t words = 0, clusters = 0;
  for (const ClusteredCells& layer : layers)
  {
    words += layer.words.size();
    clusters += layer.clusters.size();
  }
  if (clusters >= MaxClusters)
    throw std::invalid_argument(
      "ExtractActiveCells: " + std::to_string(clusters) + " clusters with surface; fewer than " +
      std::to_string(MaxClusters) + " fit: crop the volume or choose another isovalue");
  whole.words.reserve(words);
  whole.clusters.reserve(clusters);
  whole.firstCells.reserve(clusters + 1);
  const std::size_t stride = whole.Stride();
  for (ClusteredCells& layer : layers)
  {
    const auto shift = static_cast<std::uint32_t>(whole.clusters.size()) << 9;
    const auto before = static_cast<std::uint32_t>(whole.Count());
    for (std::size_t c = 1; c < layer.firstCells.size(); ++c)
      whole.firstCells.push_back(before + layer.firstCells[c]);
    for (std::size_t w = 0; w < layer.words.size(); w += stride)
      layer.words[w] += shift;
    whole.words.insert(whole.words.end(), layer.words.begin(), layer.words.end());
    whole.clusters.insert(whole.clusters.end(), layer.clusters.begin(), layer.clusters.end());
    layer = {};
  }
}

} // namespace

ClusteredCells ExtractActiveCells(const AnyGridView& grid, const MinMaxBlocks& blocks,
  double isovalue, const ProgressFunction& progress)
{
  const GridGeometry& geometry = GeometryOf(grid);
  geometry.Validate();
  const glm::ivec3 n = blocks.Blocks();
  if (!std::isfinite(static_cast<float>(isovalue)))
    throw std::invalid_argument("ExtractActiveCells: the isovalue must be a finite number");
  if (n != (geometry.Cells() + Side - 1) / Side)
    throw std::invalid_argument("ExtractActiveCells: the min-max blocks are of another grid");
  if (std::max({ n.x, n.y, n.z }) > 0xFFFF)
    throw std::invalid_argument("ExtractActiveCells: more than 524,288 samples along one axis");

  ClusteredCells whole;
  whole.geometry = geometry;
  whole.isovalue = static_cast<float>(isovalue);
  std::vector<ClusteredCells> layers(n.z);
  constexpr int layersAtATime = 8; // progress and cancel between them
  std::visit(
    [&]<typename T>(const GridView<const T>& view)
    {
      whole.cornerType = CornersOf<T>;
      const auto extractLayer = [&](std::int64_t z, std::int64_t)
      {
        layers[z].cornerType = whole.cornerType;
        for (int y = 0; y < n.y; ++y)
          for (int x = 0; x < n.x; ++x)
            if (blocks.Active({ x, y, int(z) }, whole.isovalue))
              ExtractBlock(view, { x, y, int(z) }, whole.isovalue, layers[z]);
      };
      for (int z = 0; z < n.z; z += layersAtATime)
      {
        ReportProgress(progress, double(z) / n.z);
        ParallelFor(z, std::min(n.z, z + layersAtATime), 1, extractLayer);
      }
    },
    grid);
  Join(layers, whole);
  ReportProgress(progress, 1.0);
  return whole;
}

} // namespace hasp
