// The mouse and the keyboard in slices.
#include "ViewsDesk.h"

#include "vtkImageData.h"

#include <QtTest>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace
{

using namespace hasp;
using namespace hasp::testing;

TEST(SliceView, ShiftAndAMoveSetTheCrosshairAndDrawOtherSlicesAlone)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  const auto own = desk.coronal.Frames(), other = desk.axial.Frames();
  const QPoint pixel = MiddleOf(desk.coronal) + QPoint(-12, 31);
  const glm::dvec3 place = desk.coronal.PlaceAt(pixel);
  desk.Hover(desk.coronal, pixel, Qt::ShiftModifier);
  desk.Settle();
  EXPECT_LT(glm::distance(desk.grid.Crosshair(), place), 1e-9);
  EXPECT_EQ(desk.coronal.Frames(), own);
  EXPECT_EQ(desk.axial.Frames(), other + 1);
  desk.Hover(desk.coronal, pixel + QPoint(9, 9), {});
  EXPECT_LT(glm::distance(desk.grid.Crosshair(), place), 1e-9) << "without Shift it stays";
}

TEST(SliceView, ALeftDragSetsWindowAndLevel)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  const double* range = desk.grid.Image()->GetScalarRange();
  const double pixel = 0.002 * (range[1] - range[0]);
  const glm::dvec3 cross = desk.grid.Crosshair();
  desk.Drag(desk.sagittal, { 100, 100 }, { 150, 80 });
  EXPECT_NEAR(desk.grid.Window(), 1000.0 + 50.0 * pixel, 1e-6);
  EXPECT_NEAR(desk.grid.Level(), 400.0 + 20.0 * pixel, 1e-6);
  EXPECT_EQ(desk.grid.Crosshair(), cross) << "a drag is no click";
  for (int i = 0; i < 4; ++i) // each a quarter of the image's grey values and more
    desk.Drag(desk.axial, { 280, 100 }, { 5, 100 });
  EXPECT_GT(desk.grid.Window(), 0.0) << "it ends before it turns over";
}

TEST(SliceView, DragsZoomAndMove)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  const QPoint at(90, 70);
  const glm::dvec3 fixed = desk.axial.PlaceAt(at);
  const glm::dvec3 cross = desk.grid.Crosshair();
  const QPointF crossThere = *desk.coronal.PixelOf(cross);
  const double before = desk.axial.MmPerPixel();
  desk.Drag(desk.axial, at, at - QPoint(0, 40), Qt::RightButton);
  EXPECT_NEAR(desk.axial.MmPerPixel(), before * std::exp(-0.4), 1e-9) << "up: closer";
  EXPECT_LT(glm::distance(desk.axial.PlaceAt(at), fixed), 1e-9) << "about where it was pressed";
  EXPECT_EQ(desk.coronal.Zoom(), desk.axial.Zoom());
  EXPECT_LT((*desk.coronal.PixelOf(cross) - crossThere).manhattanLength(), 1e-6);

  for (const auto& [button, keys] :
    { std::pair(Qt::MiddleButton, Qt::NoModifier), std::pair(Qt::LeftButton, Qt::ShiftModifier) })
  {
    const glm::dvec3 held = desk.axial.PlaceAt(at);
    desk.Drag(desk.axial, at, at + QPoint(31, 17), button, keys);
    EXPECT_LT(glm::distance(desk.axial.PlaceAt(at + QPoint(31, 17)), held), 1e-9);
  }
  desk.Key(desk.coronal, Qt::Key_R);
  EXPECT_NEAR(desk.axial.MmPerPixel(), before, 1e-9);
}

TEST(SliceView, KeysStep)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  const glm::dvec3 before = desk.grid.Crosshair();
  desk.Key(desk.axial, Qt::Key_Right);
  desk.Key(desk.axial, Qt::Key_F);
  desk.Key(desk.axial, Qt::Key_F);
  EXPECT_NEAR(desk.grid.Crosshair().z, before.z + 3 * 2.0, 1e-9);
  desk.Key(desk.axial, Qt::Key_Left);
  desk.Key(desk.axial, Qt::Key_B);
  EXPECT_NEAR(desk.grid.Crosshair().z, before.z + 2.0, 1e-9);
}

TEST(SliceView, WhatTheMouseDoesKeysDo)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  const double window = desk.grid.Window(), level = desk.grid.Level();
  QTest::keyClick(&desk.axial, Qt::Key_Right, Qt::ShiftModifier);
  QTest::keyClick(&desk.axial, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_GT(desk.grid.Window(), window);
  EXPECT_GT(desk.grid.Level(), level);
  const QPointF cross = *desk.axial.PixelOf(desk.grid.Crosshair());
  desk.Key(desk.axial, Qt::Key_Up);
  EXPECT_NEAR(desk.axial.Zoom(), std::exp(0.1), 1e-9);
  EXPECT_EQ(desk.coronal.Zoom(), desk.axial.Zoom());
  EXPECT_LT((*desk.axial.PixelOf(desk.grid.Crosshair()) - cross).manhattanLength(), 1e-6);
  desk.Key(desk.axial, Qt::Key_M);
  EXPECT_EQ(desk.grid.Maximised(), &desk.axial);
  desk.Key(desk.axial, Qt::Key_M);
  EXPECT_EQ(desk.grid.Maximised(), nullptr);
}

} // namespace
