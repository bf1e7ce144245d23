#include "Devices/InputHapticDevice.h"

#include "Grid/Testing/CountNew.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

namespace
{

using namespace hasp;

constexpr std::int64_t Ms = 1'000'000;
const InputDeviceSettings AtOnce{ .followS = 0.0 };

double Turned(const glm::dquat& a, const glm::dquat& b)
{
  return glm::length(RotationVector(a * glm::conjugate(b)));
}

TEST(InputHapticDevice, SettingsOutOfRangeAreRefused)
{
  EXPECT_THROW(InputHapticDevice({ .workspaceMm = { 10, 0, 10 } }), std::invalid_argument);
  EXPECT_THROW(InputHapticDevice({ .followS = -1.0 }), std::invalid_argument);
  EXPECT_THROW(InputHapticDevice({ .followS = std::nan("") }), std::invalid_argument);
  EXPECT_THROW(InputHapticDevice({ .staleS = 0.0 }), std::invalid_argument);
}

TEST(InputHapticDevice, GivesNoForceAndIsAlwaysThere)
{
  InputHapticDevice device;
  EXPECT_NO_THROW(ValidateDeviceProfile(device.Profile()));
  EXPECT_EQ(device.Profile().forceAxes, 0);
  DeviceSample sample;
  EXPECT_EQ(device.Read(0, sample), DeviceStatus::Ok);
  EXPECT_EQ(sample.pose.position, glm::dvec3(0.0));
  EXPECT_EQ(device.Read(0, sample), DeviceStatus::Stale);
  EXPECT_EQ(device.Write({ { 5, 0, 0 } }), DeviceStatus::Ok);
}

TEST(InputHapticDevice, WhatIsNoNumberIsIgnored)
{
  InputHapticDevice device(AtOnce);
  const glm::dvec3 bad(0, std::nan(""), 0), far(std::numeric_limits<double>::infinity(), 0, 0);
  device.MoveBy({ 1, 2, 3 });
  device.MoveBy(bad);
  device.TurnBy(far);
  device.MoveTo({ bad });
  device.MoveTo({ {}, { 0, 0, 0, 0 } });
  device.SetRates(bad, {}, 0);
  device.SetRates({}, far, 0);
  DeviceSample sample;
  device.Read(Ms, sample);
  device.Read(2 * Ms, sample);
  EXPECT_EQ(sample.pose.position, glm::dvec3(1, 2, 3));
  EXPECT_LT(Turned(sample.pose.orientation, { 1, 0, 0, 0 }), 1e-15);
}

TEST(InputHapticDevice, EachStepArrivesHoweverSeldomTicksLook)
{
  InputHapticDevice device(AtOnce);
  DeviceSample sample;
  glm::dvec3 moved(0.0);
  glm::dquat turned(1, 0, 0, 0);
  std::int64_t now = 0;
  for (int n = 1; n <= 60; ++n)
  {
    const glm::dvec3 step(0.1 * n, -0.05 * n, 0.3), turn(0.02 * n, 0.1, -0.01);
    device.MoveBy(step);
    device.TurnBy(turn);
    moved += step;
    turned = TurnBy(turn) * turned;
    if (n % 7 != 0) // several steps between two looks
      continue;
    device.Read(now += Ms, sample);
    EXPECT_LT(glm::length(sample.pose.position - glm::clamp(moved, -100.0, 100.0)), 1e-10);
    EXPECT_LT(Turned(sample.pose.orientation, turned), 1e-12);
  }
}

TEST(InputHapticDevice, MoveToForgetsWhatWasBefore)
{
  InputHapticDevice device(AtOnce);
  DeviceSample sample;
  device.MoveBy({ 50, 0, 0 });
  device.Read(Ms, sample);
  device.MoveBy({ 7, 7, 7 });
  device.MoveTo({ { 1, 2, 3 }, TurnBy({ 0.5, 0, 0 }) });
  device.MoveBy({ 0, 0, 1 });
  device.TurnBy({ 0.1, 0, 0 });
  device.Read(2 * Ms, sample);
  EXPECT_LT(glm::length(sample.pose.position - glm::dvec3(1, 2, 4)), 1e-12);
  EXPECT_LT(Turned(sample.pose.orientation, TurnBy({ 0.6, 0, 0 })), 1e-12);
}

TEST(InputHapticDevice, MoveToIsThereAtOnceHoweverSlowlyStepsAreFollowed)
{
  InputHapticDevice device({ .followS = 1.0 });
  DeviceSample sample;
  device.Read(0, sample);
  device.MoveBy({ 50, 0, 0 });
  device.Read(Ms, sample);
  device.MoveTo({ { 1, 2, 3 }, TurnBy({ 0.5, 0, 0 }) });
  device.Read(2 * Ms, sample);
  EXPECT_LT(glm::length(sample.pose.position - glm::dvec3(1, 2, 3)), 1e-12);
  EXPECT_LT(Turned(sample.pose.orientation, TurnBy({ 0.5, 0, 0 })), 1e-12);
}

TEST(InputHapticDevice, RatesAreIntegratedWhileTheyAreFresh)
{
  InputHapticDevice device(AtOnce);
  DeviceSample sample;
  device.Read(0, sample);
  device.SetRates({ 100, 0, 0 }, { 0, 0, 2 }, 0);
  for (int ms = 1; ms <= 300; ++ms)
  {
    device.Read(ms * Ms, sample);
    const double s = 1e-3 * std::min(ms, 100); // then nobody says them any more
    EXPECT_NEAR(sample.pose.position.x, 100.0 * s, 1e-9) << ms;
    EXPECT_LT(Turned(sample.pose.orientation, TurnBy({ 0, 0, 2 * s })), 1e-12);
  }
  device.SetRates({ 100, 0, 0 }, {}, 300 * Ms);
  device.Read(10'300 * Ms, sample); // ten seconds of pause
  EXPECT_NEAR(sample.pose.position.x, 10.0, 1e-9) << "nothing leaps";
}

TEST(InputHapticDevice, PosesStayInTheBoxAndComeBackFromItsWallAtOnce)
{
  InputHapticDevice device({ .workspaceMm = { 10, 20, 30 }, .followS = 0.0 });
  DeviceSample sample;
  device.MoveBy({ 500, -500, 500 });
  device.Read(Ms, sample);
  EXPECT_EQ(sample.pose.position, glm::dvec3(10, -20, 30));
  device.MoveBy({ -1, 1, -1 });
  device.Read(2 * Ms, sample);
  EXPECT_LT(glm::length(sample.pose.position - glm::dvec3(9, -19, 29)), 1e-12);
}

TEST(InputHapticDevice, APoseFollowsWithItsTimeConstant)
{
  InputHapticDevice device({ .followS = 0.02 });
  DeviceSample sample;
  device.Read(0, sample);
  device.MoveBy({ 10, 0, 0 });
  device.TurnBy({ 0, 0.5, 0 });
  for (int ms = 1; ms <= 100; ++ms)
  {
    device.Read(ms * Ms, sample);
    const double way = 1.0 - std::exp(-ms / 20.0);
    EXPECT_NEAR(sample.pose.position.x, 10.0 * way, 1e-10);
    EXPECT_LT(Turned(sample.pose.orientation, TurnBy({ 0, 0.5 * way, 0 })), 1e-10);
  }
}

/// A recording may say any, and a clock be set: the longest tick is all that goes by.
TEST(InputHapticDevice, AnyTwoTimesAreATick)
{
  constexpr std::int64_t First = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t Last = std::numeric_limits<std::int64_t>::max();
  InputHapticDevice device({ .followS = 0.1 });
  DeviceSample sample;
  device.Read(First, sample);
  device.MoveBy({ 10, 0, 0 });
  device.SetRates({ 1000, 0, 0 }, {}, First);
  EXPECT_EQ(device.Read(Last, sample), DeviceStatus::Ok);
  EXPECT_NEAR(sample.pose.position.x, 10.0 * (1.0 - std::exp(-1.0)), 1e-10) << "no old rate";
  EXPECT_EQ(device.Read(First, sample), DeviceStatus::Stale);
}

TEST(InputHapticDevice, ATickTakesNoMemory)
{
  InputHapticDevice device;
  DeviceSample sample;
  const std::size_t before = test::NewCountOfAllThreads();
  for (int ms = 1; ms <= 100; ++ms)
  {
    device.MoveBy({ 0.1, 0, 0 });
    device.SetRates({ 1, 1, 1 }, { 1, 1, 1 }, ms * Ms);
    device.Read(ms * Ms, sample);
  }
  EXPECT_EQ(test::NewCountOfAllThreads(), before);
}

/// One thread moves, another looks: no step is lost, however they meet.
TEST(InputHapticDevice, MayBeFedWhileItIsRead)
{
  constexpr int Steps = 5000;
  InputHapticDevice device({ .workspaceMm = { 1e4, 1e4, 1e4 }, .followS = 0.0 });
  std::atomic<bool> done{ false };
  std::thread render(
    [&]
    {
      for (int n = 1; n <= Steps; ++n)
      {
        device.MoveBy({ 1, 0, 0 });
        device.SetButtons(static_cast<std::uint32_t>(n));
      }
      done = true;
    });
  DeviceSample sample;
  std::uint64_t backwards = 0, apart = 0;
  double before = 0.0;
  for (std::int64_t now = 1; !done; ++now)
  {
    device.Read(now, sample);
    backwards += sample.pose.position.x < before;
    // A step and its button are two writes.
    const double between = sample.pose.position.x - sample.buttons;
    apart += between != 0.0 && between != 1.0;
    before = sample.pose.position.x;
  }
  render.join();
  device.Read(std::int64_t(1) << 40, sample);
  EXPECT_EQ(sample.pose.position.x, Steps);
  EXPECT_EQ(backwards, 0u);
  EXPECT_EQ(apart, 0u);
}

/// Finite numbers whose sums or squares are not: one event must not spoil all that come after.
TEST(InputHapticDevice, WhatIsAbsurdlyFarIsIgnoredAsWhatIsNotFinite)
{
  InputHapticDevice device({ .followS = 0.0 });
  DeviceSample sample;
  for (int n = 0; n < 3; ++n)
  {
    device.MoveBy(glm::dvec3(1e308));
    device.TurnBy(glm::dvec3(1e200));
    device.MoveTo({ glm::dvec3(1e308) });
    device.SetRates(glm::dvec3(1e308), glm::dvec3(1e200), 0);
    device.Read(n, sample);
  }
  device.MoveBy({ 1, 2, 3 });
  device.Read(1'000'000, sample);
  EXPECT_EQ(sample.pose.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(sample.pose.orientation, glm::dquat(1, 0, 0, 0));
}

} // namespace
