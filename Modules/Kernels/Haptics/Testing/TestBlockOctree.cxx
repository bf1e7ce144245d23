#include "Haptics/BlockOctree.h"
#include "Haptics/Testing/SampledDistance.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace
{

using namespace hasp::testing;
using hasp::BlockOctree;
using hasp::DistanceMap;
using hasp::RigidPose;

/// Points of a block's box, world: its corners and a lattice inside.
std::vector<glm::dvec3> LatticeOf(const DistanceMap& map, std::uint32_t block, int perAxis)
{
  const glm::ivec3 blocks = map.View().blocks, last = map.Geometry().dims - 1;
  const int b = static_cast<int>(block);
  const glm::ivec3 low =
    8 * glm::ivec3(b % blocks.x, b / blocks.x % blocks.y, b / blocks.x / blocks.y);
  const glm::dvec3 size = glm::min(low + 8, last) - low;
  std::vector<glm::dvec3> points;
  for (int n = 0; n < perAxis * perAxis * perAxis; ++n)
  {
    const glm::dvec3 share(n % perAxis, n / perAxis % perAxis, n / perAxis / perAxis);
    points.push_back(map.Geometry().IndexToWorld(glm::dvec3(low) + size * share / (perAxis - 1.0)));
  }
  return points;
}

std::uint32_t BlockAt(const DistanceMap& map, const glm::dvec3& world)
{
  const glm::dvec3 index = map.Geometry().WorldToIndex(world);
  const glm::ivec3 last = map.Geometry().dims - 1, blocks = map.View().blocks;
  for (int a = 0; a < 3; ++a)
    if (!(index[a] >= 0.0 && index[a] <= last[a]))
      return 0xffffffffU;
  const glm::ivec3 b = glm::min(glm::ivec3(index) / 8, blocks - 1);
  return static_cast<std::uint32_t>((b.z * blocks.y + b.y) * blocks.x + b.x);
}

TEST(BlockOctree, ItsLeavesAreTheBlocksOfTheSurfaceOrTheSolid)
{
  const SampledDistance body(Ball({ 1.0, 0.5, 0.0 }, 11.0), SkewGrid({ 64, 42, 30 }));
  const DistanceMap map(body.View());
  for (const auto kind : { BlockOctree::Leaves::Surface, BlockOctree::Leaves::Solid })
  {
    const BlockOctree tree(map, kind);
    std::vector<std::uint32_t> found(tree.Blocks().begin(), tree.Blocks().end());
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> expected;
    for (std::uint32_t b = 0; b < 8U * 6U * 4U; ++b)
    {
      const auto range = map.View().unclamped[b];
      if (range.min <= 0.0F && (range.max > 0.0F || kind == BlockOctree::Leaves::Solid))
        expected.push_back(b);
    }
    EXPECT_EQ(found, expected);
    EXPECT_GT(tree.Bytes(), 0U);
  }
}

TEST(BlockOctree, MarksEachLeafThatMeetsTheOtherBody)
{
  const SampledDistance tool(Torus({ 0, 0.6, 0.8 }, 9.0, 2.5), CubeGrid(30));
  const SampledDistance body(BumpyBall(11.0, 1.0), SkewGrid({ 64, 42, 30 }));
  const DistanceMap toolMap(tool.View()), bodyMap(body.View());
  const BlockOctree toolTree(toolMap, BlockOctree::Leaves::Surface);
  const BlockOctree bodyTree(bodyMap, BlockOctree::Leaves::Solid);
  std::vector<bool> solid(8 * 6 * 4, false);
  for (const std::uint32_t b : bodyTree.Blocks())
    solid[b] = true;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> in(-1.0, 1.0);
  std::size_t marked = 0, met = 0, leaves = 0;
  for (int n = 0; n < 40; ++n)
  {
    const glm::dvec3 way{ in(random), in(random), in(random) };
    const RigidPose pose{ 35.0 * way, hasp::TurnBy({ in(random), in(random), 2.0 * in(random) }) };
    std::vector<std::uint8_t> marks(toolTree.Blocks().size(), 0);
    toolTree.MarkOverlaps(bodyTree, pose, marks);
    for (std::size_t leaf = 0; leaf < marks.size(); ++leaf)
    {
      // Brute force: does a point of the leaf's box lie in a leaf of the body?
      const auto lattice = LatticeOf(toolMap, toolTree.Blocks()[leaf], 9);
      const bool meets = std::any_of(lattice.begin(), lattice.end(),
        [&](const glm::dvec3& p)
        {
          const std::uint32_t b = BlockAt(bodyMap, pose.Place(p));
          return b < solid.size() && solid[b];
        });
      EXPECT_TRUE(!meets || marks[leaf] == 1);
      met += meets ? 1 : 0;
      marked += marks[leaf];
      ++leaves;
    }
  }
  EXPECT_GT(met, 100U);
  EXPECT_LT(marked, leaves / 2);
  // Boxes that meet between the lattice's points are few: the test is exact but for a hair.
  EXPECT_LT(static_cast<double>(marked), 1.1 * static_cast<double>(met));
}

TEST(BlockOctree, WithoutLeavesNothingMeets)
{
  const SampledDistance ball(Ball({}, 8.0), CubeGrid(30));
  const SampledDistance far(Ball({ 100.0, 0.0, 0.0 }, 8.0), CubeGrid(30));
  const BlockOctree tree(DistanceMap(ball.View()), BlockOctree::Leaves::Surface);
  const BlockOctree none(DistanceMap(far.View()), BlockOctree::Leaves::Solid);
  EXPECT_TRUE(none.Blocks().empty());
  std::vector<std::uint8_t> marks(tree.Blocks().size(), 0);
  tree.MarkOverlaps(none, {}, marks);
  none.MarkOverlaps(tree, {}, {});
  EXPECT_EQ(std::accumulate(marks.begin(), marks.end(), 0), 0);
}

} // namespace
