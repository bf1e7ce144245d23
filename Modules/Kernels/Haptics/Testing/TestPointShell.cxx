#include "Haptics/PointShell.h"
#include "Haptics/Testing/SampledDistance.h"

#include "Grid/Trilinear.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

namespace
{

using namespace hasp::testing;
using hasp::ContactPoints;
using hasp::GridGeometry;
using hasp::PointShell;
using hasp::SurfacePoint;

constexpr float Nan = std::numeric_limits<float>::quiet_NaN();

/// A level's points without the padding.
std::vector<SurfacePoint> RealPoints(const ContactPoints& p)
{
  std::vector<SurfacePoint> points;
  for (std::uint32_t n = 0; n < p.count; ++n)
    if (p.x[n] != ContactPoints::FarAway)
      points.push_back({ { p.x[n], p.y[n], p.z[n] }, { p.nx[n], p.ny[n], p.nz[n] } });
  return points;
}

std::vector<SurfacePoint> Prefix(const PointShell& shell, int levels)
{
  std::vector<SurfacePoint> all;
  for (int level = 0; level < levels; ++level)
    for (const SurfacePoint& p : RealPoints(shell.Level(level)))
      all.push_back(p);
  return all;
}

float NearestTo(const glm::vec3& place, const std::vector<SurfacePoint>& points, bool notItself)
{
  float least = std::numeric_limits<float>::max();
  for (const SurfacePoint& p : points)
    if (const float d = glm::distance(place, p.position); !(notItself && d == 0.0F))
      least = std::min(least, d);
  return least;
}

/// The spacing of `count` points in the densest packing there is on a plane of that area.
double HexagonalSpacing(double area, std::size_t count)
{
  return std::sqrt(2.0 * area / (std::numbers::sqrt3 * static_cast<double>(count)));
}

TEST(PointShell, RefusesWhatItCannotBeMadeOf)
{
  const SampledDistance ball(Ball({}, 4.0), CubeGrid(12));
  EXPECT_THROW(PointShell::OfSurface(ball.View(), {}, { 0, 256, 1 }), std::invalid_argument);
  EXPECT_THROW(PointShell::OfSurface(ball.View(), {}, { 1 << 30, 256, 1 }), std::invalid_argument);
  EXPECT_THROW(PointShell::OfSurface(ball.View(), {}, { 100, 0, 1 }), std::invalid_argument);
  EXPECT_THROW(PointShell::OfSurface(ball.View(), { 0, 0, Nan }), std::invalid_argument);
  GridGeometry flat = ball.geometry;
  flat.spacing.y = 0.0;
  EXPECT_THROW(PointShell::OfSurface({ ball.samples.data(), flat }, {}), std::invalid_argument);

  const auto of = [](const SurfacePoint& p, double area)
  { return PointShell::OfPoints(std::span(&p, 1), area, {}); };
  EXPECT_THROW(of({ { 0, Nan, 0 }, { 0, 0, 1 } }, 1.0), std::invalid_argument);
  EXPECT_THROW(of({ { 0, 0, 0 }, { 0, 0, 1.01F } }, 1.0), std::invalid_argument);
  EXPECT_THROW(of({ { 0, 0, 0 }, { 0, 0, Nan } }, 1.0), std::invalid_argument);
  for (const double area : { 0.0, -1.0, double(Nan), 1.0 / 0.0 })
    EXPECT_THROW(of({ { 0, 0, 0 }, { 0, 0, 1 } }, area), std::invalid_argument);
  EXPECT_NO_THROW(of({ { 0, 0, 0 }, { 0, 0, 1 } }, 1.0));
}

TEST(PointShell, IsCancelledWhereverItIs)
{
  const SampledDistance ball(Ball({}, 9.0), CubeGrid(26));
  const hasp::PointShellSettings settings{ 1000, 100, 1 };
  double last = -1.0;
  int calls = 0;
  PointShell::OfSurface(ball.View(), {}, settings,
    [&](double share)
    {
      EXPECT_GE(share, last);
      last = share;
      ++calls;
      return true;
    });
  EXPECT_EQ(last, 1.0);
  ASSERT_GT(calls, 6);
  for (int stop = 0; stop < calls; ++stop)
  {
    int left = stop;
    EXPECT_THROW(
      PointShell::OfSurface(ball.View(), {}, settings, [&](double) { return left-- > 0; }),
      hasp::Cancelled);
  }
}

TEST(PointShell, HasNoPointsWithoutASurface)
{
  SampledDistance field(Ball({}, 4.0), CubeGrid(12));
  for (const float value : { 1.0F, -1.0F, Nan, std::numeric_limits<float>::infinity() })
  {
    std::fill(field.samples.begin(), field.samples.end(), value);
    const auto shell = PointShell::OfSurface(field.View(), {});
    EXPECT_EQ(shell->Levels(), 0);
    EXPECT_EQ(shell->SurfaceArea(), 0.0);
    EXPECT_EQ(shell->Radius(), 0.0F);
    hasp::ResourceList list;
    shell->ListResources(list);
    EXPECT_EQ(list.at(0).bytes, 0U);
  }
  field.geometry.dims = { 12, 12, 1 }; // no cells, no surface
  EXPECT_EQ(PointShell::OfSurface(field.View(), {})->Levels(), 0);
  EXPECT_EQ(PointShell::OfPoints({}, 0.0, {})->Levels(), 0);
}

TEST(PointShell, LevelsAreFourTimesAsLongEach)
{
  const SampledDistance ball(Ball({}, 9.0), CubeGrid(26));
  const auto ends = [&](int points, int coarsest)
  {
    const auto shell = PointShell::OfSurface(ball.View(), {}, { points, coarsest, 1 });
    std::vector<std::uint32_t> found;
    for (int level = 0; level < shell->Levels(); ++level)
    {
      found.push_back(shell->LevelEnd(level));
      EXPECT_EQ(Prefix(*shell, level + 1).size(), found.back());
    }
    return found;
  };
  using Ends = std::vector<std::uint32_t>;
  EXPECT_EQ(ends(4096, 256), (Ends{ 256, 1024, 4096 }));
  EXPECT_EQ(ends(4097, 256), (Ends{ 256, 1024, 4096, 4097 }));
  EXPECT_EQ(ends(1000, 100), (Ends{ 100, 400, 1000 }));
  EXPECT_EQ(ends(77, 256), (Ends{ 77 }));
  EXPECT_EQ(ends(16, 1), (Ends{ 1, 4, 16 }));
  EXPECT_EQ(ends(1, 1), (Ends{ 1 }));
}

TEST(PointShell, ItsArraysAreAsTheKernelsReadThem)
{
  const SampledDistance ball(Ball({}, 9.0), SkewGrid({ 34, 24, 20 }));
  for (const int points : { 1, 5, 16, 100, 777, 2000 })
  {
    const auto shell = PointShell::OfSurface(ball.View(), {}, { points, 100, 1 });
    std::size_t bytes = 0;
    for (int level = 0; level < shell->Levels(); ++level)
    {
      const ContactPoints p = shell->Level(level);
      ASSERT_EQ(p.count % ContactPoints::Lanes, 0U);
      for (const float* column : { p.x, p.y, p.z, p.nx, p.ny, p.nz })
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(column) % 64, 0U);
      EXPECT_EQ(p.areas, nullptr);
      EXPECT_NEAR(p.area, shell->SurfaceArea() / shell->LevelEnd(level), 1e-6 * p.area);
      const std::uint32_t real =
        shell->LevelEnd(level) - (level == 0 ? 0 : shell->LevelEnd(level - 1));
      EXPECT_EQ(p.count, (real + 15) / 16 * 16);
      for (std::uint32_t n = real; n < p.count; ++n)
        for (const float* column : { p.x, p.y, p.z })
          EXPECT_EQ(column[n], ContactPoints::FarAway);
      std::uint32_t next = 0; // clusters are all of the level, one after the other
      for (const hasp::PointCluster& cluster : shell->Clusters(level))
      {
        EXPECT_EQ(cluster.first, next);
        next += cluster.count;
        EXPECT_EQ(cluster.count, 16U);
        for (std::uint32_t n = cluster.first; n < std::min(next, real); ++n)
          EXPECT_LE(
            glm::distance(cluster.center, glm::vec3(p.x[n], p.y[n], p.z[n])), cluster.radius);
        bytes += sizeof(hasp::PointCluster);
      }
      EXPECT_EQ(next, p.count);
      bytes += 24U * p.count;
    }
    hasp::ResourceList list;
    shell->ListResources(list);
    EXPECT_EQ(list.at(0).bytes, bytes);
    EXPECT_EQ(Prefix(*shell, shell->Levels()).size(), static_cast<std::size_t>(points));
  }
}

