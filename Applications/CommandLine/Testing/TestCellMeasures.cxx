#include "CellChecks.h"
#include "CellDepth.h"
#include "Grid/AnalyticVolumes.h"
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CompactCells.h"
#include "MeasuredRows.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

constexpr double Voxel = 0.5;

/// A ball of 5 mm in 24^3 samples.
struct Ball
{
  hasp::GridGeometry geometry{ glm::ivec3(24), glm::dvec3(-5.75), glm::dvec3(Voxel),
    glm::dmat3(1) };
  std::vector<std::int16_t> samples = hasp::SampleAnalytic<std::int16_t>(
    hasp::AnalyticSphere({ 0.1, 0.2, 0.05 }, 5.0), this->geometry, 1000.0, 0.0);

  hasp::AnyGridView View() const
  {
    return hasp::GridView<const std::int16_t>{ this->samples.data(), this->geometry };
  }
  hasp::ClusteredCells Cells() const
  {
    return hasp::ExtractActiveCells(this->View(), hasp::MinMaxBlocks(this->View()), 0.0);
  }
  std::int16_t& At(int i, int j, int k) { return this->samples[(k * 24 + j) * 24 + i]; }
};

TEST(CellMeasures, LossIsSeen)
{
  Ball ball;
  const hasp::ClusteredCells cells = ball.Cells();
  EXPECT_TRUE(CheckLossless(ball.View(), cells).Lossless());
  const glm::ivec3 cell = cells.Cell(cells.Count() / 2);
  ball.At(cell.x, cell.y, cell.z) += 1; // a corner of 1 to 8 active cells
  EXPECT_GE(CheckLossless(ball.View(), cells).wrongCorners, 1U);
  ball.At(cell.x, cell.y, cell.z) -= 1;
  ball.At(2, 2, 2) = 500; // a bubble outside: 8 cells that the list lacks
  const hasp::LosslessCheck check = CheckLossless(ball.View(), cells);
  EXPECT_EQ(check.activeInVolume, cells.Count() + 8);
  EXPECT_EQ(check.cells, cells.Count());
  EXPECT_FALSE(check.Lossless());
}

TEST(CellMeasures, SlabsAddUpToTheVolume)
{
  const Ball ball;
  const hasp::ClusteredCells cells = ball.Cells();
  std::size_t found = 0;
  for (int first = 0; first < 23; first += 8)
  {
    hasp::GridView<const std::int16_t> slab{ ball.samples.data() + first * 24 * 24, ball.geometry };
    slab.geometry.dims.z = std::min(9, 24 - first);
    const hasp::LosslessCheck check = hasp::CheckLosslessSlab(slab, first, cells);
    EXPECT_TRUE(check.Lossless());
    found += check.cells;
  }
  EXPECT_EQ(found, cells.Count());
}

TEST(CellMeasures, ShiftAndChangedSignsAreSeen)
{
  Ball ball;
  const hasp::ClusteredCells compact = hasp::CompactCells(ball.Cells());
  const hasp::CompactShift shift = MeasureShift(ball.View(), compact);
  EXPECT_EQ(shift.changedCells, 0U);
  EXPECT_GT(shift.edges, 500U);
  EXPECT_GT(shift.rms, 0.0);
  EXPECT_LE(shift.rms, shift.p999);
  EXPECT_LE(shift.p999, shift.max);
  EXPECT_LT(shift.max, 0.02); // CompactLevels' bound, 0.0135, and what c does
  const glm::ivec3 cell = compact.Cell(compact.Count() / 2);
  ball.At(cell.x, cell.y, cell.z) =
    std::int16_t(-ball.At(cell.x, cell.y, cell.z) - 1); // other side
  EXPECT_GE(MeasureShift(ball.View(), compact).changedCells, 1U);
}

TEST(CellMeasures, EachByteThatDiffersCounts)
{
  const Ball ball;
  const hasp::ClusteredCells cells = ball.Cells();
  hasp::ClusteredCells other = cells;
  EXPECT_EQ(DifferentBytes(cells, other), 0U);
  other.corners[3] ^= 0x00FF00FFU;
  EXPECT_EQ(DifferentBytes(cells, other), 2U);
  other.clusters.pop_back();
  EXPECT_EQ(DifferentBytes(cells, other), 2U + sizeof(hasp::CellCluster));
}

std::vector<hasp::WorldRay> RaysThroughTheBall()
{
  std::vector<hasp::WorldRay> rays;
  for (int y = -30; y <= 30; ++y)
    for (int x = -30; x <= 30; ++x)
      rays.push_back({ { 0.18 * x + 0.003, 0.18 * y + 0.007, -20.0 }, { 0, 0, 1 } });
  return rays;
}

