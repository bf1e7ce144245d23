#include "vtkHaspCoverage.h"

#include "Distance/Coverage.h"
#include "FilterErrors.h"
#include "Grid/AnalyticVolumes.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspVolumeView.h"

#include "vtkAppendPolyData.h"
#include "vtkImageData.h"
#include "vtkImageTranslateExtent.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

namespace
{

constexpr double Radius = 9.0;
const double BallMm3 = 4.0 / 3.0 * std::numbers::pi * Radius * Radius * Radius;

const hasp::GridGeometry Grid{ { 30, 33, 40 }, { -13, 16, -14 }, { 0.9, 1.0, 0.7 },
  glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, -1) };

vtkSmartPointer<vtkImageData> GreyBall(hasp::GridGeometry grid = Grid)
{
  grid.origin.z = 14;
  return hasp::MakeImage(grid,
    hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere(glm::dvec3(0), Radius), grid, 50, 100));
}

double VolumeOf(vtkImageData* coverage)
{
  const auto* share = static_cast<const float*>(coverage->GetScalarPointer());
  const double* spacing = coverage->GetSpacing();
  return std::accumulate(share, share + coverage->GetNumberOfPoints(), 0.0) * spacing[0] *
         spacing[1] * spacing[2];
}

vtkSmartPointer<vtkImageData> EmptyGrid()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 42, -4, 35, 0, 39);
  image->SetSpacing(0.55, 0.6, 0.7);
  const double c = std::cos(0.4), s = std::sin(0.4);
  image->SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, 1);
  image->SetOrigin(0, 0, 0);
  double middle[3];
  image->TransformContinuousIndexToPhysicalPoint(22.5, 15.5, 19.5, middle);
  image->SetOrigin(-middle[0], -middle[1], -middle[2]);
  return image;
}

TEST(CoverageFilter, GivesTheVolumeOfABallOnItsOwnGrid)
{
  vtkNew<vtkHaspCoverage> filter;
  filter->SetInputData(GreyBall());
  filter->SetIsoValue(100.0);
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  vtkImageData* out = filter->GetOutput();
  EXPECT_STREQ(out->GetPointData()->GetScalars()->GetName(), "Coverage");
  EXPECT_EQ(out->GetScalarType(), VTK_FLOAT);
  EXPECT_NEAR(VolumeOf(out) / BallMm3, 1.0, 0.005);
}

TEST(CoverageFilter, TakesAnotherGridTurnedAndShifted)
{
  vtkNew<vtkHaspCoverage> filter;
  filter->SetInputData(GreyBall());
  filter->SetIsoValue(100.0);
  const auto grid = EmptyGrid();
  filter->SetGridData(grid);
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  vtkImageData* out = filter->GetOutput();
  EXPECT_NEAR(VolumeOf(out) / BallMm3, 1.0, 0.005);
  EXPECT_EQ(out->GetNumberOfPoints(), grid->GetNumberOfPoints());
  for (const vtkIdType point : { vtkIdType(0), out->GetNumberOfPoints() - 1 })
    for (int a = 0; a < 3; ++a)
      EXPECT_NEAR(out->GetPoint(point)[a], grid->GetPoint(point)[a], 1e-9) << point;
}

// What a pipeline is told before is what it gets, whatever the extents of what comes in.
TEST(CoverageFilter, TellsThePipelineItsGridBeforeItRuns)
{
  vtkNew<vtkImageTranslateExtent> shifted;
  shifted->SetInputData(GreyBall());
  shifted->SetTranslation(7, -3, 11);
  vtkNew<vtkHaspCoverage> filter;
  filter->SetInputConnection(shifted->GetOutputPort());
  filter->SetIsoValue(100.0);
  filter->UpdateInformation();
  vtkInformation* told = filter->GetOutputInformation(0);
  const int* whole = told->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  EXPECT_EQ(std::vector<int>(whole, whole + 6), (std::vector<int>{ 0, 29, 0, 32, 0, 39 }));
  filter->Update();
  vtkNew<vtkImageData> said;
  said->CopyInformationFromPipeline(told);
  said->SetExtent(const_cast<int*>(whole));
  vtkImageData* out = filter->GetOutput();
  for (const vtkIdType point : { vtkIdType(0), out->GetNumberOfPoints() - 1 })
    for (int a = 0; a < 3; ++a)
      EXPECT_DOUBLE_EQ(out->GetPoint(point)[a], said->GetPoint(point)[a]) << point;
  EXPECT_NEAR(VolumeOf(out) / BallMm3, 1.0, 0.005);
}

