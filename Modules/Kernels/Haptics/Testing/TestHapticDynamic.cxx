// Dynamic shells in a scene and in a whole step: a grey plate, 24 mm wide, pressed on a floor.
#include "GreyBodyOnFloor.h"
#include "Grid/Testing/CountNew.h"
#include "Haptics/HapticStep.h"
#include "StepScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{

using hasp::HapticBody;
using hasp::HapticScene;
using hasp::HapticShell;
using hasp::HapticStep;
using hasp::RigidPose;
using namespace hasp::testing;

constexpr double PlateArea = 24.0 * 24.0;

/// Solid above y = 0, as far as its grid goes: a plane that trilinear interpolation has exactly.
std::shared_ptr<const hasp::DynamicShellSource> Plate()
{
  auto source = std::make_shared<hasp::DynamicShellSource>();
  source->volume = GreyBody(HalfSpace({}, { 0, -1, 0 }), CubeGrid(25)).Volume;
  return source;
}

HapticShell PlateShell(std::shared_ptr<const hasp::DynamicShellSource> plate = Plate(),
  const RigidPose& shellInTool = {})
{
  return { nullptr, shellInTool, std::move(plate) };
}

hasp::HapticScene::Plan AllOfIt()
{
  hasp::HapticScene::Plan plan;
  plan.contact.stiffness = 0.1F; // 57.6 N/mm for the plate
  return plan;
}

/// As after `ticks` ticks at one place.
hasp::ToolContact::Answer Settled(HapticScene& scene, const RigidPose& tool, int ticks = 60)
{
  for (int n = 0; n < ticks; ++n)
    scene.Update(tool);
  return scene.At(tool);
}

double SeriesForce(double depth)
{
  const hasp::CouplingSpring spring;
  double force = 0.0;
  for (int n = 0; n < 100; ++n)
    force = spring.forceLimit *
            std::tanh(spring.stiffness * (depth - force / (0.1 * PlateArea)) / spring.forceLimit);
  return force;
}

HapticStep ReadyPlate(std::shared_ptr<const hasp::DynamicShellSource> plate,
  std::shared_ptr<const hasp::DistanceMap> floor,
  const hasp::HapticStepSettings& settings = Settings())
{
  HapticStep step(settings);
  auto scene =
    std::make_unique<HapticScene>(std::vector<HapticShell>{ PlateShell(std::move(plate)) },
      std::vector<HapticBody>{ { std::move(floor), {} } });
  step.Swap(scene);
  step.Place(At(0, 5, 0));
  Ticks(step, At(0, 5, 0), 100);
  return step;
}

std::size_t DynamicShellsOf(const HapticScene& scene)
{
  hasp::ResourceList list;
  scene.ListResources(list);
  std::size_t count = 0;
  for (const hasp::ResourceUse& use : list)
    count += use.resource == "dynamic point shell" ? 1 : 0;
  return count;
}

TEST(HapticDynamic, AShellIsEitherStaticOrDynamic)
{
  EXPECT_THROW(HapticScene({ { nullptr, {}, nullptr } }, {}), std::invalid_argument);
  EXPECT_THROW(HapticScene({ { Foot(), {}, Plate() } }, {}), std::invalid_argument);
  EXPECT_THROW(HapticScene({ PlateShell(Plate(), At(Nan, 0, 0)) }, {}), std::invalid_argument);
  auto odd = std::make_shared<hasp::DynamicShellSource>(*Plate());
  odd->settings.points = 3;
  EXPECT_THROW(HapticScene({ PlateShell(odd) }, { { Floor(), {} } }), std::invalid_argument);
}

TEST(HapticDynamic, IsMadeForEachBodyItMeetsAndNotWithoutOne)
{
  const auto floor = Floor();
  EXPECT_EQ(DynamicShellsOf(HapticScene({ { Foot(), {} } }, { { floor, {} } })), 0U);
  EXPECT_EQ(DynamicShellsOf(HapticScene({ PlateShell() }, {})), 0U);
  const HapticScene both(
    { { Foot(), {} }, PlateShell() }, { { floor, {} }, { floor, At(60, 0, 0) } });
  EXPECT_EQ(DynamicShellsOf(both), 2U);
}