hasp::SurfacePoints TruePoints(const hasp::DepthTruth& truth)
{
  hasp::SurfacePoints points;
  for (const auto& hit : truth.hits)
    points.push_back(hit ? std::optional(hit->position) : std::nullopt);
  return points;
}

TEST(CellMeasures, DepthIsMeasuredAlongTheRay)
{
  const Ball ball;
  const hasp::DepthTruth truth(ball.View(), 0.0, RaysThroughTheBall());
  hasp::SurfacePoints shown = TruePoints(truth);
  const hasp::DepthErrors none = MeasureDepth(truth, shown);
  EXPECT_GT(none.surface, 2000U);
  EXPECT_EQ(none.max, 0.0);
  EXPECT_EQ(none.missed + none.invented + none.tangent, 0U);
  for (auto& point : shown)
    if (point)
      point->z += 0.1 * Voxel;
  const hasp::DepthErrors tenth = MeasureDepth(truth, shown);
  EXPECT_NEAR(tenth.rms, 0.1, 1e-9);
  EXPECT_NEAR(tenth.max, 0.1, 1e-9);
  EXPECT_EQ(tenth.missed, 0U);
}

TEST(CellMeasures, MissedInventedAndTangentRaysAreToldApart)
{
  const Ball ball;
  const hasp::DepthTruth truth(ball.View(), 0.0, RaysThroughTheBall());
  hasp::SurfacePoints shown = TruePoints(truth);
  const std::size_t middle = shown.size() / 2;
  ASSERT_TRUE(shown[middle]);
  shown[middle].reset();
  ASSERT_TRUE(shown[middle + 1]);
  shown[middle + 1]->z += 5.0; // another sheet
  ASSERT_FALSE(shown[0]);
  shown[0] = glm::dvec3(-5.4, -5.4, 0.0);
  const hasp::DepthErrors errors = MeasureDepth(truth, shown);
  EXPECT_EQ(errors.missed, 2U);
  EXPECT_EQ(errors.invented, 1U);
  EXPECT_EQ(errors.tangent, 0U);
  EXPECT_NEAR(errors.MissedShare(), 3.0 / double(errors.surface), 1e-12);
}

/// Rays that pass the ball's rim within a thousandth and a hundred-thousandth of a voxel.
TEST(CellMeasures, OnlyRaysWithinAFloatOfTheRimAreExcused)
{
  const Ball ball;
  const auto hits = [&](double x)
  {
    return hasp::DepthTruth(ball.View(), 0.0, { { { x, 0.2, -20.0 }, { 0, 0, 1 } } })
      .hits[0]
      .has_value();
  };
  double in = 0.1, out = 5.7; // of the rim along x
  ASSERT_TRUE(hits(in));
  ASSERT_FALSE(hits(out));
  for (int n = 0; n < 60; ++n)
    (hits(0.5 * (in + out)) ? in : out) = 0.5 * (in + out);
  for (const auto& [voxels, excused] : { std::pair(1e-5, 1U), std::pair(1e-3, 0U) })
  {
    const hasp::DepthTruth truth(
      ball.View(), 0.0, { { { in - voxels * Voxel, 0.2, -20.0 }, { 0, 0, 1 } } });
    const hasp::DepthErrors errors = MeasureDepth(truth, { std::nullopt });
    EXPECT_EQ(errors.tangent, excused);
    EXPECT_EQ(errors.missed, 1U - excused);
  }
}

/// Of runs shorter than a tick of the CPU clock: 0 / 0.
TEST(CellMeasures, ARatioOfNoCpuTimeIsNotSaid)
{
  hasp::PairedTimes times{ { 0.4, 0.5, 0.6 }, { 0.7, 0.8, 0.9 }, { 1.0, 2.0 }, { 2.0, 2.5 }, 9 };
  const auto said = [&](bool faster)
  { return TimedRatio("a.b", times, "rival", { 0.0 }, "ball", faster).data; };
  EXPECT_EQ(said(false), "ball; by CPU time 0.8");
  EXPECT_EQ(said(true), "ball; by CPU time 1.25");
  const double none = std::nan("");
  times.cpuRatio = { none, none, none };
  EXPECT_EQ(said(false), "ball");
  EXPECT_EQ(said(true), "ball");
}

TEST(CellMeasures, GrowthIsTheSlopeOfTheLogarithms)
{
  EXPECT_NEAR(hasp::GrowthExponent({ { 2, 12 }, { 4, 48 }, { 8, 192 } }), 2.0, 1e-12);
  EXPECT_THROW(hasp::GrowthExponent({ { 4, 12 }, { 4, 48 } }), std::invalid_argument);
  EXPECT_THROW(hasp::GrowthExponent({}), std::invalid_argument);
}

} // namespace
