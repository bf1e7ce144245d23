#include "SegmentationWarnings.h"
#include "Segmenter.h"
#include "TwoBones.h"

#include "Grid/ThreadLimit.h"
#include "Segmentation/LabelSplit.h"
#include "vtkHaspLabelTable.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace
{

using namespace hasp;
using hasp::testing::BonesRecipe;
using hasp::testing::HashOf;
using hasp::testing::LabelAt;
using hasp::testing::StrokeAt;
using hasp::testing::TwoBones;

void Do(Segmenter& segmenter, const SegmentationRecipe& recipe)
{
  for (const SegmentationStep& step : recipe.steps)
    segmenter.Apply(step);
}

/// What `work` is refused with.
template <typename Work>
std::string Refusal(const Work& work)
{
  try
  {
    work();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

TEST(Segmenter, PartsABoneAtItsCrackAndNamesItsPieces)
{
  const auto scan = TwoBones();
  const SegmentedScan made = SegmentScan(scan, BonesRecipe());
  EXPECT_EQ(LabelAt(made.labels, 8, 5, 5), 2);
  EXPECT_EQ(LabelAt(made.labels, 13, 18, 15), 2);
  EXPECT_EQ(LabelAt(made.labels, 17, 18, 15), 3);
  EXPECT_EQ(LabelAt(made.labels, 35, 18, 15), 4);
  EXPECT_EQ(LabelAt(made.labels, 1, 1, 1), 0);
  ASSERT_EQ(made.findings.size(), 3U);
  EXPECT_EQ(made.findings[0].changed, 0U);
  EXPECT_FALSE(made.findings[1].walk);
  ASSERT_TRUE(made.findings[2].walk);
  EXPECT_TRUE(made.findings[2].walk->converged);
  EXPECT_EQ(made.findings[2].changed, made.findings[1].changed); // each voxel of bone has a name
  const LabelTable table = GetLabelTable(made.labels);
  ASSERT_EQ(table.size(), 3U);
  EXPECT_EQ(table[0].name, "left");
  EXPECT_EQ(table[1].name, "Fragment 3");
}

TEST(Segmenter, DoesWhatTheKernelsDo)
{
  const auto scan = TwoBones();
  const AnyGridView view = ViewImage(scan);
  std::vector<Label> labels(GeometryOf(view).Size());
  const GridView<Label> map{ labels.data(), GeometryOf(view) };
  ThresholdLabels(view, 226.0, 1e6, map);
  LabelSplit split(view, { labels.data(), map.geometry }, 1);
  std::vector<SeedVoxels> strokes;
  const SegmentationRecipe bones = BonesRecipe();
  for (const BrushStroke& stroke : std::get<SplitStep>(bones.steps[2]).strokes)
    strokes.push_back(
      { stroke.label, RasterizeStroke(map.geometry, stroke.points, stroke.radiusMm) });
  split.Share(strokes, map);
  SegmentationRecipe recipe = bones;
  recipe.steps.erase(recipe.steps.begin()); // the Gaussian
  EXPECT_EQ(HashOf(SegmentScan(scan, recipe).labels), HashLabels({ labels.data(), map.geometry }));
}

TEST(Segmenter, SaysWhatNoStrokeReachesAndWhichStrokesTouchNoBone)
{
  SegmentationRecipe recipe = BonesRecipe();
  std::get<SplitStep>(recipe.steps[2]).strokes[2] = StrokeAt(38, 4, 0.3);
  const SegmentedScan made = SegmentScan(TwoBones(), recipe);
  EXPECT_EQ(made.findings[2].besideBone, std::vector<std::size_t>{ 2 });
  EXPECT_EQ(LabelAt(made.labels, 35, 18, 15), 1);
  EXPECT_EQ(made.findings[2].unreached, made.findings[1].changed - made.findings[2].changed);
  EXPECT_GT(made.findings[2].unreached, 1000U);
}

TEST(Segmenter, SaysWhichLabelsGetNoVoxel)
{
  SegmentationRecipe recipe = BonesRecipe();
  auto& strokes = std::get<SplitStep>(recipe.steps[2]).strokes;
  strokes.insert(strokes.begin(), StrokeAt(8, 7, 0.7)); // the next paints over all of it
  strokes.insert(strokes.begin(), StrokeAt(9, 8, 1.5)); // and over some of this
  strokes.push_back(StrokeAt(38, 9, 0.3));              // beside the bone
  const SegmentedScan made = SegmentScan(TwoBones(), recipe);
  EXPECT_EQ(made.findings[2].withoutSeeds, (std::vector<std::uint16_t>{ 7, 9 }));
  const std::vector<std::size_t> voxels =
    CountLabels(std::get<GridView<const Label>>(ViewImage(made.labels)));
  EXPECT_EQ(voxels[7], 0U);
  EXPECT_GT(voxels[8], 0U);
  const std::vector<std::string> said = WarningsOf(recipe, made.findings, 0.24);
  ASSERT_EQ(said.size(), 3U);
  EXPECT_EQ(said[0], "steps[2].strokes[5] touches no voxel of label 1");
  EXPECT_EQ(said[1], "steps[2]: label 7 gets no voxel: its strokes touch none of label 1, or later "
                     "ones paint over them");
}

TEST(Segmenter, SaysWhichStepsChangeNothing)
{
  SegmentationRecipe recipe = BonesRecipe();
  recipe.steps.insert(recipe.steps.begin(), GaussianStep{ 0.01 }); // of a spacing of 0.5
  recipe.steps.insert(recipe.steps.end(),
    { PaintStep{ StrokeAt(8, 2), 0 }, PaintStep{ StrokeAt(8, 5), 4 }, MergeStep{ 9, 1 },
      ComponentsStep{ 4 }, FillStep{ 2 }, MorphologyStep{ 3, Morphology::Erode, 0.1 },
      MorphologyStep{ 9, Morphology::Dilate, 2.0 }, MergeStep{ 4, 0 } });
  const SegmentedScan made = SegmentScan(TwoBones(), recipe);
  const std::vector<std::string> nothing{
    "steps[0]: changes nothing: the samples are even, or sigmaMm is small against their spacing",
    "steps[4]: changes nothing: within the stroke there is no voxel that does not have label 2 "
    "already",
    "steps[5]: changes nothing: within the stroke there is no voxel of label 4 to be painted",
    "steps[6]: changes nothing: no voxel has label 9",
    "steps[7]: changes nothing: label 4 is one piece, or no voxel has it",
    "steps[8]: changes nothing: label 2 has no cavity, or no voxel has it",
    "steps[9]: changes nothing: no voxel has label 3, or 0.1 mm reach nothing that would change",
    "steps[10]: changes nothing: no voxel has label 9, or 2 mm reach nothing that would change",
  };
  EXPECT_EQ(WarningsOf(recipe, made.findings, 0.24), nothing);
  SegmentationRecipe twice{
    { ThresholdStep{ 5000.0, 1e6 }, ThresholdStep{ 226.0, 1e6 }, ThresholdStep{ 226.0, 1e6 } }, {}
  };
  const std::vector<std::string> said =
    WarningsOf(twice, SegmentScan(TwoBones(), twice).findings, 0.24);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0].find("steps[0]: changes nothing: no value is in [5000, 1e+06], or"), 0U);
  EXPECT_EQ(said[1].find("steps[2]: changes nothing: "), 0U);
}

TEST(Segmenter, NamesStrokesThatMarkNothingByTheirPlaces)
{
  SplitStep split{ 1, std::vector<BrushStroke>(13, StrokeAt(38, 4, 0.3)) };
  SegmentationFinding found;
  found.besideBone = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12 };
  found.changedNothing = true;
  found.unreached = 1;
  std::vector<std::string> said = WarningsOf(split, found, { "steps[3]" }, 0.24);
  ASSERT_EQ(said.size(), 12U);
  EXPECT_EQ(said[0], "steps[3].strokes[0] touches no voxel of label 1");
  EXPECT_EQ(said[9], "steps[3].strokes[9] touches no voxel of label 1");
  EXPECT_EQ(said[10], "steps[3]: 2 more of its strokes touch no voxel of label 1");
  EXPECT_EQ(said[11], "steps[3]: 1 voxel (0.2 mm3) that no stroke is connected to keeps label 1");
  found.besideBone = { 1 };
  found.unreached = 2;
  said = WarningsOf(split, found, { "steps[3]", { "", "labels[0].strokes[1]" } }, 0.24);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0], "labels[0].strokes[1] touches no voxel of label 1");
  EXPECT_EQ(said[1], "steps[3]: 2 voxels (0.5 mm3) that no stroke is connected to keep label 1");
}

