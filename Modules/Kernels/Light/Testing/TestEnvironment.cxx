#include "Light/Environment.h"
#include "Light/SobolSequence.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

namespace
{

constexpr double Pi = std::numbers::pi;

float Largest(const glm::vec3& v)
{
  return std::max({ v.x, v.y, v.z });
}

/// The direction of a place of a map whose up is +z, by the header's words: column x / width of a
/// turn from behind, to the right; row y / height of half a turn from up.
glm::dvec3 Towards(double x, double y, const glm::ivec2& size)
{
  const double right = 2 * Pi * (x / size.x - 0.5), fromUp = Pi * y / size.y;
  return { std::sin(fromUp) * std::sin(right), std::sin(fromUp) * std::cos(right),
    std::cos(fromUp) };
}

double SolidAngle(int y, const glm::ivec2& size)
{
  return 2 * Pi / size.x * (std::cos(Pi * y / size.y) - std::cos(Pi * (y + 1) / size.y));
}

hasp::EnvironmentMap MapOf(
  const glm::ivec2& size, const std::function<glm::vec3(const glm::dvec3&)>& radiance)
{
  hasp::EnvironmentMap map{ size, {} };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      map.pixels.push_back(radiance(Towards(x + 0.5, y + 0.5, size)));
  return map;
}

/// Unlike pixels over four decades, some black.
hasp::EnvironmentMap Noise(const glm::ivec2& size)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit;
  return MapOf(size,
    [&](const glm::dvec3&)
    {
      const float scale = unit(random) < 0.1F ? 0.0F : std::pow(10.0F, 4 * unit(random) - 2);
      return scale * glm::vec3(unit(random), unit(random), unit(random));
    });
}

glm::dvec3 RandomDirection(hasp::RandomSequence& random)
{
  const auto p = random.Next();
  const double z = 2 * p.y - 1, r = std::sqrt(1 - z * z);
  return { r * std::cos(2 * Pi * p.x), r * std::sin(2 * Pi * p.x), z };
}

TEST(Environment, HasEachPixelWhereTheHeaderSays)
{
  const auto map = Noise({ 24, 13 });
  const hasp::Environment environment(map);
  for (int y = 0; y < map.size.y; ++y)
    for (int x = 0; x < map.size.x; ++x)
      for (const double inside : { 0.001, 0.5, 0.999 })
        ASSERT_EQ(environment.Radiance(Towards(x + inside, y + inside, map.size)),
          map.pixels[y * map.size.x + x]);
  // A length that is not 1 does not matter.
  EXPECT_EQ(environment.Radiance({ 2e-5, 3e-5, 1e-5 }), environment.Radiance({ 20, 30, 10 }));
}

TEST(Environment, LooksForwardRightAndUp)
{
  const auto map = Noise({ 8, 4 });
  // A little to the right of forward and below the horizon: the pixel right of and below the
  // centre.
  const auto centre = map.pixels[2 * 8 + 4];
  EXPECT_EQ(hasp::Environment(map, { 0, 0, 1 }).Radiance({ 0.1, 1, -0.1 }), centre);
  EXPECT_EQ(hasp::Environment(map, { 0, 3, 0 }).Radiance({ 0.1, -0.1, -1 }), centre);
  EXPECT_EQ(hasp::Environment(map, { 0, 0, -1 }).Radiance({ 0.1, -1, 0.1 }), centre);
  EXPECT_EQ(hasp::Environment(map, { 1, 0, 0 }).Radiance({ -0.1, 0.1, 1 }), centre);
  // What lay forward lies to the left, which is -x.
  EXPECT_EQ(hasp::Environment(map, { 0, 0, 1 }, Pi / 2).Radiance({ -1, 0.1, -0.1 }), centre);
  // Behind, the ends of the map meet.
  EXPECT_EQ(hasp::Environment(map).Radiance({ 0.1, -1, -0.1 }), map.pixels[2 * 8 + 7]);
  EXPECT_EQ(hasp::Environment(map).Radiance({ -0.1, -1, -0.1 }), map.pixels[2 * 8]);
}

