#include "Light/Environment.h"
#include "Light/SobolSequence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace
{

constexpr double Pi = std::numbers::pi;

hasp::EnvironmentMap Constant(const glm::ivec2& size, float radiance)
{
  return { size, std::vector<glm::vec3>(std::size_t(size.x) * size.y, glm::vec3(radiance)) };
}

double SolidAngle(int y, const glm::ivec2& size)
{
  return 2 * Pi / size.x * (std::cos(Pi * y / size.y) - std::cos(Pi * (y + 1) / size.y));
}

TEST(EnvironmentExtreme, SamplesOneBrightPixelAmongOnesInProportion)
{
  const glm::ivec2 size(128, 64);
  for (const float bright : { 1e6F, 1e30F, std::numeric_limits<float>::max() })
    for (const glm::ivec2 at : { glm::ivec2(77, 40), { 0, 0 }, { 127, 63 } })
    {
      auto map = Constant(size, 1);
      map.pixels[at.y * size.x + at.x] = glm::vec3(1, bright, 0);
      const hasp::Environment environment(map, { 1, 1, 0 });
      const double light = bright * SolidAngle(at.y, size);
      const double share = light / (light + 4 * Pi - SolidAngle(at.y, size));
      EXPECT_EQ(environment.Brightest(), bright);
      constexpr int Count = 1 << 13;
      int met = 0;
      for (std::uint32_t i = 0; i < Count; ++i)
      {
        const auto sample = environment.Sample(hasp::SobolSequence(3, i).Next());
        met += sample.radiance.y > 1;
        ASSERT_EQ(environment.Radiance(sample.direction), sample.radiance);
        ASSERT_EQ(environment.Density(sample.direction), sample.density);
        ASSERT_GT(sample.density, 0);
        ASSERT_TRUE(std::isfinite(sample.density) && std::isfinite(glm::dot(sample.direction, {})));
      }
      // A net hits a row and a part of it as often as it should but for two in each direction.
      EXPECT_NEAR(met, share * Count, 4 + 4 * std::sqrt(share * (1 - share) * Count) / 8);
      EXPECT_GT(environment.Density({ 0, 0, 1 }), 0);
      const auto irradiance = environment.Irradiance({ 0, 0, 1 });
      EXPECT_TRUE(std::isfinite(irradiance.x + irradiance.y + irradiance.z));
    }
}

TEST(EnvironmentExtreme, WorksAlikeAtAnyScale)
{
  const glm::ivec2 size(33, 17);
  for (const float scale : { 1e-45F, 1e-30F, 1e30F, 8.5e37F })
  {
    auto map = Constant(size, 1 * scale), one = Constant(size, 1);
    for (int i = 0; i < size.x * size.y; i += 3)
    {
      map.pixels[i] = glm::vec3(0, 4 * scale, scale);
      one.pixels[i] = glm::vec3(0, 4, 1);
    }
    const hasp::Environment environment(map), plain(one);
    EXPECT_NEAR(environment.Total() / scale / plain.Total(), 1, 1e-6); // floats
    for (std::uint32_t i = 0; i < 1000; ++i)
    {
      const auto point = hasp::SobolSequence(3, i).Next();
      const auto a = environment.Sample(point), b = plain.Sample(point);
      // The density goes with the radiance; 1e-45 is stored as 1.4e-45, and 4e-45 as 4.2e-45.
      if (scale > 1e-40F)
      {
        ASSERT_NEAR(a.density / b.density, 1, 1e-6);
        ASSERT_LT(glm::length(a.direction - b.direction), 1e-5);
      }
      ASSERT_EQ(environment.Radiance(a.direction), a.radiance);
      ASSERT_EQ(environment.Density(a.direction), a.density);
    }
    const glm::dvec3 normal(0.48, -0.6, 0.64);
    if (scale > 1e-40F) // else the result has no digits
    {
      EXPECT_NEAR(environment.Irradiance(normal).x / scale, plain.Irradiance(normal).x, 1e-5);
      EXPECT_NEAR(environment.Irradiance(normal).z / scale, plain.Irradiance(normal).z, 1e-5);
    }
  }
}

TEST(EnvironmentExtreme, LimitsIrradianceToAFloat)
{
  auto map = Constant({ 64, 32 }, std::numeric_limits<float>::max());
  EXPECT_EQ(hasp::Environment(map).Irradiance({ 0, 0, 1 }).x, std::numeric_limits<float>::max());
  map.pixels[5] = glm::vec3(0);
  const hasp::Environment environment(map);
  EXPECT_TRUE(environment.Samples());
  EXPECT_EQ(environment.Irradiance({ 0, 0, 1 }).x, std::numeric_limits<float>::max());
  EXPECT_NEAR(environment.Total() / std::numeric_limits<float>::max() / 4 / Pi, 1, 1e-3);
}

TEST(EnvironmentExtreme, MayBeBlack)
{
  for (const auto& environment :
    { hasp::Environment(Constant({ 64, 32 }, 0)), hasp::Environment::Uniform(glm::vec3(0)),
      hasp::Environment(Constant({ 64, 32 }, 5), { 0, 0, 1 }, 0, 0) })
  {
    EXPECT_FALSE(environment.Samples());
    EXPECT_EQ(environment.Total(), 0);
    EXPECT_EQ(environment.Brightest(), 0);
    EXPECT_EQ(environment.Density({ 0, 0, 1 }), 0);
    EXPECT_EQ(environment.Radiance({ 0, 0, 1 }), glm::vec3(0));
    EXPECT_EQ(environment.Irradiance({ 0, 0, 1 }), glm::vec3(0));
    const auto sample = environment.Sample({ 0.3, 0.7 });
    EXPECT_EQ(sample.density, 0);
    EXPECT_NEAR(glm::length(sample.direction), 1, 1e-15);
  }
}

TEST(EnvironmentExtreme, SamplesTheOnlyPixelThatIsNotBlack)
{
  const glm::ivec2 size(100, 50);
  for (const int at : { 0, 99, 2517, 4900, 4999 })
  {
    auto map = Constant(size, 0);
    map.pixels[at].z = 1e-30F;
    const hasp::Environment environment(map);
    for (const double x : { 0.0, 0.3, 1 - 0x1p-32, 1.0 })
      for (const double y : { 0.0, 0.3, 1 - 0x1p-32, 1.0 })
      {
        const auto sample = environment.Sample({ x, y });
        EXPECT_EQ(sample.radiance.z, 1e-30F);
        EXPECT_EQ(environment.Radiance(sample.direction), sample.radiance);
        EXPECT_NEAR(sample.density * SolidAngle(at / 100, size), 1, 1e-12);
      }
  }
}

TEST(EnvironmentExtreme, MayBeASinglePixel)
{
  const hasp::Environment environment({ { 1, 1 }, { { 1, 2, 3 } } });
  EXPECT_FALSE(environment.Samples());
  EXPECT_EQ(environment.Radiance({ 0, -1, 0 }), glm::vec3(1, 2, 3));
  EXPECT_DOUBLE_EQ(environment.Total(), 12 * Pi);
}

TEST(EnvironmentExtreme, FindsAPixelForWhateverDirection)
{
  auto map = Constant({ 64, 32 }, 1);
  map.pixels[7] = glm::vec3(2);
  const hasp::Environment environment(map);
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const glm::dvec3 d : { glm::dvec3(0), { nan, nan, nan }, { infinite, 0, -infinite },
         { 0, 0, 1 }, { 0, 0, -1 }, { 0, -1, 0 }, { -0.0, -1, -0.0 }, { 5e-324, 0, 1 } })
  {
    EXPECT_GE(environment.Radiance(d).x, 1);
    EXPECT_GT(environment.Density(d), 0);
    environment.Irradiance(d);
  }
}

