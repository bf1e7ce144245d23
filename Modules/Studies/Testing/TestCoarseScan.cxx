#include "Grid/ThreadLimit.h"
#include "Studies/CoarseScan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace
{

using hasp::CoarseScan;
using hasp::GridGeometry;
using hasp::Label;
using Samples = std::vector<std::int16_t>;

GridGeometry Grid(const glm::ivec3& dims, const glm::dvec3& spacing)
{
  GridGeometry grid;
  grid.dims = dims;
  grid.spacing = spacing;
  grid.origin = { 3.0, -7.0, 11.0 };
  const double c = std::cos(0.4), s = std::sin(0.4);
  grid.direction = { c, s, 0, -s, c, 0, 0, 0, 1 };
  return grid;
}

TEST(CoarseScan, NonsenseIsRefused)
{
  const GridGeometry grid = Grid({ 8, 8, 8 }, { 0.5, 0.5, 1.0 });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CoarseScan(grid, { { 0.4, 0.5, 1.0 }, {} }), std::invalid_argument); // finer
  EXPECT_THROW(CoarseScan(grid, { { nan, 0.5, 1.0 }, {} }), std::invalid_argument);
  EXPECT_THROW(CoarseScan(grid, { {}, { -1.0, 0.0, 0.0 } }), std::invalid_argument);
  EXPECT_THROW(CoarseScan(grid, { {}, { 0.0, 0.0, nan } }), std::invalid_argument);
  const CoarseScan coarse(grid, {});
  EXPECT_THROW(coarse.Samples(Samples(7)), std::invalid_argument);
  EXPECT_THROW(coarse.Labels(std::vector<Label>(512), Samples(7), 226.0), std::invalid_argument);
}

TEST(CoarseScan, WithoutSettingsNothingChanges)
{
  const GridGeometry grid = Grid({ 9, 7, 5 }, { 0.5, 0.6, 1.0 });
  Samples samples(grid.Size());
  std::iota(samples.begin(), samples.end(), std::int16_t(-100));
  std::vector<Label> labels(grid.Size());
  std::iota(labels.begin(), labels.end(), Label(0));
  const CoarseScan coarse(grid, {});
  EXPECT_EQ(coarse.Geometry().dims, grid.dims);
  EXPECT_EQ(coarse.Geometry().spacing, grid.spacing);
  EXPECT_EQ(coarse.Geometry().origin, grid.origin);
  EXPECT_EQ(coarse.Samples(samples), samples);
  EXPECT_EQ(coarse.Labels(labels, samples, -1000.0), labels);
}

TEST(CoarseScan, AFieldThatIsLinearInTheWorldStaysThat)
{
  const GridGeometry grid = Grid({ 40, 30, 36 }, { 0.5, 0.6, 0.4 });
  const auto field = [](const glm::dvec3& p) { return 20.0 * p.x - 11.0 * p.y + 9.0 * p.z; };
  Samples samples;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        samples.push_back(std::int16_t(std::lround(field(grid.IndexToWorld({ i, j, k })))));
  const CoarseScan coarse(grid, { { 1.1, 0.6, 2.3 }, { 0.3, 0.2, 0.0 } });
  const GridGeometry& now = coarse.Geometry();
  EXPECT_NEAR(now.spacing.x, 1.1, 1e-12);
  EXPECT_NEAR(now.spacing.z, 2.3, 1e-12);
  const Samples made = coarse.Samples(samples);
  ASSERT_EQ(made.size(), now.Size());
  for (int k = 0; k < now.dims.z; ++k)
    for (int j = 3; j + 3 < now.dims.y; ++j) // a border's blur is one-sided
      for (int i = 2; i + 2 < now.dims.x; ++i)
        ASSERT_NEAR(made[(std::size_t(k) * now.dims.y + j) * now.dims.x + i],
          field(now.IndexToWorld({ i, j, k })), 1.01); // rounded twice
}

TEST(CoarseScan, ABlurIsAGaussiansStep)
{
  const GridGeometry grid = Grid({ 80, 2, 2 }, { 0.1, 0.5, 0.5 });
  Samples samples(grid.Size());
  for (std::size_t v = 0; v < samples.size(); ++v)
    samples[v] = v % 80 < 40 ? 0 : 1000;
  const CoarseScan coarse(grid, { {}, { 0.5, 0.0, 0.0 } });
  const Samples made = coarse.Samples(samples);
  for (int i = 20; i < 60; ++i) // 0.05 mm is half a voxel; samples are boxes of a voxel
    ASSERT_NEAR(
      made[i], 1000.0 * 0.5 * std::erfc(-(0.1 * (i - 39.5)) / (0.5 * std::sqrt(2.0))), 5.0);
}

TEST(CoarseScan, AVoxelHasTheLabelOfMostOfItsBone)
{
  const GridGeometry grid = Grid({ 6, 1, 1 }, glm::dvec3(1.0));
  const std::vector<Label> labels{ 0, 3, 5, 5, 0, 0 };
  const Samples samples{ 0, 900, 900, 900, 0, 0 };
  const CoarseScan coarse(grid, { { 3.0, 1.0, 1.0 }, {} });
  const Samples made = coarse.Samples(samples);
  EXPECT_EQ(made, (Samples{ 600, 300 }));
  EXPECT_EQ(coarse.Labels(labels, made, 226.0), (std::vector<Label>{ 3, 5 })); // 3: equals
  EXPECT_EQ(coarse.Labels(labels, made, 400.0), (std::vector<Label>{ 3, 0 }));
}

TEST(CoarseScan, ThreadsDoNotMatter)
{
  const GridGeometry grid = Grid({ 50, 40, 30 }, glm::dvec3(0.5));
  Samples samples(grid.Size());
  for (std::size_t v = 0; v < samples.size(); ++v)
    samples[v] = std::int16_t(v * 7919 % 2000);
  Samples made[2];
  for (int n = 0; n < 2; ++n)
    hasp::WithThreadLimit(1 + n,
      [&] {
        made[n] = CoarseScan(grid, { { 0.7, 0.9, 1.3 }, glm::dvec3(0.4) }).Samples(samples);
      });
  EXPECT_EQ(made[0], made[1]);
}

} // namespace
