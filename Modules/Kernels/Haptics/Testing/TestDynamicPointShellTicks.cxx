// Tick after tick: room, budget, blending, repetition, and odd input.
#include "Haptics/DynamicPointShell.h"
#include "Haptics/Testing/GreyBodyOnFloor.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp::testing;
using hasp::ContactPoints;
using hasp::DistanceMap;
using hasp::DynamicPointShell;
using hasp::RigidPose;
using hasp::ShellVolume;

TEST(DynamicPointShellTicks, KeepsItsBudgetAndItsRoom)
{
  const GreyBody tool(BumpyBall(20.0, 1.5), CubeGrid(64));
  const SampledDistance body(BumpyBall(20.0, 1.5), CubeGrid(64));
  const auto map = std::make_shared<DistanceMap>(body.View());
  for (const int room : { 512, 4096, 16'384 })
  {
    hasp::DynamicPointShellSettings settings;
    settings.points = room;
    settings.pointsPerTick = 256;
    DynamicPointShell shell(tool.Volume, map, {}, settings);
    for (int tick = 0; tick < 200; ++tick)
    {
      const double a = 0.1 * (tick / 20); // stands, then turns on
      shell.Update(
        { { 20.0 * std::cos(a), 20.0 * std::sin(a), 0.0 }, hasp::TurnBy({ 0, 0, 2.0 * a }) }, 0.0);
      EXPECT_LE(shell.LastTick().drawn, 256U + 16U);
      EXPECT_LE(shell.LastTick().points, static_cast<std::uint32_t>(room));
      EXPECT_LE(shell.Points().count, static_cast<std::uint32_t>(room));
      LivePoints(shell);
    }
    EXPECT_GT(shell.LastTick().points, static_cast<std::uint32_t>(room / 4));
  }
}

TEST(DynamicPointShellTicks, WithLittleRoomTheContactComesFirst)
{
  const GreyBody ball(Ball({}, 20.0), CubeGrid(64));
  hasp::DynamicPointShellSettings settings;
  settings.points = 512; // 16 blocks
  settings.pointsPerTick = 128;
  DynamicPointShell shell(ball.Volume, Floor(), {}, settings);
  const Touch truth = BallOnFloor(20.0, 1.0);
  double most = 0.0, sum = 0.0;
  std::uint32_t mostNear = 0;
  constexpr int Ticks = 600;
  for (int tick = 0; tick < Ticks; ++tick) // the ball turns in its place, 0.1 mm a tick
  {
    const RigidPose pose{ { 0.0, 19.0, 0.0 }, hasp::TurnBy({ 0.005 * tick, 0.0, 0.0 }) };
    shell.Update(pose, 0.0);
    mostNear = std::max(mostNear, shell.LastTick().nearBlocks);
    if (tick < 20)
      continue;
    const double area = TouchOnFloor(shell, pose).area;
    most = std::max(most, std::abs(area / truth.area - 1.0));
    sum += area / (Ticks - 20);
  }
  EXPECT_GT(mostNear, 16U); // more than there is room for
  // 20 to 40 points in contact: a few per cent of scatter each, and no bias.
  EXPECT_NEAR(sum, truth.area, 0.05 * truth.area);
  EXPECT_LT(most, 0.4);
}

// A plane's corner on a floor, the last of its blocks: more are near than there is a list for.
TEST(DynamicPointShellTicks, TheNearestBlocksAreServedHoweverManyAreNear)
{
  const auto flat = [](int width, int height)
  {
    hasp::GridGeometry grid = CubeGrid(width);
    grid.dims.y = height;
    grid.origin.y = -0.5 * (height - 1);
    return grid;
  };
  const auto floor = std::make_shared<DistanceMap>(
    SampledDistance(HalfSpace({}, { 0, 1, 0 }), flat(141, 41)).View());
  const GreyBody plane(HalfSpace({}, { 0, -1, 0 }), flat(121, 9));
  const double corner = 60.0 * std::sqrt(2.0), angle = 0.28;
  const RigidPose pose{ { 0.0, corner * std::sin(angle) - 1.0, 0.0 },
    hasp::TurnBy(angle * std::sqrt(0.5) * glm::dvec3(1.0, 0.0, -1.0)) };
  const double leg = 1.0 / std::sin(angle); // of the corner's triangle, to its middle
  for (const int room : { 512, 16'384 })
  {
    hasp::DynamicPointShellSettings settings;
    settings.points = room;
    settings.pointsPerTick = 128;
    settings.marginMm = 16.0;
    DynamicPointShell shell(plane.Volume, floor, {}, settings);
    for (int tick = 0; tick < 60; ++tick)
      shell.Update(pose, 0.0);
    EXPECT_GT(shell.LastTick().nearBlocks, 80U); // 16 of 512 points, and a list of 64
    EXPECT_NEAR(TouchOnFloor(shell, pose).area, leg * leg, 0.25 * leg * leg) << room;
  }
}

TEST(DynamicPointShellTicks, AnotherReachIsDrawnForThoughTheMarginMakesUpForIt)
{
  const auto floor =
    std::make_shared<DistanceMap>(SampledDistance(HalfSpace({}, { 0, 1, 0 }), CubeGrid(49)).View(),
      hasp::DistanceMapSettings{ .rangeMm = 4.0 });
  const GreyBody ball(Ball({}, 4.0), CubeGrid(41, 0.25));
  hasp::DynamicPointShellSettings settings;
  settings.marginMm = 4.0; // with the range: 4 mm of reach and margin together, always
  const RigidPose pose{ { 0.0, 7.0, 0.0 }, {} };
  DynamicPointShell changed(ball.Volume, floor, {}, settings);
  DynamicPointShell always(ball.Volume, floor, {}, settings);
  for (int tick = 0; tick < 80; ++tick)
  {
    changed.Update(pose, tick < 40 ? 0.0 : 4.0);
    always.Update(pose, 4.0);
  }
  EXPECT_EQ(changed.LastTick().points, always.LastTick().points);
}

TEST(DynamicPointShellTicks, ForcesDoNotJumpWhileItIsFilled)
{
  const GreyBody ball(Ball({}, 9.0), SkewGrid({ 40, 28, 22 }));
  DynamicPointShell shell(ball.Volume, Floor(), {});
  const RigidPose pose{ { 0.0, 8.0, 0.0 }, hasp::TurnBy({ 0.4, 1.1, -0.2 }) };
  double last = 0.0, area = 0.0;
  const double whole = BallOnFloor(9.0, 1.0).force;
  for (int tick = 0; tick < 60; ++tick)
  {
    shell.Update(pose, 0.0);
    const double force = TouchOnFloor(shell, pose).force;
    // Blends take 8 ticks. While the first 16 points of a block get company their share of the
    // touching area is corrected, too: a quarter at most.
    EXPECT_LT(std::abs(force - last), 0.25 * whole) << tick;
    EXPECT_LT(std::abs(force - last), tick > 15 ? 0.02 * whole : whole) << tick;
    last = force;
    area = shell.LastTick().areaMm2;
  }
  EXPECT_GT(area, BallOnFloor(9.0, 1.0).area);
  EXPECT_EQ(shell.LastTick().drawn, 0U); // at rest there is nothing to do
}

TEST(DynamicPointShellTicks, IsTheSameForTheSameTicks)
{
  const GreyBody tool(BumpyBall(20.0, 1.5), CubeGrid(64));
  const auto run = [&](std::uint32_t seed)
  {
    hasp::DynamicPointShellSettings settings;
    settings.seed = seed;
    DynamicPointShell shell(tool.Volume, Floor(), {}, settings);
    for (int tick = 0; tick < 30; ++tick)
    {
      if (tick == 17)
        shell.SetIsovalue(1020.0);
      shell.Update({ { 0.3 * tick, 19.0, 0.0 }, hasp::TurnBy({ 0.0, 0.0, 0.02 * tick }) }, 0.0);
    }
    const ContactPoints p = shell.Points();
    std::vector<float> all(p.x, p.x + p.count);
    all.insert(all.end(), p.areas, p.areas + p.count);
    return all;
  };
  EXPECT_FALSE(run(1).empty());
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST(DynamicPointShellTicks, OddPosesAndOddSamples)
{
  const GreyBody ball(Ball({}, 9.0), CubeGrid(26));
  DynamicPointShell shell(ball.Volume, Floor(), {});
  const RigidPose pose{ { 0.0, 8.0, 0.0 }, {} };
  for (int tick = 0; tick < 30; ++tick)
    shell.Update(pose, 0.0);
  const std::size_t before = LivePoints(shell).size();
  EXPECT_GT(before, 100U);
  for (const RigidPose& odd : { RigidPose{ { Nan, 0, 0 }, {} }, RigidPose{ {}, { Nan, 0, 0, 0 } },
         RigidPose{ { 1.0 / 0.0, 0, 0 }, {} } })
  {
    shell.Update(odd, 0.0);
    EXPECT_EQ(LivePoints(shell).size(), before);
    shell.Update(pose, 0.0);
    EXPECT_EQ(LivePoints(shell).size(), before);
  }
  shell.Update({ { 0.0, 200.0, 0.0 }, {} }, 0.0);
  EXPECT_EQ(shell.Points().count, 0U);
  shell.Update(pose, -5.0); // as 0
  EXPECT_GT(shell.LastTick().points, 0U);
  shell.Update(pose, 1e9); // as the map's range
  EXPECT_GT(shell.LastTick().points, 0U);

  // Numbers that are none, in a body of floats: those cells have no surface.
  auto field = std::make_shared<SampledDistance>(Ball({}, 9.0), CubeGrid(26));
  for (std::size_t n = 0; n < field->samples.size(); n += 17)
    field->samples[n] =
      n % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
  ShellVolume volume;
  volume.grid = field->View();
  volume.blocks = std::make_shared<hasp::MinMaxBlocks>(volume.grid);
  volume.insideAbove = false;
  DynamicPointShell holes(volume, Floor(), {});
  for (int tick = 0; tick < 30; ++tick)
    holes.Update(pose, 0.0);
  for (const Live& p : LivePoints(holes))
    EXPECT_TRUE(std::isfinite(p.position.x + p.normal.x + p.area));
  EXPECT_GT(holes.LastTick().points, 100U); // the others have

  const GreyBody least(HalfSpace({}, { 0, 1, 0 }), SkewGrid({ 2, 2, 2 }));
  DynamicPointShell small(least.Volume, Floor(), {});
  small.Update({}, 0.0);
  EXPECT_GT(small.LastTick().points, 0U);
}

} // namespace
