#include "Isosurface/ClusterLayer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace hasp
{

namespace
{

constexpr int Side = MinMaxBlocks::Side;
constexpr int MostBlocks = 1 << 13; // along an axis: what a cluster's origin can say

template <typename T>
constexpr CornerType CornersOf = std::is_same_v<T, float>          ? CornerType::Float32
                                 : std::is_same_v<T, std::int16_t> ? CornerType::Int16
                                                                   : CornerType::UInt16;

/// Which samples of a row satisfy a condition, a bit each.
using RowBits = std::uint8_t*;

/// Eight bytes of 0 or 1 to eight bits, the first lowest.
std::uint8_t PackBits(const std::uint8_t* flags)
{
  std::uint64_t eight;
  std::memcpy(&eight, flags, 8);
  return static_cast<std::uint8_t>(eight * 0x0102040810204080ULL >> 56);
}

/// Finds the active cells of a row of blocks along x, 8x8 rows of cells, all blocks at once: the
/// loops run along x, so that the compiler can use whole vectors.
template <typename T>
class BlockRow
{
public:
  BlockRow(const GridView<const T>& grid, float isovalue)
    : Grid(grid),
      Isovalue(isovalue),
      Bytes((grid.geometry.dims.x + Side - 1) / Side + 1),
      Inside(std::size_t{ (Side + 1) * (Side + 1) } * Bytes),
      Bad(std::is_same_v<T, float> ? Inside.size() : 0),
      Active(std::size_t{ Side * Side } * Bytes),
      Flags(std::size_t(Bytes) * 8)
  {
  }

  /// Blocks [from, to) of the row of blocks at (y, z).
  void Read(int from, int to, int y, int z)
  {
    const glm::ivec3 dims = this->Grid.geometry.dims;
    this->Rows =
      glm::min(glm::ivec2(Side), glm::ivec2(dims.y, dims.z) - 1 - glm::ivec2(y, z) * Side);
    const int first = from * Side, count = std::min(to * Side + 1, dims.x) - first;
    for (int k = 0; k <= this->Rows.y; ++k)
      for (int j = 0; j <= this->Rows.x; ++j)
        this->ReadRow(&this->Grid(first, y * Side + j, z * Side + k), count,
          this->InsideRow(j, k) + from, this->Bad.empty() ? nullptr : this->BadRow(j, k) + from);
    for (int k = 0; k < this->Rows.y; ++k)
      for (int j = 0; j < this->Rows.x; ++j)
        this->FindActive(j, k, from, to);
  }

  /// Active cells of block x, a word a slice; false if there are none.
  bool ActiveCells(int x, std::array<std::uint64_t, Side>& active) const
  {
    const int cells = std::min(Side, this->Grid.geometry.dims.x - 1 - x * Side);
    const std::uint64_t valid = 0x0101010101010101ULL * ((1U << cells) - 1U);
    std::uint64_t any = 0;
    for (int k = 0; k < Side; ++k)
    {
      std::uint64_t slice = 0;
      if (k < this->Rows.y)
        for (int j = 0; j < this->Rows.x; ++j)
          slice |= std::uint64_t{ this->Active[std::size_t(k * Side + j) * this->Bytes + x] }
                   << 8 * j;
      active[k] = slice & valid;
      any |= active[k];
    }
    return any != 0;
  }

private:
  RowBits InsideRow(int j, int k)
  {
    return &this->Inside[std::size_t(k * (Side + 1) + j) * this->Bytes];
  }
  RowBits BadRow(int j, int k) { return &this->Bad[std::size_t(k * (Side + 1) + j) * this->Bytes]; }

  void ReadRow(const T* row, int count, RowBits inside, RowBits bad)
  {
    // In a block with surface min < isovalue <= max, so the next integer is one of T.
    const T least = std::is_same_v<T, float> ? T(this->Isovalue) : T(std::ceil(this->Isovalue));
    std::uint8_t* flags = this->Flags.data();
    const int bytes = (count + 7) / 8;
    std::memset(flags + count, 0, 8 * bytes - count);
    for (int i = 0; i < count; ++i)
      flags[i] = row[i] >= least;
    for (int b = 0; b < bytes; ++b)
      inside[b] = PackBits(flags + 8 * b);
    if constexpr (std::is_same_v<T, float>)
    {
      for (int i = 0; i < count; ++i)
        flags[i] = !(std::abs(row[i]) <= std::numeric_limits<float>::max());
      for (int b = 0; b < bytes; ++b)
        bad[b] = PackBits(flags + 8 * b);
    }
  }

  /// Corners on both sides, all of them finite. The last byte of a row holds the last corner only.
  void FindActive(int j, int k, int from, int to)
  {
    const auto pairs = [](RowBits bits, int b) // each bit or-ed with the next
    { return std::uint8_t(bits[b] | bits[b] >> 1 | bits[b + 1] << 7); };
    const auto bothOf = [](RowBits bits, int b)
    { return std::uint8_t(bits[b] & (bits[b] >> 1 | bits[b + 1] << 7)); };
    RowBits a = this->InsideRow(j, k), b = this->InsideRow(j + 1, k);
    RowBits c = this->InsideRow(j, k + 1), d = this->InsideRow(j + 1, k + 1);
    RowBits out = &this->Active[std::size_t(k * Side + j) * this->Bytes];
    for (int x = from; x < to; ++x)
    {
      const std::uint8_t any = pairs(a, x) | pairs(b, x) | pairs(c, x) | pairs(d, x);
      const std::uint8_t all = bothOf(a, x) & bothOf(b, x) & bothOf(c, x) & bothOf(d, x);
      out[x] = any & ~all;
    }
    if (this->Bad.empty())
      return;
    a = this->BadRow(j, k), b = this->BadRow(j + 1, k);
    c = this->BadRow(j, k + 1), d = this->BadRow(j + 1, k + 1);
    for (int x = from; x < to; ++x)
      out[x] &= ~(pairs(a, x) | pairs(b, x) | pairs(c, x) | pairs(d, x));
  }

  GridView<const T> Grid;
  float Isovalue;
  int Bytes; ///< a row of bits: one a block, and one for the last corner
  glm::ivec2 Rows{ 0 };
  std::vector<std::uint8_t> Inside, Bad, Active, Flags;
};

/// The samples of a cluster's corners, in the order of the stream; fills cornersBefore.
template <typename T>
int GatherCorners(const GridView<const T>& grid, CellCluster& cluster, T* out)
{
  const glm::ivec3 origin = cluster.Origin();
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

template <typename T>
void AppendCluster(const GridView<const T>& grid, const glm::ivec3& block, int layersBelow,
  CellCluster& cluster, ClusterLayer& out)
{
  cluster.place = { block.x | block.y << 13, block.z };
  T values[(Side + 1) * (Side + 1) * (Side + 1)];
  const int count = GatherCorners(grid, cluster, values);
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
  cluster.place.x |= static_cast<std::uint32_t>(width) << 26;
  cluster.place.y = (block.z + layersBelow) | std::uint32_t{ base } << 16;
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
      AppendCluster(grid, { x, y, layer }, layersBelow, cluster, out);
}

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
    throw std::invalid_argument("ExtractActiveCells: more than 65,537 samples along one axis");
  std::visit([&]<typename T>(const GridView<const T>&) { cells.cornerType = CornersOf<T>; }, grid);
  return cells;
}

void AppendLayer(const ClusterLayer& layer, ClusteredCells& cells)
{
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() - 2;
  if (cells.corners.size() + layer.corners.size() > most || cells.count + layer.cells > most)
    throw std::invalid_argument(
      "ExtractActiveCells: more than " + std::to_string(most) +
      " active cells or words of corners: crop the volume or choose another isovalue");
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
