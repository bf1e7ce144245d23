// Random plates on the phantom, through the filter and a file: sound, or the named error.
#include "Evaluation/MeshCheck.h"
#include "RandomPlates.h"
#include "vtkHaspPlateFilter.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>
#include <map>
#include <string>

namespace
{

constexpr std::uint32_t SeedsEach = 11;

vtkSmartPointer<vtkImageData> Head()
{
  hasp::GridGeometry grid;
  grid.spacing = glm::dvec3(1.5);
  grid.origin = { -84, -105, -120 };
  grid.dims = { 113, 129, 130 };
  return hasp::MakeImage(grid, hasp::SamplePhantom(grid));
}

hasp::TriangleMesh ThroughFile(vtkPolyData* plate)
{
  const std::string path =
    testing::TempDir() + "TestRandomPlates" + std::to_string(getpid()) + ".stl";
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(plate);
  writer->SetFileName(path.c_str());
  writer->SetFileTypeToBinary();
  EXPECT_EQ(writer->Write(), 1);
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(path.c_str());
  reader->MergingOff();
  reader->Update();
  std::remove(path.c_str());
  return hasp::WeldPoints(hasp::MakeTriangleMesh(reader->GetOutput()));
}

/// What is wrong with what came of a recipe; `made` counts plates.
std::string Try(vtkImageData* head, const hasp::RandomPlate& plate, int& made)
{
  std::string error;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&error);
  keep->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
    { *static_cast<std::string*>(all) += static_cast<const char*>(text); });
  vtkNew<vtkHaspPlateFilter> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, keep);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, keep);
  filter->SetInputData(head);
  filter->SetRecipe(plate.recipe);
  filter->Update();
  const bool any = filter->GetOutput()->GetNumberOfPolys() > 0;
  made += any;
  return hasp::WrongWithPlate(
    plate, error, any ? ThroughFile(filter->GetOutput()) : hasp::TriangleMesh());
}

class RandomPlates : public testing::TestWithParam<std::uint32_t>
{
};

TEST_P(RandomPlates, AreSoundOrNamedErrors)
{
  const auto head = Head();
  int made = 0;
  for (std::uint32_t seed = GetParam(); seed < GetParam() + SeedsEach; ++seed)
    EXPECT_EQ(Try(head, hasp::RandomPlateRecipe(seed), made), "") << "seed " << seed;
  EXPECT_GT(made, 0);
}

// 44 plates, every kind four times.
INSTANTIATE_TEST_SUITE_P(, RandomPlates, testing::Values(0U, 11U, 22U, 33U));

TEST(RandomPlateRecipes, AreOfEveryKindAndTheSameAgain)
{
  std::map<std::string, int> kinds;
  for (std::uint32_t seed = 0; seed < 44; ++seed)
  {
    const auto plate = hasp::RandomPlateRecipe(seed);
    ++kinds[plate.kind];
    EXPECT_EQ(plate.words.empty(), plate.outcome != hasp::PlateOutcome::Refused);
    const auto again = hasp::RandomPlateRecipe(seed);
    if (std::string(plate.kind) != "nonsense") // whose NaN is like nothing
    {
      EXPECT_EQ(again.recipe, plate.recipe) << seed;
      EXPECT_NE(hasp::RandomPlateRecipe(seed + 44).recipe, plate.recipe);
    }
  }
  EXPECT_EQ(kinds.size(), hasp::RandomPlateKinds);
}

TEST(RandomPlateRecipes, WhatComesOfThemIsJudged)
{
  using hasp::WrongWithPlate;
  const hasp::TriangleMesh none, open{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const auto plain = hasp::RandomPlateRecipe(0), air = hasp::RandomPlateRecipe(5),
             any = hasp::RandomPlateRecipe(9);
  EXPECT_EQ(WrongWithPlate(air, "plate: screws[0] is 9 mm from bone", none), "");
  EXPECT_NE(WrongWithPlate(air, "plate: landmarks[0] is 9 mm from bone", none), "");
  EXPECT_NE(WrongWithPlate(air, "plate: screws[0] is 9 mm from bone", open), "");
  EXPECT_NE(WrongWithPlate(air, "", open), "");
  EXPECT_NE(WrongWithPlate(plain, "plate: no", none), "");
  EXPECT_NE(WrongWithPlate(plain, "", none), "");
  EXPECT_NE(WrongWithPlate(plain, "", open), "");
  EXPECT_EQ(WrongWithPlate(any, "plate: no", none), "");
  EXPECT_NE(WrongWithPlate(any, "bad allocation", none), "");
}

} // namespace
