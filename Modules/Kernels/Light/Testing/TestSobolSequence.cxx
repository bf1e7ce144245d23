#include "Light/SobolSequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

/// Dimensions 2 pair and 2 pair + 1 of the first points.
template <typename Sequence>
std::vector<glm::dvec2> Points(std::uint32_t seed, int pair, std::uint32_t count)
{
  std::vector<glm::dvec2> points;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    Sequence sequence(seed, i);
    for (int skipped = 0; skipped < pair; ++skipped)
      sequence.Next();
    points.push_back(sequence.Next());
  }
  return points;
}

/// Does every interval of 2^-a by 2^(a-k) hold one of 2^k points?
bool IsNet(const glm::dvec2* points, int k)
{
  for (int a = 0; a <= k; ++a)
  {
    std::vector<bool> met(std::size_t(1) << k);
    for (int i = 0; i < 1 << k; ++i)
    {
      const auto x = static_cast<std::size_t>(std::ldexp(points[i].x, a));
      const auto y = static_cast<std::size_t>(std::ldexp(points[i].y, k - a));
      if (met[x << (k - a) | y])
        return false;
      met[x << (k - a) | y] = true;
    }
  }
  return true;
}

TEST(SobolSequence, IsANetInEveryPairOfDimensions)
{
  std::mt19937 random(3);
  for (int trial = 0; trial < 60; ++trial)
  {
    // Neighbouring seeds, as of pixels, and any.
    const auto seed = trial < 20 ? std::uint32_t(trial) : static_cast<std::uint32_t>(random());
    for (const int pair : { 0, 1, 2, 7, 31 })
    {
      const auto points = Points<hasp::SobolSequence>(seed, pair, 1024);
      for (int k = 0; k <= 10; ++k)
        ASSERT_TRUE(IsNet(points.data(), k)) << "seed " << seed << " pair " << pair << " k " << k;
      for (int block = 0; block < 16; ++block)
        ASSERT_TRUE(IsNet(&points[64 * block], 6)) << "seed " << seed << " block " << block;
    }
  }
}

TEST(SobolSequence, IsEvenInASingleDimension)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed)
  {
    std::vector<bool> met(256);
    for (std::uint32_t i = 0; i < 256; ++i)
    {
      hasp::SobolSequence sequence(seed, i);
      sequence.Next();
      met[static_cast<std::size_t>(sequence.Next1() * 256)] = true;
    }
    EXPECT_EQ(std::count(met.begin(), met.end(), true), 256) << seed;
  }
}

TEST(SobolSequence, StaysInTheUnitSquareAtEveryIndex)
{
  std::mt19937 random(5);
  for (int i = 0; i < 200000; ++i)
  {
    const auto index = i == 0 ? 0xFFFFFFFFU : static_cast<std::uint32_t>(random());
    hasp::SobolSequence sequence(static_cast<std::uint32_t>(random()), index);
    const auto p = sequence.Next();
    const double single = sequence.Next1();
    ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1 && single >= 0 && single < 1);
    ASSERT_EQ(std::ldexp(p.x, 32), std::floor(std::ldexp(p.x, 32))); // 32 bits
  }
}

TEST(SobolSequence, IsTheSameAgain)
{
  hasp::SobolSequence a(17, 5), b(17, 5), mixed(17, 5);
  EXPECT_EQ(mixed.Next1(), a.Next().x); // one of a pair
  EXPECT_NE(b.Next(), glm::dvec2(0));
  for (int i = 0; i < 100; ++i)
  {
    const auto p = a.Next();
    ASSERT_EQ(p, b.Next());
    ASSERT_EQ(p, mixed.Next());
  }
  // Recorded, for the numbers are to be the same on every machine and in every release.
  hasp::SobolSequence recorded(17, 5);
  EXPECT_EQ(recorded.Next(), glm::dvec2(2098843835U, 3369869865U) / 4294967296.0);
  EXPECT_EQ(recorded.Next(), glm::dvec2(1319226031U, 2748349846U) / 4294967296.0);
}

TEST(SobolSequence, HasPairsThatAreIndependent)
{
  constexpr std::uint32_t Count = 256;
  double mean = 0.0, greatest = 0.0;
  int n = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed)
    for (int first = 0; first < 5; ++first)
      for (int second = first + 1; second < 6; ++second)
      {
        const auto a = Points<hasp::SobolSequence>(seed, first, Count);
        const auto b = Points<hasp::SobolSequence>(seed, second, Count);
        for (int c = 0; c < 4; ++c)
        {
          double sum = 0.0;
          for (std::uint32_t i = 0; i < Count; ++i)
            sum += 12 * (a[i][c / 2] - 0.5) * (b[i][c % 2] - 0.5) / Count;
          mean += sum;
          greatest = std::max(greatest, std::abs(sum));
          ++n;
        }
      }
  // Of independent dimensions the correlation has the deviation 1 / sqrt(Count) = 0.0625: the mean
  // of 2400 is below 3 deviations / sqrt(2400) and none above 5.
  EXPECT_LT(std::abs(mean / n), 3 * 0.0625 / std::sqrt(n));
  EXPECT_LT(greatest, 5 * 0.0625);
}

