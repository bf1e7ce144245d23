// Labels that are painted while there are models of them.
#include "BrokenBall.h"

#include "Isosurface/CellAttributes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace
{

using hasp::FragmentModels;
using hasp::testing::LabelledScan;
using hasp::testing::UseOf;

using Labels = std::vector<std::uint16_t>;

/// 8 cuboids, 2 to 9.
LabelledScan EightCuboids()
{
  return hasp::testing::Cuboids(2,
    hasp::testing::GridAt(
      { 26, 26, 26 }, { 0.5, 0.6, 0.5 }, hasp::testing::SkewAxes(true), { 1, 2, 3 }),
    6.0);
}

const hasp::FragmentSettings Quick{ .rangeMm = 2.0 };
const Labels All{ 2, 3, 4, 5, 6, 7, 8, 9 };

class FragmentEdits : public ::testing::Test
{
protected:
  FragmentEdits() : Scan(EightCuboids()), Models(this->Scan.Scan(), Quick)
  {
    this->Models.Prepare(All, { .map = true, .surface = true });
    for (const std::uint16_t label : All)
      this->Before.push_back(this->Models.Finished(label));
  }
  /// Makes `to` of what is `from` in a box; the labels that are said to have changed.
  Labels Paint(const glm::ivec3& low, const glm::ivec3& high, int from, std::uint16_t to)
  {
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
          if (std::uint16_t& label = this->Scan.Label({ i, j, k }); label == from)
            label = to;
    return this->Models.LabelsChanged(low, high);
  }
  /// The labels of which nothing is there any more; all others have what they had.
  Labels Dropped() const
  {
    Labels dropped;
    for (std::size_t n = 0; n < All.size(); ++n)
    {
      const hasp::FragmentModel now = this->Models.Finished(All[n]);
      if (!now.map && !now.surface)
        dropped.push_back(All[n]);
      else
        EXPECT_TRUE(now.map == this->Before[n].map && now.surface == this->Before[n].surface);
    }
    return dropped;
  }

  LabelledScan Scan;
  FragmentModels Models;
  std::vector<hasp::FragmentModel> Before;
};

TEST_F(FragmentEdits, OnlyLabelsWithOtherVoxelsAreDropped)
{
  const glm::ivec3 m(13); // the corner where all eight meet
  // The box holds voxels of all eight; two are changed.
  EXPECT_EQ(this->Paint(m - 2, m + 1, 2, 3), (Labels{ 2, 3 }));
  EXPECT_EQ(this->Dropped(), (Labels{ 2, 3 }));
  EXPECT_EQ(UseOf(this->Models, "fragment 2 distance map").bytes, 0U);
  EXPECT_EQ(UseOf(this->Models, "fragment 2 distance map").reason, "its voxels changed");
  EXPECT_GT(UseOf(this->Models, "fragment 4 distance map").bytes, 0U);
  EXPECT_NE(this->Models.Surface(2), nullptr);
  EXPECT_EQ(this->Models.Finished(3).surface, nullptr) << "made again, alone, when it is asked for";
  EXPECT_EQ(this->Models.Finished(2).map, nullptr);
}

TEST_F(FragmentEdits, ABoxInWhichNothingChangedDropsNothing)
{
  EXPECT_TRUE(this->Models.LabelsChanged(glm::ivec3(0), glm::ivec3(25)).empty());
  EXPECT_TRUE(this->Models.LabelsChanged(glm::ivec3(5), glm::ivec3(4)).empty());
  EXPECT_TRUE(this->Models.LabelsChanged(glm::ivec3(-9), glm::ivec3(-1)).empty());
  EXPECT_TRUE(this->Models.LabelsChanged(glm::ivec3(26), glm::ivec3(1 << 30)).empty());
  EXPECT_TRUE(this->Dropped().empty());
  // As many voxels and the same box, but others: a swap.
  std::swap(this->Scan.Label({ 10, 12, 12 }), this->Scan.Label({ 15, 12, 12 }));
  ASSERT_NE(this->Scan.Label({ 10, 12, 12 }), this->Scan.Label({ 15, 12, 12 }));
  EXPECT_EQ(this->Models.LabelsChanged(glm::ivec3(-1000), glm::ivec3(1000)).size(), 2U);
  std::swap(this->Scan.Label({ 10, 12, 12 }), this->Scan.Label({ 15, 12, 12 }));
  EXPECT_EQ(this->Models.LabelsChanged(glm::ivec3(10, 12, 12), glm::ivec3(15, 12, 12)).size(), 2U);
}

TEST_F(FragmentEdits, LabelsComeAndGo)
{
  EXPECT_EQ(this->Paint(glm::ivec3(0), glm::ivec3(25), 9, 77), (Labels{ 9, 77 }));
  EXPECT_THROW(this->Models.Surface(9), std::invalid_argument);
  EXPECT_EQ(this->Models.Surface(77)->points.size(), this->Before[7].surface->points.size());
  EXPECT_EQ(this->Models.Labels().size(), 8U);
  EXPECT_EQ(this->Paint(glm::ivec3(0), glm::ivec3(25), 77, 0), (Labels{ 77 }));
  EXPECT_EQ(this->Models.Labels().size(), 7U);
}

// What is made after an edit is what is made of the edited labels from the start.
TEST_F(FragmentEdits, WhatIsMadeAgainIsWhatThereWouldBe)
{
  this->Paint({ 9, 9, 9 }, { 14, 15, 16 }, 5, 2);
  FragmentModels fresh(this->Scan.Scan(), Quick);
  for (const std::uint16_t label : { 2, 5 })
  {
    EXPECT_EQ(this->Models.Surface(label)->points, fresh.Surface(label)->points);
    EXPECT_EQ(this->Models.Finished(label).origin, fresh.Finished(label).origin);
  }
}

TEST_F(FragmentEdits, CellsKeepTheirPlaceAndGetOtherLabels)
{
  const auto before = this->Models.Cells();
  const hasp::ResourceUse use = UseOf(this->Models, "fragment cells");
  this->Paint(glm::ivec3(0), glm::ivec3(25), 4, 5);
  EXPECT_TRUE(this->Models.HasCells()) << "the bone is the same";
  const auto after = this->Models.Cells();
  EXPECT_NE(after, before) << "somebody may draw the old ones";
  EXPECT_GT(std::count(before->labels.begin(), before->labels.end(), 4), 0);
  EXPECT_EQ(std::count(after->labels.begin(), after->labels.end(), 4), 0);
  EXPECT_EQ(after->clusters, before->clusters);
  EXPECT_EQ(after->corners, before->corners);
  hasp::ClusteredCells truth = *before;
  hasp::AddLabels(truth, this->Scan.LabelView());
  EXPECT_EQ(after->labels, truth.labels);
  EXPECT_EQ(this->Models.Cells(), after);
  EXPECT_GE(UseOf(this->Models, "fragment cells").milliseconds, use.milliseconds);
  this->Models.LabelsChanged(glm::ivec3(0), glm::ivec3(25));
  EXPECT_EQ(this->Models.Cells(), after) << "nothing changed";
}

// RENDER paints while a WORKER is at work on what was there before.
TEST_F(FragmentEdits, WhatWasPaintedOverMeanwhileIsNotKept)
{
  this->Models.Release(2);
  this->Models.Release(8);
  const std::uint16_t both[] = { 2, 8 };
  const auto work = this->Models.Begin(both, { .surface = true });
  this->Paint({ 9, 9, 9 }, { 14, 15, 16 }, 2, 3);
  work->Run();
  EXPECT_EQ(work->Outdated(), (Labels{ 2 }));
  EXPECT_EQ(this->Models.Finished(2).surface, nullptr);
  ASSERT_NE(this->Models.Finished(8).surface, nullptr);
  EXPECT_EQ(this->Models.Finished(8).surface->points, this->Before[6].surface->points);
  FragmentModels fresh(this->Scan.Scan(), Quick);
  EXPECT_EQ(this->Models.Surface(2)->points, fresh.Surface(2)->points);
}

// Paint beside bone is a label's voxel, but no bone of its. The crop is another one, so places
// differ in their last digits, which decide where a border falls between two of 5 sub-samples.
TEST_F(FragmentEdits, PaintOnAirMovesNoSurface)
{
  ASSERT_EQ(this->Scan.Label({ 0, 0, 0 }), 0);
  EXPECT_EQ(this->Paint({ 0, 0, 0 }, { 1, 1, 1 }, 0, 2), (Labels{ 2 }));
  const auto now = this->Models.Surface(2), before = this->Before[0].surface;
  EXPECT_NE(now, before); // made anew
  EXPECT_EQ(now->points, before->points);
  EXPECT_EQ(now->triangles, before->triangles);
}

} // namespace
