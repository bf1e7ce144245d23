// Slices of images that lie askew: what is shown is what the volume is there.
#include "ViewsDesk.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace
{

using namespace hasp;
using namespace hasp::testing;

/// What a pixel of a slice should be of, by the window.
double Shade(const ViewGrid& grid, double grey)
{
  return std::clamp(
    255.0 * (grey - (grid.Level() - 0.5 * grid.Window())) / grid.Window(), 0.0, 255.0);
}

/// Places of pixels inside the image, all over the view.
std::vector<QPoint> PixelsInside(const SliceView& view, const GridGeometry& grid)
{
  std::vector<QPoint> pixels;
  for (int y = 3; y < view.height(); y += 5)
    for (int x = 3; x < view.width(); x += 5)
    {
      const glm::dvec3 index = grid.WorldToIndex(view.PlaceAt({ x, y }));
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis)
        inside = inside && index[axis] > 0.1 && index[axis] < grid.dims[axis] - 1.1;
      if (inside)
        pixels.emplace_back(x, y);
    }
  return pixels;
}

class SlicesAskew : public ::testing::TestWithParam<bool>
{
};
INSTANTIATE_TEST_SUITE_P(StoredEitherWay, SlicesAskew, ::testing::Bool());

TEST_P(SlicesAskew, EachPixelHasTheGreyOfItsPlace)
{
  const GridGeometry grid = TurnedGrid(GetParam());
  ViewsDesk desk(ImageOf(grid, Ramp));
  desk.grid.SetWindowLevel(100.0, 100.0); // a pixel beside would be four shades off
  desk.grid.SetCrosshair({ 1.3, -2.1, 4.7 });
  for (SliceView* view : { &desk.axial, &desk.coronal, &desk.sagittal })
  {
    const QImage picture = Drawn(*view);
    const std::vector<QPoint> pixels = PixelsInside(*view, grid);
    ASSERT_GT(pixels.size(), 50U);
    const QPointF middle = *view->PixelOf(view->PlaceAt(pixels.front()));
    EXPECT_LT((middle - QPointF(0.5, 0.5) - pixels.front()).manhattanLength(), 1e-6);
    double worst = 0.0;
    for (const QPoint& pixel : pixels)
      worst = std::max(
        worst, std::abs(qRed(picture.pixel(pixel)) - Shade(desk.grid, Ramp(view->PlaceAt(pixel)))));
    // VTK's table of shades rounds, and so does the screen.
    EXPECT_LE(worst, 1.6) << qPrintable(view->objectName());
  }
}

TEST_P(SlicesAskew, AWheelsNotchIsASpacing)
{
  const GridGeometry grid = TurnedGrid(GetParam());
  ViewsDesk desk(ImageOf(grid, Ramp), false);
  const glm::dvec3 before = desk.grid.Crosshair();
  // Its axes run along x, y and z most, in turn.
  const std::array<double, 3> spacing{ 50.0, 0.7, 0.5 };
  std::size_t n = 0;
  for (SliceView* view : { &desk.axial, &desk.coronal, &desk.sagittal })
  {
    const double step = spacing[n++];
    const int notches = step > 10.0 ? 1 : 3;
    desk.grid.SetCrosshair(before);
    desk.Wheel(*view, notches);
    const glm::dvec3 at = desk.grid.Crosshair();
    const glm::dvec3 asked = before + notches * step * FrameOf(view->Axis()).next;
    if (step < 10.0) // 50 mm on, this thin volume has ended
    {
      EXPECT_LT(glm::distance(at, asked), 1e-9) << qPrintable(view->objectName());
    }
    EXPECT_EQ(view->StepMm(), step);
    // A float sample has 24 bits.
    EXPECT_NEAR(*view->GreyValue(), Ramp(at), 1e-3);
    EXPECT_EQ(
      view->GreyText(), QString("grey %1").arg(QString::number(*view->GreyValue(), 'g', 5)));
  }
}

TEST_P(SlicesAskew, AClickSetsTheCrosshairInAllViews)
{
  ViewsDesk desk(ImageOf(TurnedGrid(GetParam()), Ramp));
  const QPoint pixel = MiddleOf(desk.axial) + QPoint(20, -13);
  const glm::dvec3 place = desk.axial.PlaceAt(pixel);
  desk.Click(desk.axial, pixel);
  desk.Settle();
  EXPECT_LT(glm::distance(desk.grid.Crosshair(), place), 1e-9);
  for (SliceView* view : { &desk.coronal, &desk.sagittal })
  {
    // The lines are where the view itself says that the place is, and through nothing else.
    const QPoint cross = view->PixelOf(place)->toPoint();
    const glm::dvec3 there = view->PlaceAt(cross);
    EXPECT_LT(glm::distance(there, place), 1.5 * view->MmPerPixel());
    const QImage picture = view->Picture();
    const QColor across = FrameOf(SliceAxis::Axial).colour; // seen from its edge
    const auto isLine = [&](int y)
    {
      for (const int x : { 40, 60 }) // beside letters and gap
        for (const int row : { y - 1, y, y + 1 })
          if (QColor(picture.pixel(x, row)) == across)
            return true;
      return false;
    };
    EXPECT_TRUE(isLine(cross.y())) << qPrintable(view->objectName());
    EXPECT_FALSE(isLine(cross.y() + 10));
  }
}

TEST(SliceView, LooksAtThePatientAsRadiologistsDo)
{
  // A bright ball at the patient's right, in front, above.
  const glm::dvec3 ball(-4.0, -5.0, 6.0);
  ViewsDesk desk(ImageOf(TurnedGrid(true, 41, 0.9),
    [&](const glm::dvec3& place) { return glm::distance(place, ball) < 3.0 ? 1000.0 : 0.0; }));
  desk.grid.SetCrosshair(ball);
  const auto found = [&](SliceView& view)
  {
    const QImage picture = Drawn(view);
    QPointF sum;
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        if (qRed(picture.pixel(x, y)) > 200)
        {
          sum += QPointF(x, y);
          ++count;
        }
    EXPECT_GT(count, 10);
    return (sum / count - *view.PixelOf({ 0, 0, 0 })) * view.MmPerPixel();
  };
  const auto letters = [](const SliceView& view)
  {
    const SliceFrame& frame = FrameOf(view.Axis());
    return SideLetter(-frame.right) + SideLetter(frame.right) + SideLetter(frame.up) +
           SideLetter(-frame.up); // as PaintMarks: left, right, top, bottom
  };
  // mm; a ball of 3 mm in voxels of up to 0.9 mm
  EXPECT_NEAR(found(desk.axial).x(), -4.0, 0.7) << "right: left";
  EXPECT_NEAR(found(desk.axial).y(), -5.0, 0.7) << "anterior: up";
  EXPECT_EQ(letters(desk.axial), "RLAP");
  EXPECT_NEAR(found(desk.coronal).x(), -4.0, 0.7) << "right: left";
  EXPECT_EQ(letters(desk.coronal), "RLSI");
  EXPECT_NEAR(found(desk.sagittal).x(), -5.0, 0.7) << "anterior: left";
  EXPECT_EQ(letters(desk.sagittal), "APSI");
  EXPECT_EQ(desk.axial.PlaceText(), "S 6.0 mm");
  EXPECT_EQ(desk.coronal.PlaceText(), "A 5.0 mm");
  EXPECT_EQ(desk.sagittal.PlaceText(), "R 4.0 mm");
}

} // namespace
