#include "StepScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using hasp::HapticStep;
using hasp::RigidPose;
using namespace hasp::testing;

TEST(HapticAttraction, FadesInPullsToTheSurfaceAndFadesOut)
{
  auto settings = Settings();
  settings.contact.attraction = 0.001F; // 0.4 N at most for the whole foot
  settings.contact.captureMm = 3.0F;
  HapticStep step = Ready(settings, GroundScene());
  const RigidPose device = At(0, 0, 1.3);
  EXPECT_EQ(Ticks(step, device, 100).onDevice.force.z, 0.0) << "not asked for";
  step.Attract(true);
  double last = 0.0, largest = 0.0;
  for (int n = 0; n < 400; ++n)
  {
    const double force = step.Tick(device).onDevice.force.z;
    largest = std::max(largest, std::abs(force - last));
    last = force;
  }
  EXPECT_LT(last, -0.05) << "down, to the ground";
  EXPECT_LT(largest, 0.01);
  step.Attract(false);
  EXPECT_NEAR(Ticks(step, device, 120).onDevice.force.z, 0.0, 1e-9);
}

// An attraction far too strong for the spring is weakened to half of its stiffness: the tool does
// not jump to and fro.
TEST(HapticAttraction, NeverOutrunsTheSpring)
{
  auto settings = Settings();
  settings.contact.attraction = 0.5F; // 67 N/mm of slope against 0.33
  HapticStep step = Ready(settings, GroundScene());
  step.Attract(true);
  Ticks(step, At(0, 0, 2), 50); // not faded in yet
  double last = 0.0, moved = 0.0;
  for (int n = 0; n < 2000; ++n)
  {
    const double z = 2.0 + 1.5 * std::sin(0.01 * n); // into reach and out of it
    const double tool = step.Tick(At(0, 0, z)).tool.position.z;
    if (n > 0)
      moved = std::max(moved, std::abs(tool - last));
    last = tool;
  }
  EXPECT_LT(
    moved, 0.06); // the device moves 0.015 a tick; the rim's slope lets the tool move faster
}

// There and back along the same way, the spring and the attraction give back what they took.
TEST(HapticAttraction, PumpsNoEnergy)
{
  auto settings = Settings();
  settings.contact.attraction = 0.001F;
  HapticStep step = Ready(settings, GroundScene());
  step.Attract(true);
  Ticks(step, At(0, 0, 5), 300);
  hasp::PassivityObserver observer;
  for (int n = 0; n <= 20'000; ++n)
  {
    const double z = 2.75 + 2.25 * std::cos(2.0 * std::acos(-1.0) * n / 5000); // four times
    const RigidPose device = At(0, 0, z);
    observer.Tick(device, step.Tick(device).onDevice);
  }
  EXPECT_NEAR(observer.Energy(), 0.0, 0.01); // mJ; a tick's hold costs k v^2 T / 2 = 0.003
}

} // namespace
