#include "Isosurface/RayCache.h"
#include "Grid/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace hasp
{

namespace
{

static_assert(BlockKey::Side == MinMaxBlocks::Side);

auto Order(const BlockKey& key)
{
  return std::tuple(key.level, key.block.z, key.block.y, key.block.x);
}

const RayCacheSettings& Checked(const RayCacheSettings& settings)
{
  if (!(settings.pixelsACell > 0.0) || settings.upkeepShare < 1)
    throw std::invalid_argument("RayCache: pixelsACell must be above 0 and upkeepShare 1 or more");
  return settings;
}

/// The volume that has each `stride`-th sample.
GridGeometry Coarser(GridGeometry geometry, int stride)
{
  geometry.dims = (geometry.dims - 1) / stride + 1;
  geometry.spacing *= double(stride);
  return geometry;
}

} // namespace

RayCache::RayCache(const AnyGridView& grid, const MinMaxBlocks& blocks, double isovalue,
  const RayCacheSettings& settings)
  : Grid(grid),
    Blocks(&blocks),
    Settings(Checked(settings)),
    Isovalue(BeginCells(grid, isovalue).isovalue),
    Map(GeometryOf(grid).Cells()),
    Ring(settings.clusters, settings.words),
    Gathered(Map.Levels())
{
  (void)RayCaster(grid, blocks, isovalue); // throws if they do not match
}

void RayCache::SetIsovalue(double isovalue)
{
  const double rounded = BeginCells(this->Grid, isovalue).isovalue;
  if (rounded == this->Isovalue)
    return;
  this->Isovalue = rounded;
  this->Gathered.assign(this->Gathered.size(), nullptr); // they say the isovalue
  this->Renew(this->Ring.Numbers());
}

void RayCache::MarkModified(const glm::ivec3& low, const glm::ivec3& high)
{
  std::vector<std::uint32_t> touched;
  for (const std::uint32_t number : this->Ring.Numbers())
  {
    const BlockKey& key = this->Ring[number].key;
    const int side = BlockKey::Side << key.level;
    const glm::ivec3 first = key.block * side, last = first + side;
    if (glm::all(glm::lessThanEqual(first, high)) && glm::all(glm::greaterThanEqual(last, low)))
      touched.push_back(number);
  }
  this->Renew(touched);
}

RayCache::Frame RayCache::Sample(
  std::span<const SampledEye> eyes, std::span<const PictureView> predicted, int count)
{
  const RayCaster caster(this->Grid, *this->Blocks, this->Isovalue);
  const RaySampler::Frame sampled = this->Sampler.Sample(caster, eyes, predicted, count);
  ++this->Now;
  this->Follow(eyes);
  std::vector<Missing> missing;
  Frame frame;
  for (const SampledHit& hit : sampled.hits)
    frame.known += this->Note(hit, missing);
  frame.rays = sampled.rays;
  frame.hits = static_cast<std::int64_t>(sampled.hits.size());
  frame.checked = this->CheckShare();
  this->Add(std::move(missing), frame);
  return frame;
}

/// The windows follow the leading eye; what has left them goes.
void RayCache::Follow(std::span<const SampledEye> eyes)
{
  auto eye = std::find_if(
    eyes.begin(), eyes.end(), [this](const SampledEye& e) { return e.number == this->Leader; });
  if (eye == eyes.end() && (!this->Leader || this->Now - this->LeaderSeen >= Lately))
    eye = eyes.begin();
  if (eye == eyes.end())
    return;
  this->Leader = eye->number;
  this->LeaderSeen = this->Now;
  // The eye is where all rays of a perspective meet; a parallel view looks from far away.
  const PictureRays rays(eye->view);
  CellRay ray;
  if (!rays.Of(0.5 * glm::dvec2(eye->view.size), ray))
    return;
  if (this->Map.Follow(ray.origin + ray.tMin * ray.direction))
    for (const std::uint32_t number : this->Ring.Numbers())
      if (!this->Map.InWindow(this->Ring[number].key))
        this->Remove(number);
}

/// Upkeep: the next records in turn, round the ring.
std::int64_t RayCache::CheckShare()
{
  const std::size_t capacity = this->Ring.Capacity();
  const std::size_t share =
    (this->Ring.Live() + this->Settings.upkeepShare - 1) / this->Settings.upkeepShare;
  std::vector<std::uint32_t> numbers;
  for (std::size_t n = 0; n < capacity && numbers.size() < share; ++n)
  {
    if (this->Ring[this->Cursor].live)
      numbers.push_back(this->Cursor);
    this->Cursor = static_cast<std::uint32_t>((this->Cursor + 1) % capacity);
  }
  this->Renew(numbers);
  return static_cast<std::int64_t>(numbers.size());
}

/// Makes clusters anew from the volume. What has not changed stays, unless it was seen lately and
/// is old: then it moves to the young end, before the ring drops it.
void RayCache::Renew(const std::vector<std::uint32_t>& numbers)
{
  std::vector<BlockKey> keys; // as they are now: a record that one drops the next may take
  keys.reserve(numbers.size());
  for (const std::uint32_t number : numbers)
    keys.push_back(this->Ring[number].key);
  std::vector<ClusterLayer> layers(numbers.size());
  ParallelFor(0, std::int64_t(numbers.size()), 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const BlockKey& key = keys[n];
        if (key.level > 0 || this->Blocks->Active(key.block, this->Isovalue))
          ExtractCluster(this->Grid, float(this->Isovalue), key.block, 1 << key.level, layers[n]);
      }
    });
  for (std::size_t n = 0; n < numbers.size(); ++n)
  {
    const ClusterRing::Record record = this->Ring[numbers[n]];
    if (!record.live || record.key != keys[n]) // dropped for one before it
      continue;
    const bool wanted = this->Now - record.lastSeen < Lately && this->Ring.Old(numbers[n]);
    if (!layers[n].clusters.empty() && !wanted && this->Ring.Holds(numbers[n], layers[n]))
      continue;
    this->Remove(numbers[n]);
    if (!layers[n].clusters.empty())
      this->Insert(record.key, layers[n], record.lastSeen).lastWanted = record.lastWanted;
  }
}

