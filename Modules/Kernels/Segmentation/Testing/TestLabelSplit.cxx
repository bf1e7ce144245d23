#include "Segmentation/LabelSplit.h"

#include "Segmentation/LabelHash.h"
#include "Testing/RandomBone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{

using hasp::Label;
using hasp::LabelSplit;
using hasp::SeedVoxels;

/// Two blocks of bone that touch over one face; the face's voxels are darker. And a third block,
/// apart.
struct TwoBlocks
{
  hasp::testing::RandomBone bone{ { 30, 12, 12 }, { 0.5, 0.5, 0.8 }, 1.0, 1 };

  TwoBlocks()
  {
    for (std::size_t v = 0; v < bone.samples.size(); ++v)
    {
      const int x = static_cast<int>(v % 30);
      bone.samples[v] = x == 10 ? 300.0F : 1000.0F;
      bone.labels[v] = x == 20 ? 0 : 1;
    }
  }
  hasp::GridView<Label> Map() { return { bone.labels.data(), bone.geometry }; }
  SeedVoxels Ball(int x, Label label) const
  {
    const std::vector<glm::dvec3> points{ bone.geometry.IndexToWorld({ x, 6, 6 }) };
    return { label, hasp::RasterizeStroke(bone.geometry, points, 1.0) };
  }
};

/// With a norm: by the least cut, and by the random walk.
class OfLabelSplit : public ::testing::TestWithParam<double>
{
public:
  LabelSplit Split(const hasp::testing::RandomBone& bone) const
  {
    return { bone.Samples(), bone.Labels(), 1, { {}, GetParam() } };
  }
};
INSTANTIATE_TEST_SUITE_P(Norms, OfLabelSplit, ::testing::Values(1.0, 2.0));

TEST_P(OfLabelSplit, PartsBlocksAtTheirDarkFace)
{
  TwoBlocks blocks;
  LabelSplit split = Split(blocks.bone);
  const std::vector<SeedVoxels> strokes{ blocks.Ball(3, 2), blocks.Ball(17, 3) };
  split.Share(strokes, blocks.Map());
  EXPECT_TRUE(split.LastRun().converged);
  for (std::size_t v = 0; v < blocks.bone.labels.size(); ++v)
  {
    const std::size_t x = v % 30; // 10: the dark face itself may go to either
    const int truth = x < 10 ? 2 : x < 20 ? 3 : x == 20 ? 0 : 1;
    ASSERT_TRUE(x == 10 || blocks.bone.labels[v] == truth) << x;
  }
}

TEST_P(OfLabelSplit, EachStrokeIsTakenBackBySmallChanges)
{
  TwoBlocks blocks;
  LabelSplit split = Split(blocks.bone);
  std::vector<SeedVoxels> strokes{ blocks.Ball(3, 2) };
  const std::vector<Label> start = blocks.bone.labels;
  std::vector<hasp::LabelDelta> deltas{ split.Share(strokes, blocks.Map()) };
  strokes.push_back(blocks.Ball(17, 3));
  deltas.push_back(split.Share(strokes, blocks.Map()));
  strokes.push_back(blocks.Ball(26, 4));
  deltas.push_back(split.Share(strokes, blocks.Map()));
  EXPECT_EQ(blocks.bone.labels[25], 4);
  strokes.pop_back(); // erased: its piece is nobody's again
  deltas.push_back(split.Share(strokes, blocks.Map()));
  EXPECT_EQ(blocks.bone.labels[25], 1);
  for (; !deltas.empty(); deltas.pop_back())
    hasp::RevertDelta(deltas.back(), blocks.Map());
  EXPECT_EQ(blocks.bone.labels, start);
}

TEST_P(OfLabelSplit, WhatIsForgottenLeavesNoTrace)
{
  // Labels that come in falling order, and one that goes again, once had other systems to solve.
  hasp::testing::RandomBone bone({ 30, 24, 20 }, { 0.5, 0.5, 0.8 }, 0.9, 3);
  const auto stroke = [&](int x, Label label) -> SeedVoxels
  {
    const std::vector<glm::dvec3> points{ bone.geometry.IndexToWorld({ x, 12, 10 }) };
    return { label, hasp::RasterizeStroke(bone.geometry, points, 1.0) };
  };
  const std::vector<SeedVoxels> all{ stroke(4, 7), stroke(12, 5), stroke(20, 3), stroke(27, 2),
    stroke(16, 9), stroke(8, 4) };
  std::vector<Label> fresh = bone.labels, warm = bone.labels;
  LabelSplit once = Split(bone);
  const std::size_t left = 5; // the last stroke is taken back
  once.Share({ all.data(), left }, { fresh.data(), bone.geometry });
  LabelSplit often = Split(bone);
  for (std::size_t n = 1; n <= all.size(); ++n)
    often.Share({ all.data(), n }, { warm.data(), bone.geometry });
  EXPECT_EQ(often.Remembers(), GetParam() == 2.0);
  if (often.Remembers())
    often.Forget();
  often.Share({ all.data(), left }, { warm.data(), bone.geometry });
  EXPECT_EQ(warm, fresh);
}

TEST_P(OfLabelSplit, TheLaterOfTwoStrokesCountsAndWhatIsNoBoneDoesNot)
{
  TwoBlocks blocks;
  LabelSplit split = Split(blocks.bone);
  std::vector<SeedVoxels> strokes{ blocks.Ball(3, 2), blocks.Ball(20, 5), blocks.Ball(3, 4) };
  split.Share(strokes, blocks.Map());
  EXPECT_EQ(std::count(blocks.bone.labels.begin(), blocks.bone.labels.end(), 2), 0);
  EXPECT_EQ(blocks.bone.labels[20], 0);
  EXPECT_EQ(blocks.bone.labels[(6 * 12 + 6) * 30 + 19], 5); // the ball reaches both its sides
  EXPECT_EQ(blocks.bone.labels[(6 * 12 + 6) * 30 + 21], 5);
}

TEST_P(OfLabelSplit, WhatFailsChangesNothing)
{
  TwoBlocks blocks;
  LabelSplit split = Split(blocks.bone);
  const std::uint64_t before = hasp::HashLabels(blocks.bone.Labels());
  std::vector<SeedVoxels> strokes{ blocks.Ball(3, 2), blocks.Ball(17, 3) };
  EXPECT_THROW(
    split.Share(strokes, blocks.Map(), {}, [](double) { return false; }), hasp::Cancelled);
  EXPECT_THROW(split.Share(strokes, blocks.Map(), { .tolerance = 1.0 }), std::invalid_argument);
  strokes[0].label = 0;
  EXPECT_THROW(split.Share(strokes, blocks.Map()), std::invalid_argument);
  EXPECT_EQ(hasp::HashLabels(blocks.bone.Labels()), before);
}

TEST(LabelSplit, RefusesNormsThatAreNone)
{
  const TwoBlocks blocks;
  for (const double norm : { 0.5, 2.5, std::nan("") })
    EXPECT_THROW(LabelSplit(blocks.bone.Samples(), blocks.bone.Labels(), 1, { {}, norm }),
      std::invalid_argument);
}

} // namespace
