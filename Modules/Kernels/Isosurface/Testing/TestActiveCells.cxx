#include "Grid/AnalyticVolumes.h"
#include "Isosurface/ActiveCells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>

namespace
{

template <typename T>
hasp::ClusteredCells Extract(const std::vector<T>& samples, const hasp::GridGeometry& g, double iso)
{
  const hasp::AnyGridView grid = hasp::GridView<const T>{ samples.data(), g };
  return ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), iso);
}

template <typename T>
class ActiveCells : public ::testing::Test
{
};
using SampleTypes = ::testing::Types<std::int16_t, std::uint16_t, std::uint8_t, float>;
TYPED_TEST_SUITE(ActiveCells, SampleTypes);

TYPED_TEST(ActiveCells, MatchBruteForceAndKeepEverySample)
{
  const hasp::GridGeometry g{ { 21, 9, 18 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::mt19937 random(31);
  std::vector<TypeParam> samples(g.Size());
  for (auto& s : samples)
    s = static_cast<TypeParam>(random() % 9 == 0 ? 200 : random() % 100);
  const hasp::GridView<const TypeParam> grid{ samples.data(), g };
  const auto cells = Extract(samples, g, 150.5);

  std::set<std::tuple<int, int, int>> truth;
  for (int k = 0; k < 17; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 20; ++i)
      {
        int inside = 0;
        for (int c = 0; c < 8; ++c)
          inside += grid(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)) >= 150.5;
        if (inside != 0 && inside != 8)
          truth.insert({ i, j, k });
      }
  ASSERT_EQ(cells.Count(), truth.size());
  for (std::size_t n = 0; n < cells.Count(); ++n)
  {
    const glm::ivec3 at = cells.Cell(n);
    ASSERT_TRUE(truth.erase({ at.x, at.y, at.z })) << at.x << " " << at.y << " " << at.z;
    const auto corners = cells.Corners(n);
    for (int c = 0; c < 8; ++c)
      ASSERT_EQ(
        corners[c], static_cast<float>(grid(at.x + (c & 1), at.y + (c >> 1 & 1), at.z + (c >> 2))));
  }
}

TEST(ActiveCellsOf, AClusterHoldsEachCornerOnceInTheFewestBits)
{
  // A plane at x = 3.5 through one cluster: 64 cells, 2 x 81 corners, range 1 to 2.
  const hasp::GridGeometry g{ { 9, 9, 9 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples(g.Size());
  for (std::size_t n = 0; n < samples.size(); ++n)
    samples[n] = static_cast<std::int16_t>(-500 + 3 * (n % 9));
  const auto cells = Extract(samples, g, -489.5);
  ASSERT_EQ(cells.clusters.size(), 1U);
  EXPECT_EQ(cells.Count(), 64U);
  EXPECT_EQ(cells.clusters[0].CellCount(), 64);
  EXPECT_EQ(cells.clusters[0].CornerCount(), 162);
  EXPECT_EQ(cells.clusters[0].Width(), 2); // values -491 and -488
  EXPECT_EQ(cells.corners.size(), (162 * 2 + 31) / 32 + 2);
  EXPECT_EQ(cells.Bytes(), 96 + 4 * cells.corners.size());
}

TEST(ActiveCellsOf, AreFoundByPlaceAndByNumber)
{
  const hasp::GridGeometry g{ { 40, 33, 27 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  const auto cells =
    Extract(hasp::SampleAnalytic<std::uint8_t>(hasp::AnalyticGyroid(13), g, 60, 128), g, 128);
  ASSERT_GT(cells.Count(), 1000U);
  std::size_t found = 0;
  for (int k = -1; k <= 27; ++k)
    for (int j = -1; j <= 33; ++j)
      for (int i = -1; i <= 40; ++i)
        if (const auto n = cells.Find({ i, j, k }))
        {
          ASSERT_EQ(cells.Cell(*n), glm::ivec3(i, j, k));
          ++found;
        }
  EXPECT_EQ(found, cells.Count());
}

TEST(ActiveCellsOf, AMillionHundredsOfTheRangeEdgesAreExact)
{
  // int16 extremes and a corner exactly at the isovalue: inside is >=.
  std::vector<std::int16_t> samples(8, std::numeric_limits<std::int16_t>::min());
  const hasp::GridGeometry g{ { 2, 2, 2 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  EXPECT_EQ(Extract(samples, g, -32768).Count(), 0U); // all inside
  samples[5] = std::numeric_limits<std::int16_t>::max();
  const auto cells = Extract(samples, g, 32767);
  ASSERT_EQ(cells.Count(), 1U);
  EXPECT_EQ(cells.Corners(0)[5], 32767.0F);
  EXPECT_EQ(cells.Corners(0)[0], -32768.0F);
  EXPECT_EQ(Extract(samples, g, 32768).Count(), 0U);
}

TEST(ActiveCellsOf, WhatIsNotFiniteIsNeverActive)
{
  const hasp::GridGeometry g{ { 3, 2, 2 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : { std::numeric_limits<float>::quiet_NaN(), infinity, -infinity })
  {
    const std::vector<float> samples{ -1, 1, bad, -1, 1, 1, -1, 1, 1, -1, 1, 1 };
    const auto cells = Extract(samples, g, 0);
    ASSERT_EQ(cells.Count(), 1U) << bad;
    EXPECT_EQ(cells.Cell(0), glm::ivec3(0, 0, 0)) << bad;
  }
}

TEST(ActiveCellsOf, WrongInputIsRefused)
{
  const hasp::GridGeometry g{ { 20, 20, 20 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  const std::vector<std::uint8_t> samples(8000, 1);
  const hasp::AnyGridView grid = hasp::GridView<const std::uint8_t>{ samples.data(), g };
  const hasp::MinMaxBlocks blocks(grid);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ExtractActiveCells(grid, blocks, nan), std::invalid_argument);
  EXPECT_THROW(ExtractActiveCells(grid, blocks, 1e300), std::invalid_argument);
  EXPECT_THROW(ExtractActiveCells(grid, hasp::MinMaxBlocks(), 1), std::invalid_argument);
  EXPECT_THROW(
    ExtractActiveCells(grid, blocks, 1, hasp::CellPrecision::Exact, [](double) { return false; }),
    hasp::Cancelled);
}

TEST(ActiveCellsOf, ASingleSliceHasNoCells)
{
  const std::vector<std::uint8_t> samples{ 0, 9, 9, 0 };
  EXPECT_EQ(Extract(samples, { { 2, 2, 1 }, {}, { 1, 1, 1 }, glm::dmat3(1) }, 5).Count(), 0U);
}

} // namespace
