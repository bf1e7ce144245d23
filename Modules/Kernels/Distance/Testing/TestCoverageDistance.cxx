#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "Distance/SurfaceElements.h"
#include "Testing/AnalyticCoverage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace
{

hasp::GridGeometry Cube(int n)
{
  return { glm::ivec3(n), glm::dvec3(-0.5 * n), glm::dvec3(1), glm::dmat3(1) };
}

TEST(CoverageDistance, PlaneDistanceInvertsTheShareOfABox)
{
  std::mt19937 random(3);
  std::normal_distribution<double> any;
  std::uniform_real_distribution<double> share(0.001, 0.999), side(0.2, 3);
  for (int n = 0; n < 60; ++n)
  {
    glm::dvec3 normal = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
    if (n % 5 == 0)
      normal = glm::normalize(glm::dvec3(0, normal.y, n % 2 ? 0 : normal.z)); // along faces
    const glm::dvec3 sides(side(random), side(random), side(random));
    const double covered = share(random);
    const double d = hasp::PlaneDistanceFromCoverage(normal, sides, covered);
    // Brute force: the box's share with normal.x <= -d, 40^3 points.
    int count = 0;
    for (int s = 0; s < 64000; ++s)
    {
      const glm::dvec3 p = (glm::dvec3(s % 40, s / 40 % 40, s / 1600) + 0.5) / 40.0 - 0.5;
      count += glm::dot(normal, p * sides) <= -d;
    }
    // One layer of 40 may be off where the plane is parallel to a face.
    EXPECT_NEAR(count / 64000.0, covered, 0.026);
    EXPECT_NEAR(hasp::PlaneDistanceFromCoverage(normal, sides, 1 - covered), -d, 1e-7);
  }
}

TEST(CoverageDistance, AxisParallelPlanesAreExact)
{
  const glm::dvec3 sides(0.4, 1, 2);
  // The outward normal is +x; a quarter covered means the plane lies a quarter of the side before
  // the centre, which is then outside. The clamped two axes cost 1e-4 of the box.
  EXPECT_NEAR(hasp::PlaneDistanceFromCoverage({ 1, 0, 0 }, sides, 0.25), 0.1, 1e-4);
  EXPECT_NEAR(hasp::PlaneDistanceFromCoverage({ 0, 0, -1 }, sides, 0.9), -0.8, 1e-3);
}

TEST(CoverageDistance, IsAHundredTimesBetterThanBinaryOnSmoothShapes)
{
  const glm::dvec3 off(0.31, -0.22, 0.43);
  const std::pair<hasp::AnalyticVolume, double> shapes[] = {
    { hasp::AnalyticSphere(off, 20.3), 0.0024 }, { hasp::AnalyticSphere(off, 12.3), 0.0024 },
    { hasp::AnalyticTorus(off, glm::normalize(glm::dvec3(1, 2, 2)), 17, 7), 0.006 }
  };
  for (const auto& [shape, rms] : shapes)
  {
    const auto grid = Cube(56);
    const auto coverage = hasp::AnalyticCoverage(shape, grid);
    const auto distance = hasp::CoverageDistance(grid, coverage);
    std::vector<std::uint8_t> mask(coverage.size());
    std::transform(
      coverage.begin(), coverage.end(), mask.begin(), [](float c) { return c >= 0.5F; });
    const auto error = hasp::ErrorOf(distance, shape, grid, 3);
    const auto binary = hasp::ErrorOf(hasp::SignedEuclideanDistance(grid, mask), shape, grid, 3);
    // Measured 0.001 to 0.002 rms and 0.02 at most, of the torus, rounder than a radius of 12,
    // more; binary 0.24 and 0.5.
    EXPECT_LT(error.rms, rms) << shape.name;
    EXPECT_LT(error.most, 10 * rms + 0.02) << shape.name;
    EXPECT_GT(binary.rms, 0.24 / rms * error.rms) << shape.name;
    // Beyond the band the nearest element answers, bent as the surface is.
    EXPECT_LT(hasp::ErrorOf(distance, shape, grid, 40).rms, 0.02) << shape.name;
  }
}

TEST(CoverageDistance, HoldsItsErrorWhereverTheCentreLies)
{
  // 27 centres, a third of a voxel apart. The bias tells whether planes lie too deep by a twelfth
  // of the curvature: that would be 0.0068.
  double squares = 0, sum = 0, most = 0;
  std::size_t count = 0;
  const auto grid = Cube(36);
  for (int n = 0; n < 27; ++n)
  {
    const glm::dvec3 center = glm::dvec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1) / 3.0 + 0.05;
    const auto shape = hasp::AnalyticSphere(center, 12.3);
    const auto distance = hasp::CoverageDistanceBand(grid, hasp::AnalyticCoverage(shape, grid));
    for (std::size_t v = 0; v < distance.size(); ++v)
    {
      const double truth =
        -shape.value(grid.IndexToWorld(glm::dvec3(v % 36, v / 36 % 36, v / 1296)));
      if (std::abs(truth) > 3.0)
        continue;
      const double error = distance[v] - truth;
      squares += error * error;
      sum += error;
      most = std::max(most, std::abs(error));
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(squares / double(count)), 0.003);
  EXPECT_LT(std::abs(sum / double(count)), 0.001);
  EXPECT_LT(most, 0.04);
}

TEST(CoverageDistance, TheBandIsTheFullFieldWithinFourVoxels)
{
  const hasp::GridGeometry grid{ { 45, 51, 38 }, glm::dvec3(-20, -23, -24), { 0.9, 0.9, 1.3 },
    glm::dmat3(1) };
  const auto shape = hasp::AnalyticTorus({}, glm::normalize(glm::dvec3(1, 2, 2)), 11, 6);
  const auto coverage = hasp::AnalyticCoverage(shape, grid);
  const auto full = hasp::CoverageDistance(grid, coverage);
  const auto band = hasp::CoverageDistanceBand(grid, coverage);
  std::size_t within = 0;
  for (std::size_t v = 0; v < band.size(); ++v)
    if (std::abs(band[v]) < 3.6F)
    {
      ASSERT_EQ(band[v], full[v]) << v;
      ++within;
    }
    else
    {
      ASSERT_EQ(std::abs(band[v]), 3.6F) << v;
      ASSERT_EQ(band[v] < 0, full[v] < 0) << v;
      ASSERT_GE(std::abs(full[v]), 3.3F) << v;
    }
  EXPECT_GT(within, 5000U);
}

/// Of voxels within three voxels of a box: by how far the nearest of its edges' lines is, in [0,
/// 3), [3, 5) and beyond.
struct EdgeErrors
{
  std::array<double, 3> rms{}, most{};
  double inside = 0.0; ///< the most of voxels that are inside
};
EdgeErrors ErrorsAtEdges(const glm::dmat3& axes)
{
  const glm::dvec3 center(0.31, -0.22, 0.43), half(9.3, 12.1, 15.4);
  const auto inBox = [&](const glm::dvec3& p) { return glm::transpose(axes) * (p - center); };
  const hasp::AnalyticVolume box{ "box",
    [&](const glm::dvec3& p)
    {
      const glm::dvec3 q = glm::abs(inBox(p)) - half;
      return -(glm::length(glm::max(q, 0.0)) + std::min(0.0, std::max({ q.x, q.y, q.z })));
    },
    1.0 };
  const auto grid = Cube(56);
  const auto distance = hasp::CoverageDistance(grid, hasp::AnalyticCoverage(box, grid));
  EdgeErrors errors;
  std::array<int, 3> counts{};
  for (std::size_t n = 0; n < distance.size(); ++n)
  {
    const glm::dvec3 p = grid.IndexToWorld(glm::dvec3(n % 56, n / 56 % 56, n / 3136));
    const double truth = -box.value(p), error = std::abs(distance[n] - truth);
    if (std::abs(truth) > 3.0)
      continue;
    glm::dvec3 q = glm::abs(glm::abs(inBox(p)) - half);
    std::sort(&q.x, &q.x + 3);
    const double edge = std::hypot(q.x, q.y);
    const std::size_t part = edge < 3.0 ? 0 : edge < 5.0 ? 1 : 2;
    errors.rms[part] += error * error;
    ++counts[part];
    errors.most[part] = std::max(errors.most[part], error);
    if (truth < 0.0)
      errors.inside = std::max(errors.inside, error);
  }
  for (std::size_t part = 0; part < 3; ++part)
    errors.rms[part] = std::sqrt(errors.rms[part] / counts[part]);
  return errors;
}

TEST(CoverageDistance, SharpEdgesAreWithinTheStatedError)
{
  EdgeErrors worst;
  for (const double turn : { 0.0, 0.3, 0.7, 1.1, 2.0 })
    for (const glm::dvec3& axis : { glm::dvec3(0, 0, 1), glm::dvec3(1, 2, -1) })
    {
      const EdgeErrors errors =
        ErrorsAtEdges(glm::dmat3(glm::rotate(glm::dmat4(1), turn, glm::normalize(axis))));
      for (std::size_t part = 0; part < 3; ++part)
      {
        worst.rms[part] = std::max(worst.rms[part], errors.rms[part]);
        worst.most[part] = std::max(worst.most[part], errors.most[part]);
      }
      worst.inside = std::max(worst.inside, errors.inside);
    }
  for (std::size_t part = 0; part < 3; ++part)
    std::printf("%-24s rms %.3f  most %.3f voxels\n",
      std::array{ "within three of an edge", "within five", "beyond" }[part], worst.rms[part],
      worst.most[part]);
  std::printf("%-24s %21.3f voxels\n", "inside", worst.inside);
  EXPECT_LT(worst.rms[0], 0.2);
  EXPECT_LT(worst.most[0], 0.95);
  EXPECT_LT(worst.inside, 0.9);
  EXPECT_LT(worst.most[2], 0.02);
}

TEST(CoverageDistance, StretchedAndTurnedVoxelsKeepMillimetres)
{
  const glm::dmat3 tilt(glm::rotate(glm::dmat4(1), 0.5, glm::normalize(glm::dvec3(2, -1, 3))));
  const hasp::GridGeometry grid{ { 50, 50, 32 }, tilt * glm::dvec3(-24, -24, -24),
    { 0.957, 0.957, 1.5 }, tilt };
  const auto shape = hasp::AnalyticSphere({ 0.2, 0.1, -0.3 }, 15);
  const auto distance = hasp::CoverageDistance(grid, hasp::AnalyticCoverage(shape, grid));
  EXPECT_LT(hasp::ErrorOf(distance, shape, grid, 3).rms, 0.015);
}

TEST(CoverageDistance, TenTimesLongerVoxelsStillGiveASphere)
{
  const hasp::GridGeometry grid{ { 130, 130, 17 }, glm::dvec3(-19.5, -19.5, -24), { 0.3, 0.3, 3 },
    glm::dmat3(1) };
  const auto shape = hasp::AnalyticSphere({ 0.2, 0.1, -0.3 }, 15);
  const auto distance = hasp::CoverageDistance(grid, hasp::AnalyticCoverage(shape, grid));
  // At the poles a slice of 3 mm hides h^2 / (8 R), 0.075 mm or a quarter of the smallest spacing,
  // of curvature; beside them it shows.
  EXPECT_LT(hasp::ErrorOf(distance, shape, grid, 3).rms, 0.25);
}

TEST(CoverageDistance, ASingleSliceGivesTheDistanceInThePlane)
{
  const hasp::GridGeometry grid{ { 60, 60, 1 }, glm::dvec3(-29.5, -29.5, 0), glm::dvec3(1),
    glm::dmat3(1) };
  const hasp::AnalyticVolume disc{ "disc",
    [](const glm::dvec3& p) { return 14.3 - std::hypot(p.x - 0.3, p.y + 0.2); }, 1 };
  const auto distance = hasp::CoverageDistance(grid, hasp::AnalyticCoverage(disc, grid));
  EXPECT_LT(hasp::ErrorOf(distance, disc, grid, 3).rms, 0.01);
}

TEST(CoverageDistance, FlatSlicesStillGiveAPlane)
{
  const hasp::GridGeometry grid{ { 30, 30, 9 }, {}, { 0.3, 0.3, 3 }, glm::dmat3(1) };
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 0.5, 0.05));
  const hasp::AnalyticVolume half{ "half space",
    [=](const glm::dvec3& p) { return glm::dot(glm::dvec3(4.4, 4.2, 12) - p, normal); }, 1 };
  const auto distance = hasp::CoverageDistance(grid, hasp::AnalyticCoverage(half, grid));
  // Interior voxels: at the grid's border the gradient sees clamped copies.
  for (int k = 2; k < 7; ++k)
    for (int j = 5; j < 25; ++j)
      for (int i = 5; i < 25; ++i)
      {
        const double truth = -half.value(grid.IndexToWorld({ i, j, k }));
        if (std::abs(truth) < 0.9)
        {
          ASSERT_NEAR(distance[(k * 30 + j) * 30 + i], truth, 0.03) << i << " " << j << " " << k;
        }
      }
}

