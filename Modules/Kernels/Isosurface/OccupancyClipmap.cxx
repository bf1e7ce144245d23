#include "Isosurface/OccupancyClipmap.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hasp
{

namespace
{

constexpr int BlockSide = BlockKey::Side;
constexpr int Step = OccupancyClipmap::WindowSide / 8; // blocks: a window's moves

/// Where a window of WindowSide blocks begins, of the `blocks` of an axis, once the viewer is at
/// block `at` and it has begun at `first`.
int WindowBegin(int first, double at, int blocks)
{
  // The quarter on either side of which at least 24 blocks are left is what nests the windows: the
  // next coarser one holds 48 blocks of this level there, and this one at most 40.
  constexpr int side = OccupancyClipmap::WindowSide, margin = 3 * side / 8;
  const int last = (blocks - side + Step - 1) / Step * Step;
  const bool left = at < first + margin && first > 0,
             right = at >= first + side - margin && first < last;
  if (!left && !right)
    return first;
  return std::clamp(static_cast<int>(std::lround((at - side / 2) / Step)) * Step, 0, last);
}

int PowerOfTwoFrom(int n)
{
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(n, 1))));
}

} // namespace

std::array<BlockKey, 8> BlockKey::Finer() const
{
  std::array<BlockKey, 8> finer;
  for (int n = 0; n < 8; ++n)
    finer[n] = { 2 * this->block + glm::ivec3(n & 1, n >> 1 & 1, n >> 2), this->level - 1 };
  return finer;
}

OccupancyClipmap::OccupancyClipmap(const glm::ivec3& cells)
{
  std::size_t offset = 0;
  for (int level = 0;; ++level)
  {
    const int side = BlockSide << level;
    Window w;
    w.blocks = glm::max((cells + side - 1) / side, 1);
    for (int a = 0; a < 3; ++a)
      w.size[a] = std::min(WindowSide, PowerOfTwoFrom(w.blocks[a]));
    w.offset = offset;
    offset += static_cast<std::size_t>(w.size.x) * w.size.y * w.size.z;
    this->Windows.push_back(w);
    if (glm::all(glm::lessThanEqual(w.blocks, w.size)))
      break;
  }
  this->Numbers.assign(offset, Empty);
  this->FinerCounts.assign(offset, 0);
}

std::size_t OccupancyClipmap::Bytes() const
{
  return (this->Numbers.size() + this->FinerCounts.size()) * sizeof(std::uint32_t);
}

void OccupancyClipmap::Set(const BlockKey& key, std::uint32_t number)
{
  std::uint32_t& now = this->Numbers[this->Address(key)];
  const int change = int(number < Dropped) - int(now < Dropped);
  now = number;
  for (int level = key.level + 1; change != 0 && level < this->Levels(); ++level)
    this->FinerCounts[this->Address(key.At(level))] += change;
}

std::vector<std::uint32_t> OccupancyClipmap::FinerIn(const BlockKey& key) const
{
  std::vector<std::uint32_t> numbers;
  std::vector<BlockKey> open{ key };
  while (!open.empty())
  {
    const BlockKey coarse = open.back();
    open.pop_back();
    if (!this->HasFiner(coarse))
      continue;
    for (const BlockKey& finer : coarse.Finer())
    {
      if (!this->InWindow(finer))
        continue;
      if (const std::uint32_t number = this->Get(finer); number != Empty)
        numbers.push_back(number);
      open.push_back(finer);
    }
  }
  return numbers;
}

bool OccupancyClipmap::Follow(const glm::dvec3& viewer)
{
  bool moved = false;
  for (int level = 0; level < this->Levels(); ++level)
  {
    Window& w = this->Windows[level];
    const double side = BlockSide << level;
    for (int a = 0; a < 3; ++a)
    {
      if (w.blocks[a] <= w.size[a])
        continue; // it holds all there is
      const double wanted = viewer[a] / side;
      const double at = wanted > 0.0 ? std::min(wanted, double(w.blocks[a])) : 0.0; // NaN too
      const int place = WindowBegin(w.first[a], at, w.blocks[a]);
      moved |= place != w.first[a];
      w.first[a] = place;
    }
  }
  return moved;
}

} // namespace hasp