TEST(Environment, TakesUpAxesOfAllKindsAndTurns)
{
  const auto map = Noise({ 32, 16 });
  const hasp::Environment plain(map);
  hasp::RandomSequence random(1, 1);
  for (int trial = 0; trial < 14; ++trial)
  {
    const glm::dvec3 special[] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 },
      { 1e-200, 1e-200, 0 }, { 0.9, 0.4359, 0 }, { 1e200, 0, 1e200 } };
    const auto up = trial < 7 ? special[trial] : RandomDirection(random);
    const double turn = trial % 3 == 0 ? 0.0 : 8 * random.Next1() - 4;
    const hasp::Environment environment(map, up, turn, 2);
    const auto z =
      glm::normalize(up / std::max({ std::abs(up.x), std::abs(up.y), std::abs(up.z) }));
    const glm::dvec3 near = std::abs(z.x) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const auto right = glm::normalize(near - z * glm::dot(z, near));
    const auto toWorld =
      glm::dmat3(glm::rotate(glm::dmat4(1), turn, z)) * glm::dmat3(right, glm::cross(z, right), z);
    for (int i = 0; i < 100; ++i)
    {
      const auto direction = RandomDirection(random);
      ASSERT_EQ(environment.Radiance(toWorld * direction), 2.0F * plain.Radiance(direction));
      const auto sample = plain.Sample({ random.Next1(), random.Next1() });
      ASSERT_EQ(environment.Density(toWorld * sample.direction), sample.density);
    }
    const auto normal = RandomDirection(random);
    const auto a = environment.Irradiance(toWorld * normal), b = 2.0F * plain.Irradiance(normal);
    ASSERT_LT(glm::length(a - b), 1e-5 * glm::length(b)); // floats
  }
}

TEST(Environment, HasADensityThatIsOneOverTheSphere)
{
  for (const glm::ivec2 size : { glm::ivec2(64, 32), { 5, 3 }, { 1, 7 }, { 40, 1 }, { 17, 33 } })
  {
    const auto map = Noise(size);
    const hasp::Environment environment(map);
    double sum = 0.0, total = 0.0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
      {
        const auto pixel = map.pixels[y * size.x + x];
        const double density = environment.Density(Towards(x + 0.5, y + 0.5, size));
        ASSERT_EQ(density > 0, Largest(pixel) > 0);
        ASSERT_LE(Largest(pixel), density * environment.Total() * (1 + 1e-15));
        sum += density * SolidAngle(y, size);
        total += Largest(pixel) * SolidAngle(y, size);
      }
    EXPECT_NEAR(sum, 1, 1e-13); // rounding of 2000 doubles
    EXPECT_NEAR(environment.Total() / total, 1, 1e-13);
    EXPECT_TRUE(environment.Samples());
  }
}

TEST(Environment, SamplesInProportion)
{
  constexpr int Count = 400000;
  for (const glm::ivec2 size : { glm::ivec2(36, 18), { 3, 2 } })
  {
    const hasp::Environment environment(Noise(size));
    // Each pixel in 2 x 2 parts that are even in azimuth and in cosine.
    const glm::ivec2 parts = size * 2;
    std::vector<int> bins(parts.x * parts.y);
    std::vector<double> expected(bins.size());
    hasp::RandomSequence random(4, 0);
    for (int i = 0; i < Count; ++i)
    {
      const auto d = environment.Sample(random.Next()).direction;
      ASSERT_NEAR(glm::length(d), 1, 1e-14);
      const double x = (std::atan2(d.x, d.y) / (2 * Pi) + 0.5) * parts.x;
      const int y = static_cast<int>(std::acos(d.z) / Pi * size.y);
      const double top = std::cos(Pi * y / size.y), bottom = std::cos(Pi * (y + 1) / size.y);
      ++bins[(2 * y + (d.z < (top + bottom) / 2)) * parts.x + static_cast<int>(x)];
    }
    double chiSquare = 0.0;
    int free = -1;
    for (int y = 0; y < parts.y; ++y)
      for (int x = 0; x < parts.x; ++x)
      {
        const double share =
          environment.Density(Towards(x + 0.5, y + 0.5, parts)) * SolidAngle(y / 2, size) / 4;
        const int bin = bins[y * parts.x + x];
        if (share == 0)
          ASSERT_EQ(bin, 0);
        else
          chiSquare += (bin - Count * share) * (bin - Count * share) / (Count * share);
        free += share > 0;
      }
    // Five deviations; rare bins widen chi-square's tail by less than as much again.
    EXPECT_LT(chiSquare, free + 10 * std::sqrt(2.0 * free));
  }
}

TEST(Environment, KeepsEvenPointsEven)
{
  const auto map = Noise({ 40, 20 });
  const hasp::Environment environment(map);
  constexpr int Count = 4096;
  std::vector<int> rows(map.size.y);
  std::vector<double> shares(map.size.y);
  for (int i = 0; i < Count; ++i)
  {
    const auto d =
      environment.Sample(hasp::SobolSequence(1, static_cast<std::uint32_t>(i)).Next()).direction;
    ++rows[static_cast<int>(std::acos(d.z) / Pi * map.size.y)];
  }
  for (int y = 0; y < map.size.y; ++y)
    for (int x = 0; x < map.size.x; ++x)
      shares[y] +=
        environment.Density(Towards(x + 0.5, y + 0.5, map.size)) * SolidAngle(y, map.size);
  for (int y = 0; y < map.size.y; ++y)
    EXPECT_NEAR(rows[y], Count * shares[y], 2) << y; // one at each end of an interval
}

