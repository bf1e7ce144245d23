// Labels and colours of active cells against brute force over the volume's own samples.
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellAttributes.h"
#include "Isosurface/CompactCells.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace
{

/// Noise: every case of active and stored corners, clusters that end inside, every width.
struct Volume
{
  hasp::GridGeometry geometry{ { 37, 22, 29 }, { 5, -3, 1 }, { 0.5, 0.7, 2.0 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples;
  std::vector<std::uint16_t> labels;
  std::vector<std::uint32_t> colors;
  hasp::ClusteredCells cells;

  explicit Volume(hasp::CellPrecision precision = hasp::CellPrecision::Exact)
  {
    std::mt19937 random(7);
    for (std::size_t n = 0; n < this->geometry.Size(); ++n)
    {
      // Sparse on one side, dense on the other.
      const unsigned rarity = 2 + 60 * (n % 37) / 37;
      this->samples.push_back(static_cast<std::int16_t>(random() % rarity ? -5 : random() % 900));
      this->labels.push_back(static_cast<std::uint16_t>(random() % 3 ? random() % 4 : 65535));
      this->colors.push_back(static_cast<std::uint32_t>(random()));
    }
    const hasp::AnyGridView grid =
      hasp::GridView<const std::int16_t>{ this->samples.data(), this->geometry };
    this->cells = ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), 0.0, precision);
  }
  hasp::GridView<const std::uint16_t> Labels() const
  {
    return { this->labels.data(), this->geometry };
  }
  hasp::GridView<const std::uint32_t> Colors() const
  {
    return { this->colors.data(), this->geometry };
  }
  std::size_t Sample(const glm::ivec3& cell, int corner) const
  {
    return this->Labels().Offset(
      cell.x + (corner & 1), cell.y + (corner >> 1 & 1), cell.z + (corner >> 2));
  }
};

TEST(CellAttributes, TheLabelIsTheMostFrequentOfTheInsideCorners)
{
  for (const auto precision : { hasp::CellPrecision::Exact, hasp::CellPrecision::Compact })
  {
    Volume v(precision);
    ASSERT_GT(v.cells.Count(), 5000U);
    AddLabels(v.cells, v.Labels());
    ASSERT_EQ(v.cells.labels.size(), v.cells.Count());
    std::size_t ties = 0, none = 0;
    for (std::size_t n = 0; n < v.cells.Count(); ++n)
    {
      std::map<int, int> times;
      for (int c = 0; c < 8; ++c)
        if (const std::size_t at = v.Sample(v.cells.Cell(n), c); v.samples[at] >= 0 && v.labels[at])
          ++times[v.labels[at]];
      int truth = 0, most = 0;
      for (const auto& [label, count] : times) // ascending: the smaller wins
      {
        ties += count == most;
        if (count > most)
          std::tie(truth, most) = std::pair(label, count);
      }
      none += truth == 0;
      ASSERT_EQ(v.cells.labels[n], truth) << n;
    }
    EXPECT_GT(ties, 100U);
    EXPECT_GT(none, 100U);
  }
}

// Against labels of all cells anew: boxes within a cluster, across some, beyond the grid, of one
// sample at a cluster's border, which belongs to cells of eight clusters.
TEST(CellAttributes, LabelsOfABoxAreThoseThatAllWouldHave)
{
  Volume v;
  AddLabels(v.cells, v.Labels());
  const std::pair<glm::ivec3, glm::ivec3> boxes[] = { { { 3, 4, 5 }, { 5, 6, 6 } },
    { { 16, 8, 16 }, { 16, 8, 16 } }, { { 7, 7, 7 }, { 20, 9, 24 } },
    { { -5, -1, 20 }, { 99, 99, 99 } }, { { 0, 0, 0 }, { 36, 21, 28 } } };
  std::uint16_t paint = 100;
  int changes = 0;
  for (const auto& [low, high] : boxes)
  {
    ++paint;
    const glm::ivec3 from = glm::max(low, 0), to = glm::min(high, v.geometry.dims - 1);
    for (int k = from.z; k <= to.z; ++k)
      for (int j = from.y; j <= to.y; ++j)
        for (int i = from.x; i <= to.x; ++i)
          v.labels[v.Labels().Offset(i, j, k)] = paint;
    hasp::ClusteredCells truth = v.cells;
    AddLabels(truth, v.Labels());
    std::size_t first = truth.Count(), end = 0;
    for (std::size_t n = 0; n < truth.Count(); ++n)
      if (truth.labels[n] != v.cells.labels[n])
      {
        first = std::min(first, n);
        end = n + 1;
      }
    const hasp::CellRange range = UpdateLabels(v.cells, v.Labels(), low, high);
    EXPECT_EQ(v.cells.labels, truth.labels);
    EXPECT_EQ(range.Empty(), first > end); // samples that are not inside do not count
    EXPECT_EQ(range.first, first < end ? first : 0);
    EXPECT_EQ(range.end, end);
    changes += first < end;
    EXPECT_TRUE(UpdateLabels(v.cells, v.Labels(), low, high).Empty()) << "nothing changed since";
  }
  EXPECT_GE(changes, 3);
  EXPECT_TRUE(UpdateLabels(v.cells, v.Labels(), glm::ivec3(40), glm::ivec3(50)).Empty());
  EXPECT_TRUE(UpdateLabels(v.cells, v.Labels(), glm::ivec3(5), glm::ivec3(4)).Empty());
}

TEST(CellAttributes, EachStoredCornerHasItsSamplesColour)
{
  Volume v;
  AddColors(v.cells, v.Colors());
  const auto byGrid = v.cells;
  const std::vector<std::int64_t> samples = hasp::SamplesOfCorners(v.cells);
  ASSERT_EQ(samples.size(), v.cells.colors.size());
  ASSERT_EQ(v.cells.firstColors.size(), v.cells.clusters.size());
  std::size_t corner = 0;
  for (std::size_t c = 0; c < v.cells.clusters.size(); ++c)
  {
    const hasp::CellCluster& cluster = v.cells.clusters[c];
    ASSERT_EQ(v.cells.firstColors[c], corner);
    for (int z = 0; z <= 8; ++z)
      for (int y = 0; y <= 8; ++y)
        for (int x = 0; x <= 8; ++x)
        {
          bool touched = false;
          for (int n = 0; n < 8; ++n)
          {
            const glm::ivec3 cell = glm::ivec3(x, y, z) - glm::ivec3(n & 1, n >> 1 & 1, n >> 2);
            touched |= glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) &&
                       glm::all(glm::lessThan(cell, glm::ivec3(8))) && cluster.Active(cell);
          }
          if (!touched)
            continue;
          const glm::ivec3 at = cluster.Origin() + glm::ivec3(x, y, z);
          ASSERT_EQ(v.cells.colors[corner], v.colors[v.Sample(at, 0)]);
          ASSERT_EQ(samples[corner], static_cast<std::int64_t>(v.Sample(at, 0)));
          ++corner;
        }
  }
  EXPECT_EQ(corner, v.cells.colors.size());

  AddColors(v.cells,
    [&](std::span<const std::int64_t> which, std::span<std::uint32_t> colors)
    {
      for (std::size_t n = 0; n < which.size(); ++n)
        colors[n] = v.colors[which[n]];
    });
  EXPECT_EQ(v.cells.colors, byGrid.colors);
  EXPECT_EQ(v.cells.firstColors, byGrid.firstColors);
}

