#include "ConeBeamTruth.h"
#include "Segmentation/ConeBeam.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

namespace
{

using hasp::testing::ConeBeamCase;

constexpr double InsideAbove = -100.0;

hasp::GridGeometry Grid(const glm::ivec3& dims, const glm::dvec3& spacing)
{
  hasp::GridGeometry grid;
  grid.dims = dims;
  grid.spacing = spacing;
  return grid;
}

template <typename T>
std::vector<float> Correct(const std::vector<T>& grey, const hasp::GridGeometry& grid,
  const hasp::ConeBeamSettings& settings, hasp::ConeBeamFindings* findings = nullptr)
{
  std::vector<float> corrected(grey.size(), -7e7F);
  const hasp::ConeBeamFindings found = hasp::CorrectConeBeam(
    hasp::GridView<const T>{ grey.data(), grid }, settings, { corrected.data(), grid });
  if (findings)
    *findings = found;
  return corrected;
}

hasp::PhantomSettings Head()
{
  hasp::PhantomSettings settings;
  settings.blurMm = glm::dvec3(0.4);
  settings.noiseHU = 20.0;
  return settings;
}

// The scanner's parameters are not told. Bounds are twice what was measured.
TEST(ConeBeam, CuppingOfAHeadGoesInSoftTissueAndInBone)
{
  const hasp::PhantomSettings settings = Head();
  const ConeBeamCase head(settings, hasp::PhantomGrid(glm::dvec3(2.5), settings));
  hasp::ConeBeamFindings found;
  const std::vector<float> corrected =
    Correct(head.grey, head.geometry, { .insideAbove = InsideAbove }, &found);
  ASSERT_TRUE(found.air);
  EXPECT_NEAR(*found.air, head.Air(), 3.0);
  const auto before = hasp::testing::MeasureShading(head, head.grey);
  const auto after = hasp::testing::MeasureShading(head, corrected);
  EXPECT_GT(before.soft, 0.025);
  EXPECT_GT(before.bone, 0.03);
  EXPECT_LT(after.soft, 0.005);
  EXPECT_LT(after.bone, 0.005);
  EXPECT_GT(hasp::testing::FindBestThreshold(head, corrected).dice,
    hasp::testing::FindBestThreshold(head, head.grey).dice + 0.002);
}

TEST(ConeBeam, ACutFieldOfViewAndMetalAreStood)
{
  hasp::PhantomSettings settings = Head();
  settings.fieldRadiusMm = 60.0;
  settings.metal.on = true;
  const ConeBeamCase head(settings, hasp::PhantomGrid(glm::dvec3(2.5), settings));
  const std::vector<float> corrected =
    Correct(head.grey, head.geometry, { .insideAbove = InsideAbove });
  const auto before = hasp::testing::MeasureShading(head, head.grey);
  const auto after = hasp::testing::MeasureShading(head, corrected);
  EXPECT_LT(after.bone, 0.5 * before.bone);
  EXPECT_LT(after.soft, before.soft); // streaks are of soft tissue, and no shading
}

/// A cylinder of soft tissue along z with a tube of bone in it, in noisy air: (grey - air) / 800 is
/// the gain in soft tissue. `gain` is of the place in mm from the middle.
template <typename Gain>
std::vector<float> Cylinder(const hasp::GridGeometry& grid, bool bone, const Gain& gain)
{
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0.0F, 10.0F);
  const glm::dvec3 middle = grid.IndexToWorld(0.5 * glm::dvec3(grid.dims - 1));
  const double radius = 0.4 * grid.spacing.x * grid.dims.x;
  std::vector<float> grey(grid.Size());
  std::size_t n = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i, ++n)
      {
        const glm::dvec3 off = grid.IndexToWorld({ i, j, k }) - middle;
        const double out = std::hypot(off.x, off.y) / radius;
        const double tissue = out > 1.0 ? 0.0 : bone && out > 0.6 && out < 0.8 ? 1600.0 : 800.0;
        grey[n] = float(-600.0 + tissue * gain(off)) + noise(random);
      }
  return grey;
}

