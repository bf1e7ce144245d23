// Every layout of one scene: mono, left, right, anaglyph; side by side and top-bottom in half
// resolution; interlaced and checkerboard in full; two windows; quad buffers, left and right.
#include "StereoSheet.h"

int TestStereoLayouts(int argc, char* argv[])
{
  using hasp::StereoLayout;
  const glm::ivec2 size{ 180, 120 };
  stereotest::BallsScene scene;
  stereotest::Sheet sheet(4, 3, size);
  const auto window = stereotest::MakeWindow(size), other = stereotest::MakeWindow(size);
  window->StereoCapableWindowOn();
  for (const StereoLayout layout : { StereoLayout::Mono, StereoLayout::Left, StereoLayout::Right,
         StereoLayout::Anaglyph, StereoLayout::SideBySide, StereoLayout::TopBottom })
  {
    scene.Windows->AddWindow(window, { { layout, hasp::StereoResolution::Half } });
    scene.Windows->Render();
    sheet.Add(stereotest::Picture(window), size);
  }
  for (const StereoLayout layout : { StereoLayout::Interlaced, StereoLayout::Checkerboard })
  {
    scene.Windows->AddWindow(window, { { layout } });
    scene.Windows->Render();
    sheet.Add(stereotest::Picture(window), size);
  }
  scene.Windows->AddDualWindow(window, other, {});
  scene.Windows->Render();
  sheet.Add(stereotest::Picture(window), size);
  sheet.Add(stereotest::Picture(other), size);
  scene.Windows->AddWindow(window, "quad-buffer");
  scene.Windows->Render();
  sheet.Add(stereotest::Picture(window, false), size);
  sheet.Add(stereotest::Picture(window, true), size);
  return hasp::CheckPicture(sheet.Picture(), argc, argv);
}