TEST(CellAttributes, CostNothingUntilAskedFor)
{
  Volume v;
  const std::size_t bare = v.cells.Bytes();
  EXPECT_TRUE(v.cells.labels.empty() && v.cells.colors.empty() && v.cells.firstColors.empty());
  AddLabels(v.cells, v.Labels());
  EXPECT_EQ(v.cells.Bytes(), bare + 2 * v.cells.Count());
  AddColors(v.cells, v.Colors());
  EXPECT_EQ(v.cells.Bytes(),
    bare + 2 * v.cells.Count() + 4 * v.cells.colors.size() + 4 * v.cells.clusters.size());
}

TEST(CellAttributes, WhatDoesNotFitIsRefusedAndChangesNothing)
{
  Volume v;
  AddLabels(v.cells, v.Labels());
  AddColors(v.cells, v.Colors());
  const auto before = v.cells;
  const auto refused = [&](const auto& add) { EXPECT_THROW(add(), std::invalid_argument); };

  std::vector<hasp::GridGeometry> others(4, v.geometry);
  others[0].dims = { 22, 37, 29 };
  others[1].origin.x += 0.25;
  others[2].spacing.z *= 0.5;
  others[3].direction[1] *= -1.0;
  for (const hasp::GridGeometry& other : others)
  {
    refused(
      [&] {
        AddLabels(v.cells, hasp::GridView<const std::uint16_t>{ v.labels.data(), other });
      });
    refused(
      [&] {
        AddColors(v.cells, hasp::GridView<const std::uint32_t>{ v.colors.data(), other });
      });
  }
  const std::vector<float> floats(v.geometry.Size(), 1.0F);
  refused([&] { AddLabels(v.cells, hasp::GridView<const float>{ floats.data(), v.geometry }); });
  refused(
    [&]
    {
      UpdateLabels(v.cells, hasp::GridView<const float>{ floats.data(), v.geometry }, glm::ivec3(0),
        glm::ivec3(9));
    });
  refused(
    [&]
    {
      hasp::ClusteredCells bare = v.cells;
      bare.labels.clear();
      UpdateLabels(bare, v.Labels(), glm::ivec3(0), glm::ivec3(9));
    });
  const std::vector<std::int16_t> negative(v.geometry.Size(), -1);
  refused(
    [&] {
      AddLabels(v.cells, hasp::GridView<const std::int16_t>{ negative.data(), v.geometry });
    });
  const auto fails = [](auto, auto) { throw std::runtime_error("no colours today"); };
  EXPECT_THROW(AddColors(v.cells, fails), std::runtime_error);

  EXPECT_EQ(v.cells.labels, before.labels);
  EXPECT_EQ(v.cells.colors, before.colors);
  EXPECT_EQ(v.cells.firstColors, before.firstColors);
}

TEST(CellAttributes, NoCellsHaveNoAttributes)
{
  Volume v;
  hasp::ClusteredCells none;
  none.geometry = v.geometry;
  AddLabels(none, v.Labels());
  AddColors(none, v.Colors());
  EXPECT_EQ(none.Bytes(), 0U);
}

} // namespace
