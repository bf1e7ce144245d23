// Stiff and extreme cases, and what is refused.
#include "SeatFixture.h"

#include <gtest/gtest.h>

namespace hasp
{
namespace
{

using namespace testing;

TEST(SeatByContact, WallsAlongTheWayWithoutAGapArePassedIfSoDeepIsNotCounted)
{
  // A pin of radius 10 whose top is z = 0, and a cup around it that is 0.02 mm too narrow.
  const auto pin = [](const glm::dvec3& p)
  { return std::max(glm::length(glm::dvec2(p)) - 10.0, p.z); };
  const Map bone = MapOf(pin, CubeGrid(60, 0.5));
  Points cup = Plate(8.0, 0.3);
  for (const double z : { -5.0, -3.0, -1.0 })
  {
    const Points wall = Ring(9.98, z);
    cup.insert(cup.end(), wall.begin(), wall.end());
  }
  const Seat stopped = Push(cup, bone);
  EXPECT_FALSE(stopped.seats);
  EXPECT_NEAR(stopped.depthMm, -5.0, 0.5); // within a voxel of the pin's edge
  const Seat seat = Push(cup, bone, { .touchMm = -0.05 });
  EXPECT_TRUE(seat.seats);
  EXPECT_NEAR(seat.depthMm, 0.35, 2.0 * FoundMm);
}

TEST(SeatByContact, VoxelsAHundredTimesAsLongAsWideAreNoDifference)
{
  GridGeometry grid{ { 240, 240, 6 }, {}, { 0.1, 0.1, 10.0 },
    glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 1, 0.3)))) };
  grid.origin = -grid.IndexToWorld(0.5 * glm::dvec3(grid.dims - 1));
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, -0.1, 1.0));
  const Map bone = MapOf(HalfSpace({}, normal), grid);
  const Points plate = Plate(4.0, 0.8);
  double expected = 1e9;
  for (const glm::dvec3& p : plate)
    expected = std::min(expected, glm::dot(normal, p) / normal.z);
  // Distances are linear; floats of an index along 0.1 mm are as fine as ever.
  EXPECT_NEAR(Push(plate, bone, { .liftMm = 4.0 }).depthMm, expected, 2.0 * FoundMm);
}

TEST(SeatByContact, APartThatIsInBoneWhereItBeginsDoesNotSeat)
{
  const Map bone = MapOf(Ball({}, 12.0), CubeGrid(60, 0.5));
  const Points cap = Cap(12.3, 1.0, 400);
  const Seat seat = Push(cap, bone, { .withdrawal = { 0, 0, -1 }, .liftMm = 5.0 });
  EXPECT_FALSE(seat.seats);
  EXPECT_TRUE(seat.touched);
  EXPECT_EQ(seat.depthMm, -5.0);
  EXPECT_LT(glm::length(seat.boneAt), 12.0);
  // Deep where distances are all alike, too.
  const Seat deep = Push({ { 0, 0, 0 } }, bone, { .liftMm = 0.0 });
  EXPECT_FALSE(deep.seats && !deep.touched);
  EXPECT_EQ(deep.depthMm, 0.0);
}

TEST(SeatByContact, WhatTouchesNothingHasNoSeat)
{
  const Map bone = MapOf(Ball({}, 12.0), CubeGrid(60, 0.5));
  const Map nothing = MapOf([](const glm::dvec3&) { return 50.0; }, CubeGrid(10));
  const SeatSettings settings{ .pressMm = 2.0 };
  const Seat seats[] = { Push(Cap(12.3, 1.0, 400), std::vector<HapticBody>{}, settings),
    Push(Cap(12.3, 1.0, 400), nothing, settings), Push({}, bone, settings),
    Push(Ring(12.5, 0.0), bone, settings), Push(Cap(14.5, 1.0, 400), bone, settings) };
  for (const Seat& seat : seats)
  {
    EXPECT_FALSE(seat.touched);
    EXPECT_FALSE(seat.seats);
    EXPECT_EQ(seat.depthMm, 2.0);
    EXPECT_EQ(seat.points, 0U);
  }
}