TEST(HapticDynamic, GreyPlateOnAFloorIsTwoSpringsInSeries)
{
  HapticStep step = ReadyPlate(Plate(), Floor());
  const hasp::HapticTick tick = Ticks(step, At(0, -2, 0), 100);
  const double force = SeriesForce(2.0);
  EXPECT_NEAR(tick.onDevice.force.y, force, 1e-3 * force); // int16 steps of 1/2048 voxel
  EXPECT_NEAR(tick.tool.position.y, -force / (0.1 * PlateArea), 1e-3);
  EXPECT_NEAR(tick.sums.contactArea, PlateArea, 0.05);
  EXPECT_LT(glm::length(tick.onDevice.torque), 0.05);
  EXPECT_EQ(tick.status, 0U);
  EXPECT_GT(tick.points, 500U);
  ASSERT_NE(step.Scene(), nullptr);
  EXPECT_EQ(step.Scene()->NearPoints()[0] * tick.evaluations, tick.points);
}

TEST(HapticDynamic, PosesOfBodiesAndShellsChangeNothing)
{
  const RigidPose bodyInWorld{ { 100, -50, 30 }, hasp::TurnBy({ 0.4, -1.0, 0.7 }) };
  const RigidPose shellInTool{ { 5, 3, -8 }, hasp::TurnBy({ -0.3, 0.2, 1.1 }) };
  HapticScene moved({ PlateShell(Plate(), shellInTool) }, { { Floor(), bodyInWorld } });
  moved.Set(AllOfIt());
  const RigidPose tool = bodyInWorld * At(1, -0.25, 2) * shellInTool.Inverse();
  const hasp::ContactSums sums = Settled(moved, tool).sums;
  const glm::dvec3 force = bodyInWorld.Turn({ 0, 0.25 * 0.1 * PlateArea, 0 });
  EXPECT_LT(glm::distance(sums.contact.force, force), 1e-3 * glm::length(force));
  const glm::dvec3 arm = tool.Turn(shellInTool.position);
  // Points are spread evenly, not symmetrically: their middle is off by a part of a mm.
  EXPECT_LT(glm::distance(sums.contact.torque, glm::cross(arm, force)), 0.1 * glm::length(force));
}

TEST(HapticDynamic, AnotherIsovalueIsFeltInTheVeryNextTick)
{
  HapticScene scene({ { Foot(), At(500, 0, 0) }, PlateShell() }, { { Floor(), {} } });
  scene.Set(AllOfIt());
  const RigidPose tool = At(0, -0.2, 0);
  const auto forceAt = [&] { return scene.At(tool).sums.contact.force.y; };
  EXPECT_NEAR(Settled(scene, tool).sums.contact.force.y, 0.2 * 0.1 * PlateArea, 0.02);
  scene.SetIsovalue(0, Isovalue - 50.0); // a static shell has none
  scene.SetIsovalue(7, Isovalue - 50.0); // nor has one that is not there
  scene.Update(tool);
  EXPECT_NEAR(forceAt(), 0.2 * 0.1 * PlateArea, 0.02);
  for (const double mm : { 0.1, 0.5, 0.0 })
  {
    scene.SetIsovalue(1, Isovalue + PerMm * mm); // thicker by so much
    scene.Update(tool);
    EXPECT_NEAR(forceAt(), (0.2 + mm) * 0.1 * PlateArea, 0.02) << mm;
  }
  scene.SetIsovalue(1, Nan);
  scene.Update(tool);
  EXPECT_EQ(forceAt(), 0.0);
}

