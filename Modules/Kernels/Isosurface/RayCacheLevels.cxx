// RayCache: which blocks, at which level, what rays have met becomes.
#include "Grid/ParallelFor.h"
#include "Isosurface/RayCache.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hasp
{

/// The coarsest that would do.
int RayCache::WantedLevel(const SampledHit& hit) const
{
  const double wanted = std::log2(this->Settings.pixelsACell / hit.pixelsAVoxel);
  int level =
    std::clamp(wanted > 0.0 ? int(std::ceil(std::min(wanted, 31.0))) : 0, 0, this->Levels() - 1);
  while (level + 1 < this->Levels() && !this->Map.InWindow(BlockKey::Of(hit.cell, level)))
    ++level;
  return level;
}

/// At which level the cache holds the cell's place; -1: at none.
int RayCache::LevelAt(const glm::ivec3& cell) const
{
  for (int level = 0; level < this->Levels(); ++level)
    if (const BlockKey key = BlockKey::Of(cell, level);
        this->Map.InWindow(key) && this->Map.Get(key) != OccupancyClipmap::Empty)
      return level;
  return -1;
}

/// Is what a ray has met there, and fine enough? If not, a block becomes missing.
bool RayCache::Note(const SampledHit& hit, std::vector<Missing>& missing)
{
  const int wanted = this->WantedLevel(hit), there = this->LevelAt(hit.cell);
  if (there < 0 || there > wanted)
  {
    missing.push_back({ BlockKey::Of(hit.cell, wanted), hit.cell, true, this->Now });
    return false;
  }
  auto& record = this->Ring[this->Map.Get(BlockKey::Of(hit.cell, there))];
  record.lastSeen = this->Now;
  if (there == wanted || hit.inHole)
    record.lastWanted = this->Now;
  else if (const BlockKey coarse = BlockKey::Of(hit.cell, wanted); !this->KeepsFiner(coarse))
    missing.push_back({ coarse, hit.cell, true, this->Now });
  if (!hit.inHole || there == 0)
    return true;
  if (const BlockKey finer = BlockKey::Of(hit.cell, there - 1); this->Map.InWindow(finer))
    missing.push_back({ finer, hit.cell, true, this->Now });
  return false;
}

/// When a hit last wanted the finer blocks in the place of this one; 0 where there are none.
std::uint32_t RayCache::FinerWanted(const BlockKey& key) const
{
  std::uint32_t last = 0;
  for (const std::uint32_t number : this->Map.FinerIn(key))
    last = std::max(last, this->Ring[number].lastWanted);
  return last;
}

/// Are there finer blocks in the place of this one that must not give way to it?
bool RayCache::KeepsFiner(const BlockKey& key) const
{
  return this->Map.HasFiner(key) &&
         (this->Now >= this->FullUntil || this->Now - this->FinerWanted(key) < Lately);
}

/// If the cache holds a coarser block over this one: what else of its place takes to fill.
void RayCache::TakeApart(const BlockKey& key, std::vector<Missing>& missing) const
{
  int level = key.level + 1;
  while (level < this->Levels() && this->Map.Get(key.At(level)) == OccupancyClipmap::Empty)
    ++level;
  if (level == this->Levels())
    return;
  const glm::ivec3 cells = GeometryOf(this->Grid).Cells();
  for (; level > key.level; --level)
    for (const BlockKey& part : key.At(level).Finer())
    {
      const glm::ivec3 first = part.block * (BlockKey::Side << part.level);
      if (part != key.At(part.level) && glm::all(glm::lessThan(first, cells)))
        missing.push_back({ part, first, false, this->Now });
    }
}

/// Adds each block once; one that has no surface at its level gives way to the next finer.
void RayCache::Add(std::vector<Missing> missing, Frame& frame)
{
  for (Missing& block : missing)
    while (this->KeepsFiner(block.key))
    {
      block.wanted = this->FinerWanted(block.key); // this one is no more wanted than those
      block.key = BlockKey::Of(block.cell, block.key.level - 1);
    }
  const auto order = [](const Missing& m)
  {
    const glm::ivec3& b = m.key.block;
    return std::tuple(m.key.level, b.z, b.y, b.x, !m.met, ~m.wanted); // the latest wish counts
  };
  const auto once = [&]
  {
    std::sort(missing.begin(), missing.end(),
      [&](const Missing& a, const Missing& b) { return order(a) < order(b); });
    missing.erase(std::unique(missing.begin(), missing.end(),
                    [](const Missing& a, const Missing& b) { return a.key == b.key; }),
      missing.end());
  };
  once();
  for (std::size_t n = 0, met = missing.size(); n < met; ++n)
    this->TakeApart(BlockKey(missing[n].key), missing);
  once();

  std::vector<ClusterLayer> layers(missing.size());
  ParallelFor(0, std::int64_t(missing.size()), 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        Missing& block = missing[n];
        while (!ExtractCluster(this->Grid, float(this->Isovalue), block.key.block,
                 1 << block.key.level, layers[n]) &&
               block.met && block.key.level > 0)
          block.key = BlockKey::Of(block.cell, block.key.level - 1);
      }
    });
  for (std::size_t n = 0; n < missing.size(); ++n) // the finest first
  {
    const BlockKey& key = missing[n].key;
    if (layers[n].clusters.empty() || !this->Map.InWindow(key) ||
        this->Map.Get(key) != OccupancyClipmap::Empty || this->KeepsFiner(key))
      continue;
    frame.dropped += this->Map.DroppedAgo(key, this->Now) < Lately;
    for (const std::uint32_t number : this->Map.FinerIn(key))
      this->Remove(number);
    for (int level = key.level + 1; level < this->Levels(); ++level)
      if (const std::uint32_t over = this->Map.Get(key.At(level)); over != OccupancyClipmap::Empty)
        this->Remove(over);
    this->Insert(key, layers[n], this->Now).lastWanted = missing[n].wanted;
    ++frame.added;
  }
}

} // namespace hasp