TEST(PointShell, LiesOnTheTrilinearSurfaceAroundTheBodysOrigin)
{
  const GridGeometry g = SkewGrid({ 48, 34, 26 });
  const glm::dvec3 center{ 1.0, 0.5, 0.0 }, origin{ 2.0, -1.0, 3.0 };
  const SampledDistance ball(Ball(center, 9.0), g);
  const auto shell = PointShell::OfSurface(ball.View(), origin, { 2000, 256, 1 });
  float farthest = 0.0F;
  for (const SurfacePoint& p : Prefix(*shell, shell->Levels()))
  {
    const glm::dvec3 world = origin + glm::dvec3(p.position);
    const auto value = hasp::SampleTrilinear(ball.View(), g.WorldToIndex(world));
    ASSERT_TRUE(value);
    EXPECT_NEAR(*value, 0.0, 2e-6); // a position's last digits
    EXPECT_NEAR(glm::length(p.normal), 1.0, 1e-6);
    // Interpolated gradients are off by half a spacing times the curvature, each axis.
    EXPECT_LT(glm::distance(glm::dvec3(p.normal), glm::normalize(world - center)),
      0.5 * (0.7 + 1.1 + 1.6) / 9.0);
    farthest = std::max(farthest, glm::length(p.position));
  }
  EXPECT_GE(shell->Radius(), farthest);
  EXPECT_LT(shell->Radius(), farthest * 1.001F);
}

