#include "Segmentation/CrackDepth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using hasp::Label;

/// A block of bone of 1000, low in a corner of it 300, so that quantiles are known; all of it the
/// graph. `grey` changes it.
struct Block
{
  hasp::GridGeometry geometry;
  std::vector<float> grey;
  std::vector<Label> labels;

  explicit Block(const glm::dvec3& spacing = glm::dvec3(1))
    : geometry{ { 16, 16, 16 }, glm::dvec3(0), spacing, glm::dmat3(1) },
      grey(geometry.Size(), 1000.0F),
      labels(geometry.Size(), 1)
  {
    for (int n = 0; n < 64; ++n) // 1.6 % of the block: the 1 % quantile
      this->At(n % 4, n / 4 % 4, n / 16) = 300.0F;
  }
  float& At(int i, int j, int k) { return grey[std::size_t((k * 16 + j) * 16 + i)]; }
  float DepthAt(int i, int j, int k) const
  {
    const hasp::GridView<const float> view{ grey.data(), geometry };
    const hasp::VoxelGraph graph(
      view, { labels.data(), geometry }, Label(1), { .beta = 0.0, .crack = 0.0 });
    std::vector<float> samples; // all voxels are nodes, in their order
    for (const float value : grey)
      samples.push_back(value);
    return hasp::CrackDepths(graph, view, samples)[std::size_t((k * 16 + j) * 16 + i)];
  }
};

// soft = 300 - 0.35 (1000 - 300) = 55
constexpr double Soft = 55.0;

TEST(CrackDepth, OfALayerIsItsShareOfBonesGrey)
{
  Block block;
  for (int j = 0; j < 16; ++j)
    for (int k = 0; k < 16; ++k)
      block.At(9, j, k) = 800.0F;
  EXPECT_NEAR(block.DepthAt(9, 9, 9), 200.0 / (1000.0 - Soft), 1e-6);
  EXPECT_EQ(block.DepthAt(8, 9, 9), 0.0F);
  EXPECT_EQ(block.DepthAt(11, 9, 9), 0.0F);
}

TEST(CrackDepth, IsFoundAlongAllDiagonals)
{
  const glm::ivec3 middle(9, 9, 9);
  for (const glm::ivec3 normal : { glm::ivec3(1, 1, 0), glm::ivec3(0, 1, -1), glm::ivec3(1, 1, 1),
         glm::ivec3(-1, 1, 1), glm::ivec3(1, -1, 1) })
  {
    Block block;
    for (int n = 0; n < 4096; ++n)
    {
      const glm::ivec3 at(n % 16, n / 16 % 16, n / 256), to = at - middle;
      if (normal.x * to.x + normal.y * to.y + normal.z * to.z == 0)
        block.At(at.x, at.y, at.z) = 700.0F;
    }
    EXPECT_NEAR(block.DepthAt(9, 9, 9), 300.0 / (1000.0 - Soft), 1e-6);
  }
}

TEST(CrackDepth, AnEdgeIsNone)
{
  Block block;
  for (int n = 0; n < 4096; ++n)
    if (n % 16 >= 8)
      block.grey[std::size_t(n)] = 400.0F; // marrow, to the border
  EXPECT_EQ(block.DepthAt(8, 9, 9), 0.0F);
  EXPECT_EQ(block.DepthAt(12, 9, 9), 0.0F);
  EXPECT_EQ(block.DepthAt(7, 9, 9), 0.0F);
}

TEST(CrackDepth, LooksTwoOfTheShortestSpacingsFar)
{
  for (const double along : { 1.0, 3.0 })
  {
    Block block({ along, 1.0, 1.0 });
    for (int j = 0; j < 16; ++j)
      for (int k = 0; k < 16; ++k)
        block.At(9, j, k) = block.At(10, j, k) = block.At(11, j, k) = 800.0F;
    // Of three dark voxels the middle one sees bone two steps on; where steps are long, one step is
    // all, and the way goes on in the layer.
    EXPECT_EQ(block.DepthAt(10, 9, 9) > 0.0F, along == 1.0);
  }
}

TEST(CrackDepth, GoesAlongWithScaleAndShiftAndPassesOverWhatIsNotFinite)
{
  Block block;
  for (int j = 0; j < 16; ++j)
    for (int k = 0; k < 16; ++k)
      block.At(9, j, k) = 800.0F;
  const float depth = block.DepthAt(9, 9, 9);
  Block scaled = block;
  for (float& value : scaled.grey)
    value = 0.25F * value - 4000.0F;
  EXPECT_NEAR(scaled.DepthAt(9, 9, 9), depth, 1e-4);
  const float infinite = std::numeric_limits<float>::infinity();
  const hasp::GridView<const float> view{ block.grey.data(), block.geometry };
  std::vector<float> samples = block.grey;
  const hasp::VoxelGraph graph(view, { block.labels.data(), block.geometry }, Label(1), {});
  block.At(8, 9, 9) = infinite; // of what is not bone, on one side
  block.At(10, 9, 9) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NEAR(
    hasp::CrackDepths(graph, view, samples)[std::size_t((9 * 16 + 9) * 16 + 9)], depth, 1e-6);
  EXPECT_TRUE(hasp::CrackDepths(graph, view, std::vector<float>(4096, 500.0F))[0] <= 1.0F);
}

TEST(CrackDepth, IsTheSameAtTheEndsOfFloat)
{
  Block block;
  for (float& grey : block.grey) // 3e38 but for the corner, which is as far below 0
    grey = grey == 1000.0F ? 3e38F : -3e38F;
  for (int j = 0; j < 16; ++j)
    for (int k = 0; k < 16; ++k)
      block.At(9, j, k) = 0.0F;
  // soft would be -5.1e38: it is the lowest there is.
  EXPECT_NEAR(block.DepthAt(9, 9, 9), 3e38 / (3e38 + std::numeric_limits<float>::max()), 1e-6);
  EXPECT_EQ(block.DepthAt(11, 9, 9), 0.0F);
}

TEST(CrackDepth, HoldsAWalkBackByItsSquare)
{
  Block block;
  for (int j = 0; j < 16; ++j)
    for (int k = 0; k < 16; ++k)
      block.At(9, j, k) = 800.0F;
  const hasp::GridView<const float> view{ block.grey.data(), block.geometry };
  const hasp::VoxelGraph graph(view, { block.labels.data(), block.geometry }, Label(1),
    { .beta = 0.0, .crack = 0.2, .floor = 1e-6 });
  const std::int32_t node = graph.NodeAt(9, 9, 9);
  const double depth = 200.0 / (1000.0 - Soft) / 0.2;
  EXPECT_NEAR(graph.Along(0)[node], std::exp(-depth * depth), 1e-5);
  EXPECT_NEAR(graph.Along(0)[node - 1], std::exp(-depth * depth), 1e-5);
  EXPECT_NEAR(graph.Along(0)[node + 1], 1.0, 1e-6);
}

} // namespace
