#include "LensModel.h"
#include "LensTable.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using hasp::LensModel;
using hasp::StereoEye;

constexpr double Aspect = 0.9; // 1080 x 1200 an eye

/// As strong as those of a head-mounted display: barrel and pincushion mixed, off-centre, with
/// colours apart.
LensModel Strong()
{
  return { { 0.22, 0.24, -0.03 }, { glm::dvec2(0.08, -0.02), glm::dvec2(-0.08, -0.02) },
    { 0.995, 1.0, 1.008 } };
}

TEST(LensModel, RefusesWhatNoLensDoes)
{
  EXPECT_NO_THROW(hasp::ValidateLens({}, Aspect));
  EXPECT_NO_THROW(hasp::ValidateLens(Strong(), Aspect));
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    LensModel lens = Strong();
    lens.coefficients.y = bad;
    EXPECT_THROW(hasp::ValidateLens(lens, Aspect), std::invalid_argument);
    lens = Strong();
    lens.centers[1].x = bad;
    EXPECT_THROW(hasp::ValidateLens(lens, Aspect), std::invalid_argument);
    lens = Strong();
    lens.colorScale.z = bad;
    EXPECT_THROW(hasp::ValidateLens(lens, Aspect), std::invalid_argument);
    EXPECT_THROW(hasp::ValidateLens(Strong(), bad), std::invalid_argument);
  }
  LensModel lens = Strong();
  lens.colorScale.x = 0.0;
  EXPECT_THROW(hasp::ValidateLens(lens, Aspect), std::invalid_argument);
  EXPECT_THROW(hasp::MakeLensTable({}, StereoEye::Left, { 0, 4 }, 1.0), std::invalid_argument);
  EXPECT_THROW(hasp::MakeLensTable({}, StereoEye::Left, { 4, 40000 }, 1.0), std::invalid_argument);
}

TEST(LensModel, RefusesALensThatFoldsOverWithinThePicture)
{
  // r (1 + k r^2) turns at r = sqrt(-1 / 3 k); the farthest corner of a square is at sqrt(2).
  const auto fold = [](double radius) {
    return LensModel{ { -1.0 / (3.0 * radius * radius), 0, 0 } };
  };
  EXPECT_NO_THROW(hasp::ValidateLens(fold(1.42), 1.0));
  try
  {
    hasp::ValidateLens(fold(1.25), 1.0);
    FAIL() << "it folds over";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("1.25"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("1.414"), std::string::npos) << error.what();
  }
  LensModel aside = fold(1.42); // the other eye's centre leaves a corner farther away
  aside.centers[1] = { 0.1, 0.0 };
  EXPECT_THROW(hasp::ValidateLens(aside, 1.0), std::invalid_argument);
  // dr'/dr = (1 - 2 t)^2 (1 + ...) dips below 0 in the middle and grows again at the corner.
  const LensModel dip{ { -4.0 / 3.0, 4.2 / 5.0, 0.0 } }; // 1 - 4 t + 4.2 t^2: discriminant < 0
  EXPECT_THROW(hasp::ValidateLens({ { -4.0 / 3.0, 3.8 / 5.0, 0.0 } }, 1.0), std::invalid_argument);
  EXPECT_NO_THROW(hasp::ValidateLens(dip, 1.0));
}

TEST(LensModel, IsTheFormula)
{
  const LensModel lens = Strong();
  const glm::dvec2 panel(0.5, 0.7), off = panel - lens.centers[0];
  const double r = glm::length(off);
  const glm::dvec2 expected =
    lens.centers[0] +
    off * 0.995 * (1 + 0.22 * r * r + 0.24 * std::pow(r, 4) - 0.03 * std::pow(r, 6));
  EXPECT_LT(glm::length(hasp::SeenThroughLens(lens, StereoEye::Left, 0, panel) - expected), 1e-15);
}

TEST(LensModel, TheReverseIsTheReverse)
{
  for (const LensModel& lens : { LensModel{}, Strong(), LensModel{ { -0.1, 0.0, 0.0 } } })
    for (const StereoEye eye : { StereoEye::Left, StereoEye::Right })
      for (int channel = 0; channel < 3; ++channel)
        for (double x = -Aspect; x <= Aspect; x += 0.15)
          for (double y = -1.0; y <= 1.0; y += 0.125)
          {
            const auto seen = hasp::SeenThroughLens(lens, eye, channel, { x, y });
            const auto panel = hasp::PanelBehindLens(lens, eye, channel, seen, Aspect);
            ASSERT_TRUE(panel);
            EXPECT_LT(glm::length(*panel - glm::dvec2(x, y)), 1e-12);
          }
  EXPECT_FALSE(hasp::PanelBehindLens(Strong(), StereoEye::Left, 1, { 50, 0 }, Aspect));
}

TEST(LensTable, NoLensIsTheSamePicture)
{
  const glm::ivec2 size{ 31, 17 };
  const hasp::LensTable table = hasp::MakeLensTable({}, StereoEye::Right, size, 3.0);
  EXPECT_EQ(table.channels, 1);
  std::vector<std::uint8_t> rgb(3 * size.x * size.y);
  for (std::size_t n = 0; n < rgb.size(); ++n)
    rgb[n] = static_cast<std::uint8_t>(n * 37);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int color = 0; color < 3; ++color)
        EXPECT_EQ(
          hasp::SampleThroughLens(table, rgb, { x, y })[color], rgb[3 * (y * size.x + x) + color]);
}

/// Grey that rises with x, and in green with y: where it is seen can be read from the colour.
std::vector<std::uint8_t> Ramp(glm::ivec2 size)
{
  std::vector<std::uint8_t> rgb;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (const int value : { x, y, x })
        rgb.push_back(static_cast<std::uint8_t>(value));
  return rgb;
}

TEST(LensTable, WhatIsSeenThroughTheLensIsThePicture)
{
  const glm::ivec2 size{ 216, 240 }; // so that a grey level is a pixel
  const auto rgb = Ramp(size);
  const LensModel lens = Strong();
  for (const StereoEye eye : { StereoEye::Left, StereoEye::Right })
  {
    const hasp::LensTable table = hasp::MakeLensTable(lens, eye, size, Aspect);
    ASSERT_EQ(table.channels, 3);
    double worst = 0.0;
    int dark = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
      {
        const auto shown = hasp::SampleThroughLens(table, rgb, { x, y });
        const glm::dvec2 half(Aspect, 1.0);
        const glm::dvec2 panel =
          (2.0 * glm::dvec2(x + 0.5, y + 0.5) / glm::dvec2(size) - 1.0) * half;
        for (int color = 0; color < 3; ++color)
        {
          const glm::dvec2 seen = hasp::SeenThroughLens(lens, eye, color, panel) / half;
          const glm::dvec2 pixel = (seen + 1.0) * 0.5 * glm::dvec2(size) - 0.5;
          if (std::abs(seen.x) > 1.0 || std::abs(seen.y) > 1.0)
          {
            EXPECT_EQ(shown[color], 0);
            ++dark;
            continue;
          }
          if (pixel.x < 0 || pixel.y < 0 || pixel.x > size.x - 1 || pixel.y > size.y - 1)
            continue; // the outer half of a border pixel
          worst = std::max(worst, std::abs(shown[color] - (color == 1 ? pixel.y : pixel.x)));
        }
      }
    EXPECT_GT(dark, 0) << "this lens shows less than all of the panel";
    // Half a grey level by rounding, 1/512 pixel by the table: the grid is 0.5 pixel or better.
    EXPECT_LE(worst, 0.503);
  }
}

} // namespace
