// The trials as the report runs them, at sizes of seconds: their rows hold, and say what they are.
#include "DiceRows.h"
#include "ErrorCurves.h"
#include "SplitRival.h"
#include "Testing/FilledReport.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp;

using hasp::testing::Row;

Report Filled(const std::function<void(ReportContext&)>& fill)
{
  return hasp::testing::Filled("segmentation", fill);
}

/// A bar of bone in two, whose crack is as dark as can be and a voxel wide.
TrialScan Bar()
{
  TrialScan bar;
  bar.key = "bar";
  bar.data = "a bar in two";
  GridGeometry& grid = bar.scan.geometry;
  grid.dims = { 60, 16, 12 };
  grid.spacing = { 0.6, 0.6, 1.5 };
  bar.scan.samples.assign(grid.Size(), 40);
  bar.scan.truth.assign(grid.Size(), 0);
  bar.scan.names = { "left", "right" };
  std::size_t v = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i, ++v)
        if (i > 2 && i < 57 && j > 2 && j < 13 && k > 2 && k < 9)
        {
          bar.scan.samples[v] = i == 20 ? 260 : 1000;
          bar.scan.truth[v] = i <= 20 ? 2 : 3;
        }
  return bar;
}

TEST(SegmentationRows, AUserPartsABarAtItsCrack)
{
  const TrialScan bar = Bar();
  const TrialBone bone(bar.Samples(), 226.0);
  const TrialResult result = TryUser(bone, bar, 10, 1);
  EXPECT_TRUE(result.user.content);
  EXPECT_GT(result.dice.Worst().Dice(), 0.97); // the crack's one slice of 18 may be of either
  EXPECT_EQ(result.dice.WorstSurface().SurfaceDice(), 1.0);
  EXPECT_GT(result.firstS, 0.0);
  EXPECT_EQ(OneVoxelMm(bar.scan.geometry), 1.5);
}

TEST(SegmentationRows, TheWorstOfAllCasesIsTheFigure)
{
  const TrialScan bar = Bar();
  TrialScan other = bar;
  other.key = "other";
  const auto resultOf = [](const TrialScan& scan, const std::vector<Label>& labels)
  {
    TrialResult result;
    result.dice = CompareWithTruth(scan, labels, LabelPairing::SameNumber);
    result.allS = 1.0;
    return result;
  };
  std::vector<Label> shifted = bar.scan.truth, unnamed = bar.scan.truth;
  const glm::ivec3& dims = bar.scan.geometry.dims;
  for (std::size_t v = 0; v < shifted.size(); ++v)
    if (bar.scan.truth[v] == 3 && int(v % dims.x) < 38) // 17 slices of the 36
    {
      shifted[v] = 2;
      unnamed[v] = 1; // bone that nobody named
    }
  const Report report = Filled(
    [&](ReportContext& context)
    {
      DiceRows rows("", "strokes");
      rows.Add(context, bar, resultOf(bar, bar.scan.truth));
      rows.Add(context, other, resultOf(other, shifted));
      rows.AddAbsent(context, "cranium", "not here");
      rows.AddWorst(context, 0.97, 0.95, 0.99);
    });
  EXPECT_EQ(*Row(report, "segmentation.dice.bar").value, 1.0);
  // 18 of 18 shared with 35 slices, and 19 shared of 36 and 19.
  EXPECT_NEAR(*Row(report, "segmentation.dice").value, 36.0 / 53.0, 1e-12);
  EXPECT_TRUE(Missed(Row(report, "segmentation.dice")));
  EXPECT_TRUE(Missed(Row(report, "segmentation.surface")));
  EXPECT_NE(Row(report, "segmentation.dice").data.find("other"), std::string::npos);
  EXPECT_EQ(Row(report, "segmentation.dice.cranium").absent, "not here");
  const SegmentationDice none = CompareWithTruth(bar, unnamed, LabelPairing::SameNumber);
  EXPECT_EQ(none.strayVoxels, 0U);
  EXPECT_NEAR(none.labels[1].Dice(), 38.0 / 55.0, 1e-12);
}

TEST(SegmentationRows, CurvesHaveAPointForEachSetting)
{
  const TrialScan bar = Bar();
  const TrialBone bone(bar.Samples(), 226.0);
  const TrialResult result = TryUser(bone, bar, 10, 1);
  const Report report = Filled(
    [&](ReportContext& context) { DrawErrorCurves(context, bar, bone, result.user.strokes); });
  std::size_t rivals = 0;
  for (const SplitRival& rival : WatershedRivals())
    rivals += rival.absent.empty();
  ASSERT_EQ(report.curves.size(), 2 * (3 + rivals));
  for (const std::size_t walker : { 0, 2 })
  {
    EXPECT_EQ(report.curves[walker].points.size(), 5U);
    EXPECT_LT(report.curves[walker].points[4].second, 0.03);
  }
  EXPECT_EQ(report.curves[4].points.size(), 4U);
  // Above 350 the crack is no bone, and what is left are the two.
  EXPECT_LT(report.curves[4].points[1].second, 0.03);
  EXPECT_GT(report.curves[4].points[0].second, 0.5);
  for (std::size_t c = 6; c < report.curves.size(); c += 2)
    if (report.curves[c].method.find("inverted") != std::string::npos)
    {
      EXPECT_LT(report.curves[c].points[0].second, 0.03) << report.curves[c].method;
    }
}

TEST(SegmentationRows, TheWalkerAgreesWithADirectSolver)
{
  const Report report = Filled([](ReportContext& context) { TryDirect(context); });
  const ReportRow& row = Row(report, "segmentation.direct");
  if (row.absent.empty())
  {
    EXPECT_FALSE(Missed(row)) << *row.value;
  }
}

TEST(SegmentationRows, WhatIsUnusedHoldsNothing)
{
  const Report report = Filled(
    [](ReportContext& context)
    {
      AddUnusedSegmentation(context);
      DiceRows("", "").AddAbsent(context, "cranium", "not here"); // a report says something
    });
  EXPECT_GE(report.unused.size(), 2U);
}

} // namespace
