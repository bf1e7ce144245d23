#include "Isosurface/ClusterLayer.h"
#include "Isosurface/BlockRow.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace hasp
{

namespace
{

constexpr int Side = MinMaxBlocks::Side;
constexpr int MostCorners = (Side + 1) * (Side + 1) * (Side + 1);
constexpr int MostBlocks = 1 << 13; // along an axis: what a cluster's origin can say

template <typename T>
constexpr CornerType CornersOf = std::is_same_v<T, float>          ? CornerType::Float32
                                 : std::is_same_v<T, std::int16_t> ? CornerType::Int16
                                                                   : CornerType::UInt16;

/// The samples of a cluster's corners, in the order of the stream; fills cornersBefore. origin: the
/// cluster's first sample in the grid.
template <typename T>
int GatherCorners(
  const GridView<const T>& grid, const glm::ivec3& origin, CellCluster& cluster, T* out)
{
  int count = 0;
  for (int z = 0; z <= Side; ++z)
  {
    if (z > 0)
      cluster.cornersBefore[z - 1] = static_cast<std::uint16_t>(count);
    std::uint64_t slice = cluster.TouchSlice(z);
    for (std::uint32_t y = 0, last = 0; slice != 0 || last != 0; ++y, slice >>= 8)
    {
      const std::uint32_t cells = slice & 0xFF, touched = cells | last;
      last = cells;
      if (touched == 0)
        continue;
      const T* row = &grid(origin.x, origin.y + int(y), origin.z + z);
      for (std::uint32_t bits = touched | touched << 1; bits != 0; bits &= bits - 1)
        out[count++] = row[std::countr_zero(bits)];
    }
  }
  return count;
}

/// Appends values, `width` bits each, from a word of its own.
class BitStream
{
public:
  BitStream(std::vector<std::uint32_t>& words, std::size_t values, int width) : Width(width)
  {
    const std::size_t first = words.size();
    words.resize(first + (values * width + 31) / 32);
    this->Next = words.data() + first;
  }
  ~BitStream()
  {
    if (this->Count > 0)
      *this->Next = static_cast<std::uint32_t>(this->Waiting);
  }
  BitStream(const BitStream&) = delete;
  BitStream& operator=(const BitStream&) = delete;

  void Put(std::uint32_t value)
  {
    this->Waiting |= std::uint64_t{ value } << this->Count;
    this->Count += this->Width;
    if (this->Count < 32)
      return;
    *this->Next++ = static_cast<std::uint32_t>(this->Waiting);
    this->Waiting >>= 32;
    this->Count -= 32;
  }

private:
  std::uint32_t* Next;
  std::uint64_t Waiting = 0;
  int Width, Count = 0;
};

/// Its active cells are known. block: its place in units of 8 cells of the volume.
template <typename T>
void AppendCluster(const GridView<const T>& grid, const glm::ivec3& origin, const glm::ivec3& block,
  CellCluster& cluster, ClusterLayer& out)
{
  T values[MostCorners];
  const int count = GatherCorners(grid, origin, cluster, values);
  T least = values[0], most = values[0];
  for (int n = 1; n < count; ++n)
  {
    least = values[n] < least ? values[n] : least;
    most = values[n] > most ? values[n] : most;
  }
  int width = 32;
  std::uint16_t base = 0;
  if constexpr (!std::is_same_v<T, float>)
  {
    width = std::bit_width(static_cast<std::uint32_t>(int(most) - int(least)));
    base = static_cast<std::uint16_t>(least);
  }
  cluster.place = { block.x | block.y << 13 | std::uint32_t(width) << 26,
    block.z | std::uint32_t{ base } << 16 };
  cluster.firstWord = static_cast<std::uint32_t>(out.corners.size());
  cluster.firstCell = static_cast<std::uint32_t>(out.cells);
  BitStream stream(out.corners, count, width);
  for (int n = 0; n < count; ++n)
    if constexpr (std::is_same_v<T, float>)
      stream.Put(std::bit_cast<std::uint32_t>(values[n]));
    else
      stream.Put(static_cast<std::uint16_t>(values[n] - least));
  out.cells += cluster.CellCount();
  out.clusters.push_back(cluster);
}

template <typename T>
void ExtractRow(const GridView<const T>& grid, const MinMaxBlocks& blocks, BlockRow<T>& row,
  float isovalue, int fromX, int toX, int y, int layer, int layersBelow, ClusterLayer& out)
{
  int first = toX, end = fromX;
  for (int x = fromX; x < toX; ++x)
    if (blocks.Active({ x, y, layer }, isovalue))
    {
      first = std::min(first, x);
      end = x + 1;
    }
  if (first >= end)
    return;
  row.Read(first, end, y, layer);
  CellCluster cluster;
  for (int x = first; x < end; ++x)
    if (blocks.Active({ x, y, layer }, isovalue) && row.ActiveCells(x, cluster.active))
      AppendCluster(
        grid, glm::ivec3(x, y, layer) * Side, { x, y, layer + layersBelow }, cluster, out);
}

/// The samples of a block's corners, each stride-th along the axes of the grid.
template <typename T>
class BlockSamples
{
public:
  BlockSamples(const GridView<const T>& grid, const glm::ivec3& first, int stride)
  {
    const glm::ivec3 n = glm::min((grid.geometry.dims - 1 - first) / stride, Side) + 1;
    this->View.geometry.dims = n;
    this->View.data = this->Values;
    T* out = this->Values;
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x)
          *out++ = grid(first.x + x * stride, first.y + y * stride, first.z + z * stride);
  }
  BlockSamples(const BlockSamples&) = delete;
  BlockSamples& operator=(const BlockSamples&) = delete;

  const GridView<const T>& Grid() const { return this->View; }
  /// Can the isosurface pass? NaN is neither below nor above.
  bool Meets(float isovalue) const
  {
    const T* end = this->Values + this->View.geometry.Size();
    const auto inside = [isovalue](T sample) { return float(sample) >= isovalue; };
    const auto below = [isovalue](T sample) { return float(sample) < isovalue; };
    return std::any_of(this->Values, end, inside) && std::any_of(this->Values, end, below);
  }

private:
  T Values[MostCorners];
  GridView<const T> View;
};

} // namespace