TEST(CoverageDistance, EmptyAndFullAreInfinitelyFar)
{
  const auto grid = Cube(4);
  constexpr float far = std::numeric_limits<float>::infinity();
  for (const float d : hasp::CoverageDistance(grid, std::vector<float>(64, 0.0F)))
    ASSERT_EQ(d, far);
  for (const float d : hasp::CoverageDistance(grid, std::vector<float>(64, 1.0F)))
    ASSERT_EQ(d, -far);
}

TEST(CoverageDistance, ABinaryImageIsACoverageImageToo)
{
  const auto grid = Cube(12);
  std::vector<float> coverage(grid.Size());
  for (std::size_t n = 0; n < coverage.size(); ++n)
    coverage[n] = n % 12 < 5 ? 1.0F : 0.0F;
  const auto distance = hasp::CoverageDistance(grid, coverage);
  for (std::size_t n = 0; n < coverage.size(); ++n)
    ASSERT_NEAR(distance[n], double(n % 12) - 4.5, 1e-5);
}

/// What a scanner makes of coverage: blurred along each axis by sigma voxels, and noisy.
std::vector<float> Scanned(std::vector<float> image, int n, double sigma, double noise)
{
  for (std::size_t stride = 1; stride < image.size(); stride *= n)
  {
    std::vector<float> blurred(image.size(), 0.0F);
    for (std::size_t v = 0; v < image.size(); ++v)
    {
      double sum = 0, weights = 0;
      for (int d = -4; d <= 4; ++d)
        if (const int at = int(v / stride % n) + d; at >= 0 && at < n)
        {
          const double w = std::exp(-0.5 * d * d / (sigma * sigma));
          weights += w;
          sum += w * image[v + d * std::ptrdiff_t(stride)];
        }
      blurred[v] = static_cast<float>(sum / weights);
    }
    image.swap(blurred);
  }
  std::mt19937 random(11);
  std::normal_distribution<double> any(0, noise);
  for (float& v : image)
    v += static_cast<float>(noise > 0 ? any(random) : 0.0);
  return image;
}

