// A head-mounted display: what its panel shows, pre-distorted, with colours apart.
#include "StereoSheet.h"

int TestStereoLens(int argc, char* argv[])
{
  const glm::ivec2 size{ 432, 240 }; // a fifth of 1080 x 1200 an eye
  stereotest::BallsScene scene;
  scene.Renderer->AddActor(stereotest::MakeBall({ 0, 450, 0 }, 300, { 0.6, 0.6, 0.6 }));
  const auto window = stereotest::MakeWindow(size);
  hasp::StereoWindow settings;
  settings.hmd = hasp::StereoHmd{ { hasp::FieldOfView{ 1.1, 0.9, 1.11, 1.11 },
    hasp::FieldOfView{ 0.9, 1.1, 1.11, 1.11 } } };
  settings.lens = hasp::LensModel{ { 0.22, 0.24, 0.0 },
    { glm::dvec2(0.09, 0.0), glm::dvec2(-0.09, 0.0) }, { 0.985, 1.0, 1.02 } };
  scene.Windows->AddWindow(window, settings);
  scene.Windows->SetHead({ { 20, 10, 300 }, { 1, 0.1, 0 }, 63, { -0.1, 1, 0 } });
  scene.Windows->Render();
  stereotest::Sheet sheet(1, 1, size);
  sheet.Add(stereotest::Picture(window), size);
  return hasp::CheckPicture(sheet.Picture(), argc, argv);
}