TEST(HapticDynamic, AStepFeelsAnotherIsovalueInTheNextTick)
{
  auto linear = Settings();
  linear.leastContactMm2 = 0.0;
  HapticStep step = ReadyPlate(Plate(), Floor(), linear);
  HapticStep hardening = ReadyPlate(Plate(), Floor());
  const double thicker = SeriesForce(2.5);
  for (HapticStep* each : { &step, &hardening })
  {
    EXPECT_NEAR(Ticks(*each, At(0, -2, 0), 100).onDevice.force.y, SeriesForce(2.0), 1e-3);
    each->SetIsovalue(0, Isovalue + PerMm * 0.5);
  }
  EXPECT_NEAR(step.Tick(At(0, -2, 0)).onDevice.force.y, thicker, 0.02 * thicker);
  // Contact that hardens takes some steps more, from where the surface has jumped past a voxel.
  EXPECT_GT(hardening.Tick(At(0, -2, 0)).onDevice.force.y, 0.9 * thicker);
  EXPECT_NEAR(hardening.Tick(At(0, -2, 0)).onDevice.force.y, thicker, 0.02 * thicker);
  std::unique_ptr<HapticScene> none;
  step.Swap(none);
  step.SetIsovalue(0, Isovalue);
  EXPECT_EQ(step.Scene(), nullptr);
}

// Points, growth and isovalue go on in the scene that follows, if it has the same source at the
// same place; another source, or another place, begins without points.
TEST(HapticDynamic, WhatTwoScenesShareIsFeltOn)
{
  const auto plate = Plate();
  const auto floor = Floor();
  const auto scene = [&](auto source, const RigidPose& shellInTool)
  {
    return std::make_unique<HapticScene>(
      std::vector<HapticShell>{ { Foot(), At(500, 0, 0) }, PlateShell(source, shellInTool) },
      std::vector<HapticBody>{ { floor, {} } });
  };
  HapticStep step = ReadyPlate(plate, floor);
  step.SetIsovalue(0, Isovalue + PerMm * 0.5);
  const double before = Ticks(step, At(0, -2, 0), 100).onDevice.force.y;
  EXPECT_NEAR(before, SeriesForce(2.5), 2e-3);
  auto same = scene(plate, {});
  step.Swap(same);
  EXPECT_NEAR(step.Tick(At(0, -2, 0)).onDevice.force.y, before, 1e-6);
  EXPECT_NEAR(Ticks(step, At(0, -2, 0), 50).onDevice.force.y, before, 1e-3);
  for (const bool another : { true, false })
  {
    auto next = another ? scene(Plate(), {}) : scene(plate, At(0, 0.5, 0));
    HapticStep other = ReadyPlate(plate, floor);
    Ticks(other, At(0, -2, 0), 100);
    other.Swap(next);
    EXPECT_LT(other.Tick(At(0, -2, 0)).sums.contact.force.y, 0.01);
    EXPECT_GT(Ticks(other, At(0, -2, 0), 200).sums.contact.force.y, 0.4);
  }
}