TEST(PointShell, KnowsTheSurfacesArea)
{
  for (const GridGeometry& g : { CubeGrid(26), SkewGrid({ 48, 34, 26 }), CubeGrid(101, 0.25) })
  {
    const SampledDistance ball(Ball({ 0.3, 0.2, 0.1 }, 9.0), g);
    const double area = PointShell::OfSurface(ball.View(), {}, { 64, 64, 1 })->SurfaceArea();
    const double truth = 4.0 * std::numbers::pi * 81.0;
    // Corners and chords of triangles as wide as a cell's diagonal h lie h^2/8r below the sphere:
    // h^2/4r^2 of the area; their tilt by up to h/2r shortens it by h^2/8r^2 more.
    const double h = glm::length(g.spacing);
    EXPECT_NEAR(area / truth, 1.0, 0.375 * h * h / 81.0);
  }
  // A tilted plane's cut through the whole grid is known exactly.
  const GridGeometry box{ { 21, 16, 11 }, {}, { 0.5, 1.0, 2.0 }, glm::dmat3(1.0) };
  const double tilt = 0.3;
  const SampledDistance plane(
    HalfSpace({ 5.0, 7.0, 0.0 }, { std::cos(tilt), std::sin(tilt), 0.0 }), box);
  const double area = PointShell::OfSurface(plane.View(), {}, { 64, 64, 1 })->SurfaceArea();
  EXPECT_NEAR(area, 15.0 / std::cos(tilt) * 20.0, 1e-4); // float samples
}

