// Strokes on what a renderer shows, against the ball that it is.
#include "PaintScene.h"

#include "vtkActor2D.h"
#include "vtkDiskSource.h"
#include "vtkPolyDataMapper2D.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double R = 20.0;

/// How far a stroke's points are from a ball, at most; mm.
double Off(const std::vector<BrushStroke>& pieces, double radius, const glm::dvec3& center = {})
{
  double most = 0.0;
  for (const BrushStroke& stroke : pieces)
    for (const glm::dvec3& point : stroke.points)
      most = std::max(most, std::abs(glm::length(point - center) - radius));
  return most;
}

double LargestStep(const BrushStroke& stroke)
{
  double most = 0.0;
  for (std::size_t n = 1; n < stroke.points.size(); ++n)
    most = std::max(most, glm::length(stroke.points[n] - stroke.points[n - 1]));
  return most;
}

TEST(PaintSurface, EveryPointLiesOnTheSurfaceThatIsSeen)
{
  for (const bool parallel : { false, true })
    for (const int samples : { 0, 4 })
    {
      PaintScene scene;
      scene.window->SetMultiSamples(samples);
      scene.renderer->AddActor(BallActor(R));
      scene.renderer->GetActiveCamera()->SetParallelProjection(parallel);
      scene.renderer->GetActiveCamera()->SetParallelScale(25.0);
      scene.Enable();
      const auto& pieces = scene.Drag({ { 70, 100 }, { 130, 110 }, { 100, 60 } });
      ASSERT_EQ(pieces.size(), 1u);
      ASSERT_GT(pieces[0].points.size(), 20u);
      // Half of what a pixel covers where it is nearest to the eye.
      EXPECT_LT(Off(pieces, R), 0.5 * scene.PixelMm(Distance - R)) << parallel << samples;
      // Seen: on the side of the eye, where the pointer was.
      const glm::dvec3 first = pieces[0].points.front();
      const double mm = scene.PixelMm(Distance - first.z);
      EXPECT_NEAR(first.x, -29.5 * mm, 0.02);
      EXPECT_NEAR(first.y, 0.5 * mm, 0.02);
      EXPECT_GT(first.z, 0.0);
    }
}

TEST(PaintSurface, OneEventAcrossTheBallIsAsGoodAsManyAndHasNoHoles)
{
  std::array<std::vector<BrushStroke>, 2> strokes;
  for (const bool slow : { false, true })
  {
    PaintScene scene;
    scene.renderer->AddActor(BallActor(R));
    scene.Enable();
    scene.painter->SetRadiusMm(1.0);
    std::vector<glm::ivec2> way{ { 60, 100 } };
    for (int x = 67; slow && x < 140; x += 7)
      way.push_back({ x, 100 });
    way.push_back({ 140, 100 });
    strokes[slow] = scene.Drag(way);
    ASSERT_EQ(strokes[slow].size(), 1u);
    EXPECT_LT(LargestStep(strokes[slow][0]), 1.0) << "the brush's radius: no hole";
  }
  EXPECT_EQ(strokes[0], strokes[1]);
}

// Two balls, one far behind the other's edge.
TEST(PaintSurface, NoStrokeSpansASilhouette)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(8.0, { -6, 0, 20 }));
  scene.renderer->AddActor(BallActor(20.0, { 10, 0, -40 }));
  scene.Enable();
  const auto& pieces = scene.Drag({ { 85, 100 }, { 130, 100 } });
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_LT(Off({ pieces[0] }, 8.0, { -6, 0, 20 }), 0.5 * scene.PixelMm(80));
  EXPECT_LT(Off({ pieces[1] }, 20.0, { 10, 0, -40 }), 0.5 * scene.PixelMm(140));
}

TEST(PaintSurface, BetweenTwoBallsThereIsNothing)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(6.0, { -12, 0, 0 }));
  scene.renderer->AddActor(BallActor(6.0, { 12, 0, 0 }));
  scene.Enable();
  const auto& pieces = scene.Drag({ { 55, 100 }, { 145, 100 } });
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_LT(Off({ pieces[0] }, 6.0, { -12, 0, 0 }), 0.5 * scene.PixelMm(Distance));
  EXPECT_LT(Off({ pieces[1] }, 6.0, { 12, 0, 0 }), 0.5 * scene.PixelMm(Distance));
}

// As one hovers, the brush lies over the place; texts lie over all.
TEST(PaintSurface, NeitherTheBrushNorWhatLiesOverThePictureIsPaintedOn)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(R));
  vtkNew<vtkDiskSource> disk;
  disk->SetInnerRadius(0.0);
  disk->SetOuterRadius(30.0);
  vtkNew<vtkPolyDataMapper2D> flat;
  flat->SetInputConnection(disk->GetOutputPort());
  vtkNew<vtkActor2D> text;
  text->SetMapper(flat);
  text->SetPosition(100, 100);
  scene.renderer->AddActor2D(text);
  scene.painter->SetRadiusMm(6.0);
  scene.Enable();
  for (int n = 0; n < 3; ++n)
    scene.Hover({ 95 + n, 100 });
  EXPECT_LT(Off(scene.Drag({ { 98, 100 }, { 102, 104 } }), R), 0.5 * scene.PixelMm(Distance - R));
}

