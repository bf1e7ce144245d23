#include "Segmentation/Brush.h"
#include "Testing/RandomLabels.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace
{

using hasp::VoxelRuns;
using Points = std::vector<glm::dvec3>;

double DistanceToLine(const Points& points, const glm::dvec3& p)
{
  double least = glm::length(p - points[0]);
  for (std::size_t n = 1; n < points.size(); ++n)
  {
    const glm::dvec3 a = points[n - 1], way = points[n] - a;
    const double length2 = glm::dot(way, way);
    const double t = length2 > 0 ? glm::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::length(p - a - t * way));
  }
  return least;
}

/// Whether the line goes through a voxel: places close together, each rounded to its voxel.
std::vector<bool> OnTheWay(const hasp::GridGeometry& grid, const Points& points)
{
  std::vector<bool> on(grid.Size());
  for (std::size_t n = 0; n < points.size(); ++n)
    for (int s = 0; s <= 20000; ++s)
    {
      const glm::dvec3 p = glm::mix(points[n], points[std::min(n + 1, points.size() - 1)], s / 2e4);
      const glm::ivec3 at(glm::floor(grid.WorldToIndex(p) + 0.5));
      if (glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) &&
          glm::all(glm::lessThan(at, grid.dims)))
        on[(std::size_t(at.z) * grid.dims.y + at.y) * grid.dims.x + at.x] = true;
    }
  return on;
}

std::vector<bool> Marked(const hasp::GridGeometry& grid, const VoxelRuns& runs)
{
  std::vector<bool> marked(grid.Size());
  std::uint64_t end = 0;
  for (const hasp::VoxelRun& run : runs)
  {
    EXPECT_TRUE(run.first >= end && run.length > 0);                          // in order, apart
    EXPECT_TRUE(run.first > end || end == 0 || run.first % grid.dims.x == 0); // and long
    end = run.first + run.length;
    EXPECT_EQ(run.first / grid.dims.x, (end - 1) / grid.dims.x); // in one row
    for (std::uint64_t v = run.first; v < end; ++v)
      marked.at(v) = true;
  }
  return marked;
}

Points RandomLine(const hasp::GridGeometry& grid, int count, double beyond, std::mt19937& random)
{
  std::uniform_real_distribution<double> share(-beyond, 1 + beyond);
  Points points;
  for (int n = 0; n < count; ++n)
    points.push_back(grid.IndexToWorld(
      glm::dvec3(share(random), share(random), share(random)) * glm::dvec3(grid.dims) - 0.5));
  return points;
}

