// Plates of scans, through the filter and its file.
#include "Evaluation/GuideGap.h"
#include "GuideFixture.h"
#include "Planning/PlateRecipe.h"
#include "vtkHaspPlateFilter.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include "vtkDataArray.h"
#include "vtkFieldData.h"

using namespace guidetest;

namespace
{

hasp::PlateRecipe OnScan()
{
  hasp::PlateRecipe r;
  r.landmarks = { OnSkull(-14, 3), OnSkull(0, -2), OnSkull(14, 4) };
  r.screws = { { OnSkull(-11, 1.6) }, { OnSkull(0, -2) }, { OnSkull(11, 2.5) } };
  r.spacingMm = 0.5;
  return r;
}

struct PlateAnswer
{
  vtkNew<vtkHaspPlateFilter> filter;
  std::string error;

  PlateAnswer(vtkImageData* ct, const hasp::PlateRecipe& recipe)
  {
    parttest::KeepWords(this->filter, this->error);
    this->filter->SetInputData(ct);
    this->filter->SetRecipe(recipe);
    this->filter->Update();
  }
};

TEST(PlateFilter, MakesAPlateThatFitsTheScan)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(0.8), 0.3);
  PlateAnswer answer(ct, OnScan());
  ASSERT_EQ(answer.error, "");
  const auto mesh = ThroughFile(answer.filter->GetOutput());
  const auto check = hasp::CheckMesh(mesh);
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1U);
  EXPECT_EQ(1 - (int(check.points) - int(check.triangles / 2)) / 2, 3); // holes
#if HASP_WITH_CGAL
  EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U);
#endif
  hasp::GuideGapSettings gap;
  gap.gapMm = 0.2;
  gap.toleranceMm = 0.1;
  const auto measured = hasp::MeasureGuideGap(hasp::ViewImage(ct), mesh, gap);
  EXPECT_GE(measured.share, 0.95);
  EXPECT_GT(measured.innerWallMm2, 150.0); // 28 mm x 7 mm less three bores
  vtkDataArray* axes = answer.filter->GetOutput()->GetFieldData()->GetArray("ScrewAxes");
  ASSERT_EQ(axes->GetNumberOfTuples(), 3);
  EXPECT_NEAR(axes->GetTuple(1)[2], OnSkull(0, -2).z + 2.7, 0.1);
  EXPECT_GT(axes->GetTuple(1)[5], 0.98);
}

TEST(PlateFilter, SaysWhatCannotBeMadeAndLeavesNothing)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(2), 0);
  const auto fault = [&](auto change)
  {
    auto recipe = OnScan();
    change(recipe);
    PlateAnswer answer(ct, recipe);
    EXPECT_EQ(answer.filter->GetOutput()->GetNumberOfPolys(), 0);
    return answer.error;
  };
  EXPECT_NE(
    fault([](auto& r) { r.landmarks[2].z -= 5; }).find("landmarks[2] is"), std::string::npos);
  EXPECT_NE(fault(
              [](auto& r) {
                r.landmarks = { { 300, 0, 0 }, { 310, 0, 0 } };
              })
              .find("landmarks[0] (300, 0, 0) is outside the volume"),
    std::string::npos);
  EXPECT_NE(
    fault([](auto& r) { r.isovalue = 30000; }).find("there is no bone around the landmarks"),
    std::string::npos);
  EXPECT_NE(fault([](auto& r) { r.screws[1].point.y = 400; }).find("screws[1].point (0, 400, "),
    std::string::npos);
  EXPECT_NE(fault(
              [](auto& r)
              {
                r.landmarks = { OnSkull(14, 0), OnSkull(16, 0) };
                r.screws = { { OnSkull(15, 0) }, { OnSkull(-16, 0) } };
              })
              .find("screws[1].point is over "),
    std::string::npos);
  EXPECT_NE(fault([](auto& r) { r.widthMm = -1; }).find("widthMm is -1"), std::string::npos);
  EXPECT_NE(
    fault([](auto& r) { r.fragments = { { 1 } }; }).find("there are no labels"), std::string::npos);
}

TEST(PlateFilter, StopsWhenItIsAskedTo)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(2), 0);
  vtkNew<vtkHaspPlateFilter> filter;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->SetInputData(ct);
  filter->SetRecipe(OnScan());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 0);
}

} // namespace
