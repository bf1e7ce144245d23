#include "Light/SkyModel.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace
{

constexpr double Pi = std::numbers::pi;

double Luminance(const glm::dvec3& rgb)
{
  return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
}

/// By the midpoints of the map's pixels, which is exact to the square of their size.
double IrradianceUp(const hasp::EnvironmentMap& map)
{
  double sum = 0.0;
  for (int y = 0; y < map.size.y / 2; ++y)
    for (int x = 0; x < map.size.x; ++x)
    {
      const double fromUp = Pi * (y + 0.5) / map.size.y;
      sum += Luminance(map.pixels[y * map.size.x + x]) * std::cos(fromUp) * std::sin(fromUp) *
             (Pi / map.size.y) * (2 * Pi / map.size.x);
    }
  return sum;
}

/// Luminance of the pixel at an angle from up and an azimuth to the right of the centre.
double At(const hasp::EnvironmentMap& map, int row, int column)
{
  return Luminance(map.pixels[row * map.size.x + (column + map.size.x) % map.size.x]);
}

hasp::SkySettings With(double elevation, double azimuth, double turbidity, double share)
{
  hasp::SkySettings settings;
  settings.sunElevation = elevation;
  settings.sunAzimuth = azimuth;
  settings.turbidity = turbidity;
  settings.sunShare = share;
  return settings;
}

TEST(SkyModel, GivesAPlaneThatFacesUpPi)
{
  for (const int height : { 16, 64, 200 })
    for (const double elevation : { 0.0, 0.3, 0.8, Pi / 2 })
      for (const double share : { 0.0, 0.5, 1.0 })
      {
        auto settings = With(elevation, 0.6, 3, share);
        settings.sunHalfAngle = share == 0.5 ? 0.05 : 0.0047; // the real sun's
        const auto map = MakeSky(settings, height);
        EXPECT_EQ(map.size, glm::ivec2(2 * height, height));
        // Midpoints miss (pi / height)^2 / 6 = 0.6% at 16.
        EXPECT_NEAR(IrradianceUp(map) / Pi, 1, height == 16 ? 0.01 : 0.0005)
          << height << " " << elevation << " " << share;
      }
  // The environment's own irradiance agrees within its error: without a sun 0.1% of 1.3 pi.
  const hasp::Environment sky(MakeSky(With(0.8, 0.6, 3, 0)));
  EXPECT_NEAR(Luminance(sky.Irradiance({ 0, 0, 1 })) / Pi, 1, 0.002);
}

TEST(SkyModel, IsFiniteAndNeverNegativeOverItsSettings)
{
  for (const double elevation : { 0.0, 1e-9, 0.5, Pi / 2 })
    for (const double turbidity : { 2.0, 4.0, 10.0 })
      for (const double halfAngle : { 0.002, 0.05, 0.5 })
        for (const double share : { 0.0, 0.7, 1.0 })
        {
          auto settings = With(elevation, 100, turbidity, share);
          settings.sunHalfAngle = halfAngle;
          const auto map = MakeSky(settings, 32);
          for (const auto& pixel : map.pixels)
            for (int c = 0; c < 3; ++c)
              ASSERT_TRUE(pixel[c] >= 0 && pixel[c] < 1e8)
                << elevation << " " << turbidity << " " << halfAngle << " " << share;
          // The sky is nowhere black.
          for (int i = 0; share < 1 && i < map.size.x * map.size.y / 2; ++i)
            ASSERT_GT(Luminance(map.pixels[i]), 0.01) << elevation << " " << turbidity;
        }
}

TEST(SkyModel, ClampsColoursThatAreNone)
{
  // The zenith's side of a clear sky at sunset is beyond what sRGB holds in a channel.
  const auto map = MakeSky(With(0, 0.6, 2, 0), 128);
  int clamped = 0;
  for (const auto& pixel : map.pixels)
  {
    const float least = std::min({ pixel.x, pixel.y, pixel.z });
    ASSERT_GE(least, 0);
    clamped += least == 0;
  }
  EXPECT_GT(clamped, 0);
  EXPECT_NEAR(IrradianceUp(map) / Pi, 1, 0.0005);
}

TEST(SkyModel, HasTheSunsShareAtAnyHeight)
{
  for (const int height : { 64, 130, 512 })
    for (const double halfAngle : { 0.0047, 0.05 })
    {
      auto settings = With(0.8, 0.6, 3, 0.35);
      settings.sunHalfAngle = halfAngle;
      const auto both = MakeSky(settings, height);
      settings.sunShare = 0;
      const auto sky = MakeSky(settings, height);
      // The sky is the same but for its scale, so what is left is the sun, and lies in its disc.
      auto sun = both;
      double outside = 0.0;
      for (std::size_t i = 0; i < sun.pixels.size(); ++i)
      {
        sun.pixels[i] -= 0.65F * sky.pixels[i];
        const double fromUp = Pi * (i / sun.size.x + 0.5) / height;
        const double right = Pi * (i % sun.size.x + 0.5) / height - Pi;
        const double cosine = std::cos(fromUp) * std::sin(0.8) +
                              std::sin(fromUp) * std::cos(0.8) * std::cos(right - 0.6);
        if (i < sun.pixels.size() / 2 &&
            std::acos(std::min(1.0, cosine)) > halfAngle + 2.3 / height)
          outside = std::max(outside, std::abs(Luminance(sun.pixels[i])));
      }
      EXPECT_NEAR(IrradianceUp(sun) / Pi, 0.35, 0.001) << height << " " << halfAngle;
      EXPECT_LT(outside, 1e-4); // floats
    }
}

TEST(SkyModel, IsSymmetricAboutTheSun)
{
  const int height = 64;
  // The sun on the edge between columns 64 + 20 and its left neighbour.
  const auto map = MakeSky(With(0.7, Pi * 20 / height, 4, 0.5), height);
  for (int y = 0; y < height; ++y)
    for (int i = 0; i < height; ++i)
    {
      const double right = At(map, y, 84 + i), left = At(map, y, 83 - i);
      ASSERT_NEAR(right, left, 1e-5 * right) << y << " " << i;
    }
  // Turning the sun by columns moves the columns.
  const auto turned = MakeSky(With(0.7, Pi * 50 / height, 4, 0.5), height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 2 * height; ++x)
      ASSERT_NEAR(At(turned, y, x + 30), At(map, y, x), 1e-5 * At(map, y, x));
}

TEST(SkyModel, IsBrightestAtTheSun)
{
  const int height = 128;
  for (const double elevation : { 0.0, 0.3, 0.8, 1.3, Pi / 2 })
  {
    const auto map = MakeSky(With(elevation, 0.6, 3, 0.5), height);
    std::size_t brightest = 0;
    for (std::size_t i = 0; i < map.pixels.size(); ++i)
      if (Luminance(map.pixels[i]) > Luminance(map.pixels[brightest]))
        brightest = i;
    const double fromUp = Pi * (brightest / map.size.x + 0.5) / height;
    const double right = Pi * (brightest % map.size.x + 0.5) / height - Pi;
    const double cosine = std::cos(fromUp) * std::sin(elevation) +
                          std::sin(fromUp) * std::cos(elevation) * std::cos(right - 0.6);
    EXPECT_GT(cosine, std::cos(0.05 + Pi / height)) << elevation;
  }
}

TEST(SkyModel, FollowsPerez)
{
  // Rows next to the zenith, 30, 60 and 80 degrees; towards the sun, across and opposite.
  const int height = 360, rows[] = { 0, 60, 120, 160 };
  const struct
  {
    double turbidity, elevation;
    double ratios[3][3]; // of F(angle from up, angle from the sun) to F(0, sun from up)
  } skies[] = {
    { 2, 0.3,
      { { 1.9409, 1.1888, 1.0283 }, { 7.6278, 2.0768, 1.9699 }, { 18.8282, 4.2270, 4.3965 } } },
    { 3, 0.8,
      { { 2.2632, 0.9509, 0.7000 }, { 2.8418, 0.9887, 0.7880 }, { 2.2669, 1.1410, 1.0304 } } },
    { 6, 1.2,
      { { 1.3774, 0.7329, 0.5594 }, { 0.7270, 0.4989, 0.4068 }, { 0.5292, 0.4140, 0.3586 } } }
  };
  for (const auto& sky : skies)
  {
    // The sun at the centre of column 360.
    const auto map = MakeSky(With(sky.elevation, Pi * 0.5 / height, sky.turbidity, 0), height);
    const double zenith = At(map, 0, 360 + 180);
    for (int row = 1; row < 4; ++row)
      for (int side = 0; side < 3; ++side)
        EXPECT_NEAR(At(map, rows[row], 360 + 180 * side) / zenith / sky.ratios[row - 1][side], 1,
          0.01) // the row nearest the zenith is a quarter of a degree away
          << sky.turbidity << " " << row << " " << side;
  }
}

TEST(SkyModel, IsBlueAndItsSunIsRedAtTheHorizon)
{
  const int height = 64;
  const auto clear = MakeSky(With(0.8, 0, 2.5, 0), height);
  const auto zenith = clear.pixels[0];
  EXPECT_GT(zenith.z, 1.5 * zenith.x);
  double redness[2];
  for (int low = 0; low < 2; ++low)
  {
    const auto map = MakeSky(With(low ? 0.05 : 1.2, 0, 2.5, 0.9), height);
    const auto sun = *std::max_element(
      map.pixels.begin(), map.pixels.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    redness[low] = sun.x / sun.z;
  }
  EXPECT_LT(redness[0], 1.5);
  EXPECT_GT(redness[1], 5);
}

TEST(SkyModel, HasGroundOfItsIrradiance)
{
  auto settings = With(0.8, 0.6, 3, 0.5);
  settings.ground = { 0.25F, 0.5F, 1 };
  const auto map = MakeSky(settings, 64);
  settings.ground = glm::vec3(1);
  const auto white = MakeSky(settings, 64);
  const auto light = white.pixels.back(); // its irradiance over pi
  EXPECT_NEAR(Luminance(light), 1, 1e-6);
  for (std::size_t i = map.pixels.size() / 2; i < map.pixels.size(); ++i)
  {
    ASSERT_EQ(white.pixels[i], light);
    ASSERT_EQ(map.pixels[i], map.pixels.back());
    ASSERT_LT(glm::length(map.pixels[i] - light * glm::vec3(0.25F, 0.5F, 1)), 1e-6F);
  }
}

TEST(SkyModel, RefusesSettingsOutOfRange)
{
  const auto error = [](const auto& change, int height = 64) -> std::string
  {
    hasp::SkySettings settings;
    change(settings);
    try
    {
      hasp::MakeSky(settings, height);
    }
    catch (const std::invalid_argument& e)
    {
      return e.what();
    }
    return "none";
  };
  const auto none = [](hasp::SkySettings&) {};
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error(none), "none");
  for (const int height : { -2, 0, 14, 17, 8194 })
    EXPECT_NE(error(none, height).find("height of the map is"), std::string::npos) << height;
  for (const double value : { -0.01, 1.58, nan })
    EXPECT_NE(error([&](auto& s) { s.sunElevation = value; }).find("elevation"), std::string::npos);
  for (const double value : { infinite, nan })
    EXPECT_NE(error([&](auto& s) { s.sunAzimuth = value; }).find("azimuth"), std::string::npos);
  for (const double value : { 1.99, 10.01, nan })
    EXPECT_NE(error([&](auto& s) { s.turbidity = value; }).find("turbidity"), std::string::npos);
  for (const double value : { -0.01, 1.01, nan })
  {
    EXPECT_NE(error([&](auto& s) { s.sunShare = value; }).find("share"), std::string::npos);
    EXPECT_NE(error([&](auto& s) { s.ground.y = float(value); }).find("ground"), std::string::npos);
  }
  for (const double value : { 0.0, 0.0019, 0.51, nan })
    EXPECT_NE(
      error([&](auto& s) { s.sunHalfAngle = value; }).find("half angle"), std::string::npos);
}

} // namespace
