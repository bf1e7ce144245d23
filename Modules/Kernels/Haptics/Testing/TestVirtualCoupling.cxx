#include "AnalyticFields.h"
#include "Grid/Testing/CountNew.h"
#include "Haptics/ExplicitCoupling.h"
#include "Haptics/FieldContact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using hasp::CouplingTick;
using hasp::RigidPose;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
const std::vector<glm::dvec3> OnePoint{ glm::dvec3(0.0) };
const std::vector<glm::dvec3> Foot{ { 10, 10, 0 }, { -10, 10, 0 }, { 10, -10, 0 },
  { -10, -10, 0 } };

hasp::VirtualCouplingSettings Settings(double stiffness, double limit)
{
  hasp::VirtualCouplingSettings settings;
  settings.spring.stiffness = stiffness;
  settings.spring.forceLimit = limit;
  return settings;
}

RigidPose At(double x, double y, double z)
{
  return { { x, y, z }, { 1, 0, 0, 0 } };
}

/// Ticks until nothing moves; the last one.
CouplingTick Settle(
  hasp::VirtualCoupling& coupling, const RigidPose& device, hasp::ToolContact& contact)
{
  CouplingTick tick;
  for (int n = 0; n < 500; ++n)
    tick = coupling.Tick(device, contact);
  return tick;
}

