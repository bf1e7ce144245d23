// What each option of a stereo set-up does to the picture.
#include "RenderFixture.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <algorithm>
#include <array>

namespace
{

/// 3 bytes a pixel, x fastest, rows from the bottom.
struct Picture
{
  int width = 0, height = 0;
  std::vector<std::array<unsigned char, 3>> pixels;

  const auto& At(int x, int y) const { return this->pixels[y * this->width + x]; }
  Picture Part(
    int firstX, int firstY, int w, int h, bool reverseX = false, bool reverseY = false) const
  {
    Picture part{ w, h, {} };
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x)
        part.pixels.push_back(
          this->At(firstX + (reverseX ? w - 1 - x : x), firstY + (reverseY ? h - 1 - y : y)));
    return part;
  }
  bool operator==(const Picture&) const = default;
};

/// A tenth of a percent and more of the pixels.
bool Differ(const Picture& a, const Picture& b)
{
  if (a.pixels.size() != b.pixels.size())
    return true;
  std::size_t other = 0;
  for (std::size_t n = 0; n < a.pixels.size(); ++n)
    other += a.pixels[n] != b.pixels[n];
  return 1000 * other >= a.pixels.size();
}

class HaspRenderStereo : public RenderFixture
{
protected:
  HaspRenderStereo() { this->Phantom(); }

