#include "Grid/AnalyticVolumes.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CompactCells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

template <typename T>
hasp::ClusteredCells Extract(const std::vector<T>& samples, const hasp::GridGeometry& g, double iso,
  hasp::CellPrecision precision)
{
  const hasp::AnyGridView grid = hasp::GridView<const T>{ samples.data(), g };
  return ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), iso, precision);
}

const hasp::GridGeometry Grid{ { 60, 60, 60 }, {}, { 1, 1, 1 }, glm::dmat3(1) };

TEST(CompactCells, KeepCellsAndSignsAndMoveTheSurfaceLittle)
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 25);
  auto samples = hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(20), Grid, 700, 100);
  for (auto& s : samples)
    s = static_cast<std::int16_t>(s + noise(random));
  const auto exact = Extract(samples, Grid, 226, hasp::CellPrecision::Exact);
  const auto compact = Extract(samples, Grid, 226, hasp::CellPrecision::Compact);
  ASSERT_EQ(compact.Count(), exact.Count());
  EXPECT_LT(compact.Bytes(), exact.Bytes());

  double squares = 0, most = 0;
  std::size_t crossings = 0;
  for (std::size_t n = 0; n < exact.Count(); ++n)
  {
    const auto& cluster = exact.clusters[exact.ClusterOf(n)];
    const glm::ivec3 in = exact.Cell(n) - cluster.Origin();
    ASSERT_EQ(compact.Cell(n), exact.Cell(n));
    const auto a = exact.CornersFromIsovalue(cluster, in);
    const auto b = compact.CornersFromIsovalue(compact.clusters[compact.ClusterOf(n)], in);
    for (int c = 0; c < 8; ++c)
      ASSERT_EQ(a[c] >= 0, b[c] >= 0);
    for (const auto& [p, q] : { std::pair(0, 1), std::pair(0, 2), std::pair(0, 4) })
      if ((a[p] >= 0) != (a[q] >= 0))
      {
        const double shift = std::abs(double(a[p]) / (a[p] - a[q]) - double(b[p]) / (b[p] - b[q]));
        squares += shift * shift;
        most = std::max(most, shift);
        ++crossings;
      }
  }
  EXPECT_LT(std::sqrt(squares / crossings), 0.005); // voxels, the bar
  EXPECT_LT(most, 0.06);
}

TEST(CompactCells, ClustersAgreeOnTheCornersTheyShare)
{
  const auto samples = hasp::SampleAnalytic<float>(hasp::AnalyticGyroid(20), Grid, 700, 100);
  const auto compact = Extract(samples, Grid, 130, hasp::CellPrecision::Compact);
  int compared = 0;
  for (int k = 0; k < 59; ++k)
    for (int j = 0; j < 59; ++j)
      if (const auto low = compact.Find({ 7, j, k }), high = compact.Find({ 8, j, k }); low && high)
      {
        const auto& left = compact.clusters[compact.ClusterOf(*low)];
        const auto& right = compact.clusters[compact.ClusterOf(*high)];
        const auto a = compact.CornersFromIsovalue(left, { 7, j % 8, k % 8 });
        const auto b = compact.CornersFromIsovalue(right, { 0, j % 8, k % 8 });
        for (int c = 0; c < 8; c += 2)
          ASSERT_EQ(a[c + 1], b[c]);
        ++compared;
      }
  EXPECT_GT(compared, 100);
}

TEST(CompactCells, LevelsBoundTheErrorTheyPromise)
{
  const double range = 4096;
  const auto levels = hasp::CompactLevels(range);
  ASSERT_EQ(levels.size(), 128U);
  for (int m = 0; m < 127; ++m)
  {
    ASSERT_LT(levels[m], levels[m + 1]);
    // Half way between two levels lies the worst magnitude: 2.7 % of it + c / 37.
    const double between = 0.5 * (levels[m] + levels[m + 1]);
    EXPECT_LE(levels[m + 1] - between, 0.0275 * (between + range / 1000));
  }
  EXPECT_GT(levels[0], 0.0F);
  EXPECT_LT(levels[127], range);
  EXPECT_GT(levels[127], 0.97 * range);
  EXPECT_THROW(hasp::CompactLevels(0), std::invalid_argument);
  EXPECT_THROW(hasp::CompactLevels(std::nan("")), std::invalid_argument);
}

TEST(CompactCells, SignsHoldForTheSmallestAndLargestFloats)
{
  const hasp::GridGeometry g{ { 2, 2, 2 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  for (const float size : { 1e-45F, 1e-38F, 1e-20F, 1.0F, 3e38F })
  {
    const std::vector<float> samples{ -size, size, 0, -0.0F, size, -size, -size, size };
    const auto cells = Extract(samples, g, 0, hasp::CellPrecision::Compact);
    ASSERT_EQ(cells.Count(), 1U) << size;
    const auto corners = cells.CornersFromIsovalue(cells.clusters[0], {});
    for (int c = 0; c < 8; ++c)
    {
      EXPECT_EQ(corners[c] >= 0, samples[c] >= 0) << size << " corner " << c;
      EXPECT_TRUE(std::isnormal(corners[c])) << size << " corner " << c;
    }
  }
}

TEST(CompactCells, TakeNoMoreMemoryThanTheyFill)
{
  const auto samples = hasp::SampleAnalytic<float>(hasp::AnalyticGyroid(20), Grid, 700, 100);
  const auto compact = Extract(samples, Grid, 130, hasp::CellPrecision::Compact);
  EXPECT_EQ(compact.clusters.capacity(), compact.clusters.size());
  EXPECT_EQ(compact.corners.capacity(), compact.corners.size());
}

TEST(CompactCells, AreNotMadeOfCompactCells)
{
  const auto samples = hasp::SampleAnalytic<float>(hasp::AnalyticGyroid(20), Grid, 700, 100);
  const auto compact = Extract(samples, Grid, 130, hasp::CellPrecision::Compact);
  EXPECT_THROW(CompactCells(compact), std::invalid_argument);
  EXPECT_THROW(compact.Corners(0), std::logic_error);
}

} // namespace