double Smooth(const glm::dvec2& p)
{
  return std::exp(p.x) * std::cos(p.y) + p.x * p.y;
}
const double SmoothIntegral = (std::exp(1.0) - 1) * std::sin(1.0) + 0.25;

/// Root mean square error over seeds of the mean of so many points.
template <typename Sequence>
double Error(std::uint32_t count, std::uint32_t seeds)
{
  double squares = 0.0;
  for (std::uint32_t seed = 0; seed < seeds; ++seed)
  {
    double sum = 0.0;
    for (const auto& p : Points<Sequence>(seed, 1, count))
      sum += Smooth(p) / count;
    squares += (sum - SmoothIntegral) * (sum - SmoothIntegral) / seeds;
  }
  return std::sqrt(squares);
}

/// Of the logarithm of the error over that of the number of points.
template <typename Sequence>
double Slope()
{
  double xy = 0.0, xx = 0.0, mean = 0.0;
  std::vector<double> logs;
  for (int k = 4; k <= 12; ++k)
    mean += logs.emplace_back(std::log2(Error<Sequence>(1U << k, 64))) / 9;
  for (int k = 4; k <= 12; ++k)
  {
    xy += (k - 8) * (logs[k - 4] - mean);
    xx += (k - 8) * (k - 8);
  }
  return xy / xx;
}

TEST(SobolSequence, IntegratesFarFasterThanRandom)
{
  EXPECT_LT(Slope<hasp::SobolSequence>(), -1.4);          // -1.5 in theory
  EXPECT_NEAR(Slope<hasp::RandomSequence>(), -0.5, 0.05); // 64 seeds tell each error to 9%
  EXPECT_LT(Error<hasp::SobolSequence>(4096, 64), Error<hasp::RandomSequence>(4096, 64) / 100);
}

TEST(SobolSequence, IsScrambledIndependentlyByEachSeed)
{
  // 16 points, so that each seed has an error; the mean of seeds falls as that of independent ones.
  constexpr std::uint32_t Seeds = 20000;
  const double single = Error<hasp::SobolSequence>(16, 1000);
  double sum = 0.0, products = 0.0, before = 0.0;
  for (std::uint32_t seed = 0; seed < Seeds; ++seed)
  {
    double error = -SmoothIntegral;
    for (const auto& p : Points<hasp::SobolSequence>(seed, 0, 16))
      error += Smooth(p) / 16;
    sum += error;
    products += error * before;
    before = error;
  }
  EXPECT_GT(single, 1e-4);
  EXPECT_LT(std::abs(sum) / Seeds, 3 * single / std::sqrt(Seeds)); // three deviations
  EXPECT_LT(std::abs(products) / Seeds, 3 * single * single / std::sqrt(Seeds));
}

/// Owen's scrambling makes every point uniform by itself, whatever the index.
TEST(SobolSequence, HasPointsThatAreUniformOverTheSeeds)
{
  constexpr int Seeds = 64000, Bins = 64;
  for (const std::uint32_t index : { 0U, 1U, 77U, 0x80000000U })
  {
    std::vector<int> bins(Bins);
    for (std::uint32_t seed = 0; seed < Seeds; ++seed)
    {
      const auto p = hasp::SobolSequence(seed, index).Next();
      ++bins[static_cast<int>(p.x * 8) * 8 + static_cast<int>(p.y * 8)];
    }
    double chiSquare = 0.0;
    for (const int bin : bins)
      chiSquare += (bin - 1000.0) * (bin - 1000.0) / 1000.0;
    EXPECT_LT(chiSquare, 63 + 5 * std::sqrt(2 * 63.0)) << index; // five deviations
  }
}

TEST(RandomSequence, IsUniformAndTheSameAgain)
{
  constexpr int Count = 64000;
  std::vector<int> bins(64);
  for (std::uint32_t i = 0; i < Count; ++i)
  {
    hasp::RandomSequence sequence(9, i), again(9, i);
    sequence.Next();
    again.Next1();
    const auto p = sequence.Next();
    ASSERT_EQ(p, again.Next());
    ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
    ++bins[static_cast<int>(p.x * 8) * 8 + static_cast<int>(p.y * 8)];
  }
  double chiSquare = 0.0;
  for (const int bin : bins)
    chiSquare += (bin - 1000.0) * (bin - 1000.0) / 1000.0;
  EXPECT_LT(chiSquare, 63 + 5 * std::sqrt(2 * 63.0)); // five deviations
}

} // namespace