TEST(EnvironmentExtreme, IsExactAndSmallOnALargeMap)
{
  const glm::ivec2 size(8192, 4096), at(5000, 1000);
  auto map = Constant(size, 1);
  map.pixels[std::size_t(at.y) * size.x + at.x] = glm::vec3(1e6F);
  const hasp::Environment environment(std::move(map));
  EXPECT_LE(environment.Bytes(), std::size_t(size.x) * size.y * 27 / 2 + 100000);

  const double light = 1e6 * SolidAngle(at.y, size);
  EXPECT_NEAR(environment.Total() / (4 * Pi + light - light / 1e6), 1, 1e-9);
  // The sums tell the ones behind it apart: columns of its row are where a closed form has them.
  const double rowSum = size.x - 1 + 1e6;
  const double rows = 2 * Pi * (1 - std::cos(Pi * at.y / size.y)) + 0.5 * rowSum * light / 1e6;
  for (const int column : { 0, 15, 16, 4999, 5001, 5007, 8191 })
  {
    const double before = column + (column > at.x ? 1e6 - 1 : 0);
    const auto d =
      environment.Sample({ (before + 0.25) / rowSum, rows / environment.Total() }).direction;
    EXPECT_NEAR((std::atan2(d.x, d.y) / (2 * Pi) + 0.5) * size.x, column + 0.25, 1e-6);
    EXPECT_NEAR(std::acos(d.z) / Pi * size.y, at.y + 0.5, 1e-2);
  }
}

} // namespace
