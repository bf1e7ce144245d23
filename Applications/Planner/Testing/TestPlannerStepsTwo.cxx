// Touching bone, dragging blades and measuring with a mouse, as a surgeon does.
#include "StepsDesk.h"

#include "Planning/PlanEdits.h"
#include "Tools/BladeTool.h"
#include "Tools/LandmarkTool.h"
#include "Tools/MeasureTool.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

using namespace hasp;
using namespace hasp::testing;

namespace
{

TEST(LandmarkTool, AClickTouchesBoneAndADragTurnsTheView)
{
  StepsDesk desk(ScanOfBar());
  LandmarkTool tool(desk.planner, { "Touch." });
  int edits = 0;
  QObject::connect(&tool, &LandmarkTool::Edited, [&] { ++edits; });
  desk.Touch(Front(5.0));
  EXPECT_TRUE(tool.Places().empty()); // not in hand
  desk.planner.tools.Take(&tool);
  desk.Touch({ 5.0, -6.0, 30.0 }); // beside the bone
  EXPECT_TRUE(tool.Places().empty());
  desk.Touch(Front(5.0));
  ASSERT_EQ(tool.Places().size(), 1U);
  const TouchedPlace place = tool.Places()[0];
  EXPECT_NEAR(place.inScan.x, 5.0, ClickMm);
  EXPECT_LT(OffBar(place.inScan), SurfaceMm);
  EXPECT_LT(place.normal.y, -0.95); // out of the bone
  EXPECT_EQ(edits, 1);
  const auto eye = EyeOf(desk.views.scene);
  desk.Drag(Front(-10.0), { 60, 0 });
  EXPECT_NE(EyeOf(desk.views.scene), eye); // it turned
  EXPECT_EQ(tool.Places().size(), 1U);
}

TEST(LandmarkTool, APlaceIsDraggedAlongTheBoneAndRemovedByAKey)
{
  StepsDesk desk(ScanOfBar());
  LandmarkTool tool(desk.planner, { "Touch." });
  desk.planner.tools.Take(&tool);
  desk.Touch(Front(5.0));
  desk.Touch(Front(-8.0));
  ASSERT_EQ(tool.Places().size(), 2U);
  const auto eye = EyeOf(desk.views.scene);
  int edits = 0;
  QObject::connect(&tool, &LandmarkTool::Edited, [&] { ++edits; });
  const QPoint from = desk.PixelOf(tool.Places()[0].world), to = desk.PixelOf(Front(12.0, 2.0));
  desk.views.Drag(desk.views.scene, from, to);
  EXPECT_EQ(EyeOf(desk.views.scene), eye);
  EXPECT_EQ(edits, 1);
  EXPECT_EQ(tool.Selected(), 0);
  EXPECT_NEAR(tool.Places()[0].inScan.x, 12.0, ClickMm);
  EXPECT_LT(OffBar(tool.Places()[0].inScan), SurfaceMm);
  desk.views.Key(desk.views.scene, Qt::Key_Delete);
  ASSERT_EQ(tool.Places().size(), 1U);
  EXPECT_NEAR(tool.Places()[0].inScan.x, -8.0, ClickMm);
}

TEST(LandmarkTool, SlicesAndTheCrosshairTouchTheNearSurface)
{
  StepsDesk desk(ScanOfBar());
  LandmarkTool tool(desk.planner, { "Touch." });
  desk.planner.tools.Take(&tool);
  desk.views.grid.SetCrosshair({ 3.0, -5.0, 1.0 });
  desk.Settle();
  const auto pixel = desk.views.axial.PixelOf({ -7.0, 5.2, 1.0 });
  ASSERT_TRUE(pixel);
  desk.views.Click(desk.views.axial, pixel->toPoint());
  ASSERT_EQ(tool.Places().size(), 1U);
  EXPECT_NEAR(tool.Places()[0].inScan.x, -7.0, 1.0); // of a pixel of the slice
  EXPECT_LT(OffBar(tool.Places()[0].inScan), SurfaceMm);
  EXPECT_GT(tool.Places()[0].normal.y, 0.9);
  desk.views.grid.SetCrosshair({ 3.0, -5.0, 1.0 });
  desk.views.Key(desk.views.axial, Qt::Key_Insert);
  ASSERT_EQ(tool.Places().size(), 2U);
  EXPECT_LT(OffBar(tool.Places()[1].inScan), SurfaceMm);
  EXPECT_NEAR(tool.Places()[1].inScan.x, 3.0, 0.5);
}

TEST(BladeTool, ADragOfAHandleIsOneStepAndIsUndone)
{
  StepsDesk desk(ScanOfBar());
  BladeTool tool(desk.planner);
  tool.SetCut(desk.CutBar(0.0));
  desk.planner.tools.Take(&tool);
  const Osteotomy before = desk.Now().cuts[0].blade;
  const std::size_t steps = desk.Steps();
  const auto eye = EyeOf(desk.views.scene);
  const auto arrow = tool.PixelOf(desk.views.scene, BladeHandle::Normal);
  ASSERT_TRUE(arrow);
  desk.views.Drag(desk.views.scene, arrow->toPoint(), arrow->toPoint() + QPoint(40, 0));
  EXPECT_EQ(desk.Steps(), steps + 1);
  const Osteotomy shifted = desk.Now().cuts[0].blade;
  EXPECT_EQ(shifted.normal, before.normal);
  EXPECT_GT(glm::distance(shifted.point, before.point), 2.0);
  EXPECT_NEAR(glm::length(glm::cross(shifted.point - before.point, before.normal)), 0.0, 1e-9);
  const auto corner = tool.PixelOf(desk.views.scene, BladeHandle::Corner2);
  ASSERT_TRUE(corner);
  desk.views.Drag(desk.views.scene, corner->toPoint(), corner->toPoint() + QPoint(25, 10));
  EXPECT_EQ(desk.Steps(), steps + 2);
  EXPECT_EQ(desk.Now().cuts[0].blade.point, shifted.point);
  EXPECT_LT(glm::dot(desk.Now().cuts[0].blade.normal, before.normal), 0.999);
  EXPECT_EQ(EyeOf(desk.views.scene), eye); // the view did not turn
  desk.planner.plan.Undo();
  desk.planner.plan.Undo();
  EXPECT_EQ(desk.Now().cuts[0].blade, before);
  // Away from all handles the drag is the view's.
  desk.views.Drag(desk.views.scene, { 5, 5 }, { 45, 25 });
  EXPECT_NE(EyeOf(desk.views.scene), eye);
  EXPECT_EQ(desk.Now().cuts[0].blade, before);
}

TEST(MeasureTool, ADistanceFollowsItsFragments)
{
  StepsDesk desk(ScanOfBar());
  desk.CutBar(0.0);
  const PlanId bone = desk.Now().fragments[0].id;
  MeasureTool tool(desk.planner);
  tool.Start(MeasureKind::Distance);
  desk.Touch(Front(-10.0));
  EXPECT_TRUE(desk.Now().measures.empty());
  desk.Touch(Front(10.0));
  ASSERT_EQ(desk.Now().measures.size(), 1U);
  const PlanMeasure measure = desk.Now().measures[0];
  EXPECT_EQ(measure.points[0].fragment, bone);
  EXPECT_NEAR(MeasureValue(desk.Now(), measure), 20.0, 2.0 * ClickMm);
  const glm::dvec3 before = PlannedPlace(desk.Now(), measure.points[0]);
  desk.planner.plan.Do(MovedFragment(desk.Now(), bone, { { 0, 5, 0 } }));
  EXPECT_NEAR(PlannedPlace(desk.Now(), measure.points[0]).y, before.y + 5.0, 1e-9);
  tool.Start(MeasureKind::Angle);
  desk.Settle();
  for (const double x : { -10.0, 0.0, 10.0 })
    desk.Touch(Front(x) + glm::dvec3(0, 5, 0));
  ASSERT_EQ(desk.Now().measures.size(), 2U);
  EXPECT_NEAR(MeasureValue(desk.Now(), desk.Now().measures[1]), 180.0, 10.0);
}

} // namespace
