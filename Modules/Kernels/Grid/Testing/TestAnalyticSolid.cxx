#include "Grid/AnalyticSolid.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace
{

using glm::dvec3;
using hasp::AnalyticSolid;

hasp::RoundConeShape Ball(const dvec3& at, double radius)
{
  return { at, at, radius, radius };
}

TEST(AnalyticSolid, NothingIsNoSolid)
{
  EXPECT_THROW(AnalyticSolid::Union({}), std::invalid_argument);
  EXPECT_THROW(AnalyticSolid::Intersection({}), std::invalid_argument);
}

TEST(AnalyticSolid, InsideTwoBallsTheHiddenSurfaceIsNotMeasured)
{
  // Centres 3 apart, radius 2: they meet in the circle x = 1.5, of radius sqrt(1.75).
  const AnalyticSolid both = AnalyticSolid::Union({ Ball({}, 2.0), Ball({ 3, 0, 0 }, 2.0) });
  const hasp::SolidDistance neck = both.Distance({ 1.5, 0.3, 0.0 });
  EXPECT_NEAR(neck.mm, -(std::sqrt(1.75) - 0.3), 1e-9);
  EXPECT_GT(-neck.mm, -both.Bound({ 1.5, 0.3, 0.0 }).mm) << "the bound alone falls short";
  EXPECT_NEAR(neck.nearest.y, std::sqrt(1.75), 1e-9);
  const hasp::SolidDistance deep = both.Distance({ -0.5, 0.0, 0.0 });
  EXPECT_NEAR(deep.mm, -1.5, 1e-12);
  EXPECT_EQ(deep.errorMm, 0.0);
  const hasp::SolidDistance outside = both.Distance({ 1.5, 4.0, 0.0 });
  EXPECT_NEAR(outside.mm, std::hypot(1.5, 4.0) - 2.0, 1e-12);
  EXPECT_EQ(outside.errorMm, 0.0);
}

TEST(AnalyticSolid, AboveACutTheEdgeIsNearest)
{
  // The lower half of a ball, seen from above: the rim's distance, not the cut sphere's.
  const AnalyticSolid bowl =
    AnalyticSolid(Ball({}, 5.0)).Without(hasp::HalfSpaceShape{ { 0, 0, 0 }, { 0, 0, -1 } });
  EXPECT_NEAR(bowl.Distance({ 0, 0, 2 }).mm, 2.0, 1e-12);
  const hasp::SolidDistance rim = bowl.Distance({ 6, 0, 2 });
  EXPECT_NEAR(rim.mm, std::hypot(1.0, 2.0), 1e-9);
  EXPECT_NEAR(rim.nearest.x, 5.0, 1e-9);
  EXPECT_LT(bowl.Distance({ 0, 0, -1 }).mm, 0.0);
}

/// No change of side within the distance, both sides next to the nearest point.
TEST(AnalyticSolid, DistancesHoldAgainstMembershipForManyCuts)
{
  const AnalyticSolid shell = AnalyticSolid(hasp::EllipsoidShape{ {}, { 9, 7, 8 } })
                                .Without(hasp::EllipsoidShape{ {}, { 8, 6, 7 } })
                                .Without(Ball({ 6, 5, 0 }, 4.0));
  const AnalyticSolid solid = AnalyticSolid::Union(
    { shell, hasp::RoundConeShape{ { -9, 0, 0 }, { 0, 2, 6 }, 1.5,
               0.8 } }).Without(hasp::HalfSpaceShape{ { 0, 0, -5 }, { 0, 0, 1 } });
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-11, 11), unit(-1, 1);
  int exact = 0, points = 20000;
  for (int n = 0; n < points; ++n)
  {
    const dvec3 p(any(random), any(random), any(random));
    const hasp::SolidDistance d = solid.Distance(p);
    const bool inside = solid.Bound(p).mm < 0.0;
    ASSERT_EQ(d.mm < 0.0, inside);
    ASSERT_NEAR(glm::length(p - d.nearest), std::abs(d.mm), 1e-9);
    ASSERT_LT(std::abs(solid.Bound(d.nearest).mm), 1e-8);
    ASSERT_GE(std::abs(d.mm) + 1e-12, std::abs(solid.Bound(p).mm));
    exact += d.errorMm == 0.0;
    for (int k = 0; k < 20; ++k)
    {
      const dvec3 way = glm::normalize(dvec3(unit(random), unit(random), unit(random)));
      const double clear = std::abs(d.mm) - d.errorMm; // proven
      ASSERT_EQ(solid.Bound(p + 0.999 * clear * way).mm < 0.0, inside);
    }
  }
  EXPECT_GT(exact, 0.7 * points);
}

TEST(AnalyticSolid, NearIsTheSameFieldBitForBitWithFewerShapes)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(-10, 10), unit(-1, 1);
  std::vector<AnalyticSolid> balls;
  for (int n = 0; n < 30; ++n)
    balls.emplace_back(Ball({ any(random), any(random), any(random) }, 1.0 + 0.05 * n));
  const AnalyticSolid solid = AnalyticSolid::Union(balls)
                                .Without(AnalyticSolid::Union({ balls[3], balls[7], balls[9] }))
                                .Without(hasp::EllipsoidShape{ {}, { 3, 2, 4 } });
  std::size_t most = 0;
  for (int n = 0; n < 300; ++n)
  {
    const dvec3 center(any(random), any(random), any(random));
    const double radius = 0.1 + 0.5 * std::abs(unit(random));
    const AnalyticSolid near = solid.Near(center, radius);
    most = std::max(most, near.ShapeCount());
    for (int k = 0; k < 50; ++k)
    {
      const dvec3 p = center + 0.57 * radius * dvec3(unit(random), unit(random), unit(random));
      ASSERT_EQ(near.Bound(p).mm, solid.Bound(p).mm);
      ASSERT_EQ(near.Bound(p).outward, solid.Bound(p).outward);
    }
  }
  EXPECT_LT(most, solid.ShapeCount() / 2);
}

TEST(AnalyticSolid, VolumesConvergeWithTheSquareOfTheCell)
{
  EXPECT_THROW(AnalyticSolid(hasp::HalfSpaceShape{}).Volume(1.0), std::invalid_argument);
  EXPECT_THROW(AnalyticSolid(Ball({}, 1.0)).Volume(0.0), std::invalid_argument);
  // Two balls of radius 5, 6 apart: each loses a cap of height 2, pi h^2 (3 r - h) / 3.
  const AnalyticSolid two = AnalyticSolid::Union({ Ball({}, 5.0), Ball({ 6, 0, 0 }, 5.0) });
  const double truth = 2.0 * M_PI * (4.0 / 3.0 * 125.0 - 4.0 * 13.0 / 3.0);
  EXPECT_NEAR(two.Volume(1.0), truth, 1e-2 * truth);
  EXPECT_NEAR(two.Volume(0.25), truth, 1e-3 * truth);
}

TEST(AnalyticSolid, BoxesFollowTheCombination)
{
  const AnalyticSolid cut =
    AnalyticSolid::Union({ Ball({}, 2.0), Ball({ 5, 0, 0 }, 1.0) }).Without(Ball({ 0, 0, 0 }, 1.0));
  EXPECT_EQ(cut.Bounds().low, dvec3(-2.0));
  EXPECT_EQ(cut.Bounds().high, dvec3(6.0, 2.0, 2.0));
}

} // namespace
