#include "vtkHaspVolumeView.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <numeric>

namespace
{

TEST(VolumeView, GeometryAndSamplesSurviveTheRoundTrip)
{
  const hasp::GridGeometry geometry{ { 3, 4, 5 }, { -7, 8, 9 }, { 0.5, 1, 2 },
    glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1)) };
  std::vector<std::int16_t> samples(60);
  std::iota(samples.begin(), samples.end(), std::int16_t{ -30 });
  const auto image = hasp::MakeImage(geometry, samples);
  const auto view = std::get<hasp::GridView<const std::int16_t>>(hasp::ViewImage(image));
  EXPECT_EQ(view.geometry.dims, geometry.dims);
  EXPECT_EQ(view.geometry.direction, geometry.direction);
  EXPECT_EQ(view(2, 3, 4), 29);
  // VTK places the sample where we do.
  double world[3];
  const double index[3] = { 1, 2, 3 };
  image->TransformContinuousIndexToPhysicalPoint(index, world);
  const glm::dvec3 ours = geometry.IndexToWorld({ 1, 2, 3 });
  EXPECT_LT(glm::length(ours - glm::dvec3(world[0], world[1], world[2])), 1e-12);
}

TEST(VolumeView, AnExtentThatStartsElsewhereMovesTheOrigin)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(2, 4, 3, 6, -1, 1);
  image->SetSpacing(0.5, 1, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_EQ(hasp::ImageGeometry(image).origin, glm::dvec3(1, 3, -2));
}

TEST(VolumeView, WhatKernelsCannotReadIsRefused)
{
  EXPECT_THROW(hasp::ViewImage(nullptr), std::invalid_argument);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  EXPECT_THROW(hasp::ViewImage(image), std::invalid_argument);
  image->AllocateScalars(VTK_DOUBLE, 1);
  EXPECT_THROW(hasp::ViewImage(image), std::invalid_argument);
  image->AllocateScalars(VTK_FLOAT, 3);
  EXPECT_THROW(hasp::ViewImage(image), std::invalid_argument);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->SetDimensions(2, 2, 3); // the extent grows, the scalars do not
  EXPECT_THROW(hasp::ViewImage(image), std::invalid_argument);
}

TEST(VolumeView, StripsAreRefusedNotDropped)
{
  vtkNew<vtkPoints> points;
  for (int n = 0; n < 4; ++n)
    points->InsertNextPoint(n & 1, n >> 1, 0);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkPolyData> polyData;
  polyData->SetPoints(points);
  polyData->SetStrips(strips);
  EXPECT_THROW(hasp::MakeTriangleMesh(polyData), std::invalid_argument);
}

TEST(VolumeView, MeshesKeepDoublePrecision)
{
  const hasp::TriangleMesh mesh{ { { 0, 0, 0 }, { 1.0 / 3.0, 0, 0 }, { 0, 1e-9, 0 } },
    { { 0, 1, 2 } } };
  const auto polyData = hasp::MakePolyData(mesh);
  const auto back = hasp::MakeTriangleMesh(polyData);
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.triangles, mesh.triangles);
  polyData->GetPolys()->InsertNextCell({ 0, 1, 2, 0 });
  EXPECT_THROW(hasp::MakeTriangleMesh(polyData), std::invalid_argument);
}

} // namespace
