#include "Isosurface/ActiveCells.h"
#include "Isosurface/CompactCells.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace
{

/// Noise with some smooth surface in it: clusters that are empty, sparse and full.
template <typename T>
std::vector<T> Samples(const hasp::GridGeometry& g, std::mt19937& random)
{
  std::vector<T> samples(g.Size());
  std::size_t n = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        samples[n++] = static_cast<T>(i > 20 ? 0 : (i + 2 * j + 3 * k) % 90 + random() % 30);
  return samples;
}

void ExpectSameBytes(const hasp::ClusteredCells& a, const hasp::ClusteredCells& b)
{
  ASSERT_EQ(a.count, b.count);
  ASSERT_EQ(a.clusters, b.clusters);
  ASSERT_EQ(a.corners, b.corners);
  ASSERT_EQ(a.levels, b.levels);
}

template <typename T>
class ActiveCellEdits : public ::testing::Test
{
};
using SampleTypes = ::testing::Types<std::int16_t, std::uint16_t, std::uint8_t, float>;
TYPED_TEST_SUITE(ActiveCellEdits, SampleTypes);

TYPED_TEST(ActiveCellEdits, LeaveTheSameBytesAsFromScratch)
{
  const hasp::GridGeometry g{ { 42, 27, 35 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::mt19937 random(7);
  for (const auto precision : { hasp::CellPrecision::Exact, hasp::CellPrecision::Compact })
  {
    auto samples = Samples<TypeParam>(g, random);
    const hasp::GridView<TypeParam> edited{ samples.data(), g };
    const hasp::AnyGridView grid = hasp::GridView<const TypeParam>{ samples.data(), g };
    hasp::MinMaxBlocks blocks(grid);
    auto cells = ExtractActiveCells(grid, blocks, 60.5, precision);
    for (int edit = 0; edit < 25; ++edit)
    {
      glm::ivec3 low, high;
      for (int a = 0; a < 3; ++a)
      {
        low[a] = static_cast<int>(random() % g.dims[a]);
        high[a] = std::min<int>(g.dims[a] - 1, low[a] + static_cast<int>(random() % 12));
      }
      // Fill, clear, or a value that moves the range of the compact levels.
      const auto value = static_cast<TypeParam>(edit % 5 == 4 ? 250 : edit % 2 * 100);
      for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
          for (int i = low.x; i <= high.x; ++i)
            edited(i, j, k) = value;
      UpdateActiveCells(cells, grid, blocks, low, high);
      ExpectSameBytes(cells, ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), 60.5, precision));
    }
  }
}

TEST(ActiveCellEdit, MayTakeTheLastCellAndBringTheFirst)
{
  const hasp::GridGeometry g{ { 20, 20, 20 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples(g.Size(), 0);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  for (const auto precision : { hasp::CellPrecision::Exact, hasp::CellPrecision::Compact })
  {
    hasp::MinMaxBlocks blocks(grid);
    auto cells = ExtractActiveCells(grid, blocks, 5, precision);
    const auto none = cells;
    EXPECT_EQ(cells.Count(), 0U);
    samples[g.dims.x * (g.dims.y * 8 + 8) + 8] = 10; // a corner of 8 blocks
    UpdateActiveCells(cells, grid, blocks, { 8, 8, 8 }, { 8, 8, 8 });
    EXPECT_EQ(cells.Count(), 8U);
    EXPECT_EQ(cells.clusters.size(), 8U);
    samples[g.dims.x * (g.dims.y * 8 + 8) + 8] = 0;
    UpdateActiveCells(cells, grid, blocks, { 8, 8, 8 }, { 8, 8, 8 });
    ExpectSameBytes(cells, none);
  }
}

TEST(ActiveCellEdit, OutsideTheGridChangesNothingAndAnotherGridIsRefused)
{
  const hasp::GridGeometry g{ { 20, 20, 20 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples(g.Size(), 0);
  samples[3333] = 9;
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  hasp::MinMaxBlocks blocks(grid);
  auto cells = ExtractActiveCells(grid, blocks, 5);
  const auto before = cells;
  UpdateActiveCells(cells, grid, blocks, { 30, 0, 0 }, { 40, 5, 5 });
  UpdateActiveCells(cells, grid, blocks, { -9, -9, -9 }, { -1, -1, -1 });
  UpdateActiveCells(cells, grid, blocks, { 5, 5, 5 }, { 4, 4, 4 });
  ExpectSameBytes(cells, before);

  hasp::GridGeometry other = g;
  other.dims.z = 10;
  const hasp::AnyGridView small = hasp::GridView<const std::int16_t>{ samples.data(), other };
  EXPECT_THROW(UpdateActiveCells(cells, small, blocks, {}, {}), std::invalid_argument);
  hasp::MinMaxBlocks otherBlocks(small);
  EXPECT_THROW(UpdateActiveCells(cells, small, otherBlocks, {}, {}), std::invalid_argument);
}

TEST(ActiveCellEdit, OfEverythingMayBeSaidWithTheLimitsOfInt)
{
  const hasp::GridGeometry g{ { 20, 20, 20 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples(g.Size(), 0);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  hasp::MinMaxBlocks blocks(grid);
  auto cells = ExtractActiveCells(grid, blocks, 5);
  samples[3333] = 9;
  UpdateActiveCells(cells, grid, blocks, glm::ivec3(std::numeric_limits<int>::min()),
    glm::ivec3(std::numeric_limits<int>::max()));
  ExpectSameBytes(cells, ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), 5));
  EXPECT_GT(cells.Count(), 0U);
}

TEST(ActiveCellEdit, TakesThePlaceOfTheGridInTheWorldWithIt)
{
  hasp::GridGeometry g{ { 20, 20, 20 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples(g.Size(), 0);
  samples[3333] = 9;
  const hasp::AnyGridView before = hasp::GridView<const std::int16_t>{ samples.data(), g };
  hasp::MinMaxBlocks blocks(before);
  for (const int sample : { 5, 30 }) // inside the grid, and outside: nothing is read anew
  {
    auto cells = ExtractActiveCells(before, blocks, 5);
    g.spacing = { 0.5, 2, 3 };
    g.origin = { 1, 2, 3 };
    g.direction = glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
    const hasp::AnyGridView after = hasp::GridView<const std::int16_t>{ samples.data(), g };
    UpdateActiveCells(cells, after, blocks, glm::ivec3(sample), glm::ivec3(sample));
    EXPECT_EQ(cells.geometry.spacing, g.spacing) << sample;
    EXPECT_EQ(cells.geometry.origin, g.origin) << sample;
    EXPECT_EQ(cells.geometry.direction, g.direction) << sample;
  }
}

TEST(ActiveCellEdit, MakesCompactCellsOfOtherLevelsAnew)
{
  const hasp::GridGeometry g{ { 42, 27, 35 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::mt19937 random(8);
  auto samples = Samples<std::int16_t>(g, random);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  hasp::MinMaxBlocks blocks(grid);
  const auto exact = ExtractActiveCells(grid, blocks, 60.5);
  auto cells = CompactCells(exact, CompactExponent(exact) + 2);
  samples[12345] = 61;
  const glm::ivec3 at(12345 % 42, 12345 / 42 % 27, 12345 / 42 / 27);
  UpdateActiveCells(cells, grid, blocks, at, at);
  ExpectSameBytes(
    cells, ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), 60.5, hasp::CellPrecision::Compact));
}

} // namespace
