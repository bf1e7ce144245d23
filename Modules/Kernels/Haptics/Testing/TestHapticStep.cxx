#include "Grid/Testing/CountNew.h"
#include "Haptics/HapticStep.h"
#include "Haptics/Solve6.h"
#include "StepScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace
{

using hasp::HapticScene;
using hasp::HapticStep;
using hasp::RigidPose;
using namespace hasp::testing;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

TEST(HapticStep, WhatIsNoSettingIsRefused)
{
  const auto refused = [](auto change)
  {
    hasp::HapticStepSettings settings;
    change(settings);
    EXPECT_THROW(HapticStep{ settings }, std::invalid_argument);
  };
  refused([](auto& s) { s.tickS = 0.0; });
  refused([](auto& s) { s.budgetUs = NaN; });
  refused([](auto& s) { s.fadeS = -1.0; });
  refused([](auto& s) { s.slewS = 0.0; });
  refused([](auto& s) { s.blendTicks = 4; });
  refused([](auto& s) { s.contact.stiffness = -0.1F; });
  refused([](auto& s) { s.contact.captureMm = 0.0F; });
  refused([](auto& s) { s.leastContactMm2 = -1.0; });
  for (const double bad : { NaN, HUGE_VAL })
  {
    refused([=](auto& s) { s.tickS = bad; });
    refused([=](auto& s) { s.fadeS = bad; });
    refused([=](auto& s) { s.slewS = bad; });
    refused([=](auto& s) { s.contact.stiffness = static_cast<float>(bad); });
    refused([=](auto& s) { s.contact.attraction = static_cast<float>(bad); });
    refused([=](auto& s) { s.contact.captureMm = static_cast<float>(bad); });
    refused([=](auto& s) { s.leastContactMm2 = bad; });
  }
  refused([](auto& s) { s.friction.coefficient = -1.0; });
  refused([](auto& s) { s.friction.stiffness = NaN; });
  refused([](auto& s) { s.coupling.steps = 0; });
  EXPECT_THROW(HapticScene({ { nullptr, {} } }, {}), std::invalid_argument);
  EXPECT_THROW(HapticScene({}, { { nullptr, {} } }), std::invalid_argument);
  EXPECT_THROW(HapticScene({ { Foot(), At(NaN, 0, 0) } }, {}), std::invalid_argument);
}

TEST(HapticStep, WithoutASceneNothingIsFelt)
{
  HapticStep step;
  const hasp::HapticTick tick = Ticks(step, At(1, 2, 3), 3);
  EXPECT_EQ(tick.onDevice.force, glm::dvec3(0.0));
  EXPECT_LT(glm::length(tick.tool.position - glm::dvec3(1, 2, 3)), 1e-9);
  auto empty = std::make_unique<HapticScene>(
    std::vector<hasp::HapticShell>{}, std::vector<hasp::HapticBody>{ { Ground(), {} } });
  step.Swap(empty);
  EXPECT_EQ(empty, nullptr);
  EXPECT_LT(glm::length(Ticks(step, At(0, 0, -3), 3).onDevice.force), 1e-9);
}

// Series of spring and contact, through grid, shell, kernels and coupling.
TEST(HapticStep, FootOnTheGroundIsTwoSpringsInSeries)
{
  HapticStep step = Ready(Settings(), GroundScene());
  const hasp::HapticTick tick = Ticks(step, At(0, 0, -2), 100);
  const hasp::CouplingSpring spring;
  // F = 4 tanh(0.33 (2 - F / 40) / 4), by iteration.
  double force = 0.0;
  for (int n = 0; n < 100; ++n)
    force =
      spring.forceLimit * std::tanh(spring.stiffness * (2.0 - force / 40.0) / spring.forceLimit);
  EXPECT_NEAR(tick.onDevice.force.z, force, 1e-3 * force); // int16 steps of 1/2048 voxel
  EXPECT_NEAR(tick.tool.position.z, -force / 40.0, 1e-3);
  EXPECT_NEAR(tick.sums.contactArea, 400.0, 1e-3);
  EXPECT_LT(glm::length(tick.onDevice.torque), 0.05);
  EXPECT_EQ(tick.status, 0U);
}

// A map that is turned and moved in the world, and a shell that is turned and moved on the tool,
// are felt as the same contact where the tool stands the same to the body.
TEST(HapticStep, PosesOfBodiesAndShellsChangeNothing)
{
  const RigidPose bodyInWorld{ { 100, -50, 30 }, hasp::TurnBy({ 0.4, -1.0, 0.7 }) };
  const RigidPose shellInTool{ { 5, 3, -8 }, hasp::TurnBy({ -0.3, 0.2, 1.1 }) };
  const RigidPose shellInBody{ { 1, -2, -0.05 }, hasp::TurnBy({ 0.002, 0.001, 0.3 }) };
  HapticScene plain({ { Foot(), {} } }, { { Ground(), {} } });
  HapticScene moved({ { Foot(), shellInTool } }, { { Ground(), bodyInWorld } });
  hasp::HapticScene::Plan plan;
  plan.finest = 9;
  plan.contact.stiffness = 0.1F;
  plain.Set(plan);
  moved.Set(plan);
  const hasp::ContactSums expected = plain.At(shellInBody).sums;
  const RigidPose tool = bodyInWorld * shellInBody * shellInTool.Inverse();
  const hasp::ContactSums sums = moved.At(tool).sums;
  ASSERT_GT(expected.contacts, 1000U);
  EXPECT_EQ(sums.contacts, expected.contacts);
  // Back from the world about the tool's origin to the body's axes about the shell's.
  const glm::dquat back = glm::conjugate(bodyInWorld.orientation);
  const glm::dvec3 arm = (tool * shellInTool).position - tool.position;
  const glm::dvec3 force = back * sums.contact.force;
  const glm::dvec3 torque = back * (sums.contact.torque - glm::cross(arm, sums.contact.force));
  const double size = glm::length(expected.contact.force);
  EXPECT_LT(glm::length(force - expected.contact.force), 1e-4 * size); // float placements
  EXPECT_LT(glm::length(torque - expected.contact.torque), 1e-4 * size * 14.0);
  // And the stiffness: the same change of force for the same small motion.
  const hasp::ContactSums again = Moved(Moved(expected, bodyInWorld.orientation, arm),
    glm::conjugate(bodyInWorld.orientation), back * -arm);
  for (std::size_t i = 0; i < 21; ++i)
    EXPECT_NEAR(again.matrix[i], expected.matrix[i], 1e-6 * 40.0 * 400.0);
}

// A turn is one however long its quaternion is within what counts as a pose: 200 mm out, two
// thousandths of the way would be more than a contact is deep.
TEST(HapticStep, QuaternionsOfNearlyUnitLengthAreTakenAsTurns)
{
  const RigidPose body{ { 100, -50, 30 }, hasp::TurnBy({ 0.4, -1.0, 0.7 }) };
  const RigidPose shell{ { 150, 3, -80 }, hasp::TurnBy({ -0.3, 0.2, 1.1 }) };
  const RigidPose tool = body * At(1, -2, -0.05) * shell.Inverse();
  const auto sums = [&](double bodyLength, double shellLength)
  {
    HapticScene scene({ { Foot(), { shell.position, shell.orientation * shellLength } } },
      { { Ground(), { body.position, body.orientation * bodyLength } } });
    hasp::HapticScene::Plan plan;
    plan.finest = 9;
    plan.contact.stiffness = 0.1F;
    scene.Set(plan);
    return scene.At(tool).sums;
  };
  const hasp::ContactSums expected = sums(1.0, 1.0);
  const double size = glm::length(expected.contact.force);
  ASSERT_GT(size, 1.0);
  for (const double length : { 0.9991, 1.0009 })
    for (const bool ofBody : { true, false })
    {
      const hasp::Wrench felt = sums(ofBody ? length : 1.0, ofBody ? 1.0 : length).contact;
      EXPECT_LT(glm::distance(felt.force, expected.contact.force), 1e-6 * size) << length;
      EXPECT_LT(glm::distance(felt.torque, expected.contact.torque), 1e-4 * size) << length;
    }
}

// w(x + dx) = w(x) - K dx for points that stay in contact: the matrix is the wrench's slope, seen
// from the world about the tool's origin.
TEST(HapticStep, MatrixIsTheSlopeOfTheWrench)
{
  const RigidPose body{ { 10, -5, 3 }, hasp::TurnBy({ 0.4, -1.0, 0.7 }) };
  const RigidPose shell{ { 5, 3, -8 }, hasp::TurnBy({ -0.3, 0.2, 1.1 }) };
  HapticScene scene({ { Foot(), shell } }, { { Ground(), body } });
  hasp::HapticScene::Plan plan;
  plan.finest = 9;
  plan.contact.stiffness = 0.1F;
  scene.Set(plan);
  const RigidPose tool = body * At(0, 0, -0.5) * shell.Inverse();
  const auto wrench = [&](const RigidPose& pose)
  {
    const hasp::Wrench w = scene.At(pose).sums.contact;
    return hasp::Vector6{ w.force.x, w.force.y, w.force.z, w.torque.x, w.torque.y, w.torque.z };
  };
  const hasp::ContactSums sums = scene.At(tool).sums;
  for (int axis = 0; axis < 6; ++axis)
  {
    const double h = axis < 3 ? 0.02 : 0.001;
    glm::dvec3 move(0.0), turn(0.0);
    (axis < 3 ? move : turn)[axis % 3] = h;
    const auto at = [&](double sign) {
      return wrench({ tool.position + sign * move, hasp::TurnBy(sign * turn) * tool.orientation });
    };
    const hasp::Vector6 high = at(1.0), low = at(-1.0);
    hasp::Vector6 unit{};
    unit[axis] = 1.0;
    const hasp::Vector6 slope = hasp::Multiply6(sums.matrix, unit);
    // A turn also turns the forces' directions and arms: 20 N times the arm, which the matrix
    // leaves out on purpose (positive semidefinite).
    const double slack = axis < 3 ? 0.01 * 40.0 * 15.0 : 20.0 * 15.0;
    for (int row = 0; row < 6; ++row)
      EXPECT_NEAR((low[row] - high[row]) / (2 * h), slope[row], row < 3 ? slack / 5 : slack)
        << row << ' ' << axis;
  }
}

TEST(HapticStep, TwoFeetAreTwiceAsStiffAndTwoBodiesBothPush)
{
  const auto left = hasp::HapticShell{ Foot(), At(-15, 0, 0) };
  const auto right = hasp::HapticShell{ Foot(), At(15, 0, 0) };
  HapticScene one({ left }, { { Ground(), {} } }), two({ left, right }, { { Ground(), {} } });
  HapticScene both({ left }, { { Ground(), {} }, { Ground(), At(0, 0, -0.1) } });
  hasp::HapticScene::Plan plan;
  plan.finest = 9;
  for (HapticScene* scene : { &one, &two, &both })
    scene->Set(plan);
  const RigidPose tool = At(0, 0, -0.3);
  const double single = one.At(tool).sums.contact.force.z;
  EXPECT_NEAR(two.At(tool).sums.contact.force.z, 2.0 * single, 1e-4 * single);
  EXPECT_NEAR(two.At(tool).sums.contact.torque.y, 0.0, 1e-3 * single * 15.0);
  EXPECT_NEAR(both.At(tool).sums.contact.force.z, single * 5.0 / 3.0, 1e-3 * single);
}

// Blending levels keeps the stiffness per area whatever share counts; nothing jumps.
TEST(HapticStep, LevelsAreBlendedWithoutAJump)
{
  HapticScene scene({ { Foot(), {} } }, { { Ground(), {} } });
  hasp::HapticScene::Plan plan;
  plan.contact.stiffness = 0.1F;
  const RigidPose tool{ { 0, 0, -0.2 }, hasp::TurnBy({ 0.01, 0, 0 }) };
  double last = 0.0;
  for (double finest = 0.0; finest <= scene.Levels(); finest += 0.1)
  {
    plan.finest = finest;
    scene.Set(plan);
    const hasp::ContactSums sums = scene.At(tool).sums;
    // Coarse levels place few points: 64 of them are within some per cent of the plane's integral.
    EXPECT_NEAR(sums.contact.force.z, 8.0, 0.6) << finest;
    if (finest > 0.0)
    {
      EXPECT_NEAR(sums.contact.force.z, last, 0.08) << finest;
    }
    last = sums.contact.force.z;
  }
  EXPECT_NEAR(last, 8.0, 0.08);
}

TEST(HapticStep, StiffnessChangesGraduallyInContact)
{
  auto settings = Settings();
  settings.leastContactMm2 = 0.0; // springs in series are the linear law's
  HapticStep step = Ready(settings, GroundScene());
  double last = Ticks(step, At(0, 0, -2), 300).onDevice.force.z;
  auto contact = settings.contact;
  contact.stiffness = 0.002F; // 0.8 N/mm from 40
  step.Aim(contact);
  hasp::CouplingSpring spring;
  spring.stiffness = 0.1;
  step.Aim(spring);
  for (int n = 0; n < 200; ++n)
  {
    const double force = step.Tick(At(0, 0, -2)).onDevice.force.z;
    EXPECT_LT(std::abs(force - last), 0.05) << n;
    last = force;
  }
  EXPECT_NEAR(last, 2.0 * 0.1 * 0.8 / 0.9, 1e-3);
}

// The ground 1 mm higher, from one tick to the next, under a foot that stands on it.
TEST(HapticStep, ANewSceneIsFeltGraduallyAndTheOldOneComesBack)
{
  HapticStep step = Ready(Settings(), GroundScene());
  double last = Ticks(step, At(0, 0, -2), 300).onDevice.force.z;
  auto higher = GroundScene(1.0);
  HapticScene* const given = higher.get();
  step.Swap(higher);
  EXPECT_NE(higher, nullptr);
  EXPECT_NE(higher.get(), given);
  double largest = 0.0;
  for (int n = 0; n < 300; ++n)
  {
    const double force = step.Tick(At(0, 0, -2)).onDevice.force.z;
    largest = std::max(largest, force - last);
    last = force;
  }
  EXPECT_LT(largest, 0.15); // 2 N/ms is what the limiter would let through
  const hasp::CouplingSpring s;
  EXPECT_NEAR(last, s.forceLimit * std::tanh(s.stiffness * 3.0 / s.forceLimit), 0.03);
}

TEST(HapticStep, WhatTwoScenesShareIsFeltOn)
{
  const auto shell = Foot();
  const auto ground = Ground();
  const auto scene = [&](bool more)
  {
    std::vector<hasp::HapticBody> bodies{ { ground, {} } };
    if (more)
      bodies.push_back({ ground, At(500, 0, 0) });
    return std::make_unique<HapticScene>(std::vector<hasp::HapticShell>{ { shell, {} } }, bodies);
  };
  HapticStep step = Ready(Settings(), scene(false));
  const double before = Ticks(step, At(0, 0, -2), 300).onDevice.force.z;
  auto next = scene(true);
  step.Swap(next);
  EXPECT_NEAR(step.Tick(At(0, 0, -2)).onDevice.force.z, before, 1e-3);
}

// The first scene of a running step, and a body that has moved, are new: felt gradually.
TEST(HapticStep, WhatComesOrMovesGrowsFromNothing)
{
  const auto shell = Foot();
  const auto ground = Ground();
  const auto scene = [&](double z)
  {
    return std::make_unique<HapticScene>(std::vector<hasp::HapticShell>{ { shell, {} } },
      std::vector<hasp::HapticBody>{ { ground, At(0, 0, z) } });
  };
  HapticStep step(Settings());
  Ticks(step, At(0, 0, -2), 50);
  double last = 0.0;
  for (const double z : { 0.0, 1.0 })
  {
    auto next = scene(z);
    step.Swap(next);
    double largest = 0.0;
    for (int n = 0; n < 300; ++n)
    {
      const double force = step.Tick(At(0, 0, -2)).onDevice.force.z;
      largest = std::max(largest, force - last);
      last = force;
    }
    EXPECT_GT(last, 0.5);
    EXPECT_LT(largest, 0.15);
  }
}

TEST(HapticStep, PosesThatAreNoneGiveNoForceAndHarmNothing)
{
  HapticStep step = Ready(Settings(), GroundScene());
  const double before = Ticks(step, At(0, 0, -2), 300).onDevice.force.z;
  const hasp::HapticTick bad = step.Tick(At(NaN, 0, -2));
  EXPECT_EQ(bad.onDevice.force, glm::dvec3(0.0));
  EXPECT_EQ(bad.status, hasp::CouplingTick::BadDevicePose);
  EXPECT_NEAR(Ticks(step, At(0, 0, -2), 20).onDevice.force.z, before, 1e-6);
}

TEST(HapticStep, FrictionHoldsUnderMuTimesTheNormalForce)
{
  for (const double coefficient : { 0.0, 0.3 })
  {
    auto settings = Settings();
    settings.friction.coefficient = coefficient;
    HapticStep step = Ready(settings, GroundScene());
    const double normal = Ticks(step, At(0, 0, -3), 300).onDevice.force.z;
    hasp::HapticTick tick;
    for (int n = 1; n <= 400; ++n)
      tick = step.Tick(At(0.01 * n, 0, -3)); // 4 mm aside
    EXPECT_NEAR(tick.onDevice.force.x, -coefficient * normal, 0.03 * normal + 1e-9);
    if (coefficient == 0.0)
      continue;
    // Little of the way back it sticks, and pulls less.
    const double slid = tick.onDevice.force.x;
    tick = Ticks(step, At(3.5, 0, -3), 50);
    EXPECT_GT(tick.onDevice.force.x, slid + 0.02);
    tick = Ticks(step, At(3.5, 0, 3), 50);
    EXPECT_LT(glm::length(tick.onDevice.force), 1e-9);
  }
}

/// On the ground and off it, 20 times a second: what a late force makes energy of.
template <typename Visit>
void Shake(HapticStep& step, int ticks, const Visit& visit)
{
  for (int n = 0; n < ticks; ++n)
  {
    const RigidPose device = At(0, 0, -2.0 + 1.5 * std::cos(2.0 * std::acos(-1.0) * 0.02 * n));
    visit(device, step.Tick(device));
  }
}

// Behind ramp, slew and limit: what they take away is no energy that the device gave.
TEST(HapticStep, ObservesWhatTheDeviceHolds)
{
  auto settings = Settings();
  settings.control = true;
  settings.limits.force = 0.8;
  settings.limits.rampInS = 0.3;
  HapticStep step = Ready(settings, GroundScene());
  step.Place(At(0, 0, 5));
  hasp::PassivityObserver observer;
  Shake(step, 600,
    [&](const RigidPose& device, const hasp::HapticTick& tick)
    {
      observer.Tick(device, tick.onDevice);
      ASSERT_NEAR(step.Observer().Energy(), observer.Energy(), 1e-9);
    });
  EXPECT_GT(std::abs(observer.Energy()), 0.01);
}

// One tick, not two: the controller's own is the step's.
TEST(HapticStep, TheControllerTicksAsTheStepDoes)
{
  std::vector<double> forces[2];
  for (const int which : { 0, 1 })
  {
    auto settings = Settings();
    settings.control = true;
    settings.coupling.spring.stiffness = 5.0;
    settings.coupling.spring.forceLimit = 8.0;
    settings.passivity.tickS = which == 0 ? settings.tickS : 0.02;
    HapticStep step = Ready(settings, GroundScene());
    Shake(step, 600,
      [&](const RigidPose&, const hasp::HapticTick& tick)
      { forces[which].push_back(tick.onDevice.force.z); });
    EXPECT_GT(step.Controlled(), 10U);
  }
  EXPECT_EQ(forces[0], forces[1]);
}

// A budget that allows nothing but the coarsest level gets it; one that allows all gets all.
TEST(HapticStep, CoarseLevelsAlwaysFinish)
{
  auto settings = Settings();
  settings.budgetUs = 0.01;
  HapticStep tight = Ready(settings, GroundScene());
  hasp::HapticTick tick = Ticks(tight, At(0, 0, -2), 200);
  EXPECT_EQ(tick.levels, 0.0);
  EXPECT_EQ(tick.evaluations, 1);
  EXPECT_GT(tick.onDevice.force.z, 0.5);
  settings.budgetUs = 1e6;
  HapticStep wide = Ready(settings, GroundScene());
  tick = Ticks(wide, At(0, 0, -2), 200);
  EXPECT_EQ(tick.levels, 3.0); // 64, 256, 1024, 4096
}

TEST(HapticStep, ATickTakesNoMemory)
{
  auto settings = Settings();
  settings.contact.attraction = 0.001F;
  settings.friction.coefficient = 0.3;
  settings.control = true;
  settings.budgetUs = 400.0;
  HapticStep step = Ready(settings, GroundScene());
  auto next = GroundScene(0.5);
  step.Attract(true);
  const std::size_t before = hasp::test::NewCount();
  for (int n = 0; n < 300; ++n)
  {
    step.Tick(At(0.01 * n, 0, 3.0 - 0.02 * n));
    if (n == 200)
      step.Swap(next);
  }
  EXPECT_EQ(hasp::test::NewCount(), before);
}

} // namespace
