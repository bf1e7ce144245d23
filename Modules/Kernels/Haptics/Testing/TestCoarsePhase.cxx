#include "Haptics/CoarsePhase.h"
#include "Haptics/Testing/SampledDistance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace
{

using namespace hasp::testing;
using hasp::CoarsePhase;
using hasp::ContactPoints;
using hasp::DistanceMap;
using hasp::PointShell;
using hasp::RigidPose;

struct Pair
{
  std::shared_ptr<const PointShell> shell;
  std::shared_ptr<const DistanceMap> map;

  Pair(const SampledDistance& tool, const SampledDistance& body, int points)
    : shell(PointShell::OfSurface(tool.View(), {}, { points, 64, 1 })),
      map(std::make_shared<DistanceMap>(body.View()))
  {
  }
};

/// How many points of the levels are within reach of the body, and how many of them are in no run.
struct Census
{
  std::size_t within = 0, missed = 0;
};
Census Count(const Pair& pair, CoarsePhase& coarse, const RigidPose& pose, double reach)
{
  Census census;
  for (int level = 0; level < pair.shell->Levels(); ++level)
  {
    const ContactPoints all = pair.shell->Level(level);
    std::vector<bool> near(all.count, false);
    for (const ContactPoints& run : coarse.Near(level))
    {
      EXPECT_EQ(run.count % ContactPoints::Lanes, 0U);
      EXPECT_EQ(run.area, all.area);
      EXPECT_EQ(run.nz - run.x, all.nz - all.x);
      std::fill_n(near.begin() + (run.x - all.x), run.count, true);
    }
    for (std::uint32_t n = 0; n < all.count; ++n)
    {
      const glm::dvec3 p = pose.Place({ all.x[n], all.y[n], all.z[n] });
      if (pair.map->At(p).mm >= reach)
        continue;
      ++census.within;
      census.missed += near[n] ? 0 : 1;
    }
  }
  return census;
}

class Draw
{
public:
  explicit Draw(std::uint32_t seed) : Random(seed) {}
  double In(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  glm::dvec3 Direction()
  {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(Random), normal(Random), normal(Random)));
  }

private:
  std::mt19937 Random;
};

/// A field as no transform makes: steps, noise, and numbers that are none.
SampledDistance BadField()
{
  SampledDistance field(BumpyBall(9.0, 1.0), SkewGrid({ 48, 34, 26 }));
  std::mt19937 random(4);
  for (float& sample : field.samples)
    if (random() % 50 == 0)
      sample = random() % 2 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                 : static_cast<float>(random() % 9) - 3.0F;
  return field;
}

TEST(CoarsePhase, NeverLeavesOutAPointWithinReach)
{
  const SampledDistance tool(Torus({ 0, 0.6, 0.8 }, 6.0, 2.5), CubeGrid(22));
  const SampledDistance bodies[] = { { BumpyBall(9.0, 1.0), SkewGrid({ 48, 34, 26 }) },
    { Torus({ 1, 0, 0 }, 8.0, 1.0), CubeGrid(27) },   // thin: its slopes are steep
    { Ball({ 10.0, 0.0, 0.0 }, 12.0), CubeGrid(24) }, // cut off by the grid's border
    BadField() };
  Draw draw(5);
  for (const SampledDistance& body : bodies)
  {
    const Pair pair(tool, body, 1000);
    std::size_t within = 0, far = 0;
    for (int n = 0; n < 100; ++n)
    {
      CoarsePhase coarse(pair.shell, pair.map);
      const RigidPose pose{ draw.Direction() * draw.In(0.0, 30.0),
        hasp::TurnBy(draw.Direction() * draw.In(0.0, 3.0)) };
      const double reach = n % 2 == 0 ? 0.0 : 3.0;
      coarse.Begin(pose, reach);
      const Census census = Count(pair, coarse, pose, reach);
      EXPECT_EQ(census.missed, 0U) << n;
      within += census.within;
      far += coarse.Asked().far;
    }
    EXPECT_GT(within, 5000U); // poses that touch
    EXPECT_GT(far, 150U);     // clusters that were left out, even of the bad field
  }
}