  Picture Read(const std::string& name) const
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(this->Path(name).c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    EXPECT_EQ(image->GetNumberOfScalarComponents(), 3);
    Picture picture{ image->GetDimensions()[0], image->GetDimensions()[1], {} };
    picture.pixels.resize(static_cast<std::size_t>(image->GetNumberOfPoints()));
    const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
    std::copy_n(bytes, 3 * picture.pixels.size(), picture.pixels.front().data());
    return picture;
  }
  /// 120 x 90 pixels an eye.
  Picture Draw(const Words& more) const
  {
    const HaspRun run = this->Render(more);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return run.exitCode == 0 ? this->Read("out.png") : Picture{};
  }
  Picture Pair(Words more) const
  {
    more.insert(more.end(), { "--stereo", "side-by-side" });
    return this->Draw(more);
  }
  static Words Before(const Words& more)
  {
    Words words{ "--screen", "400x300" };
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

TEST_F(HaspRenderStereo, AScreenMakesTheShapeAndASketchIsDrawn)
{
  const HaspRun run = RunHasp({ "render", this->Path("head.mha"), "--isovalue", "226", "--stereo",
    "side-by-side", "--screen", "400x100", "--eye-separation", "60", "--head-position", "50,0,500",
    "--life-size", "--mirror", "horizontal", "--eye-resolution", "half", "--sketch",
    this->Path("sketch.png"), "--output", this->Path("out.png") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Picture out = this->Read("out.png"), sketch = this->Read("sketch.png");
  EXPECT_EQ(std::make_pair(out.width, out.height), std::make_pair(3200, 800)); // two of 4 to 1
  EXPECT_EQ(std::make_pair(sketch.width, sketch.height), std::make_pair(1200, 720));
}

TEST_F(HaspRenderStereo, EachEyeIsMirroredInItsPlace)
{
  const Picture plain = this->Pair(Before({}));
  ASSERT_TRUE(Differ(plain.Part(0, 0, 120, 90), plain.Part(120, 0, 120, 90)));
  ASSERT_TRUE(Differ(plain.Part(0, 0, 120, 90), plain.Part(0, 0, 120, 90, true, false)));
  ASSERT_TRUE(Differ(plain.Part(0, 0, 120, 90), plain.Part(0, 0, 120, 90, false, true)));
  for (const std::string mirror : { "horizontal", "vertical", "both" })
  {
    const Picture turned = this->Pair(Before({ "--mirror", mirror }));
    for (const int first : { 0, 120 })
      EXPECT_TRUE(turned.Part(first, 0, 120, 90) ==
                  plain.Part(first, 0, 120, 90, mirror != "vertical", mirror != "horizontal"))
        << mirror << " " << first;
  }
}

TEST_F(HaspRenderStereo, SwappedEyesChangePlaces)
{
  const Picture plain = this->Pair(Before({})), swapped = this->Pair(Before({ "--swap-eyes" }));
  EXPECT_TRUE(swapped.Part(0, 0, 120, 90) == plain.Part(120, 0, 120, 90));
  EXPECT_TRUE(swapped.Part(120, 0, 120, 90) == plain.Part(0, 0, 120, 90));
}

TEST_F(HaspRenderStereo, EyesInOnePlaceSeeOnePicture)
{
  const Picture one = this->Pair(Before({ "--eye-separation", "0" }));
  EXPECT_TRUE(one.Part(0, 0, 120, 90) == one.Part(120, 0, 120, 90));
  EXPECT_TRUE(one.Part(0, 0, 120, 90) == this->Draw(Before({}))) << "mono's, between the eyes";
  const Picture wide = this->Pair(Before({ "--eye-separation", "120" }));
  EXPECT_TRUE(Differ(wide, this->Pair(Before({})))); // 63 mm
}

TEST_F(HaspRenderStereo, WhereTheHeadIsAndLifeSizeShow)
{
  const Picture plain = this->Draw(Before({}));
  EXPECT_TRUE(this->Draw(Before({ "--head-position", "0,0,600" })) == plain); // the default
  const Picture beside = this->Draw(Before({ "--head-position", "150,0,600" }));
  EXPECT_TRUE(Differ(beside, plain));
  // An eye of a pair is where a head half the separation beside it is.
  EXPECT_TRUE(this->Draw(Before({ "--head-position", "180,0,600", "--eye-separation", "60",
                "--stereo", "left" })) == beside);
  EXPECT_TRUE(Differ(this->Draw(Before({ "--life-size" })), plain));
}

TEST_F(HaspRenderStereo, ADisplaysFieldOfViewShows)
{
  const Words display{ "--hmd", "1.2,0.9,1.1,1.1" };
  const Picture wide = this->Pair(display);
  EXPECT_TRUE(Differ(wide, this->Pair({})));
  EXPECT_TRUE(Differ(wide, this->Pair({ "--hmd", "0.6,0.5,0.5,0.5" })));
}

TEST_F(HaspRenderStereo, ALensBendsThePicture)
{
  this->WriteText("lens.json",
    R"({ "format": "hasp-lens-1", "note": "a test's", "coefficients": [0.2, 0.05, 0.0],
         "leftCenter": [0.0, 0.0], "rightCenter": [0.0, 0.0], "colorScale": [1.0, 1.0, 1.0] })");
  const Words lens = Before({ "--lens", this->Path("lens.json") });
  if (!HASP_WITH_JSON)
    return ExpectFailure(this->Render(lens), 2, "--lens: ");
  const Picture plain = this->Draw(Before({})), bent = this->Draw(lens);
  EXPECT_TRUE(Differ(bent, plain));
  using Pixel = std::array<unsigned char, 3>;
  EXPECT_EQ(bent.At(0, 0), (Pixel{ 0, 0, 0 })) << "beyond what the lens shows";
  EXPECT_NE(plain.At(0, 0), (Pixel{ 0, 0, 0 }));
}

TEST_F(HaspRenderStereo, EachEyeSeesTheVolumeFromItsOwnPlace)
{
  for (const std::string mapper : { "mip", "composite" })
  {
    const auto draw = [&](const std::string& layout)
    {
      const HaspRun run = RunHasp({ "render", this->Path("head.mha"), "--mapper", mapper,
        "--resolution", "120,90", "--output", this->Path("out.png"), "--stereo", layout });
      EXPECT_EQ(run.exitCode, 0) << run.err;
      return this->Read("out.png");
    };
    const Picture pair = draw("side-by-side"), left = draw("left"), right = draw("right");
    ASSERT_EQ(pair.width, 240);
    EXPECT_TRUE(pair.Part(0, 0, 120, 90) == left) << mapper;
    EXPECT_TRUE(pair.Part(120, 0, 120, 90) == right) << mapper;
    EXPECT_TRUE(Differ(left, right)) << mapper;
  }
}

} // namespace