const hasp::GridGeometry CylinderGrid = Grid({ 60, 60, 20 }, { 2.0, 2.0, 3.0 });

double Spread(const std::vector<float>& corrected, double low, double high)
{
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const float v : corrected)
    if (v > low && v < high)
    {
      sum += v;
      squares += v * double(v);
      count += 1.0;
    }
  return std::sqrt(squares / count - sum / count * (sum / count));
}

TEST(ConeBeam, ALinearGainGoesUpToTheEdge)
{
  const auto gain = [](const glm::dvec3& p) { return 1.0 + 0.004 * p.x + 0.002 * p.z; };
  const std::vector<float> grey = Cylinder(CylinderGrid, true, gain);
  const std::vector<float> corrected = Correct(grey, CylinderGrid, { .insideAbove = InsideAbove });
  EXPECT_GT(Spread(grey, InsideAbove, 500.0), 70.0);
  EXPECT_LT(Spread(corrected, InsideAbove, 500.0), 11.5); // the noise is 10
  EXPECT_LT(Spread(corrected, 600.0, 2000.0), 13.0); // 1,600 of bone is scaled as soft tissue is
}

TEST(ConeBeam, BoneDoesNotPullTheField)
{
  const auto even = [](const glm::dvec3&) { return 1.0; };
  const std::vector<float> grey = Cylinder(CylinderGrid, true, even);
  hasp::ConeBeamFindings found;
  const std::vector<float> corrected =
    Correct(grey, CylinderGrid, { .insideAbove = InsideAbove }, &found);
  EXPECT_NEAR(found.lowest, 1.0, 0.004);
  EXPECT_NEAR(found.highest, 1.0, 0.004);
  EXPECT_NEAR(found.softTissue, 200.0, 2.0);
  for (std::size_t n = 0; n < grey.size(); ++n)
    ASSERT_NEAR(corrected[n], grey[n], 10.0) << n; // 0.6 % of bone
}

TEST(ConeBeam, WhatIsOutsideStaysToTheLastBit)
{
  std::vector<float> grey =
    Cylinder(CylinderGrid, true, [](const glm::dvec3& p) { return 1.0 + 0.002 * p.y; });
  grey[5] = std::numeric_limits<float>::quiet_NaN();
  grey[36030] = std::numeric_limits<float>::infinity(); // within the patient
  const std::vector<float> before = grey;
  const std::vector<float> corrected =
    Correct(grey, CylinderGrid, { .contrastMm = 20.0, .insideAbove = InsideAbove });
  EXPECT_TRUE(std::isnan(corrected[5]));
  for (std::size_t n = 6; n < grey.size(); ++n)
    if (!(grey[n] > InsideAbove) || std::isinf(grey[n]))
      ASSERT_EQ(corrected[n], grey[n]) << n;
    else
      ASSERT_TRUE(std::isfinite(corrected[n])) << n;
  EXPECT_EQ(0, std::memcmp(before.data(), grey.data(), grey.size() * sizeof(float)));
}

TEST(ConeBeam, PaddingIsNotAir)
{
  const auto gain = [](const glm::dvec3& p) { return 1.0 + 0.003 * p.x; };
  std::vector<float> grey = Cylinder(CylinderGrid, false, gain);
  for (std::size_t n = 0; n < grey.size(); ++n)
    if (n % 60 < 4 || n % 60 > 55) // a third of all that is not the patient
      grey[n] = -3024.0F;
  hasp::ConeBeamFindings found;
  Correct(grey, CylinderGrid, { .insideAbove = InsideAbove }, &found);
  ASSERT_TRUE(found.air);
  EXPECT_NEAR(*found.air, -600.0, 5.0);
}

