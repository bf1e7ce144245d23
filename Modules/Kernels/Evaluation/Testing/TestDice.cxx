#include "Evaluation/BestMatch.h"
#include "Evaluation/Dice.h"

#include "Grid/ThreadLimit.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

namespace
{

using hasp::CompareLabels;
using hasp::DiceSettings;
using hasp::GridGeometry;
using hasp::GridView;
using hasp::LabelDice;
using hasp::LabelPairing;
using hasp::SegmentationDice;
using Labels = std::vector<std::uint16_t>;

GridGeometry GridOf(const glm::ivec3& dims, const glm::dvec3& spacing = glm::dvec3(1.0))
{
  GridGeometry grid;
  grid.dims = dims;
  grid.spacing = spacing;
  return grid;
}

SegmentationDice Compare(
  const Labels& a, const Labels& b, const GridGeometry& grid, const DiceSettings& settings = {})
{
  return CompareLabels(
    GridView<const std::uint16_t>{ a.data(), grid }, { b.data(), grid }, settings);
}

/// Labels over a box, `to` not included.
void Fill(
  Labels& labels, const GridGeometry& grid, const glm::ivec3& from, const glm::ivec3& to, int label)
{
  for (int k = from.z; k < to.z; ++k)
    for (int j = from.y; j < to.y; ++j)
      for (int i = from.x; i < to.x; ++i)
        labels[GridView<std::uint16_t>{ labels.data(), grid }.Offset(i, j, k)] =
          static_cast<std::uint16_t>(label);
}

/// Lumps of a few labels, as alike in both maps as `alike` says.
Labels Lumps(const GridGeometry& grid, int labels, std::mt19937_64& random)
{
  Labels map(grid.Size(), 0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int n = 0; n < 12; ++n)
  {
    glm::ivec3 from, to;
    for (int a = 0; a < 3; ++a)
    {
      from[a] = static_cast<int>(share(random) * grid.dims[a]);
      to[a] = std::min(grid.dims[a], from[a] + 1 + static_cast<int>(share(random) * 5.0));
    }
    Fill(map, grid, from, to, static_cast<int>(share(random) * (labels + 1)));
  }
  return map;
}

struct SurfaceVoxel
{
  glm::dvec3 at;
  double area;
};

/// All pairs of voxels and faces, in world coordinates: nothing shared with the code on trial.
std::vector<SurfaceVoxel> SurfaceOf(const Labels& labels, const GridGeometry& grid, int label)
{
  std::vector<SurfaceVoxel> surface;
  const auto inside = [&](const glm::ivec3& p)
  {
    return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < grid.dims.x && p.y < grid.dims.y &&
           p.z < grid.dims.z;
  };
  const auto at = [&](const glm::ivec3& p)
  { return labels[(std::size_t(p.z) * grid.dims.y + p.y) * grid.dims.x + p.x]; };
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
      {
        const glm::ivec3 p(i, j, k);
        if (at(p) != label)
          continue;
        double area = 0.0;
        for (int a = 0; a < 3; ++a)
          for (const int side : { -1, 1 })
          {
            glm::ivec3 q = p;
            q[a] += side;
            if (inside(q) && at(q) != label)
              area += grid.spacing.x * grid.spacing.y * grid.spacing.z / grid.spacing[a];
          }
        if (area > 0.0)
          surface.push_back({ grid.IndexToWorld(p), area });
      }
  return surface;
}

double NearArea(
  const std::vector<SurfaceVoxel>& of, const std::vector<SurfaceVoxel>& to, double toleranceMm)
{
  double area = 0.0;
  for (const SurfaceVoxel& voxel : of)
    if (std::any_of(to.begin(), to.end(),
          [&](const SurfaceVoxel& v) { return glm::distance(v.at, voxel.at) <= toleranceMm; }))
      area += voxel.area;
  return area;
}

TEST(Dice, NonsenseIsRefused)
{
  const GridGeometry grid = GridOf({ 4, 3, 2 });
  const Labels some(24, 2), none(24, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Compare(none, some, grid), std::invalid_argument);
  EXPECT_THROW(Compare(some, some, grid, { -1.0 }), std::invalid_argument);
  EXPECT_THROW(Compare(some, some, grid, { nan }), std::invalid_argument);
  EXPECT_THROW(Compare(some, some, grid, { 1e4 }), std::invalid_argument);
  GridGeometry moved = grid;
  moved.origin.x += 0.02;
  const GridView<const std::uint16_t> truth{ some.data(), grid };
  EXPECT_THROW(CompareLabels(truth, { some.data(), moved }), std::invalid_argument);
  EXPECT_THROW(CompareLabels(truth, { some.data(), GridOf({ 3, 4, 2 }) }), std::invalid_argument);
  EXPECT_THROW(CompareLabels(truth, truth, {}, [](double) { return false; }), hasp::Cancelled);
}

TEST(Dice, AMovedCubeHasTheClosedForm)
{
  // 10 x 8 x 6 voxels, moved by 2 along x: 8/10 is shared. A side of 1.5 x 1 mm on x faces.
  const GridGeometry grid = GridOf({ 20, 20, 20 }, { 0.5, 1.5, 1.0 });
  Labels truth(grid.Size(), 0), result(grid.Size(), 0);
  Fill(truth, grid, { 3, 5, 5 }, { 13, 13, 11 }, 7);
  Fill(result, grid, { 5, 5, 5 }, { 15, 13, 11 }, 7);
  const SegmentationDice dice = Compare(truth, result, grid, { 0.5 });
  ASSERT_EQ(dice.labels.size(), 1U);
  const LabelDice& d = dice.labels[0];
  EXPECT_EQ(d.sharedVoxels, 8U * 8 * 6);
  EXPECT_DOUBLE_EQ(d.Dice(), 0.8);
  const double cube = 2.0 * (8 * 6 * 1.5 * 1.0 + 10 * 6 * 0.5 * 1.0 + 10 * 8 * 0.5 * 1.5);
  EXPECT_DOUBLE_EQ(d.truthAreaMm2, cube);
  EXPECT_DOUBLE_EQ(d.resultAreaMm2, cube);
  // Tolerance of one voxel along x, none along the others. Of ten layers along x the first (its x
  // faces and its rim) is two voxels off, the second's rim is one voxel off the other's first,
  // whose inside is surface, too. The last layer's inside is two off the other's last; its rim is
  // on it.
  const double rim = 2.0 * (6 * 0.5 * 1.0 + 8 * 0.5 * 1.5);
  const double corners = (2.0 * 8 + 2.0 * 6 - 4.0) * 1.5; // x faces of the last layer's rim
  EXPECT_DOUBLE_EQ(d.truthNearMm2, 9.0 * rim + corners);
  EXPECT_EQ(dice.strayVoxels, 0U);
  EXPECT_DOUBLE_EQ(Compare(truth, result, grid, { 1.0 }).labels[0].SurfaceDice(), 1.0);
}

TEST(Dice, SurfacesMatchBruteForceOnAnisotropicTurnedGrids)
{
  std::mt19937_64 random(5);
  GridGeometry grid = GridOf({ 11, 9, 8 }, { 0.4, 1.0, 1.7 });
  const double c = std::cos(0.3), s = std::sin(0.3);
  grid.direction = { c, s, 0, s, -c, 0, 0, 0, 1 };
  grid.origin = { -30.0, 12.0, 99.0 };
  for (int n = 0; n < 20; ++n)
  {
    const Labels truth = Lumps(grid, 3, random);
    Labels result = truth;
    Fill(result, grid, { 2, 2, 2 }, { 7, 6, 5 }, n % 4);
    for (const double tolerance : { 0.0, 0.4, 1.05, 2.3 })
    {
      const SegmentationDice dice = Compare(truth, result, grid, { tolerance });
      for (const LabelDice& d : dice.labels)
      {
        const auto a = SurfaceOf(truth, grid, d.truth), b = SurfaceOf(result, grid, d.truth);
        const double reach = tolerance + 1e-9; // places are rounded
        EXPECT_NEAR(d.truthNearMm2, NearArea(a, b, reach), 1e-9);
        EXPECT_NEAR(d.resultNearMm2, d.result == 0 ? 0.0 : NearArea(b, a, reach), 1e-9);
        EXPECT_NEAR(d.truthAreaMm2, NearArea(a, a, reach), 1e-9);
        std::size_t both = 0, one = 0, other = 0;
        for (std::size_t v = 0; v < truth.size(); ++v)
        {
          both += truth[v] == d.truth && result[v] == d.truth;
          one += truth[v] == d.truth;
          other += result[v] == d.truth;
        }
        EXPECT_DOUBLE_EQ(d.Dice(), 2.0 * double(both) / double(one + other));
      }
    }
  }
}

TEST(Dice, OneMapWithItselfIsOneAndABorderIsNoSurface)
{
  const GridGeometry grid = GridOf({ 6, 5, 4 });
  Labels half(grid.Size(), 2);
  Fill(half, grid, { 3, 0, 0 }, { 6, 5, 4 }, 9);
  const SegmentationDice dice = Compare(half, half, grid, { 0.0 });
  ASSERT_EQ(dice.labels.size(), 2U);
  EXPECT_DOUBLE_EQ(dice.labels[0].truthAreaMm2, 20.0);
  EXPECT_DOUBLE_EQ(dice.Worst().Dice(), 1.0);
  EXPECT_DOUBLE_EQ(dice.WorstSurface().SurfaceDice(), 1.0);
  const Labels full(grid.Size(), 2), empty(grid.Size(), 0);
  EXPECT_DOUBLE_EQ(Compare(full, full, grid).WorstSurface().SurfaceDice(), 1.0);
  EXPECT_DOUBLE_EQ(Compare(full, empty, grid).WorstSurface().SurfaceDice(), 0.0);
  EXPECT_DOUBLE_EQ(Compare(full, empty, grid).Worst().Dice(), 0.0);
}

TEST(Dice, OtherNumbersAreMatchedAndStraysCounted)
{
  const GridGeometry grid = GridOf({ 12, 4, 4 });
  Labels truth(grid.Size(), 0), result(grid.Size(), 0);
  Fill(truth, grid, { 0, 0, 0 }, { 5, 4, 4 }, 2);
  Fill(truth, grid, { 5, 0, 0 }, { 11, 4, 4 }, 3);
  Fill(result, grid, { 0, 0, 0 }, { 5, 4, 4 }, 3);
  Fill(result, grid, { 5, 0, 0 }, { 10, 4, 4 }, 40000);
  Fill(result, grid, { 11, 0, 0 }, { 12, 4, 4 }, 2);
  const SegmentationDice named = Compare(truth, result, grid);
  EXPECT_DOUBLE_EQ(named.Worst().Dice(), 0.0);
  EXPECT_EQ(named.strayVoxels, 80U);
  const SegmentationDice matched = Compare(truth, result, grid, { 1.0, LabelPairing::BestMatch });
  EXPECT_EQ(matched.labels[0].result, 3);
  EXPECT_EQ(matched.labels[1].result, 40000);
  EXPECT_DOUBLE_EQ(matched.Worst().Dice(), 10.0 / 11.0);
  EXPECT_EQ(matched.strayVoxels, 16U);
}

TEST(Dice, ThreadsChangeNoFigure)
{
  std::mt19937_64 random(8);
  const GridGeometry grid = GridOf({ 40, 30, 50 }, { 0.7, 0.8, 0.9 });
  const Labels truth = Lumps(grid, 5, random), result = Lumps(grid, 5, random);
  std::vector<SegmentationDice> dice(3);
  for (int n = 0; n < 3; ++n)
    hasp::WithThreadLimit(1 << n, [&] { dice[n] = Compare(truth, result, grid, { 2.0 }); });
  for (int n = 1; n < 3; ++n)
    for (std::size_t l = 0; l < dice[0].labels.size(); ++l)
    {
      EXPECT_EQ(dice[n].labels[l].truthNearMm2, dice[0].labels[l].truthNearMm2);
      EXPECT_EQ(dice[n].labels[l].resultAreaMm2, dice[0].labels[l].resultAreaMm2);
      EXPECT_EQ(dice[n].labels[l].sharedVoxels, dice[0].labels[l].sharedVoxels);
    }
}

/// The largest sum over all ways to give rows columns.
double BestOfAll(std::size_t row, std::size_t rows, std::size_t columns,
  const std::vector<double>& s, unsigned used)
{
  if (row == rows)
    return 0.0;
  double best = BestOfAll(row + 1, rows, columns, s, used);
  for (std::size_t c = 0; c < columns; ++c)
    if (!(used >> c & 1U))
      best =
        std::max(best, s[row * columns + c] + BestOfAll(row + 1, rows, columns, s, used | 1U << c));
  return best;
}

TEST(BestMatch, SumsAreAsLargeAsOfAllPairings)
{
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int n = 0; n < 300; ++n)
  {
    const std::size_t rows = random() % 6, columns = random() % 6;
    std::vector<double> scores(rows * columns);
    for (double& score : scores)
      score = share(random) < 0.4 ? 0.0 : std::round(8.0 * share(random)) / 8.0; // ties
    const std::vector<std::size_t> match = hasp::BestMatch(rows, columns, scores);
    ASSERT_EQ(match.size(), rows);
    double sum = 0.0;
    std::set<std::size_t> used;
    for (std::size_t row = 0; row < rows; ++row)
      if (match[row] < columns)
      {
        EXPECT_TRUE(used.insert(match[row]).second);
        EXPECT_GT(scores[row * columns + match[row]], 0.0);
        sum += scores[row * columns + match[row]];
      }
    EXPECT_NEAR(sum, BestOfAll(0, rows, columns, scores, 0U), 1e-12);
  }
}

TEST(BestMatch, NonsenseIsRefused)
{
  EXPECT_THROW(hasp::BestMatch(2, 2, std::vector<double>(3)), std::invalid_argument);
  EXPECT_THROW(hasp::BestMatch(1, 1, std::vector<double>{ -1.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::BestMatch(1, 1, std::vector<double>{ std::nan("") }), std::invalid_argument);
}

} // namespace
