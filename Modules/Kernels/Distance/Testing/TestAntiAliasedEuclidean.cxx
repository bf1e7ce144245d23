#include "Distance/AntiAliasedEuclidean.h"
#include "Distance/ChamferDistance.h"
#include "Testing/AnalyticCoverage.h"

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

TEST(AntiAliasedEuclidean, ErrsAsPublishedOnSmoothShapes)
{
  const auto grid = Grid(glm::ivec3(56));
  for (const auto& shape : { hasp::AnalyticSphere({ 0.31, -0.22, 0.43 }, 20.3),
         hasp::AnalyticTorus({}, glm::normalize(glm::dvec3(1, 2, 2)), 15, 8) })
  {
    const auto coverage = hasp::AnalyticCoverage(shape, grid);
    const auto distance = hasp::AntiAliasedEuclideanDistance(grid, coverage);
    // Others measured 0.050 to 0.055 rms within 3 voxels, 0.3 at most; 0.017 out to 40.
    EXPECT_NEAR(hasp::ErrorOf(distance, shape, grid, 3).rms, 0.05, 0.012) << shape.name;
    EXPECT_LT(hasp::ErrorOf(distance, shape, grid, 3).most, 0.4) << shape.name;
    EXPECT_LT(hasp::ErrorOf(distance, shape, grid, 40).rms,
      0.2 * hasp::ErrorOf(hasp::ChamferDistance(grid, coverage), shape, grid, 40).rms);
  }
}

TEST(AntiAliasedEuclidean, IsTheNearestPlaneByBruteForce)
{
  const auto grid = Grid({ 23, 19, 17 }, { 0.8, 0.8, 1.1 });
  const auto shape = hasp::AnalyticSphere({ 0.3, 0.2, -0.4 }, 5.2);
  const auto coverage = hasp::AnalyticCoverage(shape, grid);
  const auto distance = hasp::AntiAliasedEuclideanDistance(grid, coverage);
  const auto place = [&](std::size_t v)
  { return glm::dvec3(v % 23, v / 23 % 19, v / 437) * grid.spacing; };
  double worst = 0;
  int asked = 0, missed = 0;
  for (std::size_t v = 0; v < coverage.size(); ++v)
  {
    if (coverage[v] > 0 && coverage[v] < 1)
      continue;
    double least = Infinity;
    for (std::size_t w = 0; w < coverage.size(); ++w)
      if (coverage[w] != coverage[v])
      {
        const double edge = coverage[w] == 1 ? -0.4 : coverage[w] == 0 ? 0.4 : distance[w];
        least =
          std::min(least, glm::distance(place(v), place(w)) + (coverage[v] > 0 ? -edge : edge));
      }
    const double off = std::abs(distance[v]) - least;
    worst = std::max(worst, off);
    ++asked;
    missed += off > 0.01;
    ASSERT_GE(off, -1e-4) << v;
  }
  // Who asks neighbours alone misses the nearest plane now and then: measured 7.7 %, by 0.16 at
  // most. A nearest voxel whose plane lies aside hides one behind it.
  EXPECT_LT(missed, 0.1 * asked);
  EXPECT_LT(worst, 0.2);
}

TEST(AntiAliasedEuclidean, PlanesAcrossAnAxisAreExact)
{
  const auto grid = Grid({ 40, 6, 5 }, { 0.7, 1, 2 });
  std::vector<float> coverage(grid.Size());
  for (std::size_t n = 0; n < coverage.size(); ++n) // until index 17.8
    coverage[n] = n % 40 < 18 ? 1.0F : n % 40 == 18 ? 0.3F : 0.0F;
  const auto distance = hasp::AntiAliasedEuclideanDistance(grid, coverage);
  for (std::size_t n = 0; n < coverage.size(); ++n)
    // The plane's inversion holds two axes at 1e-4 of the box.
    ASSERT_NEAR(distance[n], (double(n % 40) - 17.8) * 0.7, 2e-3) << n;
}

TEST(AntiAliasedEuclidean, EmptyAndFullAreInfinitelyFarAndWrongInputThrows)
{
  const auto grid = Grid({ 7, 1, 5 });
  for (const float d : hasp::AntiAliasedEuclideanDistance(grid, std::vector<float>(35, 0.0F)))
    ASSERT_EQ(d, Infinity);
  for (const float d : hasp::AntiAliasedEuclideanDistance(grid, std::vector<float>(35, 1.0F)))
    ASSERT_EQ(d, -Infinity);
  const std::vector<float> good(35, 0.5F);
  EXPECT_THROW(
    hasp::AntiAliasedEuclideanDistance(grid, std::vector<float>(34)), std::invalid_argument);
  for (const float bad : { 1.5F, -0.1F, std::nanf("") })
  {
    auto values = good;
    values[20] = bad;
    EXPECT_THROW(hasp::AntiAliasedEuclideanDistance(grid, values), std::invalid_argument);
  }
  EXPECT_THROW(
    hasp::AntiAliasedEuclideanDistance(Grid({ 32768, 1, 1 }), std::vector<float>(32768, 0.0F)),
    std::invalid_argument);
  EXPECT_THROW(
    hasp::AntiAliasedEuclideanDistance(grid, good, [](double) { return false; }), hasp::Cancelled);
}

} // namespace