std::vector<float> Clamped(std::vector<float> image)
{
  for (float& v : image)
    v = std::clamp(v, 0.0F, 1.0F);
  return image;
}

TEST(CoverageDistance, GreyScansAndNoiseAreNotTakenForCoverage)
{
  const auto grid = Cube(48);
  const auto shape = hasp::AnalyticSphere({ 0.3, -0.2, 0.4 }, 15.3);
  const auto coverage = hasp::AnalyticCoverage(shape, grid);
  for (const double sigma : { 0.5, 0.8, 1.5 })
    for (const double noise : { 0.0, 0.03 })
    {
      const auto scan = Scanned(coverage, 48, sigma, noise);
      EXPECT_THROW(hasp::CoverageDistance(grid, Clamped(scan)), std::invalid_argument)
        << sigma << " " << noise;
    }
  auto noisy = coverage;
  std::mt19937 random(2);
  std::normal_distribution<float> any(0, 0.03F);
  for (float& v : noisy)
    v += any(random);
  EXPECT_THROW(hasp::CoverageDistanceBand(grid, Clamped(noisy)), std::invalid_argument);
  EXPECT_THROW(hasp::CoverageDistance(grid, noisy), std::invalid_argument); // beyond [0,1]
  EXPECT_THROW(hasp::CoverageDistance(grid, std::vector<float>(3)), std::invalid_argument);
  // And coverage is taken for what it is, even of a plate of half a voxel and of spongy bone.
  const hasp::AnalyticVolume plate{ "plate",
    [](const glm::dvec3& p)
    { return 0.3 - std::abs(glm::dot(p, glm::normalize(glm::dvec3(1, 2, 4)))); },
    1 };
  for (const auto& thin : { plate, hasp::AnalyticTrabecular(20, 3, 8) })
    EXPECT_NO_THROW(hasp::CoverageDistance(grid, hasp::AnalyticCoverage(thin, grid))) << thin.name;
}

