#include "Isosurface/OccupancyClipmap.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hasp
{

namespace
{

constexpr int BlockSide = 8;
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
}

std::size_t OccupancyClipmap::Bytes() const
{
  return this->Numbers.size() * sizeof(this->Numbers[0]);
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
