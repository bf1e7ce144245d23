// Strokes as they are drawn.
#include "LabelPalette.h"
#include "PaintScene.h"
#include "StrokePoints.h"
#include "vtkHaspStrokeActor.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace
{

using namespace hasp;
using namespace hasp::testing;

const BrushStroke Straight{ 2, 2.0, { { -10, 0, 0 }, { 10, 0, 0 } } };

std::array<int, 3> Pixel(PaintScene& scene, int x, int y)
{
  vtkNew<vtkUnsignedCharArray> rgb;
  scene.window->GetPixelData(x, y, x, y, 0, rgb);
  return { rgb->GetValue(0), rgb->GetValue(1), rgb->GetValue(2) };
}

TEST(StrokePoints, ALineIsFilledUpAndItsOwnPointsStay)
{
  const auto along = PointsAlong(Straight, 3.0); // 20 mm: seven parts
  ASSERT_EQ(along.size(), 8u);
  EXPECT_EQ(along.front(), Straight.points.front());
  EXPECT_EQ(along.back(), Straight.points.back());
  for (std::size_t n = 1; n < along.size(); ++n)
    EXPECT_NEAR(along[n].x - along[n - 1].x, 20.0 / 7.0, 1e-12);
  EXPECT_TRUE(PointsAlong({ 2, 1.0, {} }, 1.0).empty());
  EXPECT_EQ(PointsAlong({ 2, 1.0, { { 1, 2, 3 } } }, 1.0).size(), 1u);
  EXPECT_EQ(PointsAlong(Straight, 3.0, 1).size(), 1u);
}

TEST(StrokePoints, PolyDataHasALineAStrokeAndSaysWhose)
{
  const BrushStroke dot{ 9, 0.5, { { 1, 2, 3 } } };
  const auto data = StrokePolyData({ Straight, { 4, 1.0, {} }, dot });
  ASSERT_EQ(data->GetNumberOfVerts(), 1);
  ASSERT_EQ(data->GetNumberOfLines(), 1);
  ASSERT_EQ(data->GetNumberOfPoints(), 3);
  // Cell data begins with vertices.
  EXPECT_EQ(data->GetCellData()->GetArray("Label")->GetComponent(0, 0), 9);
  EXPECT_EQ(data->GetCellData()->GetArray("Label")->GetComponent(1, 0), 2);
  EXPECT_EQ(data->GetCellData()->GetArray("RadiusMm")->GetComponent(1, 0), 2.0);
  EXPECT_EQ(data->GetPoint(0)[2], 3.0);
}

TEST(LabelPalette, NeighboursAreTold)
{
  for (int a = 0; a < 30; ++a)
    for (int b = 0; b < a; ++b)
      EXPECT_GT(glm::length(PaletteColour(Label(a)) - PaletteColour(Label(b))), 0.05) << a << b;
  for (int label : { 0, 1, 2, 65535 })
    for (int n = 0; n < 3; ++n)
    {
      EXPECT_GE(PaletteColour(Label(label))[n], 0.0);
      EXPECT_LE(PaletteColour(Label(label))[n], 1.0);
    }
}

TEST(StrokeActor, OnlyWhatIsNewIsMade)
{
  vtkNew<vtkHaspStrokeActor> actor;
  EXPECT_EQ(actor->GetBounds(), nullptr);
  ASSERT_TRUE(actor->SetStrokes({ Straight }));
  EXPECT_EQ(actor->GetNumberOfBallsMade(), 41); // half a mm apart
  ASSERT_TRUE(actor->SetStrokes({ Straight }));
  EXPECT_EQ(actor->GetNumberOfBallsMade(), 41);
  BrushStroke longer = Straight;
  longer.points.push_back({ 10, 1, 0 });
  ASSERT_TRUE(actor->SetStrokes({ longer }));
  EXPECT_EQ(actor->GetNumberOfBallsMade(), 43);
  ASSERT_TRUE(actor->SetStrokes({ longer, Straight }));
  EXPECT_EQ(actor->GetNumberOfBallsMade(), 84);
  ASSERT_TRUE(actor->SetStrokes({ longer })); // taken back
  EXPECT_EQ(actor->GetNumberOfBallsMade(), 84);
  EXPECT_EQ(actor->GetNumberOfStrokes(), 1);
  ASSERT_TRUE(actor->SetStrokes({ Straight })); // shorter: made anew
  EXPECT_EQ(actor->GetNumberOfBallsMade(), 125);
  const double* bounds = actor->GetBounds();
  EXPECT_EQ(bounds[0], -12.0);
  EXPECT_EQ(bounds[3], 2.0);
  actor->ClearStrokes();
  EXPECT_EQ(actor->GetBounds(), nullptr);
}

TEST(StrokeActor, WrongStrokesAreSaidAndWhatWasShownStays)
{
  vtkNew<vtkHaspStrokeActor> actor;
  actor->SetStrokes({ Straight });
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const BrushStroke& wrong : { BrushStroke{ 2, 0.0, {} }, BrushStroke{ 2, nan, {} },
         BrushStroke{ 2, 51.0, {} }, BrushStroke{ 2, 1.0, { { 0, nan, 0 } } } })
    EXPECT_NE(ErrorsOf(actor, [&] { EXPECT_FALSE(actor->SetStrokes({ wrong })); }).find("(0, 50]"),
      std::string::npos);
  EXPECT_EQ(actor->GetNumberOfStrokes(), 1);
  EXPECT_NE(ErrorsOf(actor, [&] { actor->SetLabelColor(-1, 0, 0, 0); }).find("[0, 65535]"),
    std::string::npos);
}

TEST(StrokeActor, AStrokeIsAsWideAsItsBrushAndHiddenByWhatIsBeforeIt)
{
  PaintScene scene;
  const auto ball = BallActor(5.0, { 0, 0, 20 });
  ball->GetProperty()->SetColor(0, 0, 1);
  scene.renderer->AddActor(ball);
  vtkNew<vtkHaspStrokeActor> actor;
  actor->SetLabelColor(2, 1, 0, 0);
  actor->SetStrokes({ Straight });
  scene.renderer->AddViewProp(actor);
  scene.window->Render();
  const double mm = scene.PixelMm(Distance);
  const auto red = [&](double x, double y)
  {
    const auto p = Pixel(scene, int(100 + x / mm), int(100 + y / mm));
    return p[0] > 40 && p[2] < 10;
  };
  EXPECT_TRUE(red(8, 0));
  EXPECT_TRUE(red(8, 1.6));
  EXPECT_FALSE(red(8, 2.6));
  EXPECT_TRUE(red(11.5, 0));
  EXPECT_FALSE(red(12.6, 0));
  EXPECT_FALSE(red(0, 0)) << "the ball";
}

TEST(StrokeActor, OnePaintsOnTheBoneUnderAStroke)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(20.0));
  vtkNew<vtkHaspStrokeActor> actor;
  actor->SetStrokes({ { 2, 3.0, { { -3, 0, 20 }, { 3, 0, 20 } } } });
  scene.renderer->AddViewProp(actor);
  scene.Enable();
  scene.Hover({ 100, 100 });
  double at[3];
  ASSERT_TRUE(scene.painter->GetPlace(100, 100, at));
  EXPECT_NEAR(std::hypot(at[0], at[1], at[2]), 20.0, 0.02);
  // It was drawn there.
  EXPECT_GT(Pixel(scene, 90, 100)[0], 100);
}

} // namespace
