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

/// The scene in a window that is resized from picture to picture.
class ResizedScene : public BallsScene
{
public:
  explicit ResizedScene(int samples = 0)
  {
    this->Window->SetMultiSamples(samples);
    this->Window->AddRenderer(this->Renderer);
    this->Still->SetRenderer(this->Renderer);
    this->Still->SetEyeAngle(6.0);
  }

  /// Through vtkHaspStereoPicture, which draws one view at a time and composes on the CPU.
  Bytes ByPicture(glm::ivec2 viewSize, const StereoOutput& output)
  {
    this->Window->SetSize(viewSize.x, viewSize.y);
    this->Still->SetOutput(output);
    const auto image = this->Still->Render();
    return image ? BytesOf(image) : Bytes();
  }

  Bytes ByWindow(glm::ivec2 size, const hasp::StereoWindow& settings)
  {
    this->Window->SetSize(size.x, size.y);
    EXPECT_TRUE(this->Windows->AddWindow(this->Window, settings));
    return this->NextFrame();
  }
  Bytes NextFrame()
  {
    EXPECT_TRUE(this->Windows->Render());
    return stereotest::Picture(this->Window);
  }

private:
  vtkSmartPointer<vtkRenderWindow> Window = stereotest::MakeWindow({ 10, 10 });
  vtkNew<vtkHaspStereoPicture> Still;
};

class StereoWindowPixels : public testing::TestWithParam<StereoLayout>
{
};

TEST_P(StereoWindowPixels, AreThoseOfTheCpu)
{
  ResizedScene scene;
  for (const glm::ivec2 view : { glm::ivec2(120, 80), glm::ivec2(61, 45), glm::ivec2(1, 1) })
    for (const StereoResolution resolution : { StereoResolution::Full, StereoResolution::Half })
      for (const MirrorFlip flip :
        { MirrorFlip::None, MirrorFlip::Horizontal, MirrorFlip::Vertical, MirrorFlip::Both })
        for (const bool swap : { false, true })
        {
          const StereoOutput output{ GetParam(), resolution, flip, swap };
          SCOPED_TRACE(std::to_string(view.x) + " " + std::to_string(int(resolution)) + " " +
                       std::to_string(int(flip)) + " " + std::to_string(swap));
          const Bytes expected = scene.ByPicture(view, output);
          ASSERT_FALSE(expected.empty());
          EXPECT_EQ(scene.ByWindow(hasp::ComposedSize(output, view), { output }), expected);
        }
  EXPECT_EQ(scene.Errors, 0);
}

TEST_P(StereoWindowPixels, AreThoseOfTheCpuWithSeveralSamples)
{
  ResizedScene smooth(4), hard;
  const StereoOutput output{ GetParam(), StereoResolution::Half, MirrorFlip::Horizontal };
  const Bytes expected = smooth.ByPicture({ 120, 80 }, output);
  EXPECT_EQ(smooth.ByWindow({ 120, 80 }, { output }), expected);
  EXPECT_NE(expected, hard.ByPicture({ 120, 80 }, output)) << "edges are smoothed";
}

TEST_P(StereoWindowPixels, AreThoseOfTheCpuThroughALens)
{
  ResizedScene scene;
  const glm::ivec2 view{ 96, 80 };
  const double aspect = 1.2;
  for (const glm::dvec3& colors : { glm::dvec3(1.0), glm::dvec3(0.99, 1.0, 1.02) })
  {
    hasp::StereoWindow settings{ { GetParam(), StereoResolution::Full, MirrorFlip::Vertical } };
    settings.lens =
      hasp::LensModel{ { 0.2, 0.1, 0.0 }, { glm::dvec2(0.1, 0.0), glm::dvec2(-0.1, 0.0) }, colors };
    const Bytes left = scene.ByPicture(
      view, { GetParam() == StereoLayout::Mono ? StereoLayout::Mono : StereoLayout::Left });
    const Bytes right = scene.ByPicture(view, { StereoLayout::Right });
    const std::array tables{ hasp::MakeLensTable(*settings.lens, StereoEye::Left, view, aspect),
      hasp::MakeLensTable(*settings.lens, StereoEye::Right, view, aspect) };
    const glm::ivec2 size = hasp::ComposedSize(settings.output, view);
    const Bytes expected = hasp::ComposeStereo(settings.output, size, left, right, &tables);
    EXPECT_EQ(scene.ByWindow(size, settings), expected);
    EXPECT_EQ(scene.NextFrame(), expected) << "with what the first one made";
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
  ResizedScene scene;
  for (const glm::ivec2 size : { glm::ivec2(120, 80), glm::ivec2(121, 81) })
  {
    const Bytes full = scene.ByWindow(size, { { StereoLayout::Interlaced } });
    const Bytes half =
      scene.ByWindow(size, { { StereoLayout::Interlaced, StereoResolution::Half } });
    int differ = 0;
    for (std::size_t n = 0; n < full.size(); ++n)
      differ += std::abs(full[n] - half[n]) > 2;
    // Matrices are rounded to 32 bits, so that a sample on an edge may fall to its other side.
    EXPECT_LE(differ, 3 * 8);
  }
}

} // namespace