TEST(ConeBeam, WithoutAirShadingIsSubtracted)
{
  std::vector<float> grey(CylinderGrid.Size());
  std::mt19937 random(4);
  std::normal_distribution<float> noise(0.0F, 5.0F);
  for (std::size_t n = 0; n < grey.size(); ++n)
    grey[n] = float(300.0 + 1.5 * (n % 60)) + noise(random) + (n % 53 == 0 ? 700.0F : 0.0F);
  hasp::ConeBeamFindings found;
  const std::vector<float> corrected = Correct(grey, CylinderGrid, {}, &found);
  EXPECT_FALSE(found.air);
  EXPECT_NEAR(found.highest - found.lowest, 80.0, 12.0); // blocks' middles do not reach the edges
  EXPECT_LT(Spread(corrected, 0.0, 700.0), 6.0);
}

TEST(ConeBeam, LostContrastComesBackAndSoftTissueStays)
{
  const auto even = [](const glm::dvec3&) { return 1.0; };
  const hasp::GridGeometry grid = Grid({ 60, 60, 60 }, glm::dvec3(2.0));
  std::vector<float> grey = Cylinder(grid, true, even);
  const auto lost = [](int k) { return 1.0 - 0.4 * std::exp(-0.5 * std::pow((k - 30) / 12.0, 2)); };
  for (std::size_t n = 0; n < grey.size(); ++n)
    if (grey[n] > 500.0F)
      grey[n] = float(200.0 + (grey[n] - 200.0) * lost(int(n / 3600)));
  hasp::ConeBeamFindings found;
  const std::vector<float> corrected =
    Correct(grey, grid, { .contrastMm = 15.0, .insideAbove = InsideAbove }, &found);
  EXPECT_GT(Spread(grey, 500.0, 2000.0), 90.0);
  EXPECT_LT(Spread(corrected, 500.0, 2000.0), 35.0);
  EXPECT_NEAR(found.boneContrast, 641.5, 5.0); // 800 (1 - 0.4 * 12 sqrt(2 pi) 0.988 / 60)
  EXPECT_LT(Spread(corrected, InsideAbove, 400.0), 11.0);
}

TEST(ConeBeam, ConstantAndNoiseImagesPass)
{
  const hasp::GridGeometry grid = Grid({ 20, 21, 22 }, glm::dvec3(1.0));
  const std::vector<std::int16_t> constant(grid.Size(), 700);
  for (const float v : Correct(constant, grid, { .contrastMm = 10.0 }))
    ASSERT_EQ(v, 700.0F);
  std::vector<float> noise(grid.Size());
  std::mt19937 random(5);
  std::normal_distribution<float> normal(0.0F, 300.0F);
  for (float& v : noise)
    v = normal(random);
  for (const double insideAbove : { -2000.0, -300.0, 0.0, 300.0, 900.0 })
    for (const float v : Correct(noise, grid, { .contrastMm = 10.0, .insideAbove = insideAbove }))
      ASSERT_TRUE(std::abs(v) < 5000.0F) << v;
  noise[17] = 3e38F; // alone: bins must not be made for it
  const std::vector<float> corrected = Correct(noise, grid, { .insideAbove = -2000.0 });
  EXPECT_NEAR(corrected[18], noise[18], 300.0);
}

TEST(ConeBeam, ThinGridsAndSpacingsOf100To1Pass)
{
  const auto gain = [](const glm::dvec3& p) { return 1.0 + 0.002 * p.x; };
  for (const auto& [dims, spacing] : { std::pair{ glm::ivec3(60, 60, 1), glm::dvec3(2.0) },
         { glm::ivec3(60, 60, 2), glm::dvec3(2.0, 2.0, 200.0) },
         { glm::ivec3(60, 60, 30), glm::dvec3(2.0, 2.0, 0.02) } })
  {
    const hasp::GridGeometry grid = Grid(dims, spacing);
    const std::vector<float> grey = Cylinder(grid, true, gain);
    const std::vector<float> corrected =
      Correct(grey, grid, { .contrastMm = 20.0, .insideAbove = InsideAbove });
    EXPECT_GT(Spread(grey, InsideAbove, 500.0), 39.0) << dims.z;
    EXPECT_LT(Spread(corrected, InsideAbove, 500.0), 13.0) << dims.z;
  }
  for (const glm::ivec3 dims : { glm::ivec3(1), glm::ivec3(1, 1, 9), glm::ivec3(2) })
  {
    std::vector<float> grey(Grid(dims, glm::dvec3(1.0)).Size());
    std::iota(grey.begin(), grey.end(), 1.0F);
    for (const float v : Correct(grey, Grid(dims, glm::dvec3(1.0)), { .contrastMm = 5.0 }))
      EXPECT_TRUE(std::isfinite(v));
  }
}

