#include "SeatFixture.h"

#include <gtest/gtest.h>

namespace hasp
{
namespace
{

using namespace testing;

TEST(SeatByContact, ACapComesDownByItsGapOnABall)
{
  // Of a ball's distance interpolation takes spacing^2 / (4 radius) at most: 0.003 mm.
  const double radius = 20.0, tolerance = 0.003 + 2.0 * FoundMm;
  const Map bone = MapOf(Ball({}, radius), CubeGrid(100, 0.5));
  for (const double gap : { 0.05, 0.3, 1.0 })
  {
    const Points cap = Cap(radius + gap, 1.2, 3000);
    const Seat seat = Push(cap, bone);
    EXPECT_TRUE(seat.seats);
    EXPECT_TRUE(seat.touched);
    EXPECT_NEAR(seat.depthMm, DepthOnBall(cap, radius), tolerance);
    EXPECT_NEAR(seat.depthMm, gap, 0.01 + tolerance); // the pole is no point of it
    EXPECT_NEAR(glm::length(seat.boneAt), radius, tolerance);
    EXPECT_NEAR(glm::length(seat.partAt), radius + gap, 1e-5);
    EXPECT_LT(glm::length(glm::dvec2(seat.boneAt)), 2.0); // at the pole, nearly
    EXPECT_GE(seat.points, 2U);                           // near the pole all touch nearly at once
    EXPECT_LT(seat.points, cap.size());
  }
}

TEST(SeatByContact, APlateComesDownOnAPlaneHoweverThatIsTilted)
{
  // Distances to a plane are linear: a skew grid of three spacings knows them to half a step of its
  // 16 bits, 11 mm / 65,536, and the last digits of floats.
  for (const double tilt : { 0.0, 0.5, 1.0 })
  {
    const glm::dvec3 normal(std::sin(tilt), 0.0, std::cos(tilt));
    const Map bone = MapOf(HalfSpace({}, normal), SkewGrid({ 110, 80, 60 }));
    const Points plate = Plate(16.0, 9.0);
    double expected = 1e9;
    for (const glm::dvec3& p : plate)
      expected = std::min(expected, glm::dot(normal, p) / normal.z);
    const Seat seat = Push(plate, bone, { .liftMm = 20.0, .pressMm = 30.0 });
    EXPECT_TRUE(seat.seats == (expected > 0.0));
    EXPECT_NEAR(seat.depthMm, expected, FoundMm + 5e-4 / normal.z) << tilt;
    // And so much sooner if it shall not come nearer.
    for (const double touch : { 0.5, -0.2 })
      EXPECT_NEAR(Push(plate, bone, { .liftMm = 20.0, .pressMm = 30.0, .touchMm = touch }).depthMm,
        expected - touch / normal.z, FoundMm + 5e-4 / normal.z);
  }
}

TEST(SeatByContact, ALipBelowTheEquatorIsStoppedWhereItMeetsTheUpperHalf)
{
  const double radius = 20.0, across = 19.5, below = 8.0;
  const Map bone = MapOf(Ball({}, radius), CubeGrid(100, 0.5));
  ASSERT_GT(std::hypot(across, below), radius); // it is planned beside the ball
  const double upper = std::sqrt(radius * radius - across * across);
  Points clip = Cap(radius + 0.3, 0.8, 500);
  EXPECT_TRUE(Push(clip, bone).seats);
  const Points lip = Ring(across, -below);
  clip.insert(clip.end(), lip.begin(), lip.end());
  const Seat seat = Push(clip, bone);
  EXPECT_TRUE(seat.touched);
  EXPECT_FALSE(seat.seats);
  // A ball's wall is steep there: 0.003 mm across are 4.5 times that along the way.
  EXPECT_NEAR(seat.depthMm, -(upper + below), 0.003 * radius / upper + 2.0 * FoundMm);
  EXPECT_NEAR(seat.partAt.z, -below, 1e-6);
  EXPECT_NEAR(seat.boneAt.z, upper, 0.02);
  EXPECT_NEAR(seat.boneAt.x, seat.partAt.x, 1e-9);
  EXPECT_EQ(seat.points, lip.size());
  // Where it begins beneath the ball's widest place nothing is in the lip's way.
  EXPECT_TRUE(Push(clip, bone, { .liftMm = 3.0 }).seats);
}

TEST(SeatByContact, ATurnedMapOfLongVoxelsSaysTheSameWhereverAllLies)
{
  const double radius = 20.0, across = 19.0;
  // Spacings 0.7, 1.1 and 1.6 mm: interpolation takes the sum of squares / (8 radius) at most.
  const double mm = (0.49 + 1.21 + 2.56) / (8.0 * radius) + 5e-4;
  const Map bone = MapOf(Ball({}, radius), SkewGrid({ 90, 60, 44 }));
  const Points cap = Cap(radius + 0.6, 1.0, 2000), lip = Ring(across, -7.0);
  const double upper = std::sqrt(radius * radius - across * across);
  Dice dice(7);
  for (int n = 0; n < 6; ++n)
  {
    const RigidPose all = AnyPose(dice, 300.0), axes = AnyPose(dice, 40.0);
    const SeatSettings settings{ .withdrawal = all.Turn({ 0, 0, 1 }) };
    const auto seen = [&](Points points) // from the part's axes
    {
      for (glm::dvec3& p : points)
        p = axes.Inverse().Place(p);
      return points;
    };
    const Seat seat = Push(seen(cap), { { bone, all } }, settings, all * axes);
    EXPECT_TRUE(seat.seats);
    EXPECT_NEAR(seat.depthMm, DepthOnBall(cap, radius), mm + 2.0 * FoundMm);
    EXPECT_NEAR(glm::distance(seat.boneAt, all.position), radius, mm + 2.0 * FoundMm);
    const Seat stopped = Push(seen(lip), { { bone, all } }, settings, all * axes);
    EXPECT_FALSE(stopped.seats);
    EXPECT_NEAR(stopped.depthMm, -(upper + 7.0), mm * radius / upper + 2.0 * FoundMm);
  }
}

TEST(SeatByContact, AgreesWithEveryPointMarchedThroughTheClosedForm)
{
  // Interpolation is off by spacing^2 / 8 of the bumps' curvature in three axes, 0.8 * 0.25 * 3 and
  // the ball's: 0.02 mm; so the touch lies between those of surfaces so far out and in.
  const double offMm = 0.025, stepMm = 0.005;
  const DistanceFunction bone = BumpyBall(12.0, 0.8);
  const Map map = MapOf(bone, CubeGrid(84, 0.5));
  Dice dice(11);
  int stopped = 0, seats = 0;
  for (int n = 0; n < 12; ++n)
  {
    const glm::dvec3 up = AnyDirection(dice);
    const RigidPose at{ 20.0 * AnyDirection(dice), AnyPose(dice, 1.0).orientation };
    const SeatSettings settings{ .withdrawal = up, .liftMm = 45.0, .pressMm = 12.0 };
    Points part, world;
    for (int p = 0; p < 300; ++p)
      part.push_back(6.0 * AnyDirection(dice));
    part = Kept(part);
    for (const glm::dvec3& p : part)
      world.push_back(at.Place(p));
    const Seat seat = Push(part, { { map, {} } }, settings, at);
    const double soonest = MarchedDepth(world, bone, settings, stepMm, offMm);
    const double latest = MarchedDepth(world, bone, settings, stepMm, -offMm);
    if (!std::isfinite(latest))
    {
      EXPECT_TRUE(!seat.touched || std::isfinite(soonest));
      continue;
    }
    ASSERT_TRUE(seat.touched);
    EXPECT_GT(seat.depthMm, soonest - stepMm - FoundMm) << n;
    EXPECT_LT(seat.depthMm, latest + FoundMm) << n;
    EXPECT_NEAR(bone(seat.boneAt), 0.0, offMm + FoundMm);
    // The map itself, by steps: nothing that it shows is passed but what is only grazed.
    const auto shown = [&](const glm::dvec3& p) { return map->At(p).mm; };
    const double graze = 0.0005;
    EXPECT_GT(seat.depthMm, MarchedDepth(world, shown, settings, stepMm, graze) - stepMm - FoundMm);
    EXPECT_LT(seat.depthMm, MarchedDepth(world, shown, settings, stepMm, -graze) + FoundMm);
    ++(seat.seats ? seats : stopped);
  }
  EXPECT_GE(stopped, 2); // of each kind there are some
  EXPECT_GE(seats, 2);
}

TEST(SeatByContact, ASheetThinnerThanAVoxelStopsWhatComesFromFarOff)
{
  const auto sheet = [](const glm::dvec3& p) { return std::abs(p.z) - 0.2; };
  const Map bone = MapOf(sheet, CubeGrid(33, 0.5), 1.0); // samples at z = 0
  for (int n = 0; n < 40; ++n)                           // wherever its steps fall
  {
    const Seat seat = Push(Plate(8.0, -20.0 + 0.01 * n, 4), bone, { .liftMm = 900.0 + 0.037 * n });
    EXPECT_FALSE(seat.seats);
    // Beside the kink at 0 interpolation is exact.
    EXPECT_NEAR(seat.depthMm, -20.2 + 0.01 * n, 2.0 * FoundMm);
    EXPECT_NEAR(seat.boneAt.z, 0.2, 2.0 * FoundMm);
  }
}

TEST(SeatByContact, WhatPassesBesideBoneTouchesIfItIsNearerThanAsked)
{
  // A ridge whose field is linear but for a kink at samples: interpolation is exact.
  const auto ridge = [](const glm::dvec3& p) { return (p.x + std::abs(p.z)) / std::sqrt(2.0); };
  const Map bone = MapOf(ridge, CubeGrid(61, 0.5));
  const double touch = 0.5, half = 0.2; // so much of the way is nearer than that, up and down
  const Points part = Kept({ { touch * std::sqrt(2.0) - half, 0, 0 } });
  for (int n = 0; n < 40; ++n) // wherever its steps fall
  {
    const double lift = 20.0 + 0.013 * n;
    const Seat seat = Push(part, bone, { .liftMm = lift, .touchMm = touch });
    EXPECT_TRUE(seat.touched);
    EXPECT_NEAR(seat.depthMm, -half, 2.0 * FoundMm);
    EXPECT_FALSE(Push(part, bone, { .liftMm = lift }).touched);
  }
}

TEST(SeatByContact, EveryPointCountsWhateverItsLevel)
{
  const Map bone = MapOf(HalfSpace({}, { 0, 0, 1 }), CubeGrid(40));
  for (const std::size_t odd : { 0U, 1U, 77U, 200U, 333U, 511U, 575U })
  {
    Points plate = Plate(16.0, 0.9);
    plate[odd].z = 0.4; // one point that stands out
    const Seat seat = Push(plate, bone);
    EXPECT_NEAR(seat.depthMm, 0.4, 2.0 * FoundMm);
    EXPECT_EQ(seat.points, 1U);
    EXPECT_NEAR(glm::distance(seat.partAt, glm::dvec3(glm::vec3(plate[odd]))), 0.0, 1e-6);
  }
}

TEST(SeatByContact, IsWhereAHandBeginsToFeelIt)
{
  const Map map = MapOf(BumpyBall(12.0, 0.8), SkewGrid({ 60, 44, 30 }));
  const auto shell = ShellOf(Cap(13.2, 1.0, 4000));
  Dice dice(3);
  for (int n = 0; n < 4; ++n)
  {
    const RigidPose bone = AnyPose(dice, 80.0), part = bone * RigidPose{ {}, TurnBy({ 0, 0, n }) };
    const SeatSettings settings{ .withdrawal = bone.Turn({ 0, 0, 1 }) };
    const std::vector<HapticBody> bones{ { map, bone } };
    const Seat seat = SeatByContact(*shell, part, bones, settings);
    ASSERT_TRUE(seat.touched);
    HapticScene scene({ { shell, {} } }, bones);
    scene.Set({ ContactSettings(), 99.0 });
    const auto felt = [&](double depth)
    {
      return scene.At({ part.position - depth * settings.withdrawal, part.orientation })
        .sums.contacts;
    };
    EXPECT_EQ(felt(seat.depthMm - 2.0 * FoundMm), 0U);
    EXPECT_GE(felt(seat.depthMm + 2.0 * FoundMm), 1U);
  }
}

TEST(SeatByContact, OfSeveralBonesTheFirstThatIsMetStopsIt)
{
  const Map ground = MapOf(HalfSpace({}, { 0, 0, 1 }), CubeGrid(40));
  const Map knob = MapOf(Ball({}, 3.0), CubeGrid(40));
  const RigidPose beside{ { 5, 0, -1.5 }, { 1, 0, 0, 0 } }; // its top at z = 1.5
  const std::vector<HapticBody> bones{ { ground, {} }, { knob, beside } };
  const Seat seat = Push(Plate(16.0, 2.0, 64), bones, {});
  EXPECT_TRUE(seat.seats);
  EXPECT_EQ(seat.bone, 1U);
  EXPECT_NEAR(seat.depthMm, 0.5, 0.1); // 1 mm voxels of a small ball: spacing^2 / (4 r)
  EXPECT_EQ(Push(Plate(4.0, 2.0), bones, {}).bone, 0U);
}

} // namespace
} // namespace hasp