TEST(PaintSurface, ALayerAboveClearsNothingOfOurs)
{
  PaintScene scene;
  scene.window->SetNumberOfLayers(2);
  scene.renderer->AddActor(BallActor(R));
  vtkNew<vtkRenderer> above;
  above->SetLayer(1);
  above->AddActor(BallActor(3.0));
  above->SetActiveCamera(scene.renderer->GetActiveCamera());
  scene.window->AddRenderer(above);
  scene.Enable();
  const auto& pieces = scene.Drag({ { 80, 100 }, { 120, 100 } });
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_LT(Off(pieces, R), 0.5 * scene.PixelMm(Distance - R));
}

TEST(PaintSurface, AViewportsPixelsAreItsOwn)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(R));
  scene.renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  vtkNew<vtkRenderer> beside;
  beside->SetViewport(0.0, 0.0, 0.5, 0.5);
  beside->AddActor(BallActor(5.0));
  scene.window->AddRenderer(beside);
  scene.Enable();
  EXPECT_TRUE(scene.Drag({ { 50, 50 }, { 52, 50 } }).empty());
  const auto& pieces = scene.Drag({ { 140, 150 }, { 160, 150 } });
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_LT(Off(pieces, R), scene.PixelMm(Distance - R)); // twice as large, half as many
  EXPECT_NEAR(pieces[0].points.front().x + pieces[0].points.back().x, 2 * scene.PixelMm(80), 0.1)
    << "about the middle, half a pixel off it";
}

TEST(PaintSurface, AStrokeIsPaintedOnWhatWasThereAtItsPress)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(R));
  scene.Enable();
  scene.Press({ 90, 100 });
  const auto lump = BallActor(4.0, { 0, 0, R }); // as a stroke drawn by somebody's tubes
  scene.renderer->AddActor(lump);
  scene.Hover({ 95, 100 });
  scene.Hover({ 110, 100 });
  scene.Release({ 110, 100 });
  EXPECT_LT(Off(scene.painter->GetPieces(), R), 0.5 * scene.PixelMm(Distance - R));
  // The next one is painted on what is there now.
  scene.Drag({ { 100, 100 }, { 101, 100 } });
  EXPECT_GT(Off(scene.painter->GetPieces(), R), 3.0);
}

TEST(PaintSurface, AfterACameraDragOnePictureMoreIsAskedFor)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(R));
  scene.Enable();
  scene.Hover({ 100, 100 });
  scene.Say(vtkCommand::RightButtonPressEvent, { 100, 100 });
  scene.renderer->GetActiveCamera()->Azimuth(90.0);
  scene.window->Render(); // as a style does; not copied
  scene.Say(vtkCommand::RightButtonReleaseEvent, { 100, 100 });
  double at[3];
  ASSERT_TRUE(scene.painter->GetPlace(100, 100, at));
  EXPECT_NEAR(at[0], R, 0.05) << "from the right";
}

TEST(PaintSurface, TheLeftEyesPictureIsPaintedOn)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(R));
  scene.renderer->GetActiveCamera()->SetEyeAngle(8.0);
  scene.window->SetStereoTypeToAnaglyph();
  scene.Enable();
  double mono[3], stereo[3];
  ASSERT_TRUE(scene.painter->GetPlace(100, 100, mono));
  scene.window->StereoRenderOn();
  scene.window->Render();
  ASSERT_TRUE(scene.painter->GetPlace(100, 100, stereo));
  EXPECT_NEAR(std::hypot(stereo[0], stereo[1], stereo[2]), R, 0.5 * scene.PixelMm(80));
  // Its line of sight goes from the left through the pixel on the screen, behind the place: 0.2 of
  // half the eyes' distance to the left.
  EXPECT_LT(stereo[0], mono[0] - 0.5);
}

TEST(PaintSurface, BeforeTheFirstPictureNothingIsAskedOfTheCamera)
{
  vtkSmartPointer<vtkRenderWindow> window = vtkSmartPointer<vtkRenderWindow>::New();
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  window->SetInteractor(interactor);
  interactor->SetInteractorStyle(nullptr);
  vtkNew<vtkHaspSeedPainter> painter;
  painter->SetRenderer(renderer);
  painter->EnabledOn();
  interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  double at[3];
  EXPECT_FALSE(painter->GetPlace(0, 0, at));
  EXPECT_FALSE(renderer->IsActiveCameraCreated());
  EXPECT_TRUE(window->GetNeverRendered());
}

} // namespace