/// With a norm: by the least cut, which each stroke leaves settled, and by the random walk.
class OfSegmenter : public ::testing::TestWithParam<double>
{
};
INSTANTIATE_TEST_SUITE_P(Norms, OfSegmenter, ::testing::Values(1.0, 2.0));

TEST_P(OfSegmenter, StrokesThatAreAddedSettleToWhatTheRecipeMakes)
{
  const auto scan = TwoBones();
  const SegmentationRecipe whole = BonesRecipe(GetParam());
  const std::uint64_t made = HashOf(SegmentScan(scan, whole).labels);
  SegmentationRecipe recipe = whole;
  auto& strokes = std::get<SplitStep>(recipe.steps[2]).strokes;
  const std::vector<BrushStroke> all = strokes;
  strokes.resize(1);
  Segmenter segmenter(scan);
  Do(segmenter, recipe);
  for (std::size_t n = 1; n < all.size(); ++n)
  {
    EXPECT_EQ(segmenter.IsSettled(), n == 1 || GetParam() < 2.0);
    segmenter.AddStroke(all[n]);
  }
  EXPECT_EQ(segmenter.Recipe().steps, whole.steps);
  EXPECT_EQ(segmenter.IsSettled(), GetParam() < 2.0);
  segmenter.Settle();
  EXPECT_TRUE(segmenter.IsSettled());
  EXPECT_EQ(HashOf(segmenter.Labels()), made);
  EXPECT_TRUE(segmenter.Settle().Empty());
  // So does the next step, whatever it is; and a stroke after it was taken back.
  segmenter.Undo();
  segmenter.AddStroke(all[2]);
  segmenter.Apply(MergeStep{ 4, 1 });
  segmenter.Undo();
  EXPECT_EQ(HashOf(segmenter.Labels()), made);
  segmenter.Undo();
  segmenter.AddStroke(all[2]); // its split was let go
  segmenter.Settle();
  EXPECT_EQ(HashOf(segmenter.Labels()), made);
}