TEST(ConeBeam, SampleTypesGiveTheSame)
{
  std::vector<float> grey =
    Cylinder(CylinderGrid, true, [](const glm::dvec3& p) { return 1.0 + 0.002 * p.y; });
  std::vector<std::int16_t> whole;
  std::vector<std::uint16_t> shifted;
  for (float& v : grey)
  {
    v = std::round(v);
    whole.push_back(std::int16_t(v));
    shifted.push_back(std::uint16_t(v + 1000.0F));
  }
  const hasp::ConeBeamSettings settings{ .insideAbove = InsideAbove };
  const std::vector<float> expected = Correct(grey, CylinderGrid, settings);
  EXPECT_EQ(Correct(whole, CylinderGrid, settings), expected);
  const std::vector<float> corrected =
    Correct(shifted, CylinderGrid, { .insideAbove = InsideAbove + 1000.0 });
  for (std::size_t n = 0; n < expected.size(); ++n)
    ASSERT_NEAR(corrected[n] - 1000.0, expected[n], 0.01) << n;
}

TEST(ConeBeam, NonsenseIsRefusedAndCancelEnds)
{
  const hasp::GridGeometry grid = Grid({ 4, 4, 4 }, glm::dvec3(1.0));
  const std::vector<std::int16_t> grey(64, 50);
  const auto message = [&](const hasp::ConeBeamSettings& settings)
  {
    try
    {
      Correct(grey, grid, settings);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message({ .insideAbove = 50.0 }).find("the largest is 50"), std::string::npos);
  EXPECT_NE(message({ .fieldMm = 9.0 }).find("fieldMm is 9"), std::string::npos);
  EXPECT_NE(message({ .fieldMm = nan }).find("fieldMm"), std::string::npos);
  EXPECT_NE(message({ .contrastMm = 4.0 }).find("contrastMm"), std::string::npos);
  EXPECT_NE(message({ .contrastMm = nan }).find("contrastMm"), std::string::npos);
  EXPECT_NE(message({ .insideAbove = 2e6 }).find("insideAbove"), std::string::npos);
  std::vector<float> corrected(64);
  const hasp::GridView<const std::int16_t> view{ grey.data(), grid };
  EXPECT_THROW(
    hasp::CorrectConeBeam(view, {}, { corrected.data(), Grid({ 4, 4, 3 }, glm::dvec3(1.0)) }),
    std::invalid_argument);
  const auto stop = [](double) { return false; };
  EXPECT_THROW(hasp::CorrectConeBeam(view, {}, { corrected.data(), grid }, stop), hasp::Cancelled);
}

TEST(ConeBeam, ProgressGrowsToOne)
{
  const std::vector<float> grey =
    Cylinder(CylinderGrid, true, [](const glm::dvec3&) { return 1.0; });
  std::vector<float> corrected(grey.size());
  double last = 0.0;
  hasp::CorrectConeBeam(hasp::GridView<const float>{ grey.data(), CylinderGrid },
    { .contrastMm = 20.0, .insideAbove = InsideAbove }, { corrected.data(), CylinderGrid },
    [&](double share)
    {
      EXPECT_GE(share, last);
      last = share;
      return true;
    });
  EXPECT_EQ(last, 1.0);
}

} // namespace
