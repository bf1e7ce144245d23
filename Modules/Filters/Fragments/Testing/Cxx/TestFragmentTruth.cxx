// What fragments measure, held against the solids that they are.
#include "BrokenBall.h"

#include "Evaluation/MeshCheck.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>

namespace
{

using hasp::testing::BrokenBall;

struct GridCase
{
  const char* name;
  glm::ivec3 dims;
  glm::dvec3 spacing;
  glm::dmat3 axes;
  int axis;
};

const GridCase Cases[] = {
  { "upright", { 44, 44, 44 }, glm::dvec3(0.5), glm::dmat3(1.0), 0 },
  { "anisotropic, turned", { 44, 37, 22 }, { 0.5, 0.6, 1.0 }, hasp::testing::SkewAxes(false), 2 },
  { "mirrored", { 40, 44, 30 }, { 0.6, 0.5, 0.8 }, hasp::testing::SkewAxes(true), 1 },
};

class FragmentTruth : public ::testing::TestWithParam<GridCase>
{
protected:
  FragmentTruth()
    : Ball(GetParam().dims, GetParam().spacing, GetParam().axes, GetParam().axis),
      Models(this->Ball.scan.Scan(), { .rangeMm = 3.0, .shellPoints = 2000 })
  {
    const glm::dvec3 s = GetParam().spacing;
    this->Spacing = std::min({ s.x, s.y, s.z });
  }

  /// Places within reach of a half's surface.
  std::vector<glm::dvec3> Places(int label, double reach) const
  {
    std::mt19937 engine(7);
    const hasp::AnalyticSolid half = this->Ball.Half(label);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    std::vector<glm::dvec3> places;
    while (places.size() < 2000)
    {
      const glm::dvec3 p = this->Ball.middle + (this->Ball.radius + reach) *
                                                 glm::dvec3(any(engine), any(engine), any(engine));
      if (std::abs(half.Bound(p).mm) < reach)
        places.push_back(p);
    }
    return places;
  }

  BrokenBall Ball;
  hasp::FragmentModels Models;
  double Spacing;
};

// The fragment's neighbour touches it all over the cut, where grey values say nothing. Coverage has
// 5 samples a voxel and axis, so it knows a plane along the grid to a tenth of a spacing: where the
// cut runs through the samples' middles, as in the second case, it is off by that. Elsewhere: the
// bounds of BodyDistance.h for faces, and for edges.
TEST_P(FragmentTruth, DistancesAreThoseOfTheSolid)
{
  for (const std::uint16_t label : { 2, 3 })
  {
    const auto map = this->Models.Map(label);
    const hasp::AnalyticSolid half = this->Ball.Half(label);
    double sum = 0.0, most = 0.0, atRim = 0.0;
    int count = 0;
    for (const glm::dvec3& p : this->Places(label, 3.0 * this->Spacing))
    {
      const double off = std::abs(map->At(p).mm - half.Distance(p).mm) / this->Spacing;
      if (this->Ball.ToRim(p) < 6.0 * this->Spacing)
      {
        atRim = std::max(atRim, off);
        continue;
      }
      sum += off * off;
      most = std::max(most, off);
      ++count;
    }
    ASSERT_GT(count, 500);
    std::printf("%s, label %d: %.4f spacings rms, %.3f at most; at the rim %.3f\n", GetParam().name,
      label, std::sqrt(sum / count), most, atRim);
    EXPECT_LT(std::sqrt(sum / count), 0.03 + 0.04 * (GetParam().axis == 2));
    EXPECT_LT(most, 0.12);
    EXPECT_LT(atRim, 1.5);
  }
}

TEST_P(FragmentTruth, TheSurfaceIsClosedAndHoldsTheSolid)
{
  const double exact = 2.0 / 3.0 * std::numbers::pi * std::pow(this->Ball.radius, 3.0);
  double together = 0.0;
  for (const hasp::FragmentLabel& fragment : this->Models.Labels())
  {
    const auto surface = this->Models.Surface(fragment.label);
    const hasp::MeshCheck check = hasp::CheckMesh(hasp::WeldPoints(*surface));
    EXPECT_TRUE(check.Sound()) << check.borderEdges << " " << check.crowdedEdges;
    EXPECT_EQ(check.pieces, 1U);
    // The rim is rounded, and the cut known to a tenth of a spacing: 0.8 % of the half.
    EXPECT_NEAR(check.volumeMm3, exact, 0.018 * exact);
    // Voxels are counted by their middles: a ball of R voxels errs by far less than 1 / R.
    const double counted = double(fragment.voxels) * this->Ball.scan.VoxelMm3();
    EXPECT_NEAR(check.volumeMm3, counted, 0.03 * counted);
    const hasp::AnalyticSolid half = this->Ball.Half(fragment.label);
    for (const glm::dvec3& p : surface->points)
      ASSERT_LT(half.Bound(p).mm, 0.3 * this->Spacing) << "stands out of the solid";
    together += check.volumeMm3;
  }
  EXPECT_NEAR(together, 2.0 * exact, 0.01 * 2.0 * exact); // what one lacks the other has
}

TEST_P(FragmentTruth, PointsLieOnTheSurfaceAndLookOut)
{
  for (const std::uint16_t label : { 2, 3 })
  {
    const auto shell = this->Models.Shell(label);
    const glm::dvec3 origin = this->Models.Finished(label).origin;
    const hasp::AnalyticSolid half = this->Ball.Half(label);
    int count = 0;
    glm::dvec3 sum(0.0);
    for (int level = 0; level < shell->Levels(); ++level)
    {
      const hasp::ContactPoints points = shell->Level(level);
      for (std::uint32_t n = 0; n < points.count; ++n)
      {
        if (points.x[n] == hasp::ContactPoints::FarAway)
          continue;
        const glm::dvec3 p = origin + glm::dvec3(points.x[n], points.y[n], points.z[n]);
        const glm::dvec3 normal(points.nx[n], points.ny[n], points.nz[n]);
        ++count;
        sum += normal;
        if (this->Ball.ToRim(p) < 6.0 * this->Spacing)
          continue;
        ASSERT_LT(std::abs(half.Distance(p).mm), 0.15 * this->Spacing);
        ASSERT_GT(glm::dot(normal, half.Bound(p).outward), 0.95);
      }
    }
    EXPECT_GT(count, 1000);
    EXPECT_LT(glm::length(sum) / count, 0.02) << "normals of a closed surface add up to nothing";
    const double area = 3.0 * std::numbers::pi * this->Ball.radius * this->Ball.radius;
    EXPECT_NEAR(shell->SurfaceArea(), area, 0.03 * area); // of the rim some is rounded away
  }
}

// Fragments that touch neither overlap nor leave a gap: across the cut one distance is minus the
// other.
TEST_P(FragmentTruth, NeighboursMeetInTheMiddle)
{
  const auto two = this->Models.Map(2), three = this->Models.Map(3);
  int count = 0;
  for (const glm::dvec3& p : this->Places(2, 2.0 * this->Spacing))
  {
    const double along = glm::dot(p - this->Ball.middle, this->Ball.normal);
    if (this->Ball.ToRim(p) < 6.0 * this->Spacing || std::abs(along) > 2.0 * this->Spacing)
      continue;
    ASSERT_NEAR(two->At(p).mm, -three->At(p).mm, 0.01 * this->Spacing);
    ASSERT_NEAR(two->At(p).mm, along, 0.12 * this->Spacing);
    ++count;
  }
  EXPECT_GT(count, 50);
}

INSTANTIATE_TEST_SUITE_P(Grids, FragmentTruth, ::testing::ValuesIn(Cases));

} // namespace
