#include "Evaluation/SurfaceDistance.h"
#include "Grid/AnalyticVolumes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

hasp::GridGeometry Slices(double mirror = 1.0)
{
  glm::dmat3 d(glm::rotate(glm::dmat4(1), 0.6, glm::normalize(glm::dvec3(1, 3, -2))));
  d[1] *= mirror;
  return { { 40, 41, 28 }, d * glm::dvec3(-19, -19, -20), { 0.957, 0.957, 1.5 }, d };
}

std::vector<glm::dvec3> Around(const glm::dvec3& center, double radius, double spread, int count)
{
  std::mt19937 random(23);
  std::normal_distribution<double> any;
  std::uniform_real_distribution<double> off(-spread, spread);
  std::vector<glm::dvec3> points;
  for (int n = 0; n < count; ++n)
    points.push_back(center + (radius + off(random)) *
                                glm::normalize(glm::dvec3(any(random), any(random), any(random))));
  return points;
}

TEST(SurfaceDistance, PlanesAreExact)
{
  for (const double mirror : { 1.0, -1.0 })
  {
    auto grid = Slices(mirror);
    grid.origin = grid.origin - grid.IndexToWorld(0.5 * glm::dvec3(grid.Cells())); // about 0
    const glm::dvec3 normal = glm::normalize(glm::dvec3(2, -1, 0.5));
    const hasp::AnalyticVolume half{ "half space",
      [=](const glm::dvec3& p) { return 1.3 - glm::dot(p, normal); }, 1 };
    const auto samples = hasp::SampleAnalytic<float>(half, grid, 1, 0);
    const auto points = Around({}, 0, 6, 300);
    const auto found =
      hasp::DistanceToIsosurface(hasp::GridView<const float>{ samples.data(), grid }, 0, points, 9);
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      ASSERT_TRUE(found[n]);
      // Float samples of size 20 carry 1e-6.
      EXPECT_NEAR(found[n]->distance, -half.value(points[n]), 1e-5);
      EXPECT_NEAR(half.value(found[n]->closest), 0, 1e-5);
      EXPECT_NEAR(glm::dot(found[n]->outward, normal), 1, 1e-5);
    }
  }
}

TEST(SurfaceDistance, SpheresWithinAHundredthOfAVoxel)
{
  // The trilinear surface of a sampled sphere lies up to h^2 / (8 R) per axis from the sphere: R is
  // chosen so that this is 0.004 voxels.
  const hasp::GridGeometry grid{ { 30, 30, 30 }, { 25, 25, 25 }, glm::dvec3(1), glm::dmat3(1) };
  const auto sphere = hasp::AnalyticSphere({ -2, -3, 1 }, 66);
  const auto samples = hasp::SampleAnalytic<float>(sphere, grid, 1, 0);
  const hasp::GridView<const float> ct{ samples.data(), grid };
  double worst = 0;
  int count = 0;
  for (const glm::dvec3& p : Around({ 38, 38, 38 }, 3, 3, 800))
  {
    if (std::abs(sphere.value(p)) > 4)
      continue;
    const auto found = hasp::DistanceToIsosurface(ct, 0, std::vector{ p }, 5);
    ASSERT_TRUE(found[0]);
    worst = std::max(worst, std::abs(found[0]->distance + sphere.value(p)));
    ++count;
  }
  EXPECT_GT(count, 300);
  EXPECT_LT(worst, 0.01);
}

TEST(SurfaceDistance, SaddlesWithinACellMatchBruteForce)
{
  // Trilinear fields reproduced exactly by the grid: x y z - c, bent in every direction.
  const hasp::GridGeometry grid{ { 4, 4, 4 }, { -1.5, -1.5, -1.5 }, glm::dvec3(1), glm::dmat3(1) };
  const double c = 0.07;
  const auto value = [=](const glm::dvec3& p) { return p.x * p.y * p.z - c; };
  const auto samples = hasp::SampleAnalytic<float>({ "", value, 1 }, grid, 1, 0);
  const auto points = Around({}, 0.6, 0.6, 60);
  const auto found =
    hasp::DistanceToIsosurface(hasp::GridView<const float>{ samples.data(), grid }, 0, points, 3);
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    // All surface points over a fine mesh of (x, y): z = c / (x y), within the grid.
    double least = 1e9;
    for (int s = 0; s < 600 * 600; ++s)
    {
      const double x = -1.5 + 3.0 * (s % 600) / 599, y = -1.5 + 3.0 * (s / 600) / 599;
      const double z = c / (x * y);
      if (std::abs(z) <= 1.5)
        least = std::min(least, glm::length(glm::dvec3(x, y, z) - points[n]));
    }
    ASSERT_TRUE(found[n]);
    // Ten times less than promised: near the surface's centres of curvature all feet are as good.
    // Brute force is too far by up to (0.005 mm)^2 / (2 d), and by 0.005 where d is small or steep.
    EXPECT_LE(std::abs(found[n]->distance), least + 0.001);
    EXPECT_GE(std::abs(found[n]->distance), least - 0.01);
    EXPECT_EQ(found[n]->distance < 0, value(points[n]) >= 0);
  }
}

TEST(SurfaceDistance, ReachNaNAndEmptyVolumes)
{
  const auto grid = Slices();
  const auto samples =
    hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 10), grid, 100, 226);
  const hasp::GridView<const std::int16_t> ct{ samples.data(), grid };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<glm::dvec3> points{ { 0, 0, 0 }, { nan, 0, 0 }, { 0, 0, 11 }, { 900, 0, 0 },
    { 1e300, -1e12, 0 } };
  const auto found = hasp::DistanceToIsosurface(ct, 226, points, 2);
  EXPECT_FALSE(found[0] || found[1] || found[3] || found[4]);
  ASSERT_TRUE(found[2]);
  EXPECT_NEAR(found[2]->distance, 1, 0.1); // R = 10: h^2 / (8 R) of 1.5 mm voxels, twice
  EXPECT_FALSE(hasp::DistanceToIsosurface(ct, 9999, points, 2)[2]);
  EXPECT_TRUE(hasp::DistanceToIsosurface(ct, 226, {}, 2).empty());
  EXPECT_THROW(hasp::DistanceToIsosurface(ct, nan, points, 2), std::invalid_argument);
  EXPECT_THROW(hasp::DistanceToIsosurface(ct, 226, points, 0), std::invalid_argument);
  EXPECT_THROW(
    hasp::DistanceToIsosurface(ct, 226, points, 2, [](double) { return false; }), hasp::Cancelled);
}

} // namespace