TEST(PointShell, EveryPrefixIsSpreadEvenly)
{
  const SampledDistance bodies[] = { { Ball({}, 20.0), CubeGrid(48) },
    { Ball({ 0.3, 0.2, 0.1 }, 9.0), SkewGrid({ 48, 34, 26 }) },
    { Torus({ 0, 0.6, 0.8 }, 12.0, 5.0), CubeGrid(44) } };
  for (const SampledDistance& body : bodies)
  {
    const auto shell = PointShell::OfSurface(body.View(), {}, { 3000, 64, 1 });
    const std::vector<SurfacePoint> all = Prefix(*shell, shell->Levels());
    for (int level = 0; level < shell->Levels(); ++level)
    {
      const std::vector<SurfacePoint> prefix = Prefix(*shell, level + 1);
      const double spacing = HexagonalSpacing(shell->SurfaceArea(), prefix.size());
      double nearest = 1e9, hole = 0.0;
      for (const SurfacePoint& p : prefix)
        nearest = std::min<double>(nearest, NearestTo(p.position, prefix, true));
      for (std::size_t n = 0; n < all.size(); n += 3)
        hole = std::max<double>(hole, NearestTo(all[n].position, prefix, false));
      // Of the densest packing's spacing: 1 and 0.577 for the packing itself. Random points would
      // have 0.02 and 1.5; what elimination reaches on a plane is 0.7 and 0.85 (Yuksel 2015).
      // Chords on bodies that bend are shorter than the surface between, by up to 5 % on the first
      // level.
      EXPECT_GT(nearest / spacing, 0.6) << level;
      EXPECT_LT(hole / spacing, 0.95) << level;
    }
  }
}

TEST(PointShell, BothSidesOfAPlateAreEven)
{
  // 1 mm thick, 40 mm wide: neighbours across are nearer than neighbours along.
  const SampledDistance plate(
    [](const glm::dvec3& p) { return std::abs(p.z) - 0.5; }, CubeGrid(41));
  const auto shell = PointShell::OfSurface(plate.View(), {}, { 1000, 250, 1 });
  EXPECT_NEAR(shell->SurfaceArea(), 2.0 * 40.0 * 40.0, 0.01);
  std::vector<SurfacePoint> above;
  for (const SurfacePoint& p : RealPoints(shell->Level(0)))
    if (p.normal.z > 0.0F)
      above.push_back(p);
  EXPECT_NEAR(static_cast<double>(above.size()), 125.0, 6.0); // a rim of odd length shifts a few
  double nearest = 1e9;
  for (const SurfacePoint& p : above)
    nearest = std::min<double>(nearest, NearestTo(p.position, above, true));
  // As even as a single sheet: see EveryPrefixIsSpreadEvenly.
  EXPECT_GT(nearest / HexagonalSpacing(1600.0, above.size()), 0.6);
}

TEST(PointShell, NeighboursInMemoryAreNeighboursInSpace)
{
  const SampledDistance ball(Ball({}, 20.0), CubeGrid(48));
  const auto shell = PointShell::OfSurface(ball.View(), {}, { 8192, 512, 1 });
  const int level = shell->Levels() - 1;
  const std::vector<SurfacePoint> points = RealPoints(shell->Level(level));
  const double spacing = std::sqrt(shell->SurfaceArea() / static_cast<double>(points.size()));
  double step = 0.0, radius = 0.0;
  for (std::size_t n = 1; n < points.size(); ++n)
    step += glm::distance(points[n].position, points[n - 1].position) / (points.size() - 1.0);
  for (const hasp::PointCluster& cluster : shell->Clusters(level))
    radius += cluster.radius / static_cast<double>(shell->Clusters(level).size());
  // 16 points in a patch of 4 x 4 spacings, in any order: 2.1 apart. In random order it would
  // be 60.
  EXPECT_LT(step / spacing, 3.0);
  // A square patch of 16: half a diagonal of 4 sqrt 2. Halves of a cut are not all square.
  EXPECT_LT(radius / spacing, 0.5 * 4.0 * std::numbers::sqrt2 * 1.3);
}

