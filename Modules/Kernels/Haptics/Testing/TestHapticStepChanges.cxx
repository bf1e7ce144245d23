// What the step does when it is placed, aimed or limited, and how it bounds what attracts.
#include "StepScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using hasp::HapticScene;
using hasp::HapticStep;
using hasp::RigidPose;
using namespace hasp::testing;

TEST(HapticStepChanges, APlacedToolMeetsItsSceneInFullAndFeelsItFromZeroOn)
{
  auto settings = Settings();
  settings.control = true;
  settings.limits.rampInS = 0.5;
  HapticStep step(settings);
  auto scene = GroundScene();
  step.Swap(scene);
  step.Place(At(0, 0, 1));
  // Grown: the ground holds the tool at once, though the device is let feel it gradually.
  const hasp::HapticTick first = Ticks(step, At(0, 0, -2), 3);
  EXPECT_GT(first.tool.position.z, -0.1);
  EXPECT_LT(first.onDevice.force.z, 0.1);
  EXPECT_GT(Ticks(step, At(0, 0, -2), 600).onDevice.force.z, 0.5);
  Ticks(step, At(0, 0, 1), 10);
  EXPECT_NE(step.Observer().Energy(), 0.0);
  step.Place(At(0, 0, 1));
  EXPECT_EQ(step.Observer().Energy(), 0.0);
  EXPECT_LT(Ticks(step, At(0, 0, -2), 3).onDevice.force.z, 0.1) << "from zero again";
}

TEST(HapticStepChanges, TravelIsAQuarterOfTheScenesVoxel)
{
  auto settings = Settings();
  settings.budgetUs = 1e-3; // one answer a tick
  HapticStep step = Ready(settings, GroundScene());
  step.Place(At(0, 0, 0.01));
  const hasp::HapticTick tick = step.Tick(At(0, 0, -20));
  EXPECT_EQ(tick.evaluations, 1);
  EXPECT_LT(tick.tool.position.z, 0.01 - 0.25 * 0.7 + 1e-9);
  EXPECT_GT(tick.tool.position.z, -0.25 * 0.7 - 1e-9) << "and what was free";
}

TEST(HapticStepChanges, NoMoreLevelsThanAsked)
{
  HapticStep step = Ready(Settings(), GroundScene());
  EXPECT_EQ(Ticks(step, At(0, 0, -2), 50).levels, 3.0);
  step.LimitLevels(2);
  EXPECT_EQ(Ticks(step, At(0, 0, -2), 50).levels, 1.0);
}

// A foot that stands flat feels the turn by the spring alone: 2 tanh(50 0.05 / 2).
TEST(HapticStepChanges, EachOfTheSpringsNumbersIsAimedAt)
{
  auto settings = Settings();
  settings.contact.stiffness = 10.0F;
  HapticStep step = Ready(settings, GroundScene());
  const RigidPose device{ { 0, 0, -2 }, hasp::TurnBy({ 0.05, 0, 0 }) };
  Ticks(step, device, 200);
  hasp::CouplingSpring spring;
  spring.turnStiffness = 50.0;
  spring.torqueLimit = 2.0;
  spring.forceLimit = 0.6;
  step.Aim(spring);
  hasp::Wrench last = step.Tick(device).onDevice;
  for (int n = 0; n < 300; ++n)
  {
    const hasp::Wrench now = step.Tick(device).onDevice;
    EXPECT_LT(std::abs(now.force.z - last.force.z), 0.05) << n;
    EXPECT_LT(std::abs(now.torque.x - last.torque.x), 1.5) << n;
    last = now;
  }
  EXPECT_NEAR(last.torque.x, -2.0 * std::tanh(50.0 * 0.05 / 2.0), 0.02);
  EXPECT_NEAR(last.force.z, 0.6 * std::tanh(0.33 * 2.0 / 0.6), 0.01);
}

TEST(HapticStepChanges, TheCaptureDistanceIsAimedAt)
{
  auto settings = Settings();
  settings.contact.attraction = 0.001F;
  HapticStep step = Ready(settings, GroundScene());
  step.Attract(true);
  EXPECT_GT(Ticks(step, At(0, 0, 2.5), 300).sums.attractedArea, 399.0);
  auto contact = settings.contact;
  contact.captureMm = 2.0F;
  step.Aim(contact);
  EXPECT_EQ(Ticks(step, At(0, 0, 2.5), 300).sums.attractedArea, 0.0);
}

// More comes within reach from one tick to the next: the very answer keeps to the bound. At most
// R times half of the spring, at the law's peak of 0.286: 0.142 N, where up to 57 N are asked for.
TEST(HapticStepChanges, WhatJumpsIntoReachIsBoundedAtOnce)
{
  auto settings = Settings();
  settings.contact.attraction = 0.5F;
  HapticStep step = Ready(settings, GroundScene());
  step.Attract(true);
  Ticks(step, At(0, 0, 3.3), 300);
  const hasp::HapticTick tick = step.Tick(At(0, 0, 1.34));
  EXPECT_GT(tick.sums.attractedArea, 399.0);
  EXPECT_LT(glm::length(tick.sums.attraction.force), 0.142 * 1.01);
  EXPECT_LT(glm::length(tick.sums.attraction.torque), 0.142 * 15.0);
}

// A foot 60 mm off the tool's middle turns it: a A r^2 / R is under half of the turn's spring.
TEST(HapticStepChanges, AttractionIsBoundedByItsLeverToo)
{
  auto settings = Settings();
  settings.contact.attraction = 0.5F;
  const auto scene = []
  {
    return std::make_unique<HapticScene>(std::vector<hasp::HapticShell>{ { Foot(), At(60, 0, 0) } },
      std::vector<hasp::HapticBody>{ { Ground(), At(60, 0, 0) } });
  };
  const double radius = scene()->RadiusMm();
  HapticStep step = Ready(settings, scene());
  step.Attract(true);
  const hasp::HapticTick tick = Ticks(step, At(0, 0, 1.34), 400);
  EXPECT_GT(tick.sums.attractedArea, 399.0);
  EXPECT_LT(
    glm::length(tick.sums.attraction.force), 1.01 * 0.286 * 3.0 * 0.5 * 300.0 / (radius * radius));
  EXPECT_GT(glm::length(tick.sums.attraction.force), 0.0);
}

// What the controller damps reaches the device.
TEST(HapticStepChanges, TheControllersWrenchIsWhatLeaves)
{
  double different = 0.0;
  auto settings = Settings();
  settings.coupling.spring.stiffness = 5.0;
  settings.coupling.spring.forceLimit = 8.0;
  HapticStep plain = Ready(settings, GroundScene());
  settings.control = true;
  HapticStep controlled = Ready(settings, GroundScene());
  for (int n = 0; n < 600; ++n)
  {
    const RigidPose device = At(0, 0, -2.0 + 1.5 * std::cos(2.0 * std::acos(-1.0) * 0.02 * n));
    different = std::max(different,
      glm::length(plain.Tick(device).onDevice.force - controlled.Tick(device).onDevice.force));
  }
  EXPECT_GT(controlled.Controlled(), 10U);
  EXPECT_EQ(plain.Controlled(), 0U);
  EXPECT_GT(different, 0.05);
}

} // namespace
