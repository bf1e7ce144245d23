#include "Distance/EuclideanDistance.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

constexpr float Infinity = std::numeric_limits<float>::infinity();

hasp::GridGeometry Grid(const glm::ivec3& dims, const glm::dvec3& spacing)
{
  return { dims, { 5, -3, 2 }, spacing, glm::dmat3(1) };
}

glm::dvec3 Position(const hasp::GridGeometry& g, std::size_t n)
{
  const std::size_t row = g.dims.x, slice = row * g.dims.y;
  return glm::dvec3(n % row, n / row % g.dims.y, n / slice) * g.spacing;
}

TEST(EuclideanDistance, NearestSeedsMatchBruteForce)
{
  std::mt19937 random(7);
  // Odd sizes, sizes of one, more than one block of lines, and stretched voxels.
  const std::pair<glm::ivec3, glm::dvec3> cases[] = { { { 33, 7, 5 }, { 1, 1, 1 } },
    { { 19, 13, 11 }, { 0.957, 0.957, 1.5 } }, { { 17, 16, 9 }, { 0.3, 0.3, 3 } },
    { { 1, 21, 6 }, { 2, 0.5, 1 } }, { { 40, 1, 1 }, { 0.1, 7, 7 } },
    { { 5, 4, 37 }, { 3, 2, 1 } } };
  for (const auto& [dims, spacing] : cases)
    for (const double density : { 0.003, 0.05, 0.6 })
    {
      const auto grid = Grid(dims, spacing);
      std::vector<std::uint8_t> seeds(grid.Size());
      std::bernoulli_distribution chance(density);
      for (auto& s : seeds)
        s = chance(random);
      seeds[seeds.size() / 2] = 1;
      const auto map = hasp::NearestSeeds(grid, seeds);
      for (std::size_t n = 0; n < seeds.size(); ++n)
      {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t m = 0; m < seeds.size(); ++m)
          if (seeds[m])
          {
            const glm::dvec3 d = Position(grid, n) - Position(grid, m);
            least = std::min(least, glm::dot(d, d));
          }
        // Floats hold the running sums: three roundings of 6e-8 each.
        ASSERT_NEAR(map.squared[n], least, 3e-7 * least) << n;
        ASSERT_TRUE(seeds.at(map.seed[n]));
        const glm::dvec3 d = Position(grid, n) - Position(grid, map.seed[n]);
        ASSERT_NEAR(glm::dot(d, d), least, 3e-7 * least) << n;
      }
    }
}

TEST(EuclideanDistance, SignedDistancesMatchBruteForce)
{
  std::mt19937 random(9);
  for (const double density : { 0.02, 0.4, 0.97 })
  {
    const auto grid = Grid({ 19, 13, 11 }, { 0.957, 0.5, 1.5 });
    std::vector<std::uint8_t> inside(grid.Size());
    std::bernoulli_distribution chance(density);
    for (auto& s : inside)
      s = chance(random);
    inside[7] = 1;
    inside[8] = 0;
    const auto distance = SignedEuclideanDistance(grid, inside);
    for (std::size_t n = 0; n < inside.size(); ++n)
    {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t m = 0; m < inside.size(); ++m)
        if (inside[m] != inside[n])
          least = std::min(least, glm::length(Position(grid, n) - Position(grid, m)));
      ASSERT_NEAR(distance[n], (inside[n] ? -1 : 1) * (least - 0.25), 1e-5) << n;
    }
  }
}

TEST(EuclideanDistance, EmptyAndFullMasksAreInfinitelyFar)
{
  const auto grid = Grid({ 5, 7, 3 }, { 1, 2, 0.5 });
  const auto map = hasp::NearestSeeds(grid, std::vector<std::uint8_t>(grid.Size(), 0));
  for (std::size_t n = 0; n < grid.Size(); ++n)
  {
    ASSERT_EQ(map.squared[n], Infinity);
    ASSERT_EQ(map.seed[n], hasp::FeatureTransform::NoSeed);
  }
  for (const float d : SignedEuclideanDistance(grid, std::vector<std::uint8_t>(grid.Size(), 0)))
    ASSERT_EQ(d, Infinity);
  for (const float d : SignedEuclideanDistance(grid, std::vector<std::uint8_t>(grid.Size(), 1)))
    ASSERT_EQ(d, -Infinity);
}

TEST(EuclideanDistance, AHalfSpaceIsExactOnBothSides)
{
  const auto grid = Grid({ 20, 3, 3 }, { 0.5, 1, 1 });
  std::vector<std::uint8_t> inside(grid.Size());
  for (std::size_t n = 0; n < inside.size(); ++n)
    inside[n] = n % 20 < 8; // the surface lies at index 7.5
  const auto d = SignedEuclideanDistance(grid, inside);
  for (std::size_t n = 0; n < inside.size(); ++n)
    ASSERT_FLOAT_EQ(d[n], static_cast<float>((double(n % 20) - 7.5) * 0.5));
}

TEST(EuclideanDistance, WrongSizesAndCancellingThrow)
{
  const auto grid = Grid({ 4, 4, 4 }, { 1, 1, 1 });
  EXPECT_THROW(NearestSeeds(grid, std::vector<std::uint8_t>(63)), std::invalid_argument);
  EXPECT_THROW(NearestSeeds(Grid({ 4, 4, 4 }, { 1, 0, 1 }), std::vector<std::uint8_t>(64)),
    std::invalid_argument);
  EXPECT_THROW(NearestSeeds(grid, std::vector<std::uint8_t>(64), [](double) { return false; }),
    hasp::Cancelled);
}

} // namespace