TEST(CoverageFilter, ANeighbouringFragmentCountsAsOutside)
{
  const auto image = GreyBall();
  vtkNew<vtkShortArray> labels;
  labels->SetName("Fragments");
  labels->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
    labels->SetValue(p, image->GetPoint(p)[0] < 0.0 ? 3 : 7);
  image->GetPointData()->AddArray(labels);
  vtkNew<vtkHaspCoverage> filter;
  filter->SetInputData(image);
  filter->SetIsoValue(100.0);
  filter->SetLabelArrayName("Fragments");
  double sum = 0.0;
  for (const int label : { 3, 7, 1 })
  {
    filter->SetLabel(label);
    EXPECT_EQ(ErrorsOfUpdate(filter), "");
    const double share = VolumeOf(filter->GetOutput()) / BallMm3;
    sum += share;
    EXPECT_NEAR(share, label == 1 ? 0.0 : 0.5, label == 1 ? 0.0 : 0.05) << label;
  }
  EXPECT_NEAR(sum, 1.0, 0.005);
  filter->SetLabelArrayName("None");
  EXPECT_NE(ErrorsOfUpdate(filter).find("no point array None"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(CoverageFilter, AClosedMeshIsCoveredOnAGrid)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(Radius);
  ball->SetThetaResolution(90);
  ball->SetPhiResolution(90);
  vtkNew<vtkHaspCoverage> filter;
  filter->SetInputConnection(ball->GetOutputPort());
  EXPECT_NE(ErrorsOfUpdate(filter).find("no grid of its own"), std::string::npos);
  filter->SetGridData(EmptyGrid());
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  EXPECT_NEAR(VolumeOf(filter->GetOutput()) / BallMm3, 1.0, 0.005);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  filter->SetInputData(cloud);
  EXPECT_NE(ErrorsOfUpdate(filter).find("no triangles"), std::string::npos);
  filter->SetInputConnection(ball->GetOutputPort());
  ball->SetEndPhi(120.0); // open
  EXPECT_NE(ErrorsOfUpdate(filter).find("closed"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Nothing lies within a single slice: said, in place of an empty part.
TEST(CoverageFilter, ASliceIsNoVolume)
{
  const hasp::GridGeometry slice{ { 9, 9, 1 }, glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  vtkNew<vtkHaspCoverage> filter;
  filter->SetInputData(hasp::MakeImage(slice, std::vector<std::int16_t>(81, 1000)));
  EXPECT_NE(ErrorsOfUpdate(filter).find("9 x 9 x 1"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(CoverageFilter, TooLittleMemoryIsSaid)
{
  vtkNew<vtkHaspCoverage> filter;
  unsigned long code = 0;
  const auto work = [](const hasp::ProgressFunction&) { throw std::bad_alloc(); };
  const std::string said =
    ErrorsOf(filter, [&] { EXPECT_EQ(hasp::RunFilter(filter, code, work), 0); });
  EXPECT_NE(code, 0UL);
  EXPECT_NE(said.find("coarser grid"), std::string::npos) << said;
}

TEST(CoverageFilter, WrongNumbersAndAnAbortGiveNothing)
{
  vtkNew<vtkHaspCoverage> filter;
  filter->SetInputData(GreyBall());
  filter->SetSamplesPerAxis(17);
  EXPECT_NE(ErrorsOfUpdate(filter).find("17"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetSamplesPerAxis(5);
  const AbortAtOnce abort(filter);
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(CoverageFilter, AMeshThatLeavesItsGridIsWarnedOf)
{
  const hasp::GridGeometry grid{ glm::ivec3(21), glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(5.0);
  vtkNew<vtkHaspCoverage> coverage;
  coverage->SetInputConnection(ball->GetOutputPort());
  coverage->SetGridData(hasp::MakeImage(grid, std::vector<float>(grid.Size())));
  ball->SetCenter(10, 10, 10);
  EXPECT_EQ(WarningsOfUpdate(coverage), "");
  ball->SetCenter(10, 10, 17.5); // to 22.5 mm, voxels to 20.5
  EXPECT_NE(WarningsOfUpdate(coverage).find("reaches 2 mm beyond its grid"), std::string::npos);
}

} // namespace