TEST(Environment, FindsWhatItSampled)
{
  const glm::ivec2 sizes[] = { { 256, 128 }, { 16384, 8 }, { 3, 8192 }, { 1, 7 }, { 37, 1 },
    { 100, 33 } };
  const double extremes[] = { 0.0, 0x1p-32, 0.5, 1 - 0x1p-32, 1 - 0x1p-53, 1.0 };
  for (const auto& size : sizes)
    for (const glm::dvec3 up : { glm::dvec3(0, 0, 1), { 0.3, -2, 0.7 } })
    {
      const hasp::Environment environment(Noise(size), up, 0.4);
      for (std::uint32_t i = 0; i < 10036; ++i)
      {
        hasp::RandomSequence random(2, i);
        auto point = i < 36 ? glm::dvec2(extremes[i / 6], extremes[i % 6]) : random.Next();
        if (i >= 36 && i < 5000)
          point[i % 2] = extremes[i / 2 % 6];
        const auto sample = environment.Sample(point);
        ASSERT_GT(sample.density, 0);
        ASSERT_EQ(environment.Radiance(sample.direction), sample.radiance) << size.x << " " << i;
        ASSERT_EQ(environment.Density(sample.direction), sample.density);
      }
    }
}

TEST(Environment, IsUniformWhereItsPixelsAreAlike)
{
  const glm::vec3 radiance(0.5F, 1, 2);
  const auto same = MapOf({ 64, 32 }, [&](const glm::dvec3&) { return radiance; });
  for (const auto& environment :
    { hasp::Environment::Uniform(radiance), hasp::Environment(same, { 1, 2, 3 }, 4) })
  {
    EXPECT_FALSE(environment.Samples());
    EXPECT_EQ(environment.Bytes(), 0U);
    EXPECT_EQ(environment.Brightest(), 2);
    EXPECT_DOUBLE_EQ(environment.Total(), 8 * Pi);
    EXPECT_EQ(environment.Radiance({ 0, 0.6, 0.8 }), radiance);
    EXPECT_DOUBLE_EQ(environment.Density({ 0, 0.6, 0.8 }), 1 / (4 * Pi));
    EXPECT_LT(glm::length(environment.Irradiance({ 0, 0.6, 0.8 }) - float(Pi) * radiance), 1e-6);
    glm::dvec3 mean(0);
    for (std::uint32_t i = 0; i < 1024; ++i)
    {
      const auto sample = environment.Sample(hasp::SobolSequence(0, i).Next());
      ASSERT_NEAR(glm::length(sample.direction), 1, 1e-15);
      ASSERT_EQ(sample.radiance, radiance);
      ASSERT_EQ(sample.density, environment.Density(sample.direction));
      mean += sample.direction / 1024.0;
    }
    EXPECT_LT(glm::length(mean), 0.005); // random: 0.03
  }
}

/// Greatest error of any channel over the poles and random normals, as a share of a quarter of the
/// total: against the sum over each pixel cut into parts of at most a 360th of a turn.
double IrradianceError(const hasp::EnvironmentMap& map)
{
  const hasp::Environment environment(map);
  std::vector<glm::dvec3> normals{ { 0, 0, 1 }, { 0, 0, -1 }, { 0, -1, 0 } }, sums(30);
  hasp::RandomSequence random(8, 0);
  while (normals.size() < sums.size())
    normals.push_back(RandomDirection(random));

  const glm::ivec2 cuts = (glm::ivec2(360, 180) + map.size - 1) / map.size, fine = map.size * cuts;
  for (int y = 0; y < fine.y; ++y)
    for (int x = 0; x < fine.x; ++x)
    {
      const glm::dvec3 pixel = map.pixels[y / cuts.y * map.size.x + x / cuts.x];
      const auto light = pixel * SolidAngle(y, fine), towards = Towards(x + 0.5, y + 0.5, fine);
      for (std::size_t i = 0; i < normals.size(); ++i)
        sums[i] += light * std::max(0.0, glm::dot(normals[i], towards));
    }
  double worst = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const auto error = glm::abs(glm::dvec3(environment.Irradiance(normals[i])) - sums[i]);
    worst = std::max({ worst, error.x, error.y, error.z });
  }
  return worst / (environment.Total() / 4);
}

