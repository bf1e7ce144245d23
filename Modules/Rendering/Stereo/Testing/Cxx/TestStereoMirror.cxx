// Side by side: as it is, and turned for a mirror across, up and down, and both.
#include "StereoSheet.h"

int TestStereoMirror(int argc, char* argv[])
{
  const glm::ivec2 size{ 240, 120 };
  stereotest::BallsScene scene;
  stereotest::Sheet sheet(2, 2, size);
  const auto window = stereotest::MakeWindow(size);
  for (const hasp::MirrorFlip flip : { hasp::MirrorFlip::None, hasp::MirrorFlip::Horizontal,
         hasp::MirrorFlip::Vertical, hasp::MirrorFlip::Both })
  {
    scene.Windows->AddWindow(
      window, { { hasp::StereoLayout::SideBySide, hasp::StereoResolution::Full, flip } });
    scene.Windows->Render();
    sheet.Add(stereotest::Picture(window), size);
  }
  return hasp::CheckPicture(sheet.Picture(), argc, argv);
}