TEST(SeatByContact, OnePointIsEnough)
{
  const Map bone = MapOf(Ball({}, 12.0), CubeGrid(60, 0.5));
  const Seat seat = Push({ { 0, 0, 12.5 } }, bone);
  EXPECT_TRUE(seat.seats);
  EXPECT_NEAR(seat.depthMm, 0.5, 0.25 / 48.0 + 2.0 * FoundMm); // spacing^2 / (4 r)
  EXPECT_EQ(seat.points, 1U);
}

TEST(SeatByContact, SaysWhatItRefuses)
{
  const Map bone = MapOf(Ball({}, 12.0), CubeGrid(60, 0.5));
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  const auto refusal = [&](const SeatSettings& settings, const RigidPose& part = {},
                         const HapticBody& body = {}) -> std::string
  {
    try
    {
      Push(Cap(12.3, 1.0, 10), { body.map ? body : HapticBody{ bone, body.mapInWorld } }, settings,
        part);
      return "";
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
  };
  const auto says = [](const std::string& text, const char* word)
  { return text.find("seat: ") == 0 && text.find(word) != std::string::npos; };
  EXPECT_EQ(refusal({}), "");
  for (const glm::dvec3& no : { glm::dvec3(0), glm::dvec3(0, 0, 2), glm::dvec3(nan, 0, 1) })
    EXPECT_TRUE(says(refusal({ .withdrawal = no }), "withdrawal"));
  for (const double no : { -1.0, 1001.0, nan, inf })
  {
    EXPECT_TRUE(says(refusal({ .liftMm = no }), "liftMm"));
    EXPECT_TRUE(says(refusal({ .pressMm = no }), "pressMm"));
  }
  for (const double no : { nan, inf, 8.0, -8.0 }) // the map's range is 16 spacings
    EXPECT_TRUE(says(refusal({ .touchMm = no }), "touchMm"));
  for (const RigidPose& no : { RigidPose{ { nan, 0, 0 }, { 1, 0, 0, 0 } },
         RigidPose{ {}, { 0, 0, 0, 0 } }, RigidPose{ {}, { inf, 0, 0, 0 } } })
  {
    EXPECT_TRUE(says(refusal({}, no), "the part has no pose"));
    EXPECT_TRUE(says(refusal({}, {}, { bone, no }), "bones[0] has no pose"));
  }
  EXPECT_THROW(Push(Cap(12.3, 1.0, 10), { { nullptr, {} } }, {}), std::invalid_argument);
}

TEST(SeatByContact, CanBeCancelled)
{
  const Map bone = MapOf(Ball({}, 12.0), CubeGrid(60, 0.5));
  const auto shell = ShellOf(Cap(12.3, 1.0, 400));
  const std::vector<HapticBody> bones{ { bone, {} } };
  EXPECT_THROW(
    SeatByContact(*shell, {}, bones, {}, [](double share) { return share < 0.3; }), Cancelled);
  double last = -1.0;
  SeatByContact(*shell, {}, bones, {},
    [&](double share)
    {
      EXPECT_GE(share, last);
      last = share;
      return true;
    });
  EXPECT_EQ(last, 1.0);
}

TEST(SeatByContact, IsQuickEnoughToTryWhileOneLooks)
{
  const DistanceFunction bone = BumpyBall(30.0, 1.0);
  const Map map = MapOf(bone, CubeGrid(100));
  const auto shell = ShellOf(Cap(32.0, 1.4, 16'384), 256);
  const std::vector<HapticBody> bones{ { map, {} } };
  const Stopwatch stopwatch;
  const Seat seat = SeatByContact(*shell, {}, bones, {});
  const double ms = stopwatch.Milliseconds();
  EXPECT_TRUE(seat.seats);
  RecordProperty("millisecondsFor16384Points", std::to_string(ms));
  EXPECT_LT(ms, 2000.0); // debug builds and sanitizers, too: nobody shall wait for seconds
}

} // namespace
} // namespace hasp
