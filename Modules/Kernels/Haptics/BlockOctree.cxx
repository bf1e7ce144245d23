#include "Haptics/BlockOctree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <array>
#include <cmath>

namespace hasp
{

namespace
{

/// Nodes along each axis, `level` halvings above the blocks.
glm::ivec3 NodesAt(const glm::ivec3& blocks, int level)
{
  return (blocks + (1 << level) - 1) / (1 << level);
}

std::size_t IndexIn(const glm::ivec3& count, const glm::ivec3& at)
{
  return (static_cast<std::size_t>(at.z) * count.y + at.y) * count.x + at.x;
}

bool Is(BlockOctree::Leaves leaves, const MinMaxBlocks::Range& range)
{
  return range.min <= 0.0F && (leaves == BlockOctree::Leaves::Solid || range.max > 0.0F);
}

/// For each level from the blocks up: does a leaf lie below?
std::vector<std::vector<bool>> Occupancy(
  const DistanceMapView<std::int16_t>& view, BlockOctree::Leaves leaves)
{
  const glm::ivec3 blocks = view.blocks;
  std::vector<std::vector<bool>> levels(1);
  const std::size_t count = static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z;
  for (std::size_t b = 0; b < count; ++b)
    levels[0].push_back(Is(leaves, view.unclamped[b]));
  for (int level = 1; levels.back().size() > 1; ++level)
  {
    const glm::ivec3 below = NodesAt(blocks, level - 1), here = NodesAt(blocks, level);
    std::vector<bool> occupied(static_cast<std::size_t>(here.x) * here.y * here.z, false);
    for (int z = 0; z < below.z; ++z)
      for (int y = 0; y < below.y; ++y)
        for (int x = 0; x < below.x; ++x)
          if (levels.back()[IndexIn(below, { x, y, z })])
            occupied[IndexIn(here, glm::ivec3(x, y, z) / 2)] = true;
    levels.push_back(std::move(occupied));
  }
  return levels;
}

} // namespace

BlockOctree::BlockOctree(const DistanceMap& map, Leaves leaves)
  : GridAxes(map.Geometry().direction),
    Spacing(map.Geometry().spacing)
{
  const auto view = map.View();
  const auto levels = Occupancy(view, leaves);
  if (!levels.back().front())
    return;
  this->Nodes.emplace_back();
  this->Add(view, levels, 0, static_cast<int>(levels.size()) - 1, glm::ivec3(0));
}

void BlockOctree::Add(const DistanceMapView<std::int16_t>& view,
  std::span<const std::vector<bool>> levels, std::uint32_t node, int level, const glm::ivec3& at)
{
  constexpr int side = DistanceMapView<std::int16_t>::Side;
  const glm::ivec3 last = glm::ivec3(view.last), low = at * (side << level);
  const glm::dvec3 from = low, to = glm::min(low + (side << level), last);
  const glm::dvec3 origin = view.indexOfOrigin;
  Node made{ (0.5 * (from + to) - origin) * this->Spacing, 0.5 * (to - from) * this->Spacing, 0,
    0 };
  if (level == 0)
  {
    made.first = static_cast<std::uint32_t>(this->LeafBlocks.size());
    this->LeafBlocks.push_back(static_cast<std::uint32_t>(IndexIn(view.blocks, at)));
    this->Nodes[node] = made;
    return;
  }
  const glm::ivec3 below = NodesAt(view.blocks, level - 1);
  std::array<glm::ivec3, 8> found{};
  for (int c = 0; c < 8; ++c)
  {
    const glm::ivec3 child = 2 * at + glm::ivec3(c & 1, c >> 1 & 1, c >> 2);
    if (glm::all(glm::lessThan(child, below)) && levels[level - 1][IndexIn(below, child)])
      found[made.children++] = child;
  }
  made.first = static_cast<std::uint32_t>(this->Nodes.size());
  this->Nodes[node] = made;
  this->Nodes.resize(this->Nodes.size() + made.children);
  for (std::uint32_t c = 0; c < made.children; ++c)
    this->Add(view, levels, made.first + c, level - 1, found[c]);
}

std::size_t BlockOctree::Bytes() const noexcept
{
  return this->Nodes.size() * sizeof(Node) + this->LeafBlocks.size() * sizeof(std::uint32_t);
}

/// Both trees on the way down; their boxes along their own grids' axes.
struct BlockOctree::Walk
{
  const BlockOctree &A, &B;
  std::span<std::uint8_t> Marks;
  glm::dmat3 Turn;  ///< columns: A's axes along B's
  glm::dmat3 Least; ///< their absolute values, and a hair for axes that are nearly parallel
  glm::dvec3 Shift; ///< of A's origin, along B's axes

  bool Meet(const Node& a, const Node& b) const noexcept
  {
    const glm::dvec3 ha = a.half, hb = b.half;
    const glm::dvec3 apart = this->Turn * glm::dvec3(a.center) + this->Shift - glm::dvec3(b.center);
    if (glm::any(glm::greaterThan(glm::abs(apart), hb + this->Least * ha)) ||
        glm::any(glm::greaterThan(glm::abs(apart * this->Turn), ha + hb * this->Least)))
      return false;
    for (int i = 0; i < 3; ++i) // the axes across one of A's and one of B's
      for (int j = 0; j < 3; ++j)
      {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        const double reach = ha[i1] * this->Least[i2][j] + ha[i2] * this->Least[i1][j] +
                             hb[j1] * this->Least[i][j2] + hb[j2] * this->Least[i][j1];
        if (std::abs(apart[j2] * this->Turn[i][j1] - apart[j1] * this->Turn[i][j2]) > reach)
          return false;
      }
    return true;
  }
  void Down(const Node& a, const Node& b) const noexcept
  {
    if ((a.children == 0 && this->Marks[a.first] != 0) || !this->Meet(a, b))
      return;
    if (a.children == 0 && b.children == 0)
      this->Marks[a.first] = 1;
    else if (b.children == 0 || (a.children != 0 && a.half.x > b.half.x))
      for (std::uint32_t c = 0; c < a.children; ++c)
        this->Down(this->A.Nodes[a.first + c], b);
    else
      for (std::uint32_t c = 0; c < b.children; ++c)
        this->Down(a, this->B.Nodes[b.first + c]);
  }
};

void BlockOctree::MarkOverlaps(const BlockOctree& other, const RigidPose& thisInOther,
  std::span<std::uint8_t> marks) const noexcept
{
  if (this->Nodes.empty() || other.Nodes.empty())
    return;
  Walk walk{ *this, other, marks, glm::dmat3(1.0), glm::dmat3(1.0), glm::dvec3(0.0) };
  const glm::dmat3 toOther = glm::transpose(other.GridAxes);
  walk.Turn = toOther * glm::mat3_cast(thisInOther.orientation) * this->GridAxes;
  for (int column = 0; column < 3; ++column)
    walk.Least[column] = glm::abs(walk.Turn[column]) + 1e-9;
  walk.Shift = toOther * thisInOther.position;
  walk.Down(this->Nodes.front(), other.Nodes.front());
}

} // namespace hasp
