// Eyes before a screen, and the window of `hasp view` around them.
#include "Devices/MouseHeadPose.h"
#include "StereoDesk.h"
#include "VtkMessages.h"

#include "vtkRenderWindow.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <functional>

namespace
{

using namespace hasp;
using hasp::testing::HandHeld;
using hasp::testing::StereoDesk;

/// Where a line meets the screen.
glm::dvec2 OnScreen(const glm::dvec3& from, const glm::dvec3& to)
{
  return glm::dvec2(from + (to - from) * (from.z / (from.z - to.z)));
}

TEST(StereoView, EachPixelIsSeenByItsEyeFromWhereItIs)
{
  StereoDesk desk("side-by-side");
  EXPECT_EQ(desk.window->GetSize()[0], 400); // two eyes of 200
  constexpr double pixel = 2.0;              // mm
  for (const bool right : { false, true })
  {
    const auto ray = desk.eyes->RayOf(right ? 350 : 150, 37); // 3/4 along the screen, 1/4 up
    ASSERT_TRUE(ray);
    const glm::dvec3 from = desk.InRoom(ray->first), to = desk.InRoom(ray->second);
    EXPECT_NEAR(from.x, right ? 30.0 : -30.0, 1e-6);
    EXPECT_NEAR(from.y, 0.0, 1e-6);
    EXPECT_NEAR(from.z, 600.0, 1e-6);
    EXPECT_LT(to.z, -10.0) << "behind all that is shown";
    EXPECT_NEAR(OnScreen(from, to).x, 100.0, pixel);
    EXPECT_NEAR(OnScreen(from, to).y, -75.0, pixel);
  }
}

TEST(StereoView, APickLiesOnTheLineOfThatEye)
{
  StereoDesk desk("left", nullptr, [](StereoChoices& c) { c.headMm = { 150.0, 40.0, 500.0 }; });
  const auto ray = desk.eyes->RayOf(100, 75); // the middle, where the ball is
  ASSERT_TRUE(ray);
  const auto hit = desk.scene->Pick(ray->first, ray->second);
  ASSERT_TRUE(hit);
  const glm::dvec3 p((*hit)[0], (*hit)[1], (*hit)[2]);
  EXPECT_NEAR(glm::length(p), 20.0, 0.15); // samples 2 to 3 mm apart round off a ball
  const glm::dvec3 room = desk.InRoom(*hit), eye(120.0, 40.0, 500.0);
  const glm::dvec2 seen = OnScreen(eye, room);
  EXPECT_LT(glm::length(seen - glm::dvec2(1.0, 1.0)), 0.1); // the pixel's middle, 2 mm wide
}

TEST(StereoView, LifeSizeIsLifeSize)
{
  StereoDesk desk("mono", nullptr, [](StereoChoices& c) { c.lifeSize = true; });
  EXPECT_NEAR(desk.Scale(), 1.0, 1e-9);
}

/// Whatever the shape of the window that its eyes share.
TEST(StereoView, EveryLayoutShowsTheContentInOneSize)
{
  const double size = StereoDesk("mono").Scale();
  for (const char* layout : { "side-by-side", "top-bottom", "interlaced", "anaglyph" })
    EXPECT_NEAR(StereoDesk(layout).Scale(), size, 1e-9 * size) << layout;
}

TEST(StereoView, TheSketchShowsTheContentIfThereIsAny)
{
  StereoDesk desk("side-by-side");
  const std::string nothing = desk.eyes->SketchPng(std::nullopt);
  const std::string ball = desk.eyes->SketchPng(desk.scene->Content());
  EXPECT_EQ(nothing.substr(1, 3), "PNG");
  EXPECT_NE(ball, nothing);
  ContentBox volume{ { -48, 48, -48, 48, -48, 48 }, false };
  const std::string larger = desk.eyes->SketchPng(volume);
  EXPECT_NE(larger, ball);
  volume.ofVolume = true;
  EXPECT_NE(desk.eyes->SketchPng(volume), larger); // and says so
}

TEST(StereoView, AHeadMovesThePictureWhenItMovedFarEnough)
{
  StereoDesk desk("left", std::make_unique<HandHeld>());
  double now = SteadySeconds();
  const auto look = [&] // a jump of the head is not shown as one
  {
    for (int n = 0; n < 30; ++n)
      desk.eyes->Draw(now += 0.05);
  };
  look();
  EXPECT_FALSE(desk.eyes->HeadMoved(now));
  desk.hand->pose.position.x = 0.05; // mm
  EXPECT_FALSE(desk.eyes->HeadMoved(now += 0.05));
  desk.hand->pose.position = { 200.0, 0.0, 400.0 };
  EXPECT_TRUE(desk.eyes->HeadMoved(now += 0.05));
  look();
  EXPECT_FALSE(desk.eyes->HeadMoved(now));
  const auto ray = desk.eyes->RayOf(100, 75);
  ASSERT_TRUE(ray);
  EXPECT_NEAR(desk.InRoom(ray->first).x, 170.0, 1.0);
  EXPECT_NEAR(desk.InRoom(ray->first).z, 400.0, 1.0);
}

/// Poses that a tracker may have and eyes before a screen cannot.
TEST(StereoView, AHeadThatSeesNothingLeavesTheViewAndIsSaidOnce)
{
  StereoDesk desk("anaglyph", std::make_unique<HandHeld>());
  const auto eye = [&]
  {
    const auto ray = desk.eyes->RayOf(100, 75);
    return ray ? desk.InRoom(ray->first) : glm::dvec3(0.0);
  };
  double now = SteadySeconds();
  const auto look = [&]
  {
    for (int n = 0; n < 20; ++n)
      EXPECT_TRUE(desk.eyes->Draw(now += 0.05));
  };
  look();
  int said = 0;
  for (const double z : { 0.0, 1e-9, -400.0, 600.0 - 9'000.0 })
  {
    desk.hand->pose.position = { 0.0, 0.0, z };
    look();
    EXPECT_GT(eye().z, 0.0);
    for (const std::string& warning : desk.eyes->TakeWarnings())
      said += warning.find("the head is behind the screen") != warning.npos;
  }
  desk.hand->pose.orientation = { std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0 }; // one eye behind it
  desk.hand->pose.position = { 0.0, 0.0, 20.0 };
  look();
  desk.hand->pose = HeadPose{};
  look();
  EXPECT_NEAR(eye().z, 600.0, 1.0);
  EXPECT_EQ(said, 1);
  EXPECT_EQ(TakeVtkError(), "");
}

TEST(StereoView, TheFirstViewComesBackInLifeSize)
{
  StereoDesk desk("mono", nullptr, [](StereoChoices& c) { c.lifeSize = true; });
  EXPECT_NE(desk.view->Text().find("at 100 % of life size"), std::string::npos);
  desk.renderer->GetActiveCamera()->Dolly(2.0);
  desk.interactor->Render();
  desk.interactor->Render(); // the text is of the frame before
  EXPECT_NE(desk.view->Text().find("at 200 % of life size"), std::string::npos);
  desk.interactor->SetKeySym("r");
  desk.interactor->InvokeEvent(vtkCommand::KeyPressEvent);
  EXPECT_NEAR(desk.Scale(), 1.0, 1e-9);
}

TEST(StereoView, TheMouseIsTheHeadUnlessItDrags)
{
  StereoDesk desk("mono", std::make_unique<MouseHeadPose>());
  /// The head comes there, in the tracker's own time; five seconds are many times that.
  const auto comes = [&](const glm::dvec3& place)
  {
    glm::dvec3 at(0.0);
    const double start = SteadySeconds();
    do
    {
      desk.Fire();
      if (const auto ray = desk.eyes->RayOf(100, 75))
        at = desk.InRoom(ray->first);
    } while (glm::length(at - place) > 0.2 && SteadySeconds() - start < 5.0);
    EXPECT_LT(glm::length(at - place), 0.2) << at.x << " " << at.y << " " << at.z;
  };
  desk.Mouse(100, 75, vtkCommand::MouseMoveEvent);
  comes({ 0.0, 0.0, 600.0 });
  desk.Mouse(150, 75, vtkCommand::MouseMoveEvent); // half of 250 mm
  comes({ 125.0, 0.0, 600.0 });
  desk.Mouse(150, 75, vtkCommand::LeftButtonPressEvent);
  desk.Mouse(20, 20, vtkCommand::MouseMoveEvent);
  comes({ 125.0, 0.0, 600.0 });
}

TEST(StereoView, ADualWindowHasTwo)
{
  StereoDesk desk("dual-window");
  const int frames = desk.frames;
  desk.interactor->Render();
  EXPECT_EQ(desk.frames, frames + 1) << "the other eye is drawn in the other window";
  const auto ray = desk.eyes->RayOf(100, 75);
  ASSERT_TRUE(ray);
  EXPECT_NEAR(desk.InRoom(ray->first).x, -30.0, 1e-6);
}

} // namespace
