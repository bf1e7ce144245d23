#include "ComparePictures.h"

#include "SoftwareScene.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

bool Same(const hasp::RGBPicture& got, const hasp::RGBPicture& expected)
{
  return hasp::FindBrokenLimits(hasp::ComparePictures(got, expected)).empty();
}

hasp::RGBPicture DrawShifted(double x, double y)
{
  SoftwareScene scene;
  scene.shiftX = x;
  scene.shiftY = y;
  return scene.Draw();
}

hasp::RGBPicture DrawShaded(double factor)
{
  SoftwareScene scene;
  scene.shade = factor;
  return scene.Draw();
}

TEST(ComparePictures, RefusesSizesThatDifferOrAreZero)
{
  const hasp::RGBPicture a(4, 3), b(3, 4), none;
  EXPECT_THROW(hasp::ComparePictures(a, b), std::invalid_argument);
  EXPECT_THROW(hasp::DrawDifference(a, b), std::invalid_argument);
  EXPECT_THROW(hasp::ComparePictures(none, none), std::invalid_argument);
}

TEST(ComparePictures, FiguresMatchTheirClosedForm)
{
  hasp::RGBPicture a(64, 32), b(64, 32);
  for (std::uint8_t& value : a.pixels)
    value = 100;
  b = a;
  b.At(40, 20)[2] = 180; // one channel of one of 2048 pixels
  const auto one = hasp::ComparePictures(b, a);
  EXPECT_DOUBLE_EQ(one.mean, 80.0 / (3 * 2048));
  EXPECT_EQ(one.maximum, 80);
  EXPECT_EQ(one.percentile, 0) << "2047 of 2048 pixels are more than 99.9 %";
  EXPECT_DOUBLE_EQ(one.block, 80.0 / 256);

  b.At(41, 20)[0] = 130;
  b.At(42, 20)[0] = 130; // three of 2048 pixels are more than 0.1 %
  EXPECT_EQ(hasp::ComparePictures(b, a).percentile, 30);

  // Flat windows: SSIM = (2 m n + c1) / (m^2 + n^2 + c1), c1 = 2.55^2.
  for (std::uint8_t& value : b.pixels)
    value = 110;
  const auto flat = hasp::ComparePictures(b, a);
  EXPECT_DOUBLE_EQ(flat.mean, 10);
  EXPECT_DOUBLE_EQ(flat.block, 10);
  EXPECT_NEAR(flat.ssim, (22000 + 6.5025) / (10000 + 12100 + 6.5025), 1e-12);
}

TEST(ComparePictures, PassesThePictureItself)
{
  const hasp::RGBPicture scene = SoftwareScene().Draw();
  const auto difference = hasp::ComparePictures(scene, scene);
  EXPECT_EQ(difference.maximum, 0);
  EXPECT_EQ(difference.ssim, 1);
  EXPECT_TRUE(Same(scene, scene));
}

TEST(ComparePictures, PassesRendererNoise)
{
  const hasp::RGBPicture scene = SoftwareScene().Draw();
  for (std::uint32_t seed = 1; seed <= 20; ++seed)
  {
    const hasp::RGBPicture noisy = AddRendererNoise(scene, seed);
    const auto difference = hasp::ComparePictures(noisy, scene);
    EXPECT_NEAR(difference.mean, 0.06, 0.01);
    EXPECT_EQ(difference.maximum, 6);
    EXPECT_TRUE(hasp::FindBrokenLimits(difference).empty()) << hasp::Describe(difference);
  }
}

TEST(ComparePictures, CatchesAShiftOfOnePixelAndNamesIt)
{
  const hasp::RGBPicture scene = SoftwareScene().Draw();
  for (const auto& [x, y] : { std::pair{ 1, 0 }, { -1, 0 }, { 0, 1 }, { 2, -3 } })
  {
    const auto difference = hasp::ComparePictures(DrawShifted(x, y), scene);
    EXPECT_FALSE(hasp::FindBrokenLimits(difference).empty()) << x << " " << y;
    EXPECT_EQ(difference.shiftX, x);
    EXPECT_EQ(difference.shiftY, y);
  }
}

TEST(ComparePictures, CatchesSwappedEyes)
{
  const hasp::RGBPicture right = DrawStereo(-3, 3), swapped = DrawStereo(3, -3);
  EXPECT_FALSE(Same(swapped, right));
  EXPECT_FALSE(Same(DrawStereo(0, 0), right)) << "the same eye twice";
  EXPECT_TRUE(Same(right, right));
}

TEST(ComparePictures, CatchesAMissingPart)
{
  SoftwareScene scene;
  scene.withBar = false;
  EXPECT_FALSE(Same(scene.Draw(), SoftwareScene().Draw()));
}

TEST(ComparePictures, CatchesWrongDepthOrder)
{
  SoftwareScene scene;
  scene.wrongDepth = true;
  EXPECT_FALSE(Same(scene.Draw(), SoftwareScene().Draw()));
}

TEST(ComparePictures, CatchesAChangeOfShadeBothWays)
{
  const hasp::RGBPicture scene = SoftwareScene().Draw();
  EXPECT_FALSE(Same(DrawShaded(1.03), scene));
  EXPECT_FALSE(Same(DrawShaded(0.97), scene));
}

TEST(ComparePictures, CatchesSmallThingsInLargePictures)
{
  // A ball that fills 1 % of the picture is 3 % darker: lost in the mean, seen by its block.
  SoftwareScene scene;
  scene.width = 800;
  scene.height = 600;
  const hasp::RGBPicture right = scene.Draw();
  scene.shade = 0.97;
  const auto difference = hasp::ComparePictures(scene.Draw(), right);
  EXPECT_LT(difference.mean, hasp::PictureLimits().mean);
  EXPECT_FALSE(hasp::FindBrokenLimits(difference).empty());
}

TEST(ComparePictures, SaysHowTightItIs)
{
  // The smallest change that is caught, found by bisection, must stay as small as it is.
  const hasp::RGBPicture scene = SoftwareScene().Draw();
  const auto smallest = [&](double large, const auto& draw)
  {
    double passes = 0, caught = large;
    EXPECT_FALSE(Same(draw(caught), scene));
    while (caught - passes > large / 64)
    {
      const double middle = (passes + caught) / 2;
      (Same(draw(middle), scene) ? passes : caught) = middle;
    }
    return caught;
  };
  const double shade = smallest(0.03, [](double d) { return DrawShaded(1 - d); });
  const double shift = smallest(1, [](double d) { return DrawShifted(d, 0); });
  RecordProperty("shade", std::to_string(shade));
  RecordProperty("shiftPixels", std::to_string(shift));
  std::cout << "smallest caught: shade " << 100 * shade << " %, shift " << shift << " pixels\n";
  EXPECT_LT(shade, 0.01);
  EXPECT_LT(shift, 0.25);
}

} // namespace