TEST(Segmenter, AStepBehindAddedStrokesGivesBackAllThatChanged)
{
  const auto scan = TwoBones();
  Segmenter segmenter(scan);
  segmenter.Apply(ThresholdStep{});
  segmenter.Apply(SplitStep{ 1, { StrokeAt(22, 5) }, 90.0, 0.1, 2.0 });
  segmenter.AddStroke(StrokeAt(8, 3));
  segmenter.AddStroke(StrokeAt(32, 2));
  vtkNew<vtkImageData> mirror; // what a scene shows
  mirror->DeepCopy(segmenter.Labels());
  auto* shown = static_cast<Label*>(mirror->GetScalarPointer());
  const LabelDelta delta = segmenter.Apply(MergeStep{ 2, 1 });
  ApplyDelta(delta, { shown, ImageGeometry(mirror) });
  EXPECT_EQ(HashOf(mirror), HashOf(segmenter.Labels()));
  SegmentationRecipe recipe = segmenter.Recipe();
  EXPECT_EQ(HashOf(mirror), HashOf(SegmentScan(scan, recipe).labels));
}

TEST(Segmenter, AThresholdSmoothsForItselfAlone)
{
  const auto scan = TwoBones();
  Segmenter blurred(scan), smooth(scan), plain(scan);
  blurred.Apply(GaussianStep{ 0.6 });
  blurred.Apply(ThresholdStep{});
  smooth.Apply(ThresholdStep{ 226.0, 1e6, 0.6 });
  plain.Apply(ThresholdStep{});
  EXPECT_EQ(HashOf(smooth.Labels()), HashOf(blurred.Labels()));
  EXPECT_NE(HashOf(smooth.Labels()), HashOf(plain.Labels()));
  EXPECT_EQ(smooth.Image(), scan.GetPointer());
}

TEST(Segmenter, GivesTheSameLabelsWithAnyNumberOfThreads)
{
  const auto scan = TwoBones();
  const std::uint64_t hash = HashOf(SegmentScan(scan, BonesRecipe()).labels);
  for (const int threads : { 1, 2, 4 })
    WithThreadLimit(threads,
      [&] { EXPECT_EQ(HashOf(SegmentScan(scan, BonesRecipe()).labels), hash) << threads; });
}

