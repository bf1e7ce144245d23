#include "Devices/WorkspaceMapping.h"

#include "Grid/Testing/CountNew.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

namespace
{

using namespace hasp;

constexpr double Tick = 0.001;

double Turned(const glm::dquat& a, const glm::dquat& b)
{
  return glm::length(RotationVector(a * glm::conjugate(b)));
}

/// A closed way through the workspace, moves and turns together.
RigidPose Loop(double share)
{
  const double a = 2.0 * std::numbers::pi * share;
  return { { 20 * std::sin(a), 15 * (1 - std::cos(a)), 9 * std::sin(2 * a) },
    TurnBy({ 0.5 * std::sin(a), 0.4 * (1 - std::cos(a)), 0.3 * std::sin(3 * a) }) };
}

TEST(WorkspaceMapping, SettingsOutOfRangeAreRefused)
{
  const double nan = std::nan("");
  EXPECT_THROW(WorkspaceMapping({ .scale = 0.0 }), std::invalid_argument);
  EXPECT_THROW(WorkspaceMapping({ .scale = -1.0 }), std::invalid_argument);
  EXPECT_THROW(WorkspaceMapping({ .scale = nan }), std::invalid_argument);
  EXPECT_THROW(WorkspaceMapping({ .forceGain = -0.1 }), std::invalid_argument);
  EXPECT_THROW(WorkspaceMapping({ .fadeS = 2.0 }), std::invalid_argument);
}

TEST(WorkspaceMapping, WhatIsNoPoseMovesNothing)
{
  WorkspaceMapping mapping;
  mapping.Update({ { 1, 2, 3 } }, false, Tick);
  RigidPose bad{ { std::nan(""), 0, 0 } };
  EXPECT_EQ(mapping.Update(bad, false, Tick).position, glm::dvec3(1, 2, 3));
  bad = { {}, { 0, 0, 0, 0 } };
  EXPECT_EQ(mapping.Update(bad, true, Tick).position, glm::dvec3(1, 2, 3));
  EXPECT_FALSE(mapping.SetAxes({ 0, 0, 0, 0 }));
  EXPECT_FALSE(mapping.SetAxes({ std::nan(""), 0, 0, 0 }));
  EXPECT_FALSE(mapping.SetScale(0.0));
  EXPECT_FALSE(mapping.SetScale(std::nan("")));
  mapping.Place(bad);
  EXPECT_EQ(mapping.Tool().position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(mapping.ToDevice({ { std::nan(""), 1, 1 }, { 1, 1, 1 } }).torque, glm::dvec3(0.0));
}

TEST(WorkspaceMapping, RightOfTheDeviceIsRightOnTheScreen)
{
  // A camera that looks along world -x with z up: its right is +y.
  const glm::dquat camera(
    glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)));
  WorkspaceMapping mapping({ .scale = 2.5 });
  mapping.Place({ { 100, 200, 300 }, camera });
  const glm::dvec3 right = mapping.Update({ { 4, 0, 0 } }, false, Tick).position;
  EXPECT_LT(glm::length(right - glm::dvec3(100, 210, 300)), 1e-12);
  const glm::dvec3 up = mapping.Update({ { 0, 4, 0 } }, false, Tick).position;
  EXPECT_LT(glm::length(up - glm::dvec3(100, 200, 310)), 1e-12);
  // A turn about the device's right is one about the screen's.
  const RigidPose& turned = mapping.Update({ {}, TurnBy({ 0.3, 0, 0 }) }, false, Tick);
  EXPECT_LT(Turned(turned.orientation, TurnBy({ 0, 0.3, 0 }) * camera), 1e-12);
  // And a push to the world's +y is one to the right.
  EXPECT_LT(glm::length(mapping.ToDevice({ { 0, 2, 0 } }).force - glm::dvec3(2, 0, 0)), 1e-12);
}

TEST(WorkspaceMapping, TheClutchHoldsTheToolAndLetsGoWithoutAJump)
{
  WorkspaceMapping mapping({ .scale = 3.0 });
  mapping.Place({ { 10, 20, 30 }, TurnBy({ 0.2, 0.7, -0.4 }) });
  RigidPose before = mapping.Update(Loop(0.0), false, Tick);
  for (int tick = 1; tick <= 1000; ++tick)
  {
    const bool held = (tick > 200 && tick <= 500) || (tick > 700 && tick <= 900);
    const RigidPose device = Loop(0.001 * tick), deviceBefore = Loop(0.001 * (tick - 1));
    const RigidPose tool = mapping.Update(device, held, Tick);
    const double moved = glm::length(tool.position - before.position);
    if (held || tick == 501 || tick == 901) // the tick of the release is where it anchors
    {
      EXPECT_EQ(tool.position, before.position) << tick;
      EXPECT_EQ(tool.orientation, before.orientation) << tick;
    }
    else
    {
      EXPECT_NEAR(moved, 3.0 * glm::length(device.position - deviceBefore.position), 1e-10);
      EXPECT_NEAR(Turned(tool.orientation, before.orientation),
        Turned(device.orientation, deviceBefore.orientation), 1e-10);
    }
    before = tool;
  }
}