TEST(HapticDynamic, DiscsAreTheLivingPointsInToolAxes)
{
  const RigidPose shellInTool{ { 5, 3, -8 }, hasp::TurnBy({ -0.3, 0.2, 1.1 }) };
  HapticScene scene(
    { { Foot(), At(500, 0, 0) }, PlateShell(Plate(), shellInTool) }, { { Floor(), {} } });
  scene.Set(AllOfIt());
  std::vector<hasp::ShellDisc> discs(20'000);
  EXPECT_EQ(scene.CopyDynamicDiscs(discs), 0U);
  const RigidPose tool = At(0, -0.2, 0) * shellInTool.Inverse();
  Settled(scene, tool);
  const std::uint32_t count = scene.CopyDynamicDiscs(discs);
  EXPECT_EQ(count, scene.At(tool).sums.contacts);
  ASSERT_GT(count, 500U);
  double area = 0.0;
  for (std::uint32_t n = 0; n < count; ++n)
  {
    const glm::dvec3 inPlate = shellInTool.Inverse().Place(discs[n].center);
    EXPECT_NEAR(inPlate.y, 0.0, 1e-4);
    EXPECT_LE(std::max(std::abs(inPlate.x), std::abs(inPlate.z)), 12.0 + 1e-4);
    EXPECT_LT(glm::distance(glm::dvec3(discs[n].normal), shellInTool.Turn({ 0, -1, 0 })), 1e-5);
    area += discs[n].areaMm2;
  }
  EXPECT_NEAR(area, PlateArea, 0.05);
  EXPECT_EQ(scene.CopyDynamicDiscs(std::span(discs).first(100)), 100U);
  EXPECT_EQ(scene.CopyDynamicDiscs({}), 0U);
}

// A gap that is known: never more than it, 0 near the floor, less by what the plate has moved
// since.
TEST(HapticDynamic, ClearanceIsNoMoreThanTheGap)
{
  const auto source = Plate();
  hasp::DynamicPointShell shell(source->volume, Floor(), {});
  EXPECT_EQ(shell.ClearanceMm({}), 0.0);
  for (const double gap : { 22.0, 18.0, 3.0, -0.5 })
  {
    shell.Update(At(0, gap, 0), 0.0);
    const double clearance = shell.ClearanceMm(At(0, gap, 0));
    EXPECT_LE(clearance, std::max(gap, 0.0));
    EXPECT_EQ(clearance > 0.0, gap > 17.0) << gap; // a block's ball and the margin: 14 + 4 mm
    if (clearance > 1.0)
    {
      EXPECT_NEAR(shell.ClearanceMm(At(0.6, gap - 0.8, 0)), clearance - 1.0, 1e-9);
    }
    EXPECT_EQ(shell.ClearanceMm(At(Nan, gap, 0)), 0.0);
  }
}

// However fast the device comes, the plate does not get through: it meets points in time.
TEST(HapticDynamic, AFallFromFarAwayStopsOnTheFloor)
{
  for (const double speed : { 0.3, 1.0, 3.0, 100.0 }) // mm a tick
  {
    HapticStep step = ReadyPlate(Plate(), Floor());
    Ticks(step, At(0, 40, 0), 50);
    double deepest = 0.0;
    for (double y = 40.0; y > -3.0; y -= speed)
      deepest = std::min(deepest, step.Tick(At(0, y, 0)).tool.position.y);
    for (int n = 0; n < 200; ++n)
      deepest = std::min(deepest, step.Tick(At(0, -3, 0)).tool.position.y);
    EXPECT_GT(deepest, -0.5) << speed; // half a voxel
    EXPECT_NEAR(step.Tick(At(0, -3, 0)).onDevice.force.y, SeriesForce(3.0), 2e-3) << speed;
  }
}

// Its points are of the coarsest level, which is summed whatever it costs.
TEST(HapticDynamic, IsFeltOnTheTightestBudget)
{
  auto settings = Settings();
  settings.budgetUs = 0.01;
  HapticStep step(settings);
  auto scene = std::make_unique<HapticScene>(
    std::vector<HapticShell>{ PlateShell(), { Foot(), At(0, 200, 0) } },
    std::vector<HapticBody>{ { Floor(), {} } });
  step.Swap(scene);
  const hasp::HapticTick tick = Ticks(step, At(0, -2, 0), 400);
  EXPECT_NEAR(tick.onDevice.force.y, SeriesForce(2.0), 0.01);
  EXPECT_EQ(tick.levels, 0.0);
  EXPECT_EQ(tick.evaluations, 1);
}

TEST(HapticDynamic, ATickTakesNoMemory)
{
  const auto plate = Plate();
  const auto floor = Floor();
  HapticStep step = ReadyPlate(plate, floor);
  auto next = std::make_unique<HapticScene>(
    std::vector<HapticShell>{ PlateShell(plate), PlateShell(Plate(), At(30, 0, 0)) },
    std::vector<HapticBody>{ { floor, {} } });
  std::vector<hasp::ShellDisc> discs(20'000);
  auto contact = Settings().contact;
  contact.attraction = 0.001F;
  step.Aim(contact);
  step.Attract(true);
  std::uint32_t shown = 0;
  const std::size_t before = hasp::test::NewCount();
  for (int n = 0; n < 300; ++n)
  {
    step.Tick(At(0.01 * n, 3.0 - 0.02 * n, 0));
    if (n % 40 == 39)
      step.SetIsovalue(0, Isovalue + n % 3);
    if (n == 200)
      step.Swap(next);
    shown += step.Scene()->CopyDynamicDiscs(discs);
  }
  EXPECT_EQ(hasp::test::NewCount(), before);
  EXPECT_GT(shown, 0U);
}

} // namespace
