// What lies over slices: labels, surfaces' lines, the line of an isovalue.
#include "ViewsDesk.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace
{

using namespace hasp;
using namespace hasp::testing;

int Props(FrameView& view)
{
  return view.Renderer()->GetViewProps()->GetNumberOfItems();
}

bool IsYellow(QRgb pixel)
{
  return qRed(pixel) > 150 && qGreen(pixel) > 150 && qBlue(pixel) < 90;
}

bool IsCyan(QRgb pixel)
{
  return qBlue(pixel) > 200 && qGreen(pixel) > 170 && qRed(pixel) < 150;
}

/// Distances (mm) of all pixels of a colour from a place.
std::vector<double> Distances(SliceView& view, const glm::dvec3& from, bool (*is)(QRgb))
{
  const QImage picture = Drawn(view);
  std::vector<double> distances;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (is(picture.pixel(x, y)))
        distances.push_back(glm::distance(view.PlaceAt({ x, y }), from));
  return distances;
}

vtkSmartPointer<vtkPolyData> Ball(double radius)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetThetaResolution(80);
  ball->SetPhiResolution(80);
  ball->Update();
  return ball->GetOutput();
}

vtkSmartPointer<vtkMatrix4x4> MovedTo(const glm::dvec3& place)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int axis = 0; axis < 3; ++axis)
    matrix->SetElement(axis, 3, place[axis]);
  return matrix;
}

double Nothing(const glm::dvec3&)
{
  return -1000.0;
}

TEST(SliceOverlays, WhatIsNotSetIsNotMade)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Nothing));
  EXPECT_EQ(Props(desk.axial), 1);
  desk.grid.SetLabels(ImageOf(UprightGrid(), Nothing), { { 1, { 1, 0, 0 } } });
  desk.grid.SetContours({ { Ball(10), nullptr, { 1, 1, 0 }, 2.0 } });
  desk.grid.SetIsovalueLine(100.0);
  desk.Settle();
  EXPECT_EQ(Props(desk.axial), 4);
  desk.grid.SetLabels(nullptr, {});
  desk.grid.SetContours({});
  desk.grid.SetIsovalueLine({});
  desk.Settle();
  EXPECT_EQ(Props(desk.axial), 1);
}

TEST(SliceOverlays, ASurfacesLineIsWhereThePlaneMeetsIt)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Nothing));
  const glm::dvec3 middle(8.0, -6.0, 10.0);
  const auto matrix = MovedTo(middle);
  desk.grid.SetContours({ { Ball(20.0), matrix, { 1, 1, 0 }, 2.0 } });
  desk.grid.SetCrosshair({ 0.0, 6.0, 18.0 });
  const auto check = [&](SliceView& view, const glm::dvec3& at, double radius)
  {
    const auto distances = Distances(view, at, &IsYellow);
    ASSERT_GT(distances.size(), 40U);
    // Half of a line's two pixels and the pixel's own half; the ball's facets lose 0.02 mm.
    const double tolerance = 1.6 * view.MmPerPixel();
    EXPECT_NEAR(*std::min_element(distances.begin(), distances.end()), radius, tolerance);
    EXPECT_NEAR(*std::max_element(distances.begin(), distances.end()), radius, tolerance);
  };
  check(desk.axial, { 8, -6, 18 }, std::sqrt(400.0 - 64.0));
  check(desk.coronal, { 8, 6, 10 }, std::sqrt(400.0 - 144.0));
  check(desk.sagittal, { 0, -6, 10 }, std::sqrt(400.0 - 64.0));

  matrix->SetElement(0, 3, -12.0); // it moves, as in a hand
  desk.grid.DrawAll();
  check(desk.axial, { -12, -6, 18 }, std::sqrt(400.0 - 64.0));
  matrix->SetElement(2, 3, 100.0);
  desk.grid.DrawAll();
  EXPECT_TRUE(Distances(desk.axial, {}, &IsYellow).empty()) << "out of reach";
}

TEST(SliceOverlays, AnotherSurfaceTakesItsPlace)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Nothing));
  const auto surface = Ball(20.0);
  desk.grid.SetContours({ { surface, nullptr, { 1, 1, 0 }, 2.0 } });
  Drawn(desk.axial);
  surface->DeepCopy(Ball(10.0)); // the same object
  const auto distances = Distances(desk.axial, {}, &IsYellow);
  ASSERT_FALSE(distances.empty());
  EXPECT_NEAR(
    *std::max_element(distances.begin(), distances.end()), 10.0, 1.6 * desk.axial.MmPerPixel());
}

