#include "FilterErrors.h"
#include "vtkHaspSurfaceDistance.h"
#include "vtkHaspVolumeView.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

vtkNew<vtkSphereSource> Ball(double radius, int sides)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetThetaResolution(sides);
  ball->SetPhiResolution(sides);
  return ball;
}

double MostOff(vtkPolyData* found, double (*distance)(const double*), vtkMatrix4x4* pose)
{
  double most = found->GetNumberOfPoints() > 0 ? 0.0 : 1e300;
  for (vtkIdType n = 0; n < found->GetNumberOfPoints(); ++n)
  {
    double p[4] = { 0, 0, 0, 1 };
    found->GetPoint(n, p);
    if (pose)
      pose->MultiplyPoint(p, p);
    most = std::max(
      most, std::abs(found->GetPointData()->GetScalars()->GetComponent(n, 0) - distance(p)));
  }
  return most;
}

double ToBall(const double* p)
{
  return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - 20.0;
}

TEST(SurfaceDistanceFilter, WhatIsMissingOrNoDistanceIsRefused)
{
  const auto ball = Ball(20, 40);
  vtkNew<vtkHaspSurfaceDistance> filter;
  filter->SetSpacing(2.0);
  filter->SetInputConnection(ball->GetOutputPort());
  EXPECT_FALSE(ErrorsOfUpdate(filter).empty()); // no reference
  vtkNew<vtkPlaneSource> plane;                 // not closed
  filter->SetReferenceConnection(plane->GetOutputPort());
  EXPECT_NE(ErrorsOfUpdate(filter).find("closed"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->AllocateScalars(VTK_SHORT, 1);
  filter->SetReferenceData(image);
  EXPECT_NE(ErrorsOfUpdate(filter).find("type float"), std::string::npos);
  filter->SetReferenceConnection(ball->GetOutputPort());
  vtkNew<vtkMatrix4x4> pose;
  pose->SetElement(0, 0, 1.1);
  filter->SetSurfaceToReference(pose);
  EXPECT_NE(ErrorsOfUpdate(filter).find("rigid"), std::string::npos);
  pose->Identity();
  EXPECT_TRUE(ErrorsOfUpdate(filter).empty());
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(SurfaceDistanceFilter, PointsGetTheirDistanceInAnyPoseAndTheBallIsSampledOnce)
{
  const auto reference = Ball(20, 200), surface = Ball(19, 60);
  vtkNew<vtkHaspSurfaceDistance> filter;
  filter->SetInputConnection(surface->GetOutputPort());
  filter->SetReferenceConnection(reference->GetOutputPort());
  filter->SetSpacing(0.5);
  vtkNew<vtkMatrix4x4> pose;
  filter->SetSurfaceToReference(pose);
  for (int n = 0; n < 5; ++n)
  {
    pose->SetElement(0, 3, 0.5 * n);
    pose->SetElement(1, 1, std::cos(0.3 * n));
    pose->SetElement(1, 2, -std::sin(0.3 * n));
    pose->SetElement(2, 1, std::sin(0.3 * n));
    pose->SetElement(2, 2, std::cos(0.3 * n));
    filter->Update();
    // A tenth of a spacing at most on a ball (BodyDistance.h), and its facets' 0.003 mm.
    EXPECT_LT(MostOff(filter->GetOutput(), ToBall, pose), 0.06) << n;
  }
  EXPECT_EQ(filter->GetSamplings(), 1);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "SignedDistance");
  double range[2];
  filter->GetOutput()->GetPointData()->GetScalars()->GetRange(range);
  EXPECT_NEAR(range[0], -3.0, 0.1); // 1 mm within, 2 mm aside: NEGATIVE INSIDE
  EXPECT_NEAR(range[1], 1.0, 0.1);
  filter->SetSpacing(1.0);
  filter->Update();
  EXPECT_EQ(filter->GetSamplings(), 2);
}

TEST(SurfaceDistanceFilter, AnImageOfDistancesIsTakenAsItIs)
{
  hasp::GridGeometry grid;
  grid.dims = { 20, 20, 20 };
  grid.origin = { -10, -10, -10 };
  std::vector<float> samples;
  for (int n = 0; n < 8000; ++n)
    samples.push_back(float(n % 20) - 10.0F); // x
  const auto surface = Ball(5, 20);
  vtkNew<vtkHaspSurfaceDistance> filter;
  filter->SetInputConnection(surface->GetOutputPort());
  filter->SetReferenceData(hasp::MakeImage(grid, samples));
  filter->Update();
  EXPECT_LT(MostOff(
              filter->GetOutput(), [](const double* p) { return p[0]; }, nullptr),
    1e-5);
  EXPECT_EQ(filter->GetSamplings(), 0);
}

TEST(SurfaceDistanceFilter, AnEmptySurfaceStaysEmpty)
{
  const auto ball = Ball(20, 20);
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkHaspSurfaceDistance> filter;
  filter->SetSpacing(2.0);
  filter->SetInputData(nothing);
  filter->SetReferenceConnection(ball->GetOutputPort());
  EXPECT_TRUE(ErrorsOfUpdate(filter).empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

} // namespace
