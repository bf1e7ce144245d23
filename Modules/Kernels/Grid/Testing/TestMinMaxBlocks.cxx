#include "Grid/MinMaxBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace
{

TEST(MinMaxBlocks, MatchBruteForceOnUnevenSizes)
{
  const hasp::GridGeometry g{ { 19, 9, 26 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::mt19937 random(4);
  std::vector<std::int16_t> samples(g.Size());
  for (auto& s : samples)
    s = static_cast<std::int16_t>(random());
  const hasp::GridView<const std::int16_t> grid{ samples.data(), g };
  const hasp::MinMaxBlocks blocks{ hasp::AnyGridView(grid) };
  ASSERT_EQ(blocks.Blocks(), glm::ivec3(3, 1, 4));
  EXPECT_EQ(blocks.Min(), *std::min_element(samples.begin(), samples.end()));
  EXPECT_EQ(blocks.Max(), *std::max_element(samples.begin(), samples.end()));

  for (int z = 0; z < 4; ++z)
    for (int x = 0; x < 3; ++x)
    {
      int low = 1 << 20, high = -(1 << 20);
      for (int k = z * 8; k <= std::min(z * 8 + 8, 25); ++k)
        for (int j = 0; j <= 8; ++j)
          for (int i = x * 8; i <= std::min(x * 8 + 8, 18); ++i)
          {
            low = std::min<int>(low, grid(i, j, k));
            high = std::max<int>(high, grid(i, j, k));
          }
      EXPECT_FALSE(blocks.Active({ x, 0, z }, low)); // all inside: value >= isovalue
      EXPECT_TRUE(blocks.Active({ x, 0, z }, low + 1));
      EXPECT_TRUE(blocks.Active({ x, 0, z }, high));
      EXPECT_FALSE(blocks.Active({ x, 0, z }, high + 1));
      EXPECT_EQ(blocks.Data()[3 * z + x].min, low);
      EXPECT_EQ(blocks.Data()[3 * z + x].max, high);
    }
}

TEST(MinMaxBlocks, NotANumberIsLeftOut)
{
  const hasp::GridGeometry g{ { 3, 3, 3 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<float> samples(27, std::numeric_limits<float>::quiet_NaN());
  const hasp::GridView<const float> grid{ samples.data(), g };
  EXPECT_FALSE(hasp::MinMaxBlocks(hasp::AnyGridView(grid)).Active({ 0, 0, 0 }, 0.0));
  samples[13] = 1.0F;
  samples[14] = -1.0F;
  EXPECT_TRUE(hasp::MinMaxBlocks(hasp::AnyGridView(grid)).Active({ 0, 0, 0 }, 0.0));
}

TEST(MinMaxBlocks, ASingleSliceHasNoBlocks)
{
  const std::vector<std::uint8_t> samples(9, 1);
  const hasp::GridView<const std::uint8_t> grid{ samples.data(),
    { { 3, 3, 1 }, {}, { 1, 1, 1 }, glm::dmat3(1) } };
  EXPECT_EQ(hasp::MinMaxBlocks(hasp::AnyGridView(grid)).Count(), 0U);
}

TEST(MinMaxBlocks, AreNotUpdatedFromAnotherGrid)
{
  const std::vector<std::int16_t> samples(20 * 20 * 20, 1);
  const auto gridOf = [&](const glm::ivec3& dims) -> hasp::AnyGridView
  {
    return hasp::GridView<const std::int16_t>{ samples.data(),
      { dims, {}, { 1, 1, 1 }, glm::dmat3(1) } };
  };
  hasp::MinMaxBlocks blocks(gridOf({ 20, 20, 20 }));
  EXPECT_THROW(blocks.Update(gridOf({ 4, 20, 20 }), {}, { 19, 19, 19 }), std::invalid_argument);
  EXPECT_THROW(blocks.Update(gridOf({ 20, 20, 8 }), {}, { 19, 19, 19 }), std::invalid_argument);
  EXPECT_NO_THROW(blocks.Update(gridOf({ 20, 20, 20 }), {}, { 19, 19, 19 }));
}

} // namespace