/// One step at random that is legal behind all others.
SegmentationStep RandomEdit(std::mt19937& random)
{
  const auto pick = [&](int low, int high)
  { return std::uniform_int_distribution<int>(low, high)(random); };
  const auto label = [&] { return static_cast<std::uint16_t>(pick(1, 6)); };
  const BrushStroke stroke = StrokeAt(pick(-2, 42), label(), 0.1 * pick(1, 30));
  switch (pick(0, 7))
  {
    case 0:
      return ThresholdStep{ 100.0 * pick(1, 9), 1e6 };
    case 1:
      return SplitStep{ label(), { stroke, StrokeAt(pick(0, 40), label()) }, 90.0, 0.1,
        pick(0, 1) == 0 ? 1.0 : 2.0 };
    case 2:
      return MergeStep{ 6, static_cast<std::uint16_t>(pick(0, 5)) };
    case 3:
      return ComponentsStep{ label(), 0.1 * pick(0, 5), pick(0, 1) == 1 };
    case 4:
      return FillStep{ label() };
    case 5:
      return MorphologyStep{ label(), static_cast<Morphology>(pick(0, 3)), 0.3 * pick(1, 4) };
    default:
      return PaintStep{ stroke, static_cast<std::uint16_t>(pick(0, 2)) };
  }
}

TEST(Segmenter, AThousandEditsAreTakenBackToTheSameLabels)
{
  std::mt19937 random(77);
  Segmenter segmenter(TwoBones());
  Do(segmenter, BonesRecipe());
  std::vector<std::uint64_t> hashes;
  std::size_t before = segmenter.UndoBytes(), most = 0;
  for (int n = 0; n < 1000; ++n)
  {
    hashes.push_back(HashOf(segmenter.Labels()));
    const auto& steps = segmenter.Recipe().steps;
    if (std::holds_alternative<SplitStep>(steps.back()) && random() % 2)
      segmenter.AddStroke(StrokeAt(int(random() % 40), std::uint16_t(1 + random() % 6)));
    else
      segmenter.Apply(RandomEdit(random));
    most = std::max(most, segmenter.UndoBytes() - std::min(before, segmenter.UndoBytes()));
    before = segmenter.UndoBytes();
  }
  EXPECT_LE(most, 1'000'000U);
  for (; !hashes.empty(); hashes.pop_back())
  {
    segmenter.Undo();
    // A split that a later step settled is as it was settled.
    if (segmenter.IsSettled() && std::holds_alternative<SplitStep>(segmenter.Recipe().steps.back()))
      continue;
    ASSERT_EQ(HashOf(segmenter.Labels()), hashes.back()) << hashes.size();
  }
  EXPECT_EQ(segmenter.Recipe().steps, BonesRecipe().steps);
  EXPECT_EQ(HashOf(segmenter.Labels()), HashOf(SegmentScan(TwoBones(), BonesRecipe()).labels));
  while (segmenter.CanUndo())
    segmenter.Undo();
  EXPECT_TRUE(segmenter.Recipe().steps.empty());
  EXPECT_EQ(HashOf(segmenter.Labels()), HashOf(SegmentScan(TwoBones(), {}).labels));
  EXPECT_THROW(segmenter.Undo(), std::logic_error);
}

TEST(Segmenter, WhatIsForgottenStaysDoneAndCostsNothing)
{
  const auto scan = TwoBones();
  Segmenter segmenter(scan);
  Do(segmenter, BonesRecipe());
  const std::uint64_t hash = HashOf(segmenter.Labels());
  const std::size_t bytes = segmenter.UndoBytes();
  segmenter.ForgetUndo();
  EXPECT_LT(segmenter.UndoBytes(), bytes);
  EXPECT_EQ(HashOf(segmenter.Labels()), hash);
  segmenter.AddStroke(StrokeAt(20, 2)); // the last step can be gone on with, and taken back
  segmenter.Undo();
  EXPECT_EQ(HashOf(segmenter.Labels()), hash);
  segmenter.Apply(FillStep{ 2 });
  segmenter.ForgetUndo();
  segmenter.Undo();
  EXPECT_FALSE(segmenter.CanUndo());
  EXPECT_THROW(segmenter.AddStroke(StrokeAt(20, 2)), std::logic_error);
  EXPECT_EQ(HashOf(segmenter.Labels()), hash);
  EXPECT_THROW(segmenter.Undo(), std::logic_error);
}

TEST(Segmenter, AFilterIsTakenBackToTheScanItself)
{
  const auto scan = TwoBones();
  Segmenter segmenter(scan);
  segmenter.Apply(GaussianStep{ 1.0 });
  EXPECT_NE(segmenter.Image(), scan.Get());
  segmenter.Undo();
  EXPECT_EQ(segmenter.Image(), scan.Get());
}

