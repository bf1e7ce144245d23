#include "ErrorsSaid.h"
#include "Segmenter.h"
#include "TwoBones.h"
#include "vtkHaspLabelTable.h"
#include "vtkHaspSegmentationFilter.h"

#include "vtkFieldData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{

using hasp::testing::BonesRecipe;
using hasp::testing::HashOf;
using hasp::testing::TwoBones;

TEST(SegmentationFilter, GivesTheRecipesLabelsOnTheScansExtent)
{
  const auto scan = TwoBones();
  const std::uint64_t hash = HashOf(hasp::SegmentScan(scan, BonesRecipe()).labels);
  scan->SetExtent(5, 44, -3, 20, 100, 119);
  vtkNew<vtkHaspSegmentationFilter> filter;
  filter->SetInputData(scan);
  filter->SetRecipe(BonesRecipe());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetExtent()[0], 5);
  EXPECT_EQ(filter->GetOutput()->GetExtent()[5], 119);
  EXPECT_EQ(filter->GetOutput()->GetScalarType(), VTK_UNSIGNED_SHORT);
  // The extent moves the scan in the world, and strokes stay: bone is bone all the same.
  filter->SetRecipe({ { hasp::ThresholdStep{ 226.0, 1e6 } }, {} });
  filter->Update();
  EXPECT_EQ(
    HashOf(filter->GetOutput()), HashOf(hasp::SegmentScan(TwoBones(), filter->GetRecipe()).labels));
  scan->SetExtent(0, 39, 0, 23, 0, 19);
  filter->SetRecipe(BonesRecipe());
  filter->Update();
  EXPECT_EQ(HashOf(filter->GetOutput()), hash);
  EXPECT_EQ(hasp::GetLabelTable(filter->GetOutput()).size(), 3U);
}

TEST(SegmentationFilter, BeginsWithTheLabelsOfItsSecondInput)
{
  const hasp::GridGeometry grid = hasp::testing::BonesGrid();
  vtkNew<vtkHaspSegmentationFilter> filter;
  filter->SetInputData(TwoBones());
  filter->SetInputData(1, hasp::MakeImage(grid, std::vector<std::uint8_t>(grid.Size(), 9)));
  filter->Update(); // no steps
  EXPECT_EQ(hasp::testing::LabelAt(filter->GetOutput(), 1, 2, 3), 9);
}

TEST(SegmentationFilter, KeepsNamesAndColoursOfTheLabelsThatItBeginsWith)
{
  const hasp::GridGeometry grid = hasp::testing::BonesGrid();
  std::vector<std::uint8_t> labels(grid.Size(), 9);
  labels[0] = 5;
  labels[1] = 3;
  const auto given = hasp::MakeImage(grid, labels);
  const hasp::LabelEntry five{ 5, "ramus", { 9, 8, 7 }, false };
  hasp::SetLabelTable(given, { five, { 3, "chin" }, { 9, "tooth" }, { 4, "gone" } });
  vtkNew<vtkHaspSegmentationFilter> filter;
  filter->SetInputData(TwoBones());
  filter->SetInputData(1, given);
  filter->SetRecipe({ { hasp::MergeStep{ 3, 7 } }, { { 9, "molar", { 1, 2, 3 } } } });
  filter->Update();
  // The recipe's word counts, then the input's; what has no voxel any more is not listed.
  const hasp::LabelTable expected{ { 9, "molar", { 1, 2, 3 } }, five, hasp::UnnamedLabel(7) };
  EXPECT_EQ(hasp::GetLabelTable(filter->GetOutput()), expected);
  given->GetFieldData()->RemoveArray("LabelColors");
  given->Modified();
  EXPECT_NE(ErrorsOfUpdate(filter).find("LabelColors"), std::string::npos);
}

TEST(SegmentationFilter, SaysWhatIsWrongAndIsEmptyThen)
{
  vtkNew<vtkHaspSegmentationFilter> filter;
  filter->SetInputData(TwoBones());
  hasp::SegmentationRecipe recipe = BonesRecipe();
  std::get<hasp::SplitStep>(recipe.steps[2]).beta = -1.0;
  filter->SetRecipe(recipe);
  EXPECT_NE(ErrorsOfUpdate(filter).find("steps[2]"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetRecipe(BonesRecipe());
  filter->SetRecipe({}); // nothing that would ask for it
  for (const double tolerance : { 0.5, 0.0, -1.0, std::nan("") })
  {
    filter->SetTolerance(tolerance);
    EXPECT_NE(ErrorsOfUpdate(filter).find("Tolerance is"), std::string::npos) << tolerance;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << tolerance;
  }
  filter->SetRecipe(BonesRecipe());
  filter->SetTolerance(1e-3);
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("Steps: 3"), std::string::npos);
}

TEST(SegmentationFilter, WarnsOfStepsThatChangeNothing)
{
  vtkNew<vtkHaspSegmentationFilter> filter;
  filter->SetInputData(TwoBones());
  hasp::SegmentationRecipe recipe = BonesRecipe();
  filter->SetRecipe(recipe);
  EXPECT_EQ(SaidInUpdate(filter, vtkCommand::WarningEvent), "");
  recipe.steps.push_back(hasp::MergeStep{ 9, 1 });
  filter->SetRecipe(recipe);
  EXPECT_NE(SaidInUpdate(filter, vtkCommand::WarningEvent)
              .find("steps[3]: changes nothing: no voxel has label 9"),
    std::string::npos);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(SegmentationFilter, AnAbortIsNoErrorAndGivesNothing)
{
  vtkNew<vtkHaspSegmentationFilter> filter;
  filter->SetInputData(TwoBones());
  filter->SetRecipe(BonesRecipe());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn(); });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->RemoveObserver(tag);
  filter->AbortExecuteOff();
  filter->Modified();
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}

} // namespace