// The other side of a wall looks like a slope that goes on.
TEST(CoverageDistance, WallsOfAnyThicknessAndPoseAreCoverage)
{
  const auto grid = Cube(32);
  std::mt19937 random(3);
  std::normal_distribution<double> any;
  for (const double thick : { 0.6, 1.0, 1.6, 2.0, 2.5, 3.0, 4.0 }) // voxels
    for (int n = 0; n < 6; ++n)
    {
      const glm::dvec3 normal = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
      const hasp::AnalyticVolume wall{ "",
        [&](const glm::dvec3& p) { return 0.5 * thick - std::abs(glm::dot(p, normal) - 0.1 * n); },
        1 };
      EXPECT_TRUE(hasp::MeasureEdges(grid, hasp::AnalyticCoverage(wall, grid)).Coverage())
        << thick << ": " << normal.x << " " << normal.y << " " << normal.z;
    }
}

TEST(CoverageDistance, AGreyScanIsMeasuredAsItIs)
{
  const auto grid = Cube(48);
  const auto shape = hasp::AnalyticSphere({ 0.3, -0.2, 0.4 }, 15.3);
  const auto coverage = hasp::AnalyticCoverage(shape, grid);
  const auto scan = Clamped(Scanned(coverage, 48, 0.8, 0));
  const hasp::GridView<const float> image{ scan.data(), grid };
  const auto grey = hasp::GreyDistance(image, 0.5);
  // The blur draws the surface in by sigma^2 / R = 0.042, the trilinear surface by 1 / (6 R) at
  // most.
  const auto error = hasp::ErrorOf(grey, shape, grid, 3);
  EXPECT_LT(error.rms, 0.042 + 0.011 + 0.01);
  EXPECT_LT(error.most, 0.12);
  // Who does not know what the image is gets the same, and of coverage what coverage gives.
  EXPECT_EQ(hasp::ImageDistance(image), grey);
  EXPECT_EQ(hasp::ImageDistance({ coverage.data(), grid }), hasp::CoverageDistance(grid, coverage));
  // Units of the samples do not matter.
  std::vector<std::int16_t> hounsfield(scan.size());
  for (std::size_t v = 0; v < scan.size(); ++v)
    hounsfield[v] = static_cast<std::int16_t>(std::lround(1000 + 20000 * scan[v]));
  const auto scaled =
    hasp::GreyDistance(hasp::GridView<const std::int16_t>{ hounsfield.data(), grid }, 11000);
  for (std::size_t v = 0; v < scan.size(); ++v)
    if (std::abs(grey[v]) < 3.0F) // farther out another element may answer
    {
      ASSERT_NEAR(scaled[v], grey[v], 0.005) << v;
    }
  auto tiny = scan; // kg / mm^3, say
  for (float& value : tiny)
    value *= 0x1p-30F;
  EXPECT_EQ(
    hasp::GreyDistance(hasp::GridView<const float>{ tiny.data(), grid }, 0.5 * 0x1p-30), grey);
  auto holes = scan;
  holes[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(hasp::GreyDistance(hasp::GridView<const float>{ holes.data(), grid }, 0.5),
    std::invalid_argument);
  EXPECT_THROW(hasp::GreyDistance(image, std::nan("")), std::invalid_argument);
}

TEST(CoverageDistance, NoiseOfAScanIsSmoothedAndTheSurfaceStaysWhereItIs)
{
  const auto grid = Cube(52);
  const auto shape = hasp::AnalyticSphere({ 0.3, -0.2, 0.4 }, 20.3);
  const auto coverage = hasp::AnalyticCoverage(shape, grid);
  const auto still = Scanned(coverage, 52, 0.8, 0), noisy = Scanned(coverage, 52, 0.8, 0.03);
  const auto truth = hasp::GreyDistance(hasp::GridView<const float>{ still.data(), grid }, 0.5);
  const auto found = hasp::GreyDistance(hasp::GridView<const float>{ noisy.data(), grid }, 0.5);
  double squares = 0, sum = 0, count = 0;
  for (std::size_t v = 0; v < truth.size(); ++v)
    if (std::abs(truth[v]) < 3)
    {
      squares += std::pow(found[v] - truth[v], 2);
      sum += found[v] - truth[v];
      ++count;
    }
  // Measured 0.024; fits to 27 elements alone leave 0.034.
  EXPECT_LT(std::sqrt(squares / count), 0.028);
  EXPECT_LT(std::abs(sum / count), 0.004);
}

TEST(CoverageDistance, ThinSheetsAndSpecksStayFinite)
{
  const auto grid = Cube(16);
  std::vector<float> coverage(grid.Size(), 0.0F);
  for (int n = 0; n < 256; ++n)
    coverage[8 * 256 + n] = 0.4F; // thinner than a voxel: no gradient on its middle
  coverage[3 * 256 + 100] = 0.2F;
  for (const float d : hasp::CoverageDistance(grid, coverage))
    ASSERT_TRUE(std::isfinite(d) && d > -1.0F);
}

} // namespace