TEST(SliceOverlays, TheIsovalueLineIsTheIsosurfacesEdge)
{
  const glm::dvec3 middle(2.0, 3.0, -1.0);
  const auto ball = [&](const glm::dvec3& place)
  { return 500.0 - 20.0 * glm::distance(place, middle); };
  ViewsDesk desk(ImageOf(UprightGrid(), ball));
  desk.grid.SetIsovalueLine(100.0); // 20 mm
  desk.grid.SetWindowLevel(1e6, 1e6);
  desk.grid.SetCrosshair(middle);
  const auto distances = Distances(desk.coronal, middle, &IsCyan);
  ASSERT_GT(distances.size(), 40U);
  // Samples 2 mm apart bend a circle of 20 mm by 0.03 mm; a pixel is half a mm.
  const double tolerance = 1.6 * desk.coronal.MmPerPixel();
  EXPECT_NEAR(*std::min_element(distances.begin(), distances.end()), 20.0, tolerance);
  EXPECT_NEAR(*std::max_element(distances.begin(), distances.end()), 20.0, tolerance);
}

TEST(SliceOverlays, TheIsovalueLineFollowsASliceAskew)
{
  const GridGeometry grid = TurnedGrid(true);
  ViewsDesk desk(ImageOf(grid, Ramp));
  desk.grid.SetIsovalueLine(110.0);
  desk.grid.SetWindowLevel(1e6, 1e6);
  desk.grid.SetCrosshair({ 0, 0, 0 });
  const QImage picture = Drawn(desk.axial);
  int seen = 0, beyond = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
    {
      if (!IsCyan(picture.pixel(x, y)))
        continue;
      const glm::dvec3 place = desk.axial.PlaceAt({ x, y });
      const glm::dvec3 index = grid.WorldToIndex(place);
      if (index.x > 1 && index.x < 59 && index.y > 1 && index.y < 49)
      {
        ++seen;
        // Along the slice the ramp rises by sqrt(13) a mm; the line is a pixel wide.
        EXPECT_NEAR(Ramp(place), 110.0, std::sqrt(13.0) * 1.5 * desk.axial.MmPerPixel());
      }
      else if (index.x < -3 || index.x > 63 || index.y < -3 || index.y > 53)
        ++beyond; // two pixels off the border
    }
  EXPECT_GT(seen, 20);
  EXPECT_EQ(beyond, 0);
}

TEST(SliceOverlays, LabelsHaveTheirColoursAndUnnamedOnesNone)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Nothing));
  auto labels = vtkSmartPointer<vtkImageData>::New();
  labels->CopyStructure(desk.grid.Image());
  labels->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  const GridGeometry grid = UprightGrid();
  const auto fill = [&](int atRight)
  {
    auto* label = static_cast<unsigned short*>(labels->GetScalarPointer());
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i)
          *label++ = static_cast<unsigned short>(i < 30   ? atRight
                                                 : i < 50 ? 0
                                                 : j < 50 ? 7
                                                 : j < 70 ? 9
                                                          : 500);
    labels->Modified();
  };
  fill(300);
  desk.grid.SetLabels(labels, { { 300, { 1, 0, 0 } }, { 7, { 0, 0, 1 } } }, 0.5);
  const auto at = [&](double x, double y)
  {
    const QImage picture = Drawn(desk.axial);
    return QColor(picture.pixel(desk.axial.PixelOf({ x, y, 0.0 })->toPoint()));
  };
  // Over black, half of the colour.
  EXPECT_NEAR(at(-20, 0).red(), 128, 2);
  EXPECT_EQ(at(-20, 0).blue(), 0);
  EXPECT_NEAR(at(20, -20).blue(), 128, 2);
  EXPECT_EQ(at(20, 10), QColor(Qt::black)) << "9 has no colour";
  EXPECT_EQ(at(20, 30), QColor(Qt::black)) << "nor has 500, above all that have";
  EXPECT_EQ(at(0, 0), QColor(Qt::black));
  fill(7); // a stroke
  desk.grid.DrawAll();
  EXPECT_NEAR(at(-20, 0).blue(), 128, 2);
}

TEST(SliceOverlays, WhatChangesInTheImageIsShown)
{
  const auto image = ImageOf(UprightGrid(), Nothing);
  ViewsDesk desk(image);
  EXPECT_EQ(qRed(Drawn(desk.axial).pixel(MiddleOf(desk.axial))), 0);
  std::fill_n(static_cast<float*>(image->GetScalarPointer()), image->GetNumberOfPoints(), 900.0F);
  image->Modified();
  desk.grid.DrawAll();
  EXPECT_EQ(qRed(Drawn(desk.axial).pixel(MiddleOf(desk.axial))), 255);
  EXPECT_EQ(desk.axial.GreyText(), "900 HU");
}

} // namespace
