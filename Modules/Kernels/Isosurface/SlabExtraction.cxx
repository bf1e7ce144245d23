#include "Isosurface/SlabExtraction.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ClusterLayer.h"
#include "Isosurface/CompactCells.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr int Side = MinMaxBlocks::Side;
constexpr std::size_t MostCorners = std::size_t{ Side + 1 } * (Side + 1) * (Side + 1); // a cluster

/// Holds what is about to be taken against the cap.
class MemoryCap
{
public:
  explicit MemoryCap(std::size_t bytes) : Cap(bytes) {}
  bool Holds(std::size_t bytes) const { return bytes <= this->Cap; }
  void Require(std::size_t bytes, double share) const
  {
    if (!this->Holds(bytes))
      throw MemoryCapExceeded(bytes, this->Cap, share);
  }

private:
  std::size_t Cap;
};

/// Makes room for `more` elements: half as much again, where the cap allows, so that moving does
/// not cost; else just what is needed. `taken` is what all else takes.
template <typename T>
void MakeRoom(
  std::vector<T>& values, std::size_t more, std::size_t taken, const MemoryCap& cap, double share)
{
  const std::size_t needed = values.size() + more;
  if (needed <= values.capacity())
    return;
  std::size_t room = std::max(needed, values.capacity() + values.capacity() / 2);
  if (!cap.Holds(taken + room * sizeof(T)))
    room = needed;
  cap.Require(taken + room * sizeof(T), share);
  values.reserve(room);
}

std::size_t BytesHeld(const ClusteredCells& cells)
{
  return cells.clusters.capacity() * sizeof(CellCluster) +
         cells.corners.capacity() * sizeof(std::uint32_t);
}

/// Most that the cells of blocks with surface may take.
std::size_t MostBytes(const MinMaxBlocks& blocks, float isovalue, std::size_t sampleBytes)
{
  const glm::ivec3 n = blocks.Blocks();
  std::size_t active = 0;
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x)
        active += blocks.Active({ x, y, z }, isovalue);
  return active * (sizeof(CellCluster) + (MostCorners + 1) / 2 * 2 * sampleBytes);
}

int SlicesOf(const SlabSettings& settings, const glm::ivec3& dims, std::size_t sliceBytes)
{
  if (settings.slices != 0)
    return std::min(settings.slices, dims.z);
  const std::size_t fits = settings.memoryCapBytes / 4 / sliceBytes / Side;
  const int layers = static_cast<int>(std::clamp<std::size_t>(fits, 1, ParallelThreads()));
  return std::min(Side * layers + 1, dims.z);
}

void CheckSlab(const AnyGridView& slab, const GridGeometry& whole, int slices, std::size_t type)
{
  const glm::ivec3& dims = GeometryOf(slab).dims;
  if (slab.index() != type || dims != glm::ivec3(whole.dims.x, whole.dims.y, slices))
    throw std::invalid_argument(
      "ExtractActiveCellsFromSlabs: the source gives " + std::to_string(dims.x) + " x " +
      std::to_string(dims.y) + " x " + std::to_string(dims.z) + " samples, must be " +
      std::to_string(whole.dims.x) + " x " + std::to_string(whole.dims.y) + " x " +
      std::to_string(slices) + ", all slabs of one sample type");
}

/// The slab's clusters after those that there are.
void AppendSlab(const AnyGridView& slab, int first, ClusteredCells& cells, const MemoryCap& cap)
{
  const double share = double(first) / cells.geometry.dims.z;
  const std::size_t slabBytes = SliceBytes(slab) * GeometryOf(slab).dims.z;
  const MinMaxBlocks blocks(slab);
  const glm::ivec3 n = blocks.Blocks();
  const std::size_t sampleBytes = cells.cornerType == CornerType::Float32 ? 4 : 2;
  std::size_t taken = slabBytes + blocks.Bytes();
  // A guess upwards: where it does not fit, layers are made and joined one by one.
  const std::size_t all = MostBytes(blocks, cells.isovalue, sampleBytes);
  const bool atOnce = cap.Holds(taken + BytesHeld(cells) + all);
  for (int z = 0; z < n.z;)
  {
    std::vector<ClusterLayer> layers(atOnce ? n.z : 1);
    ParallelFor(0, std::ssize(layers), 1,
      [&](std::int64_t l, std::int64_t)
      {
        layers[l] = ExtractLayer(
          slab, blocks, cells.isovalue, z + int(l), { { 0, 0 }, { n.x, n.y } }, first / Side);
      });
    z += static_cast<int>(layers.size());
    std::size_t clusters = 0, corners = 0, made = 0;
    for (const ClusterLayer& layer : layers)
    {
      clusters += layer.clusters.size();
      corners += layer.corners.size();
      made += layer.clusters.capacity() * sizeof(CellCluster) +
              layer.corners.capacity() * sizeof(std::uint32_t);
    }
    MakeRoom(cells.clusters, clusters, taken + made + BytesHeld(cells), cap, share);
    MakeRoom(cells.corners, corners + PaddingWords, taken + made + BytesHeld(cells), cap, share);
    for (const ClusterLayer& layer : layers)
      AppendLayer(layer, cells);
  }
}

