#include "Devices/HeadMotionFit.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{

const glm::dvec3 At(3, -4, 600), Rate(200, -50, 30);

std::vector<double> Times(std::size_t count, double step)
{
  std::vector<double> times;
  for (std::size_t n = 0; n < count; ++n)
    times.push_back(-step * static_cast<double>(count - 1 - n));
  return times;
}

std::vector<glm::dvec3> Line(const std::vector<double>& times)
{
  std::vector<glm::dvec3> values;
  for (const double t : times)
    values.push_back(At + Rate * t);
  return values;
}

TEST(HeadMotionFit, ALineIsFoundExactly)
{
  for (std::size_t count = 3; count <= hasp::MostMotionSamples; ++count)
  {
    const auto times = Times(count, 1.0 / 60);
    const auto fit = hasp::FitEvenMotion(times, Line(times), 1.0, 0.004);
    EXPECT_LT(glm::length(fit.value - At), 1e-10) << count;
    EXPECT_LT(glm::length(fit.rate - Rate), 1e-8) << count;
  }
}

TEST(HeadMotionFit, TooLittleGivesTheNewestAndNoRate)
{
  const auto check = [](const std::vector<double>& times)
  {
    const auto fit = hasp::FitEvenMotion(times, Line(times), 1.0, 0.004);
    EXPECT_EQ(fit.value, Line(times).back());
    EXPECT_EQ(fit.rate, glm::dvec3(0.0));
  };
  check({ 0.0 });
  check({ -0.02, 0.0 });
  check(Times(10, 1e-9));
  check(Times(5, 0.0));
}

TEST(HeadMotionFit, TimesThatFallTogetherMakeNoSlope)
{
  const std::vector<double> times = { -0.05, -0.05, -0.05 + 1e-9, -0.01, 0.0 };
  auto values = Line(times);
  values[1] += glm::dvec3(0.3, 0, 0); // a slope of 3e8 with its neighbours
  const auto fit = hasp::FitEvenMotion(times, values, 1.0, 0.004);
  EXPECT_LT(glm::length(fit.rate - Rate), 20.0); // 0.3 mm over 0.05 s is 6 mm/s, in a fit of five
}

/// One of five far off, wherever it stands: the line stays.
TEST(HeadMotionFit, OnePoseOfFiveMayBeAnywhere)
{
  const auto times = Times(5, 1.0 / 60);
  for (std::size_t wrong = 0; wrong < 5; ++wrong)
    for (const double off : { 2.0, 50.0, 9000.0 })
    {
      auto values = Line(times);
      values[wrong] += glm::dvec3(off, -off, 0.5 * off);
      const auto fit = hasp::FitEvenMotion(times, values, 1.0, 0.004);
      EXPECT_LT(glm::length(fit.value - At), 1e-9) << wrong << " " << off;
      EXPECT_LT(glm::length(fit.rate - Rate), 1e-6) << wrong << " " << off;
    }
}

/// Least squares is the least: the mean square error of the value moved on by h is
/// 3 s^2 (1 / n + (h - mean t)^2 / sum (t - mean t)^2), for noise below the floor of outliers.
TEST(HeadMotionFit, NoiseGrowsAsTheoryOfLeastSquaresSays)
{
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.1);
  const auto times = Times(5, 1.0 / 60);
  const double ahead = 1.0 / 30;
  double sum = 0.0;
  constexpr int Rounds = 20'000;
  for (int n = 0; n < Rounds; ++n)
  {
    auto values = Line(times);
    for (auto& v : values)
      v += glm::dvec3(noise(random), noise(random), noise(random));
    const auto fit = hasp::FitEvenMotion(times, values, 1.0, 0.004);
    const glm::dvec3 off = fit.value + ahead * fit.rate - (At + ahead * Rate);
    sum += glm::dot(off, off) / Rounds;
  }
  const double theory = 3 * 0.01 * (0.2 + std::pow(4.0 / 60, 2) / (10.0 / 3600));
  // 60,000 normal numbers: 1 %; that the rate is shrunk by s^2 / r^2 = 0.0005 shifts the mean less.
  EXPECT_NEAR(sum / theory, 1.0, 0.03);
}

TEST(HeadMotionFit, AStillHeadIsNotSentAboutByNoise)
{
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0.0, 0.3);
  const auto times = Times(5, 1.0 / 60);
  double shrunk = 0.0;
  constexpr int Rounds = 5000;
  for (int n = 0; n < Rounds; ++n)
  {
    std::vector<glm::dvec3> values(5);
    for (auto& v : values)
      v = glm::dvec3(noise(random), noise(random), noise(random));
    const glm::dvec3 rate = hasp::FitEvenMotion(times, values, 1.0, 0.004).rate;
    shrunk += glm::dot(rate, rate) / Rounds;
  }
  const double plain = 3 * 0.09 / (10.0 / 3600); // of least squares
  EXPECT_LT(shrunk, 0.45 * plain); // r^2 about s^2: half of the rate is left, in the mean
  EXPECT_GT(shrunk, 0.0);
}

} // namespace
