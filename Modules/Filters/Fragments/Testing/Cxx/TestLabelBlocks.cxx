// Which labels an edit has changed, against a plain look at all voxels.
#include "LabelBlocks.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace
{

using hasp::LabelBlocks;
using hasp::LabelExtent;

const glm::ivec3 Dims(70, 33, 40); // blocks that are cut off

struct Map
{
  std::vector<std::uint16_t> labels =
    std::vector<std::uint16_t>(std::size_t(Dims.x) * Dims.y * Dims.z);

  hasp::GridView<const std::uint16_t> View() const
  {
    return { this->labels.data(), { Dims, glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) } };
  }
  std::uint16_t& At(int i, int j, int k)
  {
    return this->labels[(std::size_t(k) * Dims.y + j) * Dims.x + i];
  }
  std::map<std::uint16_t, LabelExtent> Extents() const
  {
    std::map<std::uint16_t, LabelExtent> extents;
    std::size_t n = 0;
    for (int k = 0; k < Dims.z; ++k)
      for (int j = 0; j < Dims.y; ++j)
        for (int i = 0; i < Dims.x; ++i, ++n)
          if (this->labels[n] != 0)
          {
            LabelExtent& e = extents[this->labels[n]];
            e.low = e.voxels == 0 ? glm::ivec3(i, j, k) : glm::min(e.low, glm::ivec3(i, j, k));
            e.high = glm::max(e.high, glm::ivec3(i, j, k));
            ++e.voxels;
          }
    return extents;
  }
};

void ExpectSame(
  const std::map<std::uint16_t, LabelExtent>& a, const std::map<std::uint16_t, LabelExtent>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (auto one = a.begin(), other = b.begin(); one != a.end(); ++one, ++other)
  {
    EXPECT_EQ(one->first, other->first);
    EXPECT_EQ(one->second.low, other->second.low) << one->first;
    EXPECT_EQ(one->second.high, other->second.high) << one->first;
    EXPECT_EQ(one->second.voxels, other->second.voxels) << one->first;
  }
}

TEST(LabelBlocks, OfAnEmptyMapThereIsNothing)
{
  Map map;
  LabelBlocks blocks(map.View());
  EXPECT_TRUE(blocks.Extents().empty());
  map.At(69, 32, 39) = 65535;
  EXPECT_EQ(blocks.Update(map.View(), Dims - 1, Dims - 1), (std::vector<std::uint16_t>{ 65535 }));
  ExpectSame(blocks.Extents(), map.Extents());
}

TEST(LabelBlocks, RandomEditsChangeTheLabelsThatTheyChange)
{
  std::mt19937 engine(3);
  const auto any = [&](int most) { return int(engine() % unsigned(most)); };
  Map map;
  for (std::uint16_t& label : map.labels)
    label = std::uint16_t(any(4));
  LabelBlocks blocks(map.View());
  ExpectSame(blocks.Extents(), map.Extents());
  int quiet = 0;
  for (int edit = 0; edit < 300; ++edit)
  {
    const glm::ivec3 low(any(Dims.x), any(Dims.y), any(Dims.z));
    const glm::ivec3 high = glm::min(low + glm::ivec3(any(12), any(12), any(12)), Dims - 1);
    const int from = any(6), to = any(6);
    std::set<std::uint16_t> changed;
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
          if (std::uint16_t& label = map.At(i, j, k); label == from && from != to)
          {
            changed.insert({ label, std::uint16_t(to) });
            label = std::uint16_t(to);
          }
    changed.erase(0);
    quiet += changed.empty();
    EXPECT_EQ(blocks.Update(map.View(), low, high),
      (std::vector<std::uint16_t>(changed.begin(), changed.end())));
  }
  EXPECT_GT(quiet, 10);
  ExpectSame(blocks.Extents(), map.Extents());
}

// Counts and boxes alone would not see it.
TEST(LabelBlocks, VoxelsThatChangePlacesAreAChange)
{
  Map map;
  for (int i = 2; i < 30; ++i)
    map.At(i, 5, 5) = std::uint16_t(2 + i % 2);
  LabelBlocks blocks(map.View());
  for (int i = 6; i < 24; ++i)
    map.At(i, 5, 5) = std::uint16_t(3 - i % 2);
  EXPECT_EQ(
    blocks.Update(map.View(), { 6, 5, 5 }, { 23, 5, 5 }), (std::vector<std::uint16_t>{ 2, 3 }));
  EXPECT_TRUE(blocks.Update(map.View(), { 6, 5, 5 }, { 23, 5, 5 }).empty());
}

} // namespace