TEST_P(OfSegmenter, WhatIsCancelledLeavesAllAsItWas)
{
  const SegmentationRecipe recipe = BonesRecipe(GetParam());
  Segmenter segmenter(TwoBones());
  Do(segmenter, recipe);
  segmenter.AddStroke(StrokeAt(20, 2));
  const std::uint64_t warm = HashOf(segmenter.Labels());
  const std::vector<SegmentationStep> steps = segmenter.Recipe().steps;
  const std::size_t bytes = segmenter.UndoBytes();
  for (const double at : { 0.0, 0.4, 0.9 })
  {
    const ProgressFunction stop = [at](double share) { return share < at; };
    EXPECT_THROW(segmenter.AddStroke(StrokeAt(25, 3), stop), Cancelled);
    EXPECT_EQ(HashOf(segmenter.Labels()), warm);
    EXPECT_EQ(segmenter.Recipe().steps, steps);
    EXPECT_EQ(segmenter.UndoBytes(), bytes);
  }
  segmenter.Settle();
  const std::uint64_t settled = HashOf(segmenter.Labels());
  for (const SegmentationStep& step : { SegmentationStep(ThresholdStep{ 300.0, 1e6 }),
         SegmentationStep(PaintStep{ StrokeAt(3, 7), 0 }), SegmentationStep(MergeStep{ 2, 3 }),
         SegmentationStep(SplitStep{ 2, { StrokeAt(5, 8) }, 90.0 }) })
  {
    EXPECT_THROW(segmenter.Apply(step, [](double) { return false; }), Cancelled);
    EXPECT_EQ(HashOf(segmenter.Labels()), settled);
    EXPECT_EQ(segmenter.Recipe().steps, steps);
  }
}

TEST(Segmenter, RefusalsNameTheStepAndTheKey)
{
  const auto scan = TwoBones();
  Segmenter segmenter(scan);
  Do(segmenter, BonesRecipe());
  EXPECT_NE(
    Refusal([&] { segmenter.Apply(GaussianStep{ 0.5 }); }).find("steps[3]"), std::string::npos);
  EXPECT_NE(Refusal([&] { segmenter.Apply(FillStep{ 0 }); }).find("steps[3]: label is 0"),
    std::string::npos);
  BrushStroke far = StrokeAt(3, 2);
  far.radiusMm = 51.0;
  EXPECT_NE(Refusal([&] { segmenter.AddStroke(far); }).find("radiusMm is 51"), std::string::npos);
  segmenter.Apply(FillStep{ 2 });
  EXPECT_NE(Refusal([&] { segmenter.AddStroke(StrokeAt(3, 2)); }).find("split"), std::string::npos);
  SegmentationRecipe recipe = BonesRecipe();
  std::get<ThresholdStep>(recipe.steps[1]).lowest = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(Refusal([&] { SegmentScan(scan, recipe); }).find("steps[1]"), std::string::npos);
  vtkNew<vtkImageData> empty;
  EXPECT_THROW(Segmenter{ empty }, std::invalid_argument);
  // A threshold that finds no bone, and a split of nothing, are no errors.
  EXPECT_EQ(SegmentScan(scan, { { ThresholdStep{ 5000.0, 6000.0 }, BonesRecipe().steps[2] }, {} })
              .findings[1]
              .changed,
    0U);
}

TEST(Segmenter, BeginsWithLabelsOfTheScansGridAndNoOthers)
{
  const auto scan = TwoBones();
  GridGeometry grid = hasp::testing::BonesGrid();
  const auto given = MakeImage(grid, std::vector<std::uint8_t>(grid.Size(), 7));
  Segmenter segmenter(scan, given);
  segmenter.Apply(MergeStep{ 7, 300 });
  EXPECT_EQ(LabelAt(segmenter.Labels(), 5, 5, 5), 300);
  EXPECT_EQ(given->GetScalarComponentAsDouble(5, 5, 5, 0), 7.0);
  grid.spacing.x *= 1.1;
  const auto wider = MakeImage(grid, std::vector<std::uint8_t>(grid.Size(), 7));
  EXPECT_THROW(Segmenter(scan, wider), std::invalid_argument);
  EXPECT_THROW(Segmenter(scan, scan), std::invalid_argument); // float
}

} // namespace
