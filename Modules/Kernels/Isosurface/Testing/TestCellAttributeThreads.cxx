// The same labels and colours whatever the number of threads.
#include "Grid/AnalyticVolumes.h"
#include "Grid/Testing/WithThreads.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellAttributes.h"

#include <gtest/gtest.h>

namespace
{

TEST(CellAttributeThreads, GiveTheSameBytes)
{
  const hasp::GridGeometry g{ { 61, 50, 95 }, {}, { 0.5, 0.7, 0.6 }, glm::dmat3(1) };
  const auto samples = hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(9), g, 100, 0);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  std::vector<std::uint8_t> labels;
  std::vector<std::uint32_t> colors;
  for (std::size_t n = 0; n < g.Size(); ++n)
  {
    labels.push_back(static_cast<std::uint8_t>(n * 2654435761U >> 13));
    colors.push_back(static_cast<std::uint32_t>(n * 2246822519U));
  }
  const auto cells = ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), 0);
  ASSERT_GT(cells.Count(), 10000U);
  const auto add = [&](int threads)
  {
    return hasp::testing::WithThreads(threads,
      [&]
      {
        auto result = cells;
        AddLabels(result, hasp::GridView<const std::uint8_t>{ labels.data(), g });
        AddColors(result, hasp::GridView<const std::uint32_t>{ colors.data(), g });
        return result;
      });
  };
  const auto one = add(1);
  for (const int threads : { 2, 3, 8 })
  {
    const auto many = add(threads);
    EXPECT_EQ(many.labels, one.labels) << threads;
    EXPECT_EQ(many.colors, one.colors) << threads;
    EXPECT_EQ(many.firstColors, one.firstColors) << threads;
  }
}

} // namespace