TEST(WorkspaceMapping, ACameraThatMovesMovesNoTool)
{
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  WorkspaceMapping mapping;
  mapping.Update(Loop(0.3), false, Tick);
  for (int n = 0; n < 200; ++n)
  {
    const RigidPose before = mapping.Tool();
    const glm::dquat axes = TurnBy({ normal(random), normal(random), normal(random) });
    ASSERT_TRUE(mapping.SetAxes(axes));
    ASSERT_TRUE(mapping.SetScale(std::exp(normal(random))));
    const RigidPose device = Loop(0.3 + 0.001 * n), next = Loop(0.3 + 0.001 * (n + 1));
    const RigidPose same = mapping.Update(device, false, Tick);
    EXPECT_LT(glm::length(same.position - before.position), 1e-10);
    EXPECT_LT(Turned(same.orientation, before.orientation), 1e-12);
    const RigidPose moved = mapping.Update(next, false, Tick);
    const glm::dvec3 way = mapping.Scale() * (axes * (next.position - device.position));
    EXPECT_LT(glm::length(moved.position - same.position - way), 1e-10);
  }
}

TEST(WorkspaceMapping, ForceGoesWithTheClutchAndComesBack)
{
  WorkspaceMapping mapping({ .fadeS = 0.05 });
  const Wrench push{ { 0, 0, 2 }, { 0, 10, 0 } };
  EXPECT_EQ(mapping.ToDevice(push).force, push.force);
  for (int tick = 1; tick <= 200; ++tick)
  {
    mapping.Update({}, tick <= 100, Tick);
    const double share =
      tick <= 100 ? std::max(0.0, 1.0 - tick / 50.0) : std::min(1.0, (tick - 100) / 50.0);
    EXPECT_NEAR(mapping.ForceShare(), share, 1e-12);
    EXPECT_NEAR(mapping.ToDevice(push).force.z, 2.0 * share, 1e-12);
    EXPECT_NEAR(mapping.ToDevice(push).torque.y, 10.0 * share, 1e-12);
  }
}

/// A scene with an energy: a spring on a point off the tool's origin, so that moves and turns
/// exchange it.
struct Spring
{
  glm::dvec3 arm{ 12, -5, 30 }, hook{ 15, 25, 20 };
  double k = 0.3;
  double Energy(const RigidPose& tool) const
  {
    const glm::dvec3 apart = tool.Place(this->arm) - this->hook;
    return 0.5 * this->k * glm::dot(apart, apart);
  }
  Wrench Force(const RigidPose& tool) const
  {
    const glm::dvec3 force = -this->k * (tool.Place(this->arm) - this->hook);
    return { force, glm::cross(tool.Turn(this->arm), force) };
  }
};

/// The work that the device does on the hand along a way is (gain / scale) of the energy that the
/// scene gives: none around a loop, at any scale.
TEST(WorkspaceMapping, PowerIsConservedUpToTheScale)
{
  const Spring spring;
  for (const double scale : { 0.2, 1.0, 5.0 })
    for (const double gain : { 0.5, 1.0 })
    {
      WorkspaceMapping mapping({ .scale = scale, .forceGain = gain });
      mapping.Place({ { 5, 5, 5 }, TurnBy({ 1.0, -0.3, 0.6 }) });
      constexpr int Steps = 20'000;
      double work = 0.0, most = 0.0, worst = 0.0;
      RigidPose before = Loop(0.0);
      const double start = spring.Energy(mapping.Update(before, false, Tick));
      for (int n = 1; n <= Steps; ++n)
      {
        // The midpoint rule: of second order in a step of 1e-4 of the loop.
        const RigidPose middle = Loop((n - 0.5) / Steps), after = Loop(double(n) / Steps);
        const Wrench felt = mapping.ToDevice(spring.Force(mapping.Update(middle, false, Tick)));
        work += glm::dot(felt.force, after.position - before.position) +
                glm::dot(felt.torque,
                  RotationVector(after.orientation * glm::conjugate(before.orientation)));
        const double given =
          gain / scale * (start - spring.Energy(mapping.Update(after, false, Tick)));
        worst = std::max(worst, std::abs(work - given));
        most = std::max(most, std::abs(given));
        before = after;
      }
      EXPECT_GT(most, 10.0 * gain) << "there was energy to lose";
      EXPECT_LT(worst, 1e-6 * most) << scale << " " << gain;
      EXPECT_LT(std::abs(work), 1e-6 * most) << "and none is left over";
    }
}

TEST(WorkspaceMapping, ATickTakesNoMemory)
{
  WorkspaceMapping mapping;
  const std::size_t before = test::NewCountOfAllThreads();
  for (int tick = 0; tick < 100; ++tick)
  {
    mapping.SetAxes(TurnBy({ 0.01 * tick, 0, 0 }));
    mapping.Update(Loop(0.01 * tick), tick % 10 == 0, Tick);
    mapping.ToDevice({ { 1, 2, 3 } });
  }
  EXPECT_EQ(test::NewCountOfAllThreads(), before);
}

/// A time or place that is none must not stay: forces come back, and the tool does.
TEST(WorkspaceMapping, ABadTickIsForgotten)
{
  WorkspaceMapping mapping({ .scale = 1000.0 });
  mapping.Update({}, false, std::nan(""));
  EXPECT_EQ(mapping.ToDevice({ { 1, 0, 0 } }).force, glm::dvec3(1, 0, 0));
  mapping.Update({ glm::dvec3(0.001, 0, 0) }, false, 0.001);
  EXPECT_EQ(mapping.Update({ glm::dvec3(1e306) }, false, 0.001).position, glm::dvec3(1, 0, 0))
    << "too far for doubles: the tool stays";
  mapping.Update({ glm::dvec3(1e306) }, true, 0.001); // and the anchor is not there either
  mapping.Update({}, true, 0.001);
  mapping.Update({}, false, 0.001);
  EXPECT_EQ(
    mapping.Update({ glm::dvec3(0.001, 0, 0) }, false, 0.001).position, glm::dvec3(2, 0, 0));
}

} // namespace
