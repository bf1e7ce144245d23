#include "Isosurface/OccupancyClipmap.h"

#include <algorithm>
#include <bit>

namespace hasp
{

namespace
{

constexpr int BlockSide = 8;

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
      const int step = std::max(1, w.size[a] / 8);
      const double wanted = viewer[a] / side;
      const double at = wanted > 0.0 ? std::min(wanted, double(w.blocks[a])) : 0.0; // NaN too
      const int first = (static_cast<int>(at) - w.size[a] / 2) / step * step;
      const int place = std::clamp(first, 0, std::max(0, w.blocks[a] - w.size[a]));
      moved |= place != w.first[a];
      w.first[a] = place;
    }
  }
  return moved;
}

} // namespace hasp
