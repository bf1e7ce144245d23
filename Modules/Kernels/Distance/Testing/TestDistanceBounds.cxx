// What every distance is held to, whatever the surface: noise, too.
#include "Distance/DistanceBounds.h"

#include "Distance/CoverageDistance.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

using hasp::GridGeometry;

/// visits all pairs of neighbours along an axis: work(index, index of the next, spacing).
template <typename Work>
void OverPairs(const GridGeometry& grid, const Work& work)
{
  const std::int64_t stride[3] = { 1, grid.dims.x, std::int64_t(grid.dims.x) * grid.dims.y };
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        for (int a = 0; a < 3; ++a)
          if (glm::ivec3(i, j, k)[a] + 1 < grid.dims[a])
          {
            const std::int64_t v = i + j * stride[1] + k * stride[2];
            work(v, v + stride[a], grid.spacing[a]);
          }
}

double Steepest(const GridGeometry& grid, const std::vector<float>& distance)
{
  double most = 0.0;
  OverPairs(grid, [&](std::int64_t v, std::int64_t w, double spacing)
    { most = std::max(most, std::abs(double(distance[v]) - distance[w]) / spacing); });
  return most;
}

const GridGeometry Noisy{ { 40, 37, 33 }, glm::dvec3(-20), { 0.5, 0.6, 1.1 }, glm::dmat3(1) };

std::vector<float> Noise(const GridGeometry& grid)
{
  std::mt19937 random(5);
  std::vector<float> noise(grid.Size());
  for (float& value : noise)
    value = float(random() % 1000) / 1000.0F;
  return noise;
}

TEST(DistanceBounds, OfNoiseNoneIsFartherThanTheNearestCrossing)
{
  const std::vector<float> noise = Noise(Noisy);
  constexpr double IsoValue = 0.6205; // no sample is just there
  const auto distance =
    hasp::GreyDistance(hasp::GridView<const float>{ noise.data(), Noisy }, IsoValue);
  double worst = 0.0;
  OverPairs(Noisy,
    [&](std::int64_t v, std::int64_t w, double spacing)
    {
      for (const std::int64_t n : { v, w })
        EXPECT_EQ(std::signbit(distance[n]), noise[n] >= IsoValue)
          << n << " " << distance[n] << " of " << noise[n];
      if ((noise[v] >= IsoValue) == (noise[w] >= IsoValue))
        return;
      const double at = spacing * (noise[v] - IsoValue) / (double(noise[v]) - noise[w]);
      worst =
        std::max({ worst, std::abs(distance[v]) - at, std::abs(distance[w]) - (spacing - at) });
    });
  EXPECT_LT(worst, 1e-5);
  EXPECT_LE(Steepest(Noisy, distance), 1.0101);
}

TEST(DistanceBounds, OfCoverageThatIsNoiseNoNeighboursAreFartherApartThanTheyAre)
{
  const std::vector<float> noise = Noise(Noisy);
  std::vector<float> coverage(noise.size());
  for (std::size_t v = 0; v < noise.size(); ++v)
    coverage[v] = noise[v] >= 0.8F; // specks and holes of single voxels
  EXPECT_LE(Steepest(Noisy, hasp::CoverageDistance(Noisy, coverage)), 1.0101);
  EXPECT_LE(Steepest(Noisy, hasp::CoverageDistanceBand(Noisy, coverage)), 1.0101);
}

TEST(DistanceBounds, OnlyWhatIsWrongMoves)
{
  const GridGeometry grid{ { 9, 3, 3 }, glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  std::vector<float> distance(grid.Size());
  for (std::size_t v = 0; v < distance.size(); ++v)
    distance[v] = float(v % 9) - 4.0F;
  const std::vector<float> right = distance;
  hasp::BoundByNeighbours(grid, 0.0F, distance);
  EXPECT_EQ(distance, right);
  const std::size_t middle = 9 + 27; // row y = 1, z = 1
  distance[middle + 6] = 7.5F;       // 2 is right
  hasp::BoundByNeighbours(grid, 0.0F, distance);
  EXPECT_EQ(distance, right);
  distance[middle + 6] = 7.5F;
  hasp::BoundByNeighbours(grid, 3.0F, distance);
  EXPECT_EQ(distance[middle + 6], 3.0F) << "not below the least";
  distance = right;
  distance[middle + 3] = -3.0F; // -1 is right; across the surface is 0
  hasp::BoundByNeighbours(grid, 0.0F, distance);
  EXPECT_EQ(distance[middle + 3], -1.0F);
}

// Oblique, so that no axis tells that it is too steep.
TEST(DistanceBounds, WhatFallsTooSteeplyInAnyDirectionComesNearer)
{
  const GridGeometry grid{ { 24, 25, 26 }, glm::dvec3(0), { 0.5, 0.6, 0.5 }, glm::dmat3(1) };
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 1.1, 0.9));
  std::vector<float> right(grid.Size()), distance;
  for (std::size_t v = 0; v < right.size(); ++v)
  {
    const glm::dvec3 index(v % 24, v / 24 % 25, v / 600);
    right[v] = float(glm::dot(normal, grid.spacing * (index - glm::dvec3(12))));
  }
  distance = right;
  EXPECT_FALSE(hasp::BoundByNearVoxels(grid, 0.8F, 2.0F, distance));
  EXPECT_EQ(distance, right);
  for (float& value : distance)
    if (value > 0.9F && value < 2.0F)
      value += 0.25F * (value - 0.9F);
  ASSERT_LE(Steepest(grid, distance), 1.01);
  EXPECT_TRUE(hasp::BoundByNearVoxels(grid, 0.8F, 2.0F, distance));
  for (std::size_t v = 0; v < right.size(); ++v)
  {
    const glm::ivec3 index(v % 24, v / 24 % 25, v / 600);
    if (glm::any(glm::lessThan(index, glm::ivec3(6))) || right[v] >= 2.0F)
      continue; // what is near lies beyond the border
    EXPECT_NEAR(distance[v], right[v], 0.05) << v;
  }
}

// So far out floats come in steps of 1/128: a neighbour that is one step farther is 0.0078 away, by
// more than a spacing, and one spacing nearer is rounded to where it was.
TEST(DistanceBounds, AnEndIsFoundWhereFloatsAreCoarserThanVoxels)
{
  const GridGeometry grid{ { 4, 1, 1 }, glm::dvec3(0), { 0.006, 1, 1 }, glm::dmat3(1) };
  const float far = 100000.0F, next = std::nextafter(far, 2e5F);
  std::vector<float> distance{ far, next, far, far };
  hasp::BoundByNeighbours(grid, 0.0F, distance);
  EXPECT_EQ(distance, (std::vector<float>{ far, next, far, far }));
  distance = { std::numeric_limits<float>::infinity(), -5.0F, -5.0F, -5.0F };
  hasp::BoundByNeighbours(grid, 5.0F, distance);
  EXPECT_EQ(distance[1], -5.0F);
}

} // namespace
