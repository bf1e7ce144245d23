// What a scene in mono does not ask for is not there.
#include "StereoTestScene.h"

#include <gtest/gtest.h>

namespace
{

using hasp::StereoLayout;

hasp::ResourceList ListOf(vtkHaspStereoWindows* windows)
{
  hasp::ResourceList list;
  windows->ListResources(list);
  return list;
}

TEST(StereoWindowsMinimal, OneEyePaysForNoSecondAndNoPass)
{
  stereotest::BallsScene scene;
  const auto window = stereotest::MakeWindow({ 60, 40 });
  window->AddRenderer(scene.Renderer);
  for (const StereoLayout layout : { StereoLayout::Mono, StereoLayout::Left, StereoLayout::Right,
         StereoLayout::Interlaced, StereoLayout::Mono }) // once more after two eyes: released
  {
    scene.Windows->AddWindow(window, { { layout } });
    ASSERT_TRUE(scene.Windows->Render());
    const hasp::ResourceList list = ListOf(scene.Windows);
    ASSERT_EQ(list.size(), 3u);
    for (const hasp::ResourceUse& use : list)
    {
      EXPECT_FALSE(use.reason.empty()) << use.resource;
      const bool there = layout == StereoLayout::Interlaced && use.resource != "lens tables";
      EXPECT_EQ(use.bytes > 0, there) << use.resource;
      EXPECT_EQ(use.milliseconds > 0.0, there && use.resource == "second eye");
    }
  }
}

TEST(StereoWindowsMinimal, EachTextureIsCounted)
{
  stereotest::BallsScene scene;
  const auto window = stereotest::MakeWindow({ 60, 40 });
  hasp::StereoWindow settings{ { StereoLayout::Anaglyph } };
  settings.lens = hasp::LensModel{ { 0.1, 0.0, 0.0 }, {}, { 1.0, 1.01, 1.02 } };
  scene.Windows->AddWindow(window, settings);
  ASSERT_TRUE(scene.Windows->Render());
  auto list = ListOf(scene.Windows);
  EXPECT_EQ(list[0].bytes, 4u * 60 * 40);         // the second eye's half
  EXPECT_EQ(list[1].bytes, 2u * 4 * 60 * 40);     // of both pictures
  EXPECT_EQ(list[2].bytes, 2u * 3 * 8 * 60 * 40); // three colours
  settings.output = { StereoLayout::Left, {}, hasp::MirrorFlip::Horizontal };
  settings.lens.reset();
  scene.Windows->AddWindow(window, settings);
  ASSERT_TRUE(scene.Windows->Render());
  list = ListOf(scene.Windows);
  EXPECT_EQ(list[0].bytes, 0u);
  EXPECT_EQ(list[1].bytes, 4u * 60 * 40); // one eye, turned
  EXPECT_EQ(list[2].bytes, 0u);
}

} // namespace