TEST(VirtualCoupling, WhatIsNoSettingIsRefused)
{
  const auto refused = [](auto change)
  {
    hasp::VirtualCouplingSettings settings;
    change(settings);
    EXPECT_THROW(hasp::VirtualCoupling{ settings }, std::invalid_argument);
  };
  refused([](auto& s) { s.spring.stiffness = 0.0; });
  refused([](auto& s) { s.spring.turnStiffness = -1.0; });
  refused([](auto& s) { s.spring.forceLimit = NaN; });
  refused([](auto& s) { s.spring.torqueLimit = HUGE_VAL; });
  refused([](auto& s) { s.travelMm = 0.0; });
  refused([](auto& s) { s.radiusMm = 0.0; });
  refused([](auto& s) { s.steps = 0; });
  refused([](auto& s) { s.tolerance = NaN; });
  EXPECT_THROW(hasp::ExplicitCoupling({ .massKg = 0.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::ExplicitCoupling({ .turnDamping = -1.0 }), std::invalid_argument);
}

TEST(FieldContact, PointsThatAreNoNumbersAreRefused)
{
  const hasp::test::HalfSpace ground;
  for (const double bad : { NaN, HUGE_VAL })
    for (int axis = 0; axis < 3; ++axis)
    {
      std::vector<glm::dvec3> points = Foot;
      points[1][axis] = bad;
      EXPECT_THROW(hasp::FieldContact(points, 1.0, ground), std::invalid_argument) << bad << axis;
    }
  EXPECT_THROW(hasp::FieldContact(Foot, NaN, ground), std::invalid_argument);
  EXPECT_THROW(hasp::FieldContact(Foot, -1.0, ground), std::invalid_argument);
}

TEST(VirtualCoupling, APoseThatIsNoneGivesNoWrenchAndLeavesTheTool)
{
  const hasp::test::HalfSpace ground;
  hasp::FieldContact contact(OnePoint, 10.0, ground);
  hasp::VirtualCoupling coupling;
  coupling.Place(At(0, 0, 1));
  for (const RigidPose& bad :
    { At(NaN, 0, 0), At(0, HUGE_VAL, 0), RigidPose{ glm::dvec3(0.0), { NaN, 0, 0, 0 } },
      RigidPose{ glm::dvec3(0.0), { 0, 0, 0, 0 } } })
  {
    const CouplingTick tick = coupling.Tick(bad, contact);
    EXPECT_EQ(tick.status, CouplingTick::BadDevicePose);
    EXPECT_EQ(tick.onDevice.force, glm::dvec3(0.0));
    EXPECT_EQ(tick.onDevice.torque, glm::dvec3(0.0));
    EXPECT_EQ(coupling.Tool().position.z, 1.0);
  }
}

struct NotFinite : hasp::ToolContact
{
  Answer At(const RigidPose&) noexcept override
  {
    Answer answer;
    answer.sums.contact.force.x = NaN;
    answer.sums.matrix.fill(NaN);
    return answer;
  }
};

TEST(VirtualCoupling, ContactThatIsNotFiniteNeverLeaves)
{
  NotFinite contact;
  hasp::VirtualCoupling coupling;
  const CouplingTick tick = coupling.Tick(At(1, 0, 0), contact);
  EXPECT_TRUE(tick.status & CouplingTick::Unsolved);
  EXPECT_TRUE(std::isfinite(tick.onDevice.force.x));
  EXPECT_EQ(coupling.Tool().position, glm::dvec3(0.0));
}

// Nothing near: one evaluation, the whole way, no force. An explicit tool lags by its mass.
TEST(VirtualCoupling, FollowsAtOnceWhereNothingTouches)
{
  hasp::test::HalfSpace ground;
  ground.height = -1000.0;
  hasp::FieldContact contact(Foot, 10.0, ground);
  hasp::VirtualCoupling coupling;
  const RigidPose device{ { 30, -20, 10 }, hasp::TurnBy({ 0.5, -1.0, 2.0 }) };
  const CouplingTick tick = coupling.Tick(device, contact);
  EXPECT_EQ(tick.evaluations, 1);
  EXPECT_EQ(tick.status, CouplingTick::Good);
  EXPECT_LT(glm::length(coupling.Tool().position - device.position), 1e-9); // 1e-12 of 37 mm
  EXPECT_LT(glm::length(tick.onDevice.force), 1e-9);
  EXPECT_LT(glm::length(tick.onDevice.torque), 1e-6);
}

// Springs in series: z = -depth k / (k + K), force K |z|.
TEST(VirtualCoupling, SpringsInSeriesBelowSaturation)
{
  const hasp::test::HalfSpace ground;
  for (const double stiffness : { 0.01, 0.1, 1.0, 100.0, 1e5 })
  {
    hasp::FieldContact contact(Foot, stiffness, ground);
    hasp::VirtualCoupling coupling(Settings(0.5, 1e6));
    const CouplingTick tick = Settle(coupling, At(0, 0, -2), contact);
    const double series = 0.5 * 4 * stiffness / (0.5 + 4 * stiffness);
    // 2 mm beyond tanh's straight part: u = 1e-6, off by u^2/3.
    EXPECT_NEAR(tick.onDevice.force.z, 2.0 * series, 1e-9) << stiffness;
    EXPECT_NEAR(coupling.Tool().position.z, -2.0 * series / (4 * stiffness), 1e-9) << stiffness;
    EXPECT_EQ(tick.evaluations, 1) << "a balanced tool needs no second look";
  }
}

TEST(VirtualCoupling, SaturatesSmoothlyInForceAndTorque)
{
  const hasp::CouplingSpring spring{ 0.5, 300.0, 4.0, 120.0 };
  const RigidPose origin;
  double last = 0.0;
  for (double way = 0.0; way < 100.0; way += 0.1)
  {
    const hasp::Wrench pull = spring.Pull(At(way, 0, 0), origin);
    EXPECT_NEAR(pull.force.x, 4.0 * std::tanh(0.5 * way / 4.0), 1e-12);
    EXPECT_GE(pull.force.x, last);
    EXPECT_LE(pull.force.x, 4.0);
    last = pull.force.x;
  }
  const hasp::Wrench turned = spring.Pull({ glm::dvec3(0.0), hasp::TurnBy({ 0, 2, 0 }) }, origin);
  EXPECT_NEAR(turned.torque.y, 120.0 * std::tanh(300.0 * 2.0 / 120.0), 1e-9);
  EXPECT_EQ(turned.force, glm::dvec3(0.0));
}

// Started on the far side of tanh's knee: Newton's tangent would throw the tool beyond the device.
TEST(VirtualCoupling, ASaturatedSpringDoesNotOvershoot)
{
  const hasp::test::HalfSpace ground;
  hasp::FieldContact contact(OnePoint, 10.0, ground);
  hasp::VirtualCoupling coupling(Settings(1.0, 4.0));
  coupling.Place(At(0, 0, 50));
  const CouplingTick tick = Settle(coupling, At(0, 0, -50), contact);
  EXPECT_NEAR(tick.onDevice.force.z, 4.0, 1e-9); // tanh(12) is 1 within 1e-10
  EXPECT_NEAR(coupling.Tool().position.z, -0.4, 1e-9);
}

// A step goes no farther past the clearance than the travel: no depth beyond it, at any speed.
TEST(VirtualCoupling, NoStepGoesDeeperThanTheTravel)
{
  const hasp::test::HalfSpace ground;
  for (const double speed : { 0.1, 1.0, 3.0 }) // mm a tick: m/s
  {
    hasp::FieldContact contact(Foot, 10.0, ground);
    hasp::VirtualCoupling coupling(Settings(0.5, 4.0));
    double deepest = 0.0, z = 5.0;
    coupling.Place(At(0, 0, z));
    for (int n = 0; n < 300; ++n)
    {
      z = std::max(-10.0, z - speed);
      coupling.Tick(At(0, 0, z), contact);
      deepest = std::min(deepest, coupling.Tool().position.z);
    }
    EXPECT_GE(deepest, -0.125) << speed; // equilibrium is 4 N / 40 N/mm = 0.1 mm
    EXPECT_NEAR(coupling.Tool().position.z, -0.1 * std::tanh(0.5 * 9.9 / 4.0), 1e-3) << speed;
  }
}

// A plate of thickness 2h pushes back with h sum k at most: it holds exactly the spring that is
// weaker.
TEST(VirtualCoupling, ThinPlateHoldsWhatPullsLessThanItsMiddlePushes)
{
  for (const double thickness : { 0.2, 1.0, 5.0 })
    for (const double share : { 0.5, 0.95, 1.05, 2.0 })
      for (const double speed : { 0.1, 1.0, 3.0 })
      {
        const hasp::test::Plate plate(0.5 * thickness);
        hasp::FieldContact contact(Foot, 5.0, plate);
        auto settings = Settings(0.5, share * 0.5 * thickness * 4 * 5.0);
        settings.travelMm = 0.05 * thickness;
        hasp::VirtualCoupling coupling(settings);
        double z = 5.0;
        coupling.Place(At(0, 0, z));
        for (int n = 0; n < 3000; ++n)
        {
          z = std::max(-40.0 * settings.spring.forceLimit, z - speed); // far into saturation
          coupling.Tick(At(0, 0, z), contact);
        }
        EXPECT_EQ(coupling.Tool().position.z > 0.0, share < 1.0)
          << thickness << " mm, F_sat " << share << " of h sum k, " << speed << " m/s";
      }
}

// 10 mm inside a wall: out again, within the force limit, towards the side it is nearest to.
TEST(VirtualCoupling, DeepStartComesOut)
{
  const hasp::test::HalfSpace ground;
  hasp::FieldContact contact(Foot, 10.0, ground);
  hasp::VirtualCoupling coupling(Settings(0.5, 4.0));
  coupling.Place(At(0, 0, -10));
  int ticks = 0;
  double last = -10.0;
  while (coupling.Tool().position.z < -0.2 && ticks < 50)
  {
    const CouplingTick tick = coupling.Tick(At(0, 0, -10), contact);
    EXPECT_LE(glm::length(tick.onDevice.force), 4.0);
    EXPECT_GT(coupling.Tool().position.z, last);
    last = coupling.Tool().position.z;
    ++ticks;
  }
  EXPECT_LE(ticks, 20); // 10 mm by four steps of 1/8 mm
}

// All points on one line leave the turn about it to the spring.
TEST(VirtualCoupling, CollinearPointsTurnAsTheDeviceDoes)
{
  const hasp::test::HalfSpace ground;
  const std::vector<glm::dvec3> line{ { -10, 0, 0 }, { 0, 0, 0 }, { 10, 0, 0 } };
  hasp::FieldContact contact(line, 100.0, ground);
  hasp::VirtualCoupling coupling(Settings(0.5, 4.0));
  const RigidPose device{ { 0, 0, -3 }, hasp::TurnBy({ 0.7, 0, 0 }) };
  const CouplingTick tick = Settle(coupling, device, contact);
  const glm::dvec3 turn = hasp::RotationVector(coupling.Tool().orientation);
  EXPECT_NEAR(turn.x, 0.7, 1e-9);
  EXPECT_NEAR(turn.y, 0.0, 1e-9);
  EXPECT_NEAR(tick.onDevice.torque.x, 0.0, 1e-6);
  EXPECT_GT(tick.onDevice.force.z, 1.0);
}

// A tilted foot pressed on the ground stands flat, and the torque that takes is the spring's.
TEST(VirtualCoupling, FootStandsFlatAgainstTheTurningDevice)
{
  const hasp::test::HalfSpace ground;
  hasp::FieldContact contact(Foot, 1000.0, ground);
  hasp::VirtualCoupling coupling(Settings(2.0, 40.0));
  const double tilt = 0.1;
  const RigidPose device{ { 0, 0, -5 }, hasp::TurnBy({ tilt, 0, 0 }) };
  const CouplingTick tick = Settle(coupling, device, contact);
  // Four corners of 1000 N/mm at 10 mm: 4e5 N mm/rad against 300.
  EXPECT_NEAR(hasp::RotationVector(coupling.Tool().orientation).x, 0.0, 1e-4);
  EXPECT_NEAR(tick.onDevice.torque.x, -120.0 * std::tanh(300.0 * tilt / 120.0), 0.03);
  EXPECT_EQ(tick.sums.contacts, 4U);
}

// Two walls one tool wide less a hair: both press, nothing alternates.
TEST(VirtualCoupling, BetweenTwoWallsItRests)
{
  struct Slot : hasp::ImplicitField
  {
    Sample At(const glm::dvec3& p) const noexcept override
    {
      return { 9.99 - std::abs(p.x), { p.x < 0.0 ? 1.0 : -1.0, 0, 0 } };
    }
  } slot;
  hasp::FieldContact contact(Foot, 50.0, slot);
  hasp::VirtualCoupling coupling;
  const RigidPose device{ { 3, 0, 0 }, hasp::TurnBy({ 0, 0, 0.05 }) };
  RigidPose last;
  double moved = 0.0;
  for (int n = 0; n < 300; ++n)
  {
    coupling.Tick(device, contact);
    if (n > 200)
      moved = std::max(moved, glm::length(coupling.Tool().position - last.position));
    last = coupling.Tool();
  }
  EXPECT_LT(moved, 1e-6);
}

TEST(VirtualCoupling, StiffnessThatADeviceStandsIsTheFormula)
{
  // Falcon-like, loose grip, 0 to 2 ticks of delay: facts of sampled walls.
  EXPECT_NEAR(hasp::StableStiffness(0.002, 0.001, 0.000, 1.0), 4.0, 1e-12);
  EXPECT_NEAR(hasp::StableStiffness(0.002, 0.001, 0.001, 1.0), 2.0 / 1.5, 1e-12);
  EXPECT_NEAR(hasp::StableStiffness(0.002, 0.001, 0.002, 1.0), 0.8, 1e-12);
  // The default coupling is half of what a Falcon that nobody holds stands.
  EXPECT_LE(hasp::CouplingSpring{}.stiffness, hasp::StableStiffness(0.001, 0.001, 0.001) + 1e-12);
}

TEST(VirtualCoupling, ATickTakesNoMemory)
{
  const hasp::test::HalfSpace ground;
  hasp::FieldContact contact(Foot, 10.0, ground);
  hasp::VirtualCoupling coupling;
  hasp::ExplicitCoupling rival;
  const std::size_t before = hasp::test::NewCount();
  for (int n = 0; n < 50; ++n)
  {
    coupling.Tick(At(0, 0, 1.0 - 0.1 * n), contact);
    rival.Tick(At(0, 0, 1.0 - 0.1 * n), contact);
  }
  EXPECT_EQ(hasp::test::NewCount(), before);
  std::vector<int> counted(1);
  EXPECT_GT(hasp::test::NewCount(), before) << "the counter counts";
}

// K + k < 4 m / T^2: 50 g hold 131 N/mm less the damper's share, not four times that.
TEST(ExplicitCoupling, BreaksWhereItsMassIsTooSmall)
{
  const hasp::test::HalfSpace ground;
  const auto stays = [&](double total)
  {
    hasp::FieldContact contact(Foot, 0.25 * total, ground);
    hasp::ExplicitCoupling coupling({ .spring = { .stiffness = 1.0, .forceLimit = 1e3 } });
    coupling.Place(At(0, 0, 0));
    double low = 0.0, high = -1e9;
    for (int n = 0; n < 3000; ++n)
    {
      coupling.Tick(At(0, 0, -2), contact);
      if (n > 2500)
      {
        low = std::min(low, coupling.Tool().position.z);
        high = std::max(high, coupling.Tool().position.z);
      }
    }
    return high - low < 0.01;
  };
  EXPECT_TRUE(stays(10.0));
  EXPECT_FALSE(stays(250.0)); // 4 m/T^2 = 200 N/mm
}

} // namespace