ClusterRing::Record& RayCache::Insert(
  const BlockKey& key, const ClusterLayer& layer, std::uint32_t seen)
{
  const std::uint32_t number = this->Ring.Add(key, layer, seen,
    [this](std::uint32_t oldest)
    {
      this->Remove(oldest);
      this->Map.Drop(this->Ring[oldest].key, this->Now);
      this->FullUntil = this->Now + Lately / 2;
    });
  this->Map.Set(key, number);
  this->Gathered[key.level] = nullptr;
  return this->Ring[number];
}

void RayCache::Remove(std::uint32_t number)
{
  const BlockKey key = this->Ring[number].key;
  if (this->Map.Get(key) == number)
    this->Map.Set(key, OccupancyClipmap::Empty);
  this->Ring.Remove(number);
  this->Gathered[key.level] = nullptr;
}

std::shared_ptr<const ClusteredCells> RayCache::Cells(int level)
{
  auto& gathered = this->Gathered.at(level);
  if (!gathered)
    gathered = std::make_shared<const ClusteredCells>(this->Gather(level));
  return gathered;
}

ClusteredCells RayCache::Gather(int level) const
{
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t number : this->Ring.Numbers())
    if (this->Ring[number].key.level == level)
      numbers.push_back(number);
  std::sort(numbers.begin(), numbers.end(),
    [this](std::uint32_t a, std::uint32_t b)
    { return Order(this->Ring[a].key) < Order(this->Ring[b].key); });
  ClusteredCells cells = BeginCells(this->Grid, this->Isovalue);
  cells.geometry = Coarser(cells.geometry, 1 << level);
  cells.clusters.reserve(numbers.size());
  for (const std::uint32_t number : numbers)
  {
    const ClusterRing::Record& record = this->Ring[number];
    CellCluster cluster = record.cluster;
    cluster.firstWord = static_cast<std::uint32_t>(cells.corners.size());
    cluster.firstCell = static_cast<std::uint32_t>(cells.count);
    const std::uint32_t* words = this->Ring.Words(record);
    cells.corners.insert(cells.corners.end(), words, words + record.words);
    cells.clusters.push_back(cluster);
    cells.count += cluster.CellCount();
  }
  FinishCells(cells);
  return cells;
}

} // namespace hasp
