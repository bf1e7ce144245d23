// Slabs of as many layers as there are threads, and the same bytes.
#include "CellFixture.h"
#include "Grid/AnalyticVolumes.h"
#include "Grid/Testing/WithThreads.h"
#include "Isosurface/SlabExtraction.h"
#include "Isosurface/ValidateCells.h"

#include <gtest/gtest.h>

namespace
{

TEST(SlabThreads, GiveTheSameBytesAndTheSameFault)
{
  const hasp::GridGeometry g{ { 61, 50, 95 }, {}, { 0.5, 0.7, 0.6 }, glm::dmat3(1) };
  const auto samples = hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(9), g, 100, 0);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  const hasp::ClusteredCells whole = hasp::testing::CellsOf(grid, 0.0);
  ASSERT_GT(whole.Count(), 10000U);
  for (const int threads : { 1, 2, 3, 8 })
  {
    const auto slabs = hasp::testing::WithThreads(
      threads, [&] { return hasp::ExtractActiveCellsFromSlabs(g, hasp::SlabsOf(grid), 0.0); });
    EXPECT_TRUE(hasp::testing::SameCells(slabs, whole)) << threads;
    hasp::ClusteredCells bad = whole;
    bad.isovalue = 20.0F; // cells of many clusters are wrong
    const auto fault = hasp::testing::WithThreads(threads,
      [&]
      {
        try
        {
          hasp::ValidateCells(bad);
          return std::string("none");
        }
        catch (const std::invalid_argument& error)
        {
          return std::string(error.what());
        }
      });
    EXPECT_NE(fault.find("cluster 0: an active cell"), std::string::npos) << fault;
  }
}

} // namespace
