#include "Dice.h"
#include "Grid/Stopwatch.h"
#include "Haptics/SeatByContact.h"
#include "SampledDistance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{
namespace
{

using testing::Ball;
using testing::BumpyBall;
using testing::CubeGrid;
using testing::DistanceFunction;
using testing::HalfSpace;
using testing::SampledDistance;
using testing::SkewGrid;

using Points = std::vector<glm::dvec3>;
using Map = std::shared_ptr<const DistanceMap>;

constexpr double FoundMm = 1e-3; ///< of way, as the header promises

Map MapOf(const DistanceFunction& bone, const GridGeometry& grid, double rangeMm = 0.0)
{
  return std::make_shared<const DistanceMap>(
    SampledDistance(bone, grid).View(), DistanceMapSettings{ .rangeMm = rangeMm });
}

/// Rounded to what a shell keeps.
Points Kept(const Points& points)
{
  Points kept;
  for (const glm::dvec3& p : points)
    kept.emplace_back(glm::vec3(p));
  return kept;
}

std::shared_ptr<const PointShell> ShellOf(const Points& points, int coarsest = 16)
{
  std::vector<SurfacePoint> surface;
  for (const glm::dvec3& p : points)
    surface.push_back({ glm::vec3(p), { 0, 0, -1 } });
  const int count = std::max<int>(1, static_cast<int>(points.size()));
  return PointShell::OfPoints(surface, 100.0, glm::dvec3(0.0), { count, coarsest, 1 });
}

Seat Push(const Points& part, const std::vector<HapticBody>& bones, const SeatSettings& settings,
  const RigidPose& at = {})
{
  return SeatByContact(*ShellOf(part), at, bones, settings);
}
Seat Push(const Points& part, const Map& bone, const SeatSettings& settings = {})
{
  return Push(part, { { bone, {} } }, settings);
}

/// Within `angle` of +z, mm of `radius`: evenly spread.
Points Cap(double radius, double angle, int n)
{
  Points points;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < n; ++i)
  {
    const double z = 1.0 - (i + 0.5) / n * (1.0 - std::cos(angle)), across = std::sqrt(1.0 - z * z);
    points.push_back(
      radius * glm::dvec3(across * std::cos(golden * i), across * std::sin(golden * i), z));
  }
  return Kept(points);
}

Points Ring(double radius, double z, int n = 64)
{
  Points points;
  for (int i = 0; i < n; ++i)
  {
    const double a = 2.0 * std::numbers::pi * i / n;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
  }
  return Kept(points);
}

/// n x n points, `side` mm.
Points Plate(double side, double z, int n = 24)
{
  Points points;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      points.emplace_back(side * ((i + 0.5) / n - 0.5), side * ((j + 0.5) / n - 0.5), z);
  return Kept(points);
}

/// A ball at 0 stops a point p, pushed along -z, where |p - t z| is its radius.
double DepthOnBall(const Points& points, double radius)
{
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& p : points)
    if (const double across2 = p.x * p.x + p.y * p.y; across2 < radius * radius)
      least = std::min(least, p.z - std::sqrt(radius * radius - across2));
  return least;
}

/// By steps of a field that is no steeper than 2, the points of the part one after the other.
double MarchedDepth(const Points& world, const DistanceFunction& bone, const SeatSettings& settings,
  double stepMm, double touchMm)
{
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& p : world)
    for (double depth = -settings.liftMm; depth < std::min(settings.pressMm, least);)
    {
      const double above = bone(p - depth * settings.withdrawal) - touchMm;
      if (above < 0.0)
      {
        least = depth;
        break;
      }
      depth += std::max(0.5 * above, stepMm);
    }
  return least;
}

RigidPose AnyPose(Dice& dice, double mm)
{
  const glm::dvec3 at = dice.InBox(mm), turn = dice.InBox(1.7);
  return { at, TurnBy(turn) };
}
glm::dvec3 AnyDirection(Dice& dice)
{
  return AnyPose(dice, 1.0).Turn({ 0, 0, 1 });
}

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