TEST(CoarsePhase, SleepingNeverMissesAContactAtTheGreatestMotion)
{
  const SampledDistance tool(BumpyBall(6.0, 0.6), CubeGrid(20));
  const SampledDistance body(BumpyBall(9.0, 1.0), SkewGrid({ 48, 34, 26 }));
  const Pair pair(tool, body, 3000);
  CoarsePhase coarse(pair.shell, pair.map);
  // Straight at the body and away again as fast as the coupling lets go: half a voxel a tick, and
  // the farthest point by as much again in a turn.
  const double most = 0.5 * pair.map->SmallestSpacing();
  Draw draw(6);
  RigidPose pose{ { 40.0, 0.0, 0.0 }, hasp::TurnBy({}) };
  std::size_t within = 0, clusters = 0, looked = 0, near = 0;
  for (int bout = 0; bout < 12; ++bout)
  {
    const glm::dvec3 axis = draw.Direction();
    const glm::dvec3 goal = draw.Direction() * draw.In(13.0, 16.0);
    for (int tick = 0; tick < 150; ++tick)
    {
      const glm::dvec3 way = (tick < 90 ? goal : 3.0 * goal) - pose.position;
      pose.position += glm::length(way) > most ? way * (most / glm::length(way)) : way;
      pose.orientation =
        glm::normalize(hasp::TurnBy(axis * (most / pair.shell->Radius())) * pose.orientation);
      coarse.Begin(pose, 0.0);
      const Census census = Count(pair, coarse, pose, 0.0);
      ASSERT_EQ(census.missed, 0U) << bout << ' ' << tick;
      within += census.within;
      clusters += coarse.Asked().near + coarse.Asked().far;
      looked += coarse.Asked().looked;
      near += coarse.Asked().near;
    }
  }
  EXPECT_GT(within, 1000U);
  EXPECT_LT(looked, clusters / 4); // the others slept
  EXPECT_LT(near, clusters / 2);
  RecordProperty("clusters", static_cast<int>(clusters));
  RecordProperty("near", static_cast<int>(near));
  RecordProperty("looked", static_cast<int>(looked));
}

TEST(CoarsePhase, EachKindOfMotionCountsInFull)
{
  // A small ball 20 mm from its body's origin, and a plane, whose distance is as steep as it may
  // be: what a cluster may move is used up to the last.
  const SampledDistance tool(
    Ball({ 20.0, 0.0, 0.0 }, 2.0), { glm::ivec3(9), { 16, -4, -4 }, glm::dvec3(1), glm::dmat3(1) });
  const Pair pair(tool, { HalfSpace({}, { 0, 1, 0 }), CubeGrid(65) }, 500);
  for (const bool turning : { false, true })
  {
    CoarsePhase coarse(pair.shell, pair.map);
    std::size_t within = 0;
    for (int tick = 0; tick < 45; ++tick) // to the floor from 12 mm above, 0.4 mm a tick
    {
      const RigidPose pose =
        turning ? RigidPose{ { 0.0, 0.0, 0.0 }, hasp::TurnBy({ 0.0, 0.0, 0.6 - 0.02 * tick }) }
                : RigidPose{ { 0.0, 12.0 - 0.4 * tick, 0.0 }, hasp::TurnBy({}) };
      coarse.Begin(pose, 0.0);
      const Census census = Count(pair, coarse, pose, 0.0);
      ASSERT_EQ(census.missed, 0U) << turning << ' ' << tick;
      within += census.within;
    }
    EXPECT_GT(within, 1000U);
  }
}

TEST(CoarsePhase, WithinTheClearanceNothingTouches)
{
  const SampledDistance tool(BumpyBall(6.0, 0.6), CubeGrid(20));
  const SampledDistance body(BumpyBall(9.0, 1.0), SkewGrid({ 48, 34, 26 }));
  const Pair pair(tool, body, 1000);
  Draw draw(8);
  int clear = 0;
  for (int n = 0; n < 100; ++n)
  {
    CoarsePhase coarse(pair.shell, pair.map);
    RigidPose pose{ draw.Direction() * draw.In(17.0, 45.0),
      hasp::TurnBy(draw.Direction() * draw.In(0.0, 3.0)) };
    coarse.Begin(pose, 0.0);
    Count(pair, coarse, pose, 0.0);
    const double clearance = coarse.Asked().clearanceMm;
    EXPECT_EQ(clearance == 0.0, coarse.Asked().near > 0);
    clear += clearance > 1.0 ? 1 : 0;
    // The straight way to the body is the shortest: just short of it.
    pose.position -= glm::normalize(pose.position) * (0.999 * clearance);
    CoarsePhase there(pair.shell, pair.map);
    there.Begin(pose, 0.0);
    EXPECT_TRUE(clearance == 0.0 || Count(pair, there, pose, 0.0).within == 0) << clearance;
  }
  EXPECT_GT(clear, 50);
}

// A level that sleeps is as far off as it was, less what it was moved by.
TEST(CoarsePhase, WhatSleepsTellsItsClearance)
{
  const SampledDistance tool(BumpyBall(6.0, 0.6), CubeGrid(20));
  const SampledDistance body(BumpyBall(9.0, 1.0), SkewGrid({ 48, 34, 26 }));
  const Pair pair(tool, body, 1000);
  CoarsePhase coarse(pair.shell, pair.map);
  RigidPose pose{ { 30.0, 0.0, 0.0 }, { 1, 0, 0, 0 } };
  coarse.Begin(pose, 0.0);
  Count(pair, coarse, pose, 0.0);
  const double first = coarse.Asked().clearanceMm;
  ASSERT_GT(first, 2.0); // 1 mm of it is used up below
  for (int n = 1; n <= 10; ++n)
  {
    pose.position.y = 0.1 * n;
    coarse.Begin(pose, 0.0);
    Count(pair, coarse, pose, 0.0);
    EXPECT_EQ(coarse.Asked().looked, 0U) << n;
    EXPECT_NEAR(coarse.Asked().clearanceMm, first - 0.1 * n, 1e-9) << n;
  }
}