ClusterLayer ExtractLayer(const AnyGridView& grid, const MinMaxBlocks& blocks, float isovalue,
  int layer, const BlockRectangle& rectangle, int layersBelow)
{
  ClusterLayer out;
  std::visit(
    [&]<typename T>(const GridView<const T>& view)
    {
      BlockRow<T> row(view, isovalue);
      for (int y = rectangle.from.y; y < rectangle.to.y; ++y)
        ExtractRow(view, blocks, row, isovalue, rectangle.from.x, rectangle.to.x, y, layer,
          layersBelow, out);
    },
    grid);
  return out;
}

bool ExtractCluster(
  const AnyGridView& grid, float isovalue, const glm::ivec3& block, int stride, ClusterLayer& out)
{
  return std::visit(
    [&]<typename T>(const GridView<const T>& view)
    {
      const BlockSamples<T> samples(view, block * (Side * stride), stride);
      const bool hasCells = glm::all(glm::greaterThan(samples.Grid().geometry.dims, glm::ivec3(1)));
      if (!hasCells || !samples.Meets(isovalue))
        return false;
      BlockRow<T> row(samples.Grid(), isovalue);
      row.Read(0, 1, 0, 0);
      CellCluster cluster;
      if (!row.ActiveCells(0, cluster.active))
        return false;
      AppendCluster(samples.Grid(), glm::ivec3(0), block, cluster, out);
      return true;
    },
    grid);
}

ClusteredCells BeginCells(const AnyGridView& grid, double isovalue)
{
  const GridGeometry& geometry = GeometryOf(grid);
  geometry.Validate();
  ClusteredCells cells;
  cells.geometry = geometry;
  cells.isovalue = static_cast<float>(isovalue);
  if (!std::isfinite(cells.isovalue))
    throw std::invalid_argument("ExtractActiveCells: the isovalue must be a finite number");
  const glm::ivec3& dims = geometry.dims;
  if (std::max({ dims.x, dims.y, dims.z }) - 1 > MostBlocks * Side)
    throw std::invalid_argument("ExtractActiveCells: the volume has more than 65,537 samples along "
                                "one axis: crop or resample it");
  std::visit([&]<typename T>(const GridView<const T>&) { cells.cornerType = CornersOf<T>; }, grid);
  return cells;
}

void RefuseTooMany(std::size_t cells, std::size_t cornerWords)
{
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() - PaddingWords;
  if (std::max(cells, cornerWords) > most)
    throw std::invalid_argument("ExtractActiveCells: more than " + std::to_string(most) +
                                " active cells or words of corners: crop the volume or choose "
                                "another isovalue");
}

void AppendLayer(const ClusterLayer& layer, ClusteredCells& cells)
{
  RefuseTooMany(cells.count + layer.cells, cells.corners.size() + layer.corners.size());
  const auto firstWord = static_cast<std::uint32_t>(cells.corners.size());
  const auto firstCell = static_cast<std::uint32_t>(cells.count);
  cells.corners.insert(cells.corners.end(), layer.corners.begin(), layer.corners.end());
  for (CellCluster cluster : layer.clusters)
  {
    cluster.firstWord += firstWord;
    cluster.firstCell += firstCell;
    cells.clusters.push_back(cluster);
  }
  cells.count += layer.cells;
}

void FinishCells(ClusteredCells& cells)
{
  cells.corners.insert(cells.corners.end(), PaddingWords, 0U);
}

} // namespace hasp
