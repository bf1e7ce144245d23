#include "Distance/ChamferDistance.h"
#include "Testing/AnalyticCoverage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

constexpr float Infinity = std::numeric_limits<float>::infinity();

hasp::GridGeometry Grid(const glm::ivec3& dims, const glm::dvec3& spacing = glm::dvec3(1))
{
  return { dims, -0.5 * glm::dvec3(dims) * spacing, spacing, glm::dmat3(1) };
}

TEST(ChamferDistance, ErrsAsMuchAsItsMetricDoes)
{
  // One voxel in a corner of 64^3: half a voxel less than the sum of steps to it.
  const auto grid = Grid(glm::ivec3(64));
  std::vector<float> one(grid.Size(), 0.0F);
  one[0] = 1.0F;
  const auto distance = hasp::ChamferDistance(grid, one);
  double high = 0, low = 0, overLargest = 0;
  for (std::size_t n = 1; n < one.size(); ++n)
  {
    const glm::dvec3 p(n % 64, n / 64 % 64, n / 4096);
    const double euclid = glm::length(p), d = double(distance[n]) + 0.5;
    high = std::max(high, d / euclid - 1);
    low = std::min(low, d / euclid - 1);
    overLargest = std::max(overLargest, std::abs(d - euclid) / std::max({ p.x, p.y, p.z }));
  }
  // (1 + 2t/3) - sqrt(1 + 2t^2) at t = 1/sqrt(7); (5/3 + 2) / sqrt(11) - 1; (4/3) / sqrt(2) - 1.
  EXPECT_NEAR(overLargest, 0.1181, 0.0005);
  EXPECT_NEAR(high, 11.0 / 3.0 / std::sqrt(11.0) - 1, 1e-5);
  EXPECT_NEAR(low, 4.0 / 3.0 / std::sqrt(2.0) - 1, 1e-5);
}

TEST(ChamferDistance, IsTheLeastSumOfStepsByBruteForce)
{
  // Relaxation without an order until nothing changes, over all 26 neighbours.
  std::mt19937 random(5);
  std::uniform_int_distribution<int> any(0, 9);
  for (const glm::dvec3 spacing : { glm::dvec3(1), glm::dvec3(0.4, 0.4, 1.5) })
  {
    const glm::ivec3 n(13, 9, 7);
    const auto grid = Grid(n, spacing);
    std::vector<float> mask(grid.Size());
    for (auto& m : mask)
      m = any(random) == 0;
    std::vector<double> least(mask.size(), 1e30);
    for (bool changed = true; changed;)
    {
      changed = false;
      for (std::size_t v = 0; v < mask.size(); ++v)
        for (int s = 0; s < 27; ++s)
        {
          const glm::ivec3 step(s % 3 - 1, s / 3 % 3 - 1, s / 9 - 1);
          const glm::ivec3 q = glm::ivec3(v % 13, v / 13 % 9, v / 117) + step;
          if (glm::any(glm::lessThan(q, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(q, n)) ||
              s == 13)
            continue;
          const int axes = std::abs(step.x) + std::abs(step.y) + std::abs(step.z);
          double length =
            glm::length(glm::dvec3(step) * spacing) * (axes == 1    ? 1.0
                                                        : axes == 2 ? 4.0 / 3.0 / std::sqrt(2.0)
                                                                    : 5.0 / 3.0 / std::sqrt(3.0));
          for (int a = 0; a < 3; ++a) // here, a step along z is longer than any without
            if (step[a])
              length = std::max(length, spacing[a]);
          const std::size_t from = (q.z * 9 + q.y) * 13 + q.x;
          const bool here = mask[v] == 1, there = mask[from] == 1;
          const double half = axes == 1 ? 0.5 * length : std::min(spacing.x, spacing.z) / 2;
          const double offer = here == there ? least[from] + length
                               : axes == 1   ? half
                                             : length - half;
          if (offer < least[v] - 1e-9)
          {
            least[v] = offer;
            changed = true;
          }
        }
    }
    const auto distance = hasp::ChamferDistance(grid, mask);
    for (std::size_t v = 0; v < mask.size(); ++v)
    {
      ASSERT_EQ(distance[v] < 0, mask[v] == 1) << v;
      ASSERT_NEAR(std::abs(distance[v]), least[v], 1e-5) << v;
    }
  }
}

TEST(ChamferDistance, PlanesAcrossAnAxisAreExactWhateverTheSpacing)
{
  const glm::dvec3 spacing(0.3, 0.05, 5);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::ivec3 dims(5);
    dims[axis] = 24;
    const auto grid = Grid(dims, spacing);
    std::vector<float> coverage(grid.Size());
    for (std::size_t n = 0; n < coverage.size(); ++n)
    {
      const glm::ivec3 p(n % dims.x, n / dims.x % dims.y, n / (dims.x * dims.y));
      coverage[n] = std::clamp(9.3F - float(p[axis]), 0.0F, 1.0F); // surface at index 8.8
    }
    const auto distance = hasp::ChamferDistance(grid, coverage);
    for (std::size_t n = 0; n < coverage.size(); ++n)
    {
      const glm::ivec3 p(n % dims.x, n / dims.x % dims.y, n / (dims.x * dims.y));
      ASSERT_NEAR(distance[n], (p[axis] - 8.8) * spacing[axis], 1e-4) << axis << " " << n;
    }
  }
}