TEST(CoarsePhase, JumpsAndNewReachesWakeWhomTheyMust)
{
  const SampledDistance tool(BumpyBall(6.0, 0.6), CubeGrid(20));
  const SampledDistance body(BumpyBall(9.0, 1.0), SkewGrid({ 48, 34, 26 }));
  const Pair pair(tool, body, 1000);
  CoarsePhase coarse(pair.shell, pair.map);
  Draw draw(7);
  std::size_t within = 0;
  RigidPose pose{ { 30.0, 0.0, 0.0 }, hasp::TurnBy({}) };
  for (int tick = 0; tick < 400; ++tick)
  {
    const double reach = tick % 3 == 0 ? 0.0 : draw.In(0.0, 6.0);
    if (tick % 5 == 0)
      pose = { draw.Direction() * draw.In(5.0, 60.0),
        hasp::TurnBy(draw.Direction() * draw.In(0.0, 3.0)) };
    if (tick % 40 == 7)
    {
      const double nan = std::numeric_limits<double>::quiet_NaN();
      RigidPose bad = pose;
      (tick % 80 == 7 ? bad.position.y : bad.orientation.z) = nan;
      coarse.Begin(bad, reach);
      const auto runs = coarse.Near(0);
      ASSERT_EQ(runs.size(), 1U); // all, for nothing is known
      EXPECT_EQ(runs[0].count, pair.shell->Level(0).count);
    }
    coarse.Begin(pose, reach);
    const Census census = Count(pair, coarse, pose, reach);
    ASSERT_EQ(census.missed, 0U) << tick;
    within += census.within;
  }
  EXPECT_GT(within, 1000U);
}

TEST(CoarsePhase, LevelsMayBeAskedNowAndThen)
{
  const SampledDistance tool(BumpyBall(6.0, 0.6), CubeGrid(20));
  const SampledDistance body(BumpyBall(9.0, 1.0), SkewGrid({ 48, 34, 26 }));
  const Pair pair(tool, body, 1000);
  CoarsePhase coarse(pair.shell, pair.map);
  for (int tick = 0; tick < 60; ++tick) // approaches by half a millimetre; all levels each tenth
  {
    const RigidPose pose{ { 40.0 - 0.5 * tick, 0.0, 0.0 }, hasp::TurnBy({}) };
    coarse.Begin(pose, 0.0);
    coarse.Near(0);
    if (tick % 10 == 9)
    {
      EXPECT_EQ(Count(pair, coarse, pose, 0.0).missed, 0U);
    }
  }
}

TEST(CoarsePhase, FarAwayACallLooksAtNothing)
{
  const SampledDistance tool(BumpyBall(6.0, 0.6), CubeGrid(20));
  const SampledDistance body(BumpyBall(9.0, 1.0), SkewGrid({ 48, 34, 26 }));
  const Pair pair(tool, body, 1000);
  CoarsePhase coarse(pair.shell, pair.map);
  coarse.Begin({ { 500.0, 0.0, 0.0 }, hasp::TurnBy({}) }, 3.0);
  const int last = pair.shell->Levels() - 1;
  EXPECT_TRUE(coarse.Near(last).empty());
  EXPECT_EQ(coarse.Asked().looked, pair.shell->Clusters(last).size());
  for (int tick = 1; tick < 900; ++tick) // 450 mm in half millimetres
  {
    coarse.Begin({ { 500.0 - 0.5 * tick, 0.0, 0.0 }, hasp::TurnBy({}) }, 3.0);
    EXPECT_TRUE(coarse.Near(last).empty());
    EXPECT_EQ(coarse.Asked().looked, 0U) << tick;
    EXPECT_EQ(coarse.Asked().far, pair.shell->Clusters(last).size());
  }
}

TEST(CoarsePhase, NothingToTouchAndNothingToTouchWith)
{
  const SampledDistance ball(Ball({}, 6.0), CubeGrid(20));
  SampledDistance empty(Ball({}, 6.0), CubeGrid(20));
  std::fill(empty.samples.begin(), empty.samples.end(), std::numeric_limits<float>::infinity());
  const Pair noBody(ball, empty, 500);
  CoarsePhase coarse(noBody.shell, noBody.map);
  coarse.Begin({}, 0.0);
  EXPECT_TRUE(coarse.Near(0).empty());
  const Pair noTool(empty, ball, 500);
  CoarsePhase nothing(noTool.shell, noTool.map);
  nothing.Begin({}, 0.0);
  EXPECT_EQ(nothing.Bytes(), 0U);
}

} // namespace