/// An empty view of the volume, to begin with.
AnyGridView Whole(const AnyGridView& slab, const GridGeometry& geometry)
{
  return std::visit(
    [&](auto view) -> AnyGridView
    {
      view.data = nullptr;
      view.geometry = geometry;
      return view;
    },
    slab);
}

} // namespace

MemoryCapExceeded::MemoryCapExceeded(std::size_t needed, std::size_t cap, double done)
  : std::runtime_error("ExtractActiveCellsFromSlabs: needs " + std::to_string(needed) +
                       " bytes after " + std::to_string(int(100.0 * done)) +
                       " % of the volume, the limit is " + std::to_string(cap) +
                       ": raise it, crop the volume or choose another isovalue"),
    neededBytes(needed),
    capBytes(cap),
    share(done)
{
}

std::size_t SliceBytes(const AnyGridView& view)
{
  return std::visit([](const auto& grid)
    { return std::size_t(grid.geometry.dims.x) * grid.geometry.dims.y * sizeof(*grid.data); },
    view);
}

SlabSource SlabsOf(const AnyGridView& volume)
{
  return [volume](int first, int count)
  {
    return std::visit(
      [&](auto view) -> AnyGridView
      {
        view.data += view.Offset(0, 0, first);
        view.geometry.dims.z = count;
        return view;
      },
      volume);
  };
}

ClusteredCells ExtractActiveCellsFromSlabs(const GridGeometry& geometry, const SlabSource& source,
  double isovalue, const SlabSettings& settings, const ProgressFunction& progress)
{
  geometry.Validate();
  if (settings.slices != 0 && (settings.slices <= Side || settings.slices % Side != 1))
    throw std::invalid_argument("ExtractActiveCellsFromSlabs: slabs of " +
                                std::to_string(settings.slices) +
                                " slices, must be 9, 17, 25 and so on, or 0");
  const MemoryCap cap(settings.memoryCapBytes);
  ReportProgress(progress, 0.0);
  const int depth = geometry.dims.z;
  AnyGridView slab = source(0, 1); // what type it is of
  const std::size_t type = slab.index();
  CheckSlab(slab, geometry, 1, type);
  ClusteredCells cells = BeginCells(Whole(slab, geometry), isovalue);
  const int slices = SlicesOf(settings, geometry.dims, SliceBytes(slab));
  cap.Require(SliceBytes(slab) * slices, 0.0);
  for (int first = 0; first + 1 < depth; first += slices - 1)
  {
    ReportProgress(progress, double(first) / depth);
    const int count = std::min(slices, depth - first);
    slab = source(first, count);
    CheckSlab(slab, geometry, count, type);
    AppendSlab(slab, first, cells, cap);
  }
  FinishCells(cells);
  if (settings.precision == CellPrecision::Compact)
  {
    std::size_t words = PaddingWords; // compact cells are made beside the exact ones
    for (const CellCluster& cluster : cells.clusters)
      words += (cluster.CornerCount() + 3) / 4;
    cap.Require(BytesHeld(cells) + cells.clusters.size() * (sizeof(CellCluster) + sizeof(int)) +
                  words * sizeof(std::uint32_t),
      1.0);
    cells = CompactCells(cells);
  }
  ReportProgress(progress, 1.0);
  return cells;
}

} // namespace hasp