TEST(ChamferDistance, CoverageIsWorthEightTimesTheErrorAtTheSurface)
{
  const auto grid = Grid(glm::ivec3(56));
  const auto shape = hasp::AnalyticSphere({ 0.31, -0.22, 0.43 }, 20.3);
  const auto coverage = hasp::AnalyticCoverage(shape, grid);
  std::vector<float> mask(coverage.size());
  std::transform(coverage.begin(), coverage.end(), mask.begin(),
    [](float c) { return c >= 0.5F ? 1.0F : 0.0F; });
  const auto smooth = hasp::ChamferDistance(grid, coverage);
  const auto binary = hasp::ChamferDistance(grid, mask);
  // Published by others within 3 voxels: 0.086 to 0.089 and 0.25.
  EXPECT_NEAR(hasp::ErrorOf(smooth, shape, grid, 3).rms, 0.087, 0.01);
  EXPECT_NEAR(hasp::ErrorOf(binary, shape, grid, 3).rms, 0.25, 0.02);
}

TEST(ChamferDistance, EmptyAndFullAreInfinitelyFarAndOneVoxelIsNot)
{
  const auto grid = Grid({ 7, 1, 5 });
  for (const float d : hasp::ChamferDistance(grid, std::vector<float>(35, 0.0F)))
    ASSERT_EQ(d, Infinity);
  for (const float d : hasp::ChamferDistance(grid, std::vector<float>(35, 1.0F)))
    ASSERT_EQ(d, -Infinity);
  EXPECT_EQ(hasp::ChamferDistance(Grid(glm::ivec3(1)), std::vector<float>{ 0.25F })[0], 0.25F);
}

TEST(ChamferDistance, ALineOf2048DoesNotOverflow)
{
  const auto grid = Grid({ 2048, 1, 1 }, { 0.05, 5, 5 });
  std::vector<float> coverage(2048, 0.0F);
  coverage[0] = 1.0F;
  const auto distance = hasp::ChamferDistance(grid, coverage);
  EXPECT_NEAR(distance[2047], (2047 - 0.5) * 0.05, 0.01); // 2,000 additions of floats
}

TEST(ChamferDistance, WrongInputAndCancellingThrow)
{
  const auto grid = Grid(glm::ivec3(4));
  const std::vector<float> good(64, 0.5F);
  EXPECT_THROW(hasp::ChamferDistance(grid, std::vector<float>(63)), std::invalid_argument);
  for (const float bad : { 1.5F, -0.1F, std::numeric_limits<float>::quiet_NaN() })
  {
    auto values = good;
    values[40] = bad;
    EXPECT_THROW(hasp::ChamferDistance(grid, values), std::invalid_argument);
  }
  EXPECT_THROW(hasp::ChamferDistance(grid, good, [](double) { return false; }), hasp::Cancelled);
}

} // namespace
