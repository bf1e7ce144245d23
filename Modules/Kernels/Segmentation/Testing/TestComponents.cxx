#include "Segmentation/Components.h"
#include "Testing/RandomLabels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace
{

using hasp::Label;
using hasp::LabelDelta;
using hasp::testing::LabelMap;

using Pieces = std::vector<std::vector<std::size_t>>;

/// By flooding from face to face, in the order of first voxels.
Pieces Flooded(const LabelMap& map, const std::function<bool(Label)>& is)
{
  const glm::ivec3 dims = map.geometry.dims;
  std::vector<bool> seen(map.labels.size());
  Pieces pieces;
  for (std::size_t start = 0; start < seen.size(); ++start)
  {
    if (seen[start] || !is(map.labels[start]))
      continue;
    std::vector<std::size_t> piece{ start };
    seen[start] = true;
    for (std::size_t n = 0; n < piece.size(); ++n)
    {
      const glm::ivec3 at(
        int(piece[n]) % dims.x, int(piece[n]) / dims.x % dims.y, int(piece[n]) / (dims.x * dims.y));
      for (int side = 0; side < 6; ++side)
      {
        glm::ivec3 to = at;
        to[side / 2] += side % 2 ? 1 : -1;
        if (to[side / 2] < 0 || to[side / 2] >= dims[side / 2])
          continue;
        const std::size_t v = (std::size_t(to.z) * dims.y + to.y) * dims.x + to.x;
        if (seen[v] || !is(map.labels[v]))
          continue;
        seen[v] = true;
        piece.push_back(v);
      }
    }
    pieces.push_back(piece);
  }
  return pieces;
}

LabelMap Separated(const LabelMap& map, Label label, double leastMm3, bool alone)
{
  Pieces pieces = Flooded(map, [label](Label l) { return l == label; });
  std::stable_sort(
    pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  const glm::dvec3 s = map.geometry.spacing;
  Label next = *std::max_element(map.labels.begin(), map.labels.end());
  LabelMap result = map;
  for (std::size_t n = 0; n < pieces.size(); ++n)
  {
    const bool stays = double(pieces[n].size()) * s.x * s.y * s.z >= leastMm3 && !(alone && n > 0);
    const Label number = !stays ? Label(0) : n == 0 ? label : ++next;
    for (const std::size_t v : pieces[n])
      result.labels[v] = number;
  }
  return result;
}

/// A map of noise: pieces of all shapes.
LabelMap Noise(const hasp::GridGeometry& grid, double share, Label most, std::mt19937& random)
{
  LabelMap map(grid);
  std::bernoulli_distribution bone(share);
  for (Label& label : map.labels)
    label = bone(random) ? static_cast<Label>(1 + random() % most) : Label(0);
  return map;
}

TEST(Components, NonsenseIsRefusedBeforeAnythingChanges)
{
  std::mt19937 random(1);
  LabelMap map = Noise(hasp::testing::PlainGrid({ 12, 12, 12 }), 0.2, 1, random);
  const std::uint64_t hash = map.Hash();
  EXPECT_THROW(hasp::SeparateComponents(map.View(), 0), std::invalid_argument);
  EXPECT_THROW(hasp::FillCavities(map.View(), 0), std::invalid_argument);
  for (const double bad : { -1.0, 2e9, std::nan("") })
    EXPECT_THROW(hasp::SeparateComponents(map.View(), 1, { bad, false }), std::invalid_argument);
  EXPECT_EQ(map.Hash(), hash);
}

TEST(Components, NumbersEndAtTheLargestLabelAndNotBeyond)
{
  // Three pieces need two new numbers.
  LabelMap map(hasp::testing::PlainGrid({ 7, 1, 1 }));
  map.labels = { 1, 0, 1, 0, 1, 0, 65533 };
  const std::vector<Label> before = map.labels;
  const LabelDelta delta = hasp::SeparateComponents(map.View(), 1);
  EXPECT_EQ(map.labels, (std::vector<Label>{ 1, 0, 65534, 0, 65535, 0, 65533 }));
  hasp::RevertDelta(delta, map.View());
  map.labels[6] = 65534;
  try
  {
    hasp::SeparateComponents(map.View(), 1);
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("3 pieces"), std::string::npos) << error.what();
  }
  EXPECT_EQ(std::vector<Label>(map.labels.begin(), map.labels.begin() + 6),
    std::vector<Label>(before.begin(), before.begin() + 6));
  hasp::SeparateComponents(map.View(), 1, { 0.0, true }); // needs no numbers
  EXPECT_EQ(map.labels, (std::vector<Label>{ 1, 0, 0, 0, 0, 0, 65534 }));
}

TEST(Components, ArePiecesAsFloodingFindsThem)
{
  std::mt19937 random(47);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (const double share : { 0.0, 0.1, 0.3, 0.5, 0.8, 1.0 })
      for (const Label most : { 1, 3 })
        for (const auto& [voxels, alone] :
          { std::pair<int, bool>{ 0, false }, { 3, false }, { 0, true }, { 1000000, false } })
        {
          LabelMap map = Noise(grid, share, most, random);
          const LabelMap before = map;
          // Exactly so many voxels: what is rounded must not decide.
          const double least = voxels * (grid.spacing.x * (grid.spacing.y * grid.spacing.z));
          const LabelMap expected = Separated(map, 1, least * (1.0 - 1e-12), alone);
          const LabelDelta delta = hasp::SeparateComponents(map.View(), 1, { least, alone });
          ASSERT_EQ(map.labels, expected.labels);
          hasp::RevertDelta(delta, map.View());
          EXPECT_EQ(map.labels, before.labels);
        }
}

TEST(Components, SixtyFragmentsAreNumberedBySizeThenByPlace)
{
  LabelMap map(hasp::testing::PlainGrid({ 120, 3, 2 }, { 1, 1, 1 }));
  for (int n = 0; n < 60; ++n)
    for (int j = 0; j < 1 + n % 3; ++j)
      map.At(2 * n, j, n % 2) = 1;
  hasp::SeparateComponents(map.View(), 1);
  EXPECT_EQ(map.At(4, 0, 0), 1);   // the first of three voxels
  EXPECT_EQ(map.At(10, 0, 1), 11); // behind the ten of three voxels with z = 0
  for (int n = 0; n < 60; ++n)
  {
    const Label label = map.At(2 * n, 0, n % 2);
    EXPECT_EQ((label - 1) / 20, 2 - n % 3) << n;
  }
}

TEST(Components, SpiralsAreOnePiece)
{
  // A comb joined at its far end: rows are joined long after they were found, across slabs.
  const hasp::GridGeometry grid = hasp::testing::PlainGrid({ 31, 4, 70 });
  LabelMap map(grid);
  for (int k = 0; k < 70; ++k)
    for (int i = 0; i < 31; i += 2)
      map.At(i, (i / 2) % 2 ? 0 : 2, k) = 1;
  for (int i = 0; i < 31; ++i)
    for (int j = 0; j < 4; ++j)
      map.At(i, j, 69) = 1;
  EXPECT_TRUE(hasp::SeparateComponents(map.View(), 1).Empty());
  map.At(2, 0, 40) = 0; // cut in two
  hasp::SeparateComponents(map.View(), 1);
  EXPECT_EQ(map.At(2, 0, 39), 2);
  EXPECT_EQ(map.At(2, 0, 41), 1);
}

TEST(Cavities, AreWhatNoWayLeadsOutOf)
{
  std::mt19937 random(53);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (const double share : { 0.0, 0.3, 0.6, 0.75, 0.9, 1.0 })
      for (const Label most : { 1, 2 })
      {
        LabelMap map = Noise(grid, share, most, random);
        const LabelMap before = map;
        LabelMap expected = map;
        for (const auto& piece : Flooded(map, [](Label label) { return label != 1; }))
        {
          bool out = false;
          for (const std::size_t v : piece)
          {
            const glm::ivec3 at(int(v) % grid.dims.x, int(v) / grid.dims.x % grid.dims.y,
              int(v) / (grid.dims.x * grid.dims.y));
            for (int a = 0; a < 3; ++a)
              out |= at[a] == 0 || at[a] + 1 == grid.dims[a];
          }
          if (!out)
            for (const std::size_t v : piece)
              if (expected.labels[v] == 0)
                expected.labels[v] = 1;
        }
        const LabelDelta delta = hasp::FillCavities(map.View(), 1);
        ASSERT_EQ(map.labels, expected.labels);
        hasp::RevertDelta(delta, map.View());
        EXPECT_EQ(map.labels, before.labels);
      }
}

TEST(Cavities, OtherLabelsWithinStayAndAreNoWall)
{
  LabelMap map(hasp::testing::PlainGrid({ 7, 7, 7 }), 1);
  for (int k = 2; k < 5; ++k)
    for (int j = 2; j < 5; ++j)
      for (int i = 2; i < 5; ++i)
        map.At(i, j, k) = 0;
  map.At(3, 3, 3) = 2;
  EXPECT_EQ(hasp::FillCavities(map.View(), 1).Voxels(), 26U);
  EXPECT_EQ(map.At(3, 3, 3), 2);
  // Shut in by two labels: a cavity of neither.
  LabelMap two(hasp::testing::PlainGrid({ 9, 5, 5 }), 1);
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 5; i < 9; ++i)
        two.At(i, j, k) = 2;
  two.At(4, 2, 2) = 0;
  EXPECT_TRUE(hasp::FillCavities(two.View(), 1).Empty());
  EXPECT_TRUE(hasp::FillCavities(two.View(), 2).Empty());
  EXPECT_TRUE(hasp::FillCavities(two.View(), 777).Empty());
}

} // namespace