TEST(PointShell, OfASingleVoxel)
{
  SampledDistance voxel(Ball({}, 4.0), SkewGrid({ 5, 5, 5 }));
  std::fill(voxel.samples.begin(), voxel.samples.end(), 1.0F);
  voxel.samples[62] = -1.0F;
  const auto shell = PointShell::OfSurface(voxel.View(), {}, { 500, 32, 1 });
  ASSERT_EQ(shell->Levels(), 3);
  EXPECT_GT(shell->LevelEnd(2), 490U); // a few may lie where the field has no slope
  for (const SurfacePoint& p : Prefix(*shell, 3))
  {
    const glm::dvec3 off = voxel.geometry.WorldToIndex(p.position) - glm::dvec3(2.0);
    EXPECT_LE(std::max({ std::abs(off.x), std::abs(off.y), std::abs(off.z) }), 0.51);
    EXPECT_GT(glm::dot(p.normal, p.position), 0.0F);
  }
}

TEST(PointShell, OfGivenPointsKeepsThem)
{
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  std::vector<SurfacePoint> given(3000);
  for (SurfacePoint& p : given)
  {
    p.normal = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
    p.position = glm::vec3(100, 200, 300) + 10.0F * p.normal;
  }
  const double area = 400.0 * std::numbers::pi;
  const auto all = PointShell::OfPoints(given, area, { 100, 200, 300 }, { 3000, 256, 1 });
  EXPECT_EQ(all->SurfaceArea(), area);
  EXPECT_EQ(all->LevelEnd(all->Levels() - 1), 3000U);
  EXPECT_NEAR(all->Radius(), 10.0F, 1e-4);
  const auto some = PointShell::OfPoints(given, area, { 100, 200, 300 }, { 500, 100, 1 });
  EXPECT_EQ(some->LevelEnd(some->Levels() - 1), 500U);
  for (const SurfacePoint& p : Prefix(*some, some->Levels()))
  {
    const auto same = [&](const SurfacePoint& g)
    { return glm::distance(g.position - glm::vec3(100, 200, 300), p.position) < 1e-4F; };
    EXPECT_TRUE(std::any_of(given.begin(), given.end(), same));
  }
}

TEST(PointShell, OddHeapsOfPointsAreTakenInTheirStride)
{
  const auto heap = [](const glm::vec3& step, double area)
  {
    std::vector<SurfacePoint> points(20'000);
    for (std::size_t n = 0; n < points.size(); ++n)
      points[n] = { static_cast<float>(n) * step, { 0, 0, 1 } };
    return PointShell::OfPoints(points, area, {}, { 1000, 250, 1 });
  };
  for (const double area : { 1e-300, 1e-9, 1.0, 1e9, 1e300 })
    for (const glm::vec3& step : { glm::vec3(0), glm::vec3(0.01F, 0.02F, 0.0F), glm::vec3(1e6F) })
    {
      const auto shell = heap(step, area);
      EXPECT_EQ(Prefix(*shell, 2).size(), 1000U);
      for (const hasp::PointCluster& cluster : shell->Clusters(1))
        EXPECT_TRUE(std::isfinite(cluster.radius));
    }
}

TEST(PointShell, IsTheSameEachTimeAndAnotherForAnotherSeed)
{
  const SampledDistance ball(Ball({}, 9.0), CubeGrid(26));
  const auto x = [&](std::uint32_t seed)
  {
    const auto shell = PointShell::OfSurface(ball.View(), {}, { 1000, 100, seed });
    const ContactPoints p = shell->Level(2);
    return std::vector<float>(p.x, p.x + p.count);
  };
  EXPECT_EQ(x(1), x(1));
  EXPECT_NE(x(1), x(2));
}

} // namespace
