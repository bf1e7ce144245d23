// The pass on the GPU against the same in C++: every byte.
#include "LensTable.h"
#include "StereoTestScene.h"
#include "vtkHaspStereoCamera.h"
#include "vtkHaspStereoPicture.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

namespace
{

using hasp::MirrorFlip;
using hasp::StereoEye;
using hasp::StereoLayout;
using hasp::StereoOutput;
using hasp::StereoResolution;
using stereotest::BallsScene;
using stereotest::Bytes;

constexpr StereoLayout Composed[] = { StereoLayout::Mono, StereoLayout::SideBySide,
  StereoLayout::TopBottom, StereoLayout::Left, StereoLayout::Right, StereoLayout::Anaglyph,
  StereoLayout::Interlaced, StereoLayout::Checkerboard };

Bytes BytesOf(vtkImageData* image)
{
  const auto* rgb = static_cast<const std::uint8_t*>(image->GetScalarPointer());
  return { rgb, rgb + 3 * image->GetNumberOfPoints() };
}

/// The same scene through vtkHaspStereoPicture, which draws one view at a time and composes on the
/// CPU.
Bytes ByPicture(BallsScene& scene, glm::ivec2 viewSize, const StereoOutput& output, int samples = 0)
{
  const auto window = stereotest::MakeWindow(viewSize);
  window->SetMultiSamples(samples);
  window->AddRenderer(scene.Renderer);
  vtkNew<vtkHaspStereoPicture> picture;
  picture->SetRenderer(scene.Renderer);
  picture->SetEyeAngle(6.0);
  picture->SetOutput(output);
  const auto image = picture->Render();
  window->RemoveRenderer(scene.Renderer);
  return image ? BytesOf(image) : Bytes();
}

Bytes ByWindow(
  BallsScene& scene, glm::ivec2 size, const hasp::StereoWindow& settings, int samples = 0)
{
  const auto window = stereotest::MakeWindow(size);
  window->SetMultiSamples(samples);
  window->AddRenderer(scene.Renderer);
  EXPECT_TRUE(scene.Windows->AddWindow(window, settings));
  EXPECT_TRUE(scene.Windows->Render());
  const Bytes picture = stereotest::Picture(window);
  scene.Windows->RemoveWindow(window);
  window->RemoveRenderer(scene.Renderer);
  return picture;
}

class StereoWindowPixels : public testing::TestWithParam<StereoLayout>
{
};

TEST_P(StereoWindowPixels, AreThoseOfTheCpu)
{
  BallsScene scene;
  for (const glm::ivec2 view : { glm::ivec2(120, 80), glm::ivec2(61, 45), glm::ivec2(1, 1) })
    for (const StereoResolution resolution : { StereoResolution::Full, StereoResolution::Half })
      for (const MirrorFlip flip :
        { MirrorFlip::None, MirrorFlip::Horizontal, MirrorFlip::Vertical, MirrorFlip::Both })
        for (const bool swap : { false, true })
        {
          const StereoOutput output{ GetParam(), resolution, flip, swap };
          SCOPED_TRACE(std::to_string(view.x) + " " + std::to_string(int(resolution)) + " " +
                       std::to_string(int(flip)) + " " + std::to_string(swap));
          const Bytes expected = ByPicture(scene, view, output);
          ASSERT_FALSE(expected.empty());
          EXPECT_EQ(ByWindow(scene, hasp::ComposedSize(output, view), { output }), expected);
        }
  EXPECT_EQ(scene.Errors, 0);
}

TEST_P(StereoWindowPixels, AreThoseOfTheCpuWithSeveralSamples)
{
  BallsScene scene;
  const StereoOutput output{ GetParam(), StereoResolution::Half, MirrorFlip::Horizontal };
  const Bytes expected = ByPicture(scene, { 120, 80 }, output, 4);
  EXPECT_EQ(ByWindow(scene, { 120, 80 }, { output }, 4), expected);
  EXPECT_NE(expected, ByPicture(scene, { 120, 80 }, output, 0)) << "edges are smoothed";
}

TEST_P(StereoWindowPixels, AreThoseOfTheCpuThroughALens)
{
  BallsScene scene;
  const glm::ivec2 view{ 96, 80 };
  const double aspect = 1.2;
  for (const glm::dvec3& colors : { glm::dvec3(1.0), glm::dvec3(0.99, 1.0, 1.02) })
  {
    hasp::StereoWindow settings{ { GetParam(), StereoResolution::Full, MirrorFlip::Vertical } };
    settings.lens = hasp::LensModel{ { 0.2, 0.1, 0.0 },
      { glm::dvec2(0.1, 0.0), glm::dvec2(-0.1, 0.0) }, colors };
    const Bytes left = ByPicture(scene, view, { GetParam() == StereoLayout::Mono
                                                   ? StereoLayout::Mono
                                                   : StereoLayout::Left });
    const Bytes right = ByPicture(scene, view, { StereoLayout::Right });
    const std::array tables{ hasp::MakeLensTable(*settings.lens, StereoEye::Left, view, aspect),
      hasp::MakeLensTable(*settings.lens, StereoEye::Right, view, aspect) };
    const glm::ivec2 size = hasp::ComposedSize(settings.output, view);
    EXPECT_EQ(ByWindow(scene, size, settings),
      hasp::ComposeStereo(settings.output, size, left, right, &tables));
  }
}

INSTANTIATE_TEST_SUITE_P(Layouts, StereoWindowPixels, testing::ValuesIn(Composed),
  [](const auto& info)
  {
    std::string name = hasp::StereoLayoutName(info.param);
    std::erase(name, '-');
    return name;
  });

/// Half the rows of a picture drawn in full are the picture drawn in half: what is not drawn is
/// not shown either.
TEST(StereoWindowHalf, InterlacedRowsAreThoseOfTheFullPicture)
{
  BallsScene scene;
  for (const glm::ivec2 size : { glm::ivec2(120, 80), glm::ivec2(121, 81) })
  {
    const Bytes full = ByWindow(scene, size, { { StereoLayout::Interlaced } });
    const Bytes half =
      ByWindow(scene, size, { { StereoLayout::Interlaced, StereoResolution::Half } });
    int differ = 0;
    for (std::size_t n = 0; n < full.size(); ++n)
      differ += std::abs(full[n] - half[n]) > 2;
    // Matrices are rounded to 32 bits, so that a sample on an edge may fall to its other side.
    EXPECT_LE(differ, 3 * 8);
  }
}

} // namespace
