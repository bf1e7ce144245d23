// The same bytes whatever the number of threads.
#include "Grid/AnalyticVolumes.h"
#include "Grid/Testing/WithThreads.h"
#include "Isosurface/ActiveCells.h"

#include <gtest/gtest.h>

namespace
{

TEST(ActiveCellThreads, GiveTheSameBytes)
{
  const hasp::GridGeometry g{ { 61, 50, 95 }, {}, { 0.5, 0.7, 0.6 }, glm::dmat3(1) };
  const auto samples = hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(9), g, 100, 0);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  for (const auto precision : { hasp::CellPrecision::Exact, hasp::CellPrecision::Compact })
  {
    const auto extract = [&](int threads)
    {
      return hasp::testing::WithThreads(
        threads, [&] { return ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), 0, precision); });
    };
    const auto one = extract(1);
    ASSERT_GT(one.Count(), 10000U);
    for (const int threads : { 2, 3, 8 })
    {
      const auto many = extract(threads);
      EXPECT_EQ(many.corners, one.corners) << threads;
      EXPECT_EQ(many.clusters, one.clusters) << threads;
      EXPECT_EQ(many.levels, one.levels) << threads;
    }
  }
}

} // namespace
