#include "Planning/PlanEdits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace
{
using namespace hasp;

std::string Refusal(const std::function<void()>& act)
{
  try
  {
    act();
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

Plan Labelled()
{
  const Plan plan = Apply({}, AddObject<PlanVolume>{ { 1, "head", std::string(64, 'a') } });
  return Apply(plan, AddObject<PlanSegmentation>{ { 2, "bones", 1, std::string(64, 'b') } });
}

/// volume 1; segmentation 2, which begins with a label map and has a filter, a threshold and a
/// split.
Plan Segmented()
{
  Plan plan = Labelled();
  for (const SegmentationStep& step : { SegmentationStep(MedianStep{}),
         SegmentationStep(ThresholdStep{}), SegmentationStep(SplitStep{}) })
    plan = Apply(plan, AddSegmentationStep{ 2, step });
  return plan;
}

TEST(PlanEdits, StepsAndStrokesAreAddedBehindTheOthers)
{
  Plan plan = Segmented();
  const BrushStroke stroke{ 2, 1.5, { { 1, 2, 3 } } };
  plan = Apply(plan, AddSegmentationStroke{ 2, stroke });
  plan = Apply(plan, AddSegmentationStroke{ 2, { 3, 1.5, { { 4, 5, 6 } } } });
  const SegmentationRecipe& recipe = plan.segmentations[0].recipe;
  ASSERT_EQ(recipe.steps.size(), 3U);
  const auto& split = std::get<SplitStep>(recipe.steps[2]);
  ASSERT_EQ(split.strokes.size(), 2U);
  EXPECT_EQ(split.strokes[0], stroke);
  EXPECT_EQ(split.strokes[1].label, 3);
  EXPECT_EQ(plan.segmentations[0].labels, std::string(64, 'b')); // what the steps begin with
  ValidatePlan(plan);
  EXPECT_EQ(
    EditLabel(plan, AddSegmentationStroke{ 2, stroke }), "Stroke of label 2 in segmentation 2");
  EXPECT_EQ(EditLabel(plan, AddSegmentationStep{ 2, MergeStep{ 3, 2 } }),
    "Merge label 3 into 2 in segmentation 2");
}

TEST(PlanEdits, StepsAndStrokesThatDoNotFitAreRefused)
{
  const Plan plan = Segmented();
  const auto refused = [&](const PlanEdit& edit) { return Refusal([&] { Apply(plan, edit); }); };
  const BrushStroke stroke{ 2, 1.5, { { 1, 2, 3 } } };
  EXPECT_EQ(refused(AddSegmentationStep{ 3, FillStep{} }), "segmentation 3: the plan has none");
  EXPECT_EQ(refused(AddSegmentationStroke{ 3, stroke }), "segmentation 3: the plan has none");
  EXPECT_EQ(refused(AddSegmentationStep{ 2, FillStep{ 0 } }),
    "segmentation 2: step: label is 0, must be in [1, 65535]");
  EXPECT_EQ(refused(AddSegmentationStep{ 2, GaussianStep{} }),
    "segmentation 2: a filter must stand before all steps that are none; undo those first");
  EXPECT_EQ(refused(AddSegmentationStroke{ 2, { 0, 1.5, { { 1, 2, 3 } } } }),
    "segmentation 2: stroke: label is 0, must be in [1, 65535]");
  EXPECT_EQ(refused(AddSegmentationStroke{ 2, { 2, 1.5, { { 1, 2, std::nan("") } } } }),
    "segmentation 2: stroke: points[0][2] is nan, must be in [-4000, 4000] mm");
  EXPECT_EQ(Refusal(
              [&] {
                Apply(Labelled(), AddSegmentationStroke{ 2, stroke });
              }),
    "segmentation 2: its last step is none that splits a label; add one first");
  Plan full = plan;
  std::get<SplitStep>(full.segmentations[0].recipe.steps[2]).strokes.resize(MostStrokes, stroke);
  EXPECT_EQ(Refusal(
              [&] {
                Apply(full, AddSegmentationStroke{ 2, stroke });
              }),
    "segmentation 2: its last step has 10000 strokes, no more fit; add a step");
  full.segmentations[0].recipe.steps.resize(MostSegmentationSteps, FillStep{});
  EXPECT_EQ(Refusal(
              [&] {
                Apply(full, AddSegmentationStep{ 2, FillStep{} });
              }),
    "segmentation 2: has 10000 steps, no more fit");
  PlanSegmentation spoilt = plan.segmentations[0];
  spoilt.recipe.steps.emplace_back(GaussianStep{});
  EXPECT_EQ(refused(ChangeObject<PlanSegmentation>{ spoilt }),
    "segmentation 2: recipe: segmentation recipe: steps[3] is a filter, which must stand before "
    "all other steps");
  spoilt = plan.segmentations[0];
  spoilt.labels = "Erika";
  EXPECT_EQ(refused(ChangeObject<PlanSegmentation>{ spoilt }),
    "segmentation 2: labels must be 64 hexadecimal digits in lower case, a SHA-256");
  spoilt.labels.clear(); // label 0 everywhere
  EXPECT_EQ(refused(ChangeObject<PlanSegmentation>{ spoilt }), "");
}

} // namespace
