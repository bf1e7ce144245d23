// Where a window's pixels lie in what the eyes see.
#include "StereoTestScene.h"

#include "vtkTransform.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

using hasp::MirrorFlip;
using hasp::StereoLayout;
using hasp::StereoResolution;
using stereotest::BallsScene;
using stereotest::Bytes;
using stereotest::MakeWindow;
using stereotest::Picture;

const glm::ivec2 Size{ 120, 80 };

TEST(StereoWindows, ARaySeesWhatThePixelShows)
{
  BallsScene scene;
  scene.Renderer->RemoveAllViewProps();
  const glm::dvec3 center(25, -40, 20);
  const auto ball = stereotest::MakeBall(center, 14.0);
  ball->GetProperty()->LightingOff();
  scene.Renderer->AddActor(ball);
  const auto window = MakeWindow({ 300, 200 });
  window->AddRenderer(scene.Renderer);
  hasp::StereoWindow settings;
  settings.screen.emplace();
  for (const StereoLayout layout :
    { StereoLayout::SideBySide, StereoLayout::Interlaced, StereoLayout::Checkerboard })
    for (const MirrorFlip flip : { MirrorFlip::None, MirrorFlip::Both })
      for (const bool lens : { false, true })
      {
        settings.output = { layout, StereoResolution::Half, flip };
        settings.lens.reset();
        if (lens)
          settings.lens = hasp::LensModel{ { 0.1, 0.0, 0.0 } };
        scene.Windows->AddWindow(window, settings);
        scene.Windows->SetHead({ { 60, 30, 600 }, { 1, 0.2, 0 } });
        ASSERT_TRUE(scene.Windows->Render());
        const Bytes picture = Picture(window);
        int wrong = 0, bright = 0;
        for (int y = 0; y < 200; y += 3)
          for (int x = 0; x < 300; x += 3)
          {
            double eye[3], through[3];
            const bool any = scene.Windows->GetRay(window, x, y, eye, through);
            const glm::dvec3 e(eye[0], eye[1], eye[2]), t(through[0], through[1], through[2]);
            const double off = glm::length(glm::cross(glm::normalize(t - e), center - e));
            const bool shown = picture[3 * (y * 300 + x) + 1] > 200;
            bright += shown;
            wrong += any ? shown != (off < 14.0) : shown;
          }
        EXPECT_GT(bright, 40);
        EXPECT_LE(wrong, 12) << "pixels on the outline: " << bright; // fields are half a pixel off
      }
  double eye[3], through[3];
  EXPECT_FALSE(scene.Windows->GetRay(window, 300, 10, eye, through));
  EXPECT_FALSE(scene.Windows->GetRay(MakeWindow(Size), 10, 10, eye, through));
}

TEST(StereoWindows, KnowsWhereAPixelLiesInItsEyesView)
{
  BallsScene scene;
  auto window = MakeWindow({ 300, 200 });
  window->AddRenderer(scene.Renderer);
  hasp::StereoWindow settings;
  settings.output = { hasp::StereoLayout::SideBySide, hasp::StereoResolution::Full,
    hasp::MirrorFlip::Horizontal };
  ASSERT_TRUE(scene.Windows->AddWindow(window, settings));
  hasp::StereoEye eye = hasp::StereoEye::Left;
  double device[2];
  ASSERT_TRUE(scene.Windows->GetPositionInView(window, 180, 50, eye, device));
  EXPECT_EQ(eye, hasp::StereoEye::Right);
  EXPECT_NEAR(device[0], 1.0 - 2.0 * 30.5 / 150.0, 1e-12); // turned over within its half
  EXPECT_NEAR(device[1], 2.0 * 50.5 / 200.0 - 1.0, 1e-12);
  ASSERT_TRUE(scene.Windows->GetPositionInViewOf(hasp::StereoEye::Right, window, 140, -5, device));
  EXPECT_NEAR(device[0], 1.0 + 2.0 * 9.5 / 150.0, 1e-12); // beyond the border, in the other's half
  EXPECT_NEAR(device[1], -1.0 - 2.0 * 4.5 / 200.0, 1e-12);
  EXPECT_FALSE(scene.Windows->GetPositionInView(window, 300, 50, eye, device));
  EXPECT_FALSE(scene.Windows->GetPositionInView(nullptr, 10, 50, eye, device));
}

TEST(StereoWindows, AUsersTransformTurnsTheViewAndNotTheRows)
{
  BallsScene scene;
  scene.Renderer->RemoveAllViewProps();
  const glm::dvec3 center(25, -40, 20);
  const auto ball = stereotest::MakeBall(center, 24.0);
  ball->GetProperty()->LightingOff();
  scene.Renderer->AddActor(ball);
  const auto window = MakeWindow({ 300, 200 });
  window->AddRenderer(scene.Renderer);
  vtkNew<vtkTransform> user; // a mirror, and beside
  user->Translate(0.1, 0.2, 0.0);
  user->Scale(1, -1, 1);
  scene.Renderer->GetActiveCamera()->SetUserTransform(user);
  hasp::StereoWindow settings;
  settings.screen.emplace(); // of another aspect than the window
  Bytes full;
  for (const StereoResolution resolution : { StereoResolution::Full, StereoResolution::Half })
  {
    settings.output = { StereoLayout::Interlaced, resolution };
    scene.Windows->AddWindow(window, settings);
    ASSERT_TRUE(scene.Windows->Render());
    const Bytes picture = Picture(window);
    int wrong = 0, bright = 0, differ = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 300; ++x)
      {
        double eye[3], through[3];
        ASSERT_TRUE(scene.Windows->GetRay(window, x, y, eye, through));
        const glm::dvec3 e(eye[0], eye[1], eye[2]), t(through[0], through[1], through[2]);
        const double off = glm::length(glm::cross(glm::normalize(t - e), center - e));
        const std::size_t at = 3 * (y * 300 + x) + 1;
        bright += picture[at] > 200;
        if (std::abs(off - 24.0) > 0.5) // half of a pixel: its outline
          wrong += (picture[at] > 200) != (off < 24.0);
        differ += !full.empty() && std::abs(full[at] - picture[at]) > 2;
      }
    EXPECT_GT(bright, 1000);
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(differ, 8) << "a sample on an edge may fall to its other side";
    full = picture;
  }
}
} // namespace