TEST(Environment, HasTheIrradianceOfLightFromEverywhere)
{
  // The errors that the header promises; the sums themselves are good to 0.01%.
  for (const glm::ivec2 size : { glm::ivec2(256, 128), { 3, 2 } })
  {
    auto even = MapOf(size, [](const glm::dvec3&) { return glm::vec3(0.5F, 1, 2); });
    even.pixels[0] *= 1.0001F; // lest it were uniform
    EXPECT_LT(IrradianceError(even), 1e-3);
  }
  const auto smooth = MapOf({ 128, 64 }, [](const glm::dvec3& d)
    { return glm::vec3(1 + d.z, 1 + d.x * d.y, 1.5 + std::sin(3 * d.x) * d.z); });
  EXPECT_LT(IrradianceError(smooth), 1e-3);
  for (const glm::ivec2 size : { glm::ivec2(5, 3), { 12, 6 }, { 45, 30 }, { 128, 64 } })
    EXPECT_LT(IrradianceError(Noise(size)), 5e-3);
}

TEST(Environment, HasTheIrradianceOfASingleSmallLight)
{
  const glm::ivec2 size(512, 256);
  for (const glm::ivec2 at :
    { glm::ivec2(100, 90), { 256, 128 }, { 7, 0 }, { 300, 255 }, { 0, 200 } })
  {
    hasp::EnvironmentMap map{ size, std::vector<glm::vec3>(512 * 256) };
    map.pixels[at.y * 512 + at.x] = { 1000, 500, 0 };
    const auto towards = Towards(at.x + 0.5, at.y + 0.5, size);
    const double full = 1000 * SolidAngle(at.y, size);
    const hasp::Environment environment(map);
    hasp::RandomSequence random(6, 0);
    for (int i = 0; i < 3000; ++i)
    {
      const auto normal = RandomDirection(random);
      const auto irradiance = environment.Irradiance(normal);
      // A small light is that of its middle, to the square of its size: 1e-4.
      ASSERT_NEAR(irradiance.x / full, std::max(0.0, glm::dot(normal, towards)), 0.02);
      ASSERT_NEAR(irradiance.y, irradiance.x / 2, 1e-5 * full);
      ASSERT_EQ(irradiance.z, 0);
    }
    EXPECT_NEAR(environment.Irradiance(towards).x / full, 1, 2e-3);
    EXPECT_NEAR(environment.Irradiance(-towards).x / full, 0, 2e-3);
  }
}

std::string ErrorOf(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "none";
}

TEST(Environment, RefusesSizesThatAreNone)
{
  const auto error = [](const glm::ivec2& size, std::size_t pixels) {
    return ErrorOf([&] { hasp::Environment({ size, std::vector<glm::vec3>(pixels) }); });
  };
  for (const glm::ivec2 size : { glm::ivec2(0, 0), { 0, 5 }, { 5, 0 }, { -1, -1 }, { 16385, 1 },
         { 1, 8193 }, { 2147483647, 2147483647 } })
    EXPECT_NE(error(size, 1).find("16384 x 8192 is needed"), std::string::npos) << size.x;
  EXPECT_NE(error({ 4, 2 }, 7).find("4 x 2 has 7 pixels"), std::string::npos);
  EXPECT_NE(error({ 4, 2 }, 9).find("has 9 pixels"), std::string::npos);
}

TEST(Environment, RefusesRadianceThatIsNoneAndSaysWhere)
{
  const float bad[] = { -1e-9F, std::numeric_limits<float>::quiet_NaN(),
    std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity() };
  for (int channel = 0; channel < 3; ++channel)
    for (const float value : bad)
    {
      auto map = Noise({ 8, 4 });
      map.pixels[2 * 8 + 5][channel] = value;
      map.pixels[3 * 8][channel] = value;
      const auto error = ErrorOf([&] { hasp::Environment{ map }; });
      EXPECT_NE(error.find("not finite: 2, the first in column 5 of row 2"), std::string::npos)
        << error;
      glm::vec3 radiance(1);
      radiance[channel] = value;
      EXPECT_THROW(hasp::Environment::Uniform(radiance), std::invalid_argument);
    }
}

TEST(Environment, RefusesAxesTurnsAndStrengthsThatAreNone)
{
  const auto map = Noise({ 8, 4 });
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const glm::dvec3 up : { glm::dvec3(0), { nan, 0, 1 }, { 1, infinite, 0 } })
    EXPECT_NE(ErrorOf([&] { hasp::Environment(map, up); }).find("up is not 0"), std::string::npos);
  EXPECT_THROW(hasp::Environment(map, { 0, 0, 1 }, nan), std::invalid_argument);
  EXPECT_THROW(hasp::Environment(map, { 0, 0, 1 }, infinite), std::invalid_argument);
  for (const float strength : { -1.0F, float(nan), float(infinite) })
    EXPECT_NE(ErrorOf(
                [&] {
                  hasp::Environment(map, { 0, 0, 1 }, 0, strength);
                })
                .find("a strength"),
      std::string::npos);
  EXPECT_NE(ErrorOf(
              [&] {
                hasp::Environment(map, { 0, 0, 1 }, 0, 3e38F);
              })
              .find("times the strength"),
    std::string::npos);
}

} // namespace
