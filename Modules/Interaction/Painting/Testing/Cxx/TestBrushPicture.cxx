// The brush as it is drawn: its size in pixels in closed form, and what it must not touch.
#include "PaintScene.h"
#include "vtkHaspBrushProp.h"

#include "vtkPropPicker.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace hasp;
using namespace hasp::testing;

using Pixels = std::vector<std::uint8_t>; // RGB

Pixels Picture(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> rgb;
  window->GetPixelData(0, 0, Side - 1, Side - 1, 0, rgb);
  return { rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues() };
}

/// The pixels of this colour, to a few steps.
std::vector<glm::dvec2> Find(const Pixels& picture, const glm::dvec3& colour)
{
  std::vector<glm::dvec2> found;
  for (int y = 0; y < Side; ++y)
    for (int x = 0; x < Side; ++x)
    {
      const std::uint8_t* p = &picture[3 * (y * Side + x)];
      if (glm::length(glm::dvec3(p[0], p[1], p[2]) - 255.0 * colour) < 6.0)
        found.push_back({ x + 0.5, y + 0.5 });
    }
  return found;
}

struct RingScene : PaintScene
{
  RingScene()
  {
    this->ball->GetProperty()->LightingOff();
    this->ball->GetProperty()->SetColor(0, 0, 1);
    this->renderer->AddActor(this->ball);
    this->painter->SetLabelColor(2, 1, 1, 0);
    this->painter->SetRadiusMm(5.0);
    this->Enable();
  }
  /// Mean distance of the ring's pixels from the place's pixel, and the largest deviation.
  glm::dvec2 Measure(const glm::dvec2& middle)
  {
    const auto ring = Find(Picture(this->window), { 1, 1, 0 });
    EXPECT_GT(ring.size(), 50u);
    double mean = 0.0, off = 0.0;
    for (const glm::dvec2& at : ring)
      mean += glm::length(at - middle) / ring.size();
    for (const glm::dvec2& at : ring)
      off = std::max(off, std::abs(glm::length(at - middle) - mean));
    return { mean, off };
  }
  vtkSmartPointer<vtkActor> ball = BallActor(20.0);
};

TEST(BrushPicture, TheRingIsAsLargeAsTheBrushIsInTheWorld)
{
  for (const bool parallel : { false, true })
    for (const double mm : { 3.0, 8.0 })
    {
      RingScene scene;
      scene.renderer->GetActiveCamera()->SetParallelProjection(parallel);
      scene.renderer->GetActiveCamera()->SetParallelScale(30.0);
      scene.painter->SetRadiusMm(mm);
      scene.window->Render();
      scene.Hover({ 100, 100 });
      double at[3];
      ASSERT_TRUE(scene.painter->GetPlace(100, 100, at));
      const double pixels = mm / scene.PixelMm(Distance - at[2]);
      const glm::dvec2 measured = scene.Measure({ 100.5, 100.5 });
      EXPECT_NEAR(measured.x, pixels, 0.35) << parallel; // a line two pixels wide, on whole pixels
      EXPECT_LT(measured.y, 2.0);
    }
}

// Where the surface is slanted a ring across the view would half vanish in it.
TEST(BrushPicture, TheRingIsSeenAllRound)
{
  RingScene scene;
  scene.Hover({ 140, 100 });
  bool quarter[4] = {};
  for (const glm::dvec2& at : Find(Picture(scene.window), { 1, 1, 0 }))
    quarter[(at.x > 140.5) + 2 * (at.y > 100.5)] = true;
  EXPECT_TRUE(quarter[0] && quarter[1] && quarter[2] && quarter[3]);
}

TEST(BrushPicture, TheBallShowsOnTheSurfaceWhatIsWithinTheRadius)
{
  RingScene scene;
  const Pixels before = Picture(scene.window);
  scene.Hover({ 100, 100 });
  double at[3];
  ASSERT_TRUE(scene.painter->GetPlace(100, 100, at));
  const Pixels after = Picture(scene.window);
  const auto changed = [&](int x)
  {
    return !std::equal(&before[3 * (100 * Side + x)], &before[3 * (100 * Side + x) + 3],
      &after[3 * (100 * Side + x)]);
  };
  const double ring = 5.0 / scene.PixelMm(Distance - at[2]);
  EXPECT_TRUE(changed(100));
  EXPECT_TRUE(changed(100 + int(0.6 * ring)));
  EXPECT_FALSE(changed(100 + int(ring) + 4));
  // Mixed, not painted over.
  const std::uint8_t* middle = &after[3 * (100 * Side + 100)];
  EXPECT_GT(middle[0], 20);
  EXPECT_GT(middle[2], 100);
}

TEST(BrushPicture, ItIsGoneWhereThereIsNothingToPaintOn)
{
  RingScene scene;
  const Pixels before = Picture(scene.window);
  scene.Hover({ 100, 100 });
  EXPECT_NE(Picture(scene.window), before);
  scene.Hover({ 5, 5 });
  EXPECT_EQ(Picture(scene.window), before);
  scene.Hover({ 100, 100 });
  scene.Say(vtkCommand::LeaveEvent, { 0, 0 });
  EXPECT_EQ(Picture(scene.window), before);
  scene.Hover({ 100, 100 });
  scene.painter->EnabledOff();
  scene.window->Render();
  EXPECT_EQ(Picture(scene.window), before);
}

TEST(BrushPicture, WhereTheMouseStandsStillNoPictureIsAskedFor)
{
  RingScene scene;
  scene.Hover({ 100, 100 });
  const Count frames(scene.window, vtkCommand::EndEvent);
  for (int n = 0; n < 5; ++n)
    scene.Hover({ 100, 100 });
  EXPECT_EQ(frames.times, 0);
  scene.Hover({ 101, 100 });
  EXPECT_EQ(frames.times, 1);
}

TEST(BrushPicture, ItIsPickedByNobody)
{
  RingScene scene;
  scene.Hover({ 100, 100 });
  vtkNew<vtkPropPicker> picker;
  EXPECT_TRUE(picker->Pick(100, 100, 0, scene.renderer));
  EXPECT_EQ(picker->GetViewProp(), scene.ball);
}

} // namespace