TEST(Brush, NonsenseIsRefused)
{
  const hasp::GridGeometry grid = hasp::testing::PlainGrid({ 4, 4, 4 });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points middle{ glm::dvec3(1) };
  EXPECT_THROW(hasp::RasterizeStroke(grid, {}, 1.0), std::invalid_argument);
  for (const double radius : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
    EXPECT_THROW(hasp::RasterizeStroke(grid, middle, radius), std::invalid_argument);
  for (const double bad : { nan, 1.1e6, -std::numeric_limits<double>::infinity() })
    EXPECT_THROW(hasp::RasterizeStroke(grid, Points{ { 0, 0, 0 }, { 1, bad, 0 } }, 1.0),
      std::invalid_argument);
  EXPECT_THROW(
    hasp::RasterizeStroke(grid, middle, 1.0, [](double) { return false; }), hasp::Cancelled);
  const std::vector<std::uint8_t> mask(64, 1);
  EXPECT_THROW(
    hasp::KeepInMask(VoxelRuns{ { 62, 3 } }, { mask.data(), grid }), std::invalid_argument);
  EXPECT_THROW(hasp::KeepInMask(VoxelRuns{ { ~std::uint64_t(0), 2 } }, { mask.data(), grid }),
    std::invalid_argument);
}

TEST(Brush, MarksWhatBruteForceMarks)
{
  std::mt19937 random(17);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (const int points : { 1, 2, 5 })
      for (const double radius : { 0.02, 0.4, 1.1, 3.0, 20.0 })
      {
        const Points line = RandomLine(grid, points, 0.4, random);
        const std::vector<bool> marked = Marked(grid, hasp::RasterizeStroke(grid, line, radius));
        const std::vector<bool> onTheWay = OnTheWay(grid, line);
        hasp::testing::ForVoxels(grid,
          [&](const glm::ivec3& at, std::size_t v)
          {
            const double away = DistanceToLine(line, grid.IndexToWorld(at)) - radius;
            if (std::abs(away) < 1e-8)
              return; // either is right
            if (away < 0.0 || onTheWay[v])
            {
              EXPECT_TRUE(marked[v]) << away;
            }
            else if (marked[v]) // the line cuts a corner that the steps of OnTheWay miss
            {
              EXPECT_LT(away + radius, 0.5 * glm::length(grid.spacing));
            }
          });
      }
}

TEST(Brush, AThinBrushMarksTheVoxelsOfItsLineAndNoOthers)
{
  const hasp::GridGeometry grid = hasp::testing::PlainGrid({ 9, 9, 9 }, { 0.5, 0.5, 2.0 });
  // A diagonal that misses all corners: the voxels on its way in closed form.
  const Points line{ { 0.0, 0.0, 4.0 }, { 4.0, 2.0, 4.0 } };
  const std::vector<bool> marked = Marked(grid, hasp::RasterizeStroke(grid, line, 1e-6));
  hasp::testing::ForVoxels(grid,
    [&](const glm::ivec3& at, std::size_t v)
    {
      // In index space y = x / 2: within |x - i| <= 1/2 it covers [(i - 1/2) / 2, (i + 1/2) / 2].
      const double low = std::max(0.0, (at.x - 0.5) / 2), high = std::min(4.0, (at.x + 0.5) / 2);
      const bool through = at.z == 2 && high >= at.y - 0.5 && low <= at.y + 0.5;
      EXPECT_EQ(marked[v], through) << at.x << ' ' << at.y << ' ' << at.z;
    });
  EXPECT_EQ(
    hasp::CountVoxels(hasp::RasterizeStroke(grid, Points{ { 1.1, 1.1, 3.0001 } }, 1e-9)), 1U);
}

TEST(Brush, ReachesWholeVoxelsWhateverIsRounded)
{
  // 3 * 0.3 is 0.8999999999999999 or 0.9000000000000001, as one likes.
  const hasp::GridGeometry grid = hasp::testing::PlainGrid({ 21, 21, 21 }, glm::dvec3(0.3));
  const VoxelRuns ball =
    hasp::RasterizeStroke(grid, Points{ grid.IndexToWorld({ 10, 10, 10 }) }, 0.9);
  std::uint64_t inBall = 0;
  for (int k = -3; k <= 3; ++k)
    for (int j = -3; j <= 3; ++j)
      for (int i = -3; i <= 3; ++i)
        inBall += i * i + j * j + k * k <= 9;
  EXPECT_EQ(hasp::CountVoxels(ball), inBall);
}

TEST(Brush, NextToTheGridMarksNothingAndAroundItAll)
{
  const hasp::GridGeometry grid = hasp::testing::SkewGrid({ 5, 6, 7 }, { 0.3, 0.5, 1 }, 3);
  const glm::dvec3 far = grid.IndexToWorld({ -1e5, 3, 3 }), middle = grid.IndexToWorld({ 2, 3, 3 });
  EXPECT_TRUE(hasp::RasterizeStroke(grid, Points{ far }, 5.0).empty());
  EXPECT_EQ(hasp::CountVoxels(hasp::RasterizeStroke(grid, Points{ far }, 1e5)), 5 * 6 * 7U);
  EXPECT_EQ(hasp::CountVoxels(hasp::RasterizeStroke(grid, Points{ middle }, 100.0)), 5 * 6 * 7U);
  // In and out again: the part within is marked.
  EXPECT_FALSE(hasp::RasterizeStroke(grid, Points{ far, middle, far }, 0.1).empty());
}

TEST(Brush, ManyPointsOnALineAreTheLine)
{
  const hasp::GridGeometry grid = hasp::testing::SkewGrid({ 60, 50, 40 }, { 0.3, 0.3, 0.4 }, 1);
  const glm::dvec3 a = grid.IndexToWorld({ 5, 6, 7 }), b = grid.IndexToWorld({ 50, 40, 33 });
  Points dense;
  for (int n = 0; n <= 3000; ++n)
    dense.push_back(glm::mix(a, b, n / 3000.0));
  EXPECT_EQ(
    hasp::RasterizeStroke(grid, dense, 1.7), hasp::RasterizeStroke(grid, Points{ a, b }, 1.7));
}

TEST(Brush, KeepsWhatTheMaskHas)
{
  std::mt19937 random(23);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
  {
    std::vector<std::uint8_t> mask(grid.Size());
    for (std::uint8_t& m : mask)
      m = random() % 3 ? 0 : 200;
    const VoxelRuns runs = hasp::RasterizeStroke(grid, RandomLine(grid, 3, 0.0, random), 1.5);
    const std::vector<bool> all = Marked(grid, runs);
    const std::vector<bool> kept = Marked(grid, hasp::KeepInMask(runs, { mask.data(), grid }));
    for (std::size_t v = 0; v < mask.size(); ++v)
      EXPECT_EQ(kept[v], all[v] && mask[v]);
  }
}

TEST(Brush, ASurfaceLayerIsWhatLiesWithinItsDepth)
{
  std::mt19937 random(29);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (const double depth : { 0.2, 1.0, 4.0 })
    {
      const hasp::testing::LabelMap map = hasp::testing::RandomLabels(grid, 9, 3, random);
      const VoxelRuns runs = hasp::RasterizeStroke(grid, RandomLine(grid, 3, 0.0, random), 2.5);
      const std::vector<bool> all = Marked(grid, runs);
      const std::vector<bool> kept = Marked(grid, hasp::KeepSurfaceLayer(runs, map.View(), depth));
      hasp::testing::ForVoxels(grid,
        [&](const glm::ivec3& at, std::size_t v)
        {
          double least = HUGE_VAL;
          hasp::testing::ForVoxels(grid,
            [&](const glm::ivec3& other, std::size_t w)
            {
              if (map.labels[w] == 0)
                least = std::min(least, glm::length(grid.spacing * glm::dvec3(other - at)));
            });
          EXPECT_EQ(kept[v], all[v] && map.labels[v] != 0 && least <= depth * (1 + 1e-6));
        });
    }
  // The surface lies out of the stroke's box: 2 voxels in front of it.
  hasp::testing::LabelMap block(hasp::testing::PlainGrid({ 9, 3, 3 }), 1);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      block.At(0, j, k) = 0;
  const VoxelRuns inside = hasp::RasterizeStroke(block.geometry, Points{ { 2, 1, 1 } }, 1.0);
  EXPECT_EQ(
    hasp::CountVoxels(hasp::KeepSurfaceLayer(inside, std::as_const(block).View(), 1.0)), 1U);
  EXPECT_EQ(
    hasp::CountVoxels(hasp::KeepSurfaceLayer(inside, std::as_const(block).View(), 2.0)), 6U);
  EXPECT_EQ(
    hasp::CountVoxels(hasp::KeepSurfaceLayer(inside, std::as_const(block).View(), 3.0)), 7U);
  const hasp::testing::LabelMap map(hasp::testing::PlainGrid({ 3, 3, 3 }), 1);
  EXPECT_TRUE(hasp::KeepSurfaceLayer({}, map.View(), 1.0).empty());
  EXPECT_THROW(hasp::KeepSurfaceLayer({}, map.View(), 51.0), std::invalid_argument);
}

} // namespace
