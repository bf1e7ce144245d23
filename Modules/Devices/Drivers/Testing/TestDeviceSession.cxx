#include "Devices/Drivers/DeviceSession.h"
#include "Grid/Progress.h"
#include "ScriptedDriver.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <new>
#include <random>
#include <stdexcept>

namespace
{

using namespace hasp;
using hasp::test::ScriptedDevice;
using hasp::test::ScriptedDriver;

constexpr std::int64_t TickNs = 1'000'000;

/// HAPTIC and the driver's thread, taking turns in virtual time.
struct Bench
{
  /// One ms: the driver's exchange if it is due, then HAPTIC's tick.
  DeviceStatus Tick(const Wrench& wrench)
  {
    this->nowNs += TickNs;
    if (this->nowNs >= this->dueNs)
      this->dueNs = this->session.Step(this->nowNs);
    const DeviceStatus status = this->session.Read(this->sample);
    this->session.Write(wrench);
    return status;
  }
  void Run(int ms, const Wrench& wrench = { { 0, 0, 2 }, {} })
  {
    for (int n = 0; n < ms; ++n)
      this->status = this->Tick(wrench);
  }

  ScriptedDevice device;
  DeviceSession session{ std::make_unique<ScriptedDriver>(device) };
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  std::int64_t nowNs = 0, dueNs = 0;
};

TEST(DeviceSession, WhatCannotBeIsRefused)
{
  EXPECT_THROW(DeviceSession(nullptr), std::invalid_argument);
  ScriptedDevice device;
  EXPECT_THROW(DeviceSession(std::make_unique<ScriptedDriver>(device), { .retryNs = 0 }),
    std::invalid_argument);
  device.profile.poseAxes = 5;
  EXPECT_THROW(DeviceSession(std::make_unique<ScriptedDriver>(device)), std::invalid_argument);
}

TEST(DeviceSession, ItsProfileCountsTheHandOver)
{
  ScriptedDevice device;
  const auto ticks = [&](int own)
  {
    device.profile.delayTicks = own;
    return DeviceSession(std::make_unique<ScriptedDriver>(device)).Profile().delayTicks;
  };
  EXPECT_EQ(ticks(2), 4);
  EXPECT_EQ(ticks(16), 16);
}

TEST(DeviceSession, OpensAndHandsOnWhatIsSaid)
{
  Bench bench;
  bench.device.sample.pose.position = { 1, 2, 3 };
  bench.device.sample.buttons = 5;
  bench.Run(700);
  EXPECT_EQ(bench.status, DeviceStatus::Ok);
  EXPECT_EQ(bench.sample.pose.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(bench.sample.buttons, 5U);
  EXPECT_EQ(bench.device.force.force, glm::dvec3(0, 0, 2));
  EXPECT_EQ(bench.session.News().phase, DevicePhase::Running);
  EXPECT_EQ(bench.session.News().opened, 1U);
}

TEST(DeviceSession, TriesAgainOnceASecondAndSaysWhy)
{
  Bench bench;
  bench.device.there = false;
  bench.device.trouble = DeviceTrouble::Permission;
  bench.Run(3500);
  EXPECT_EQ(bench.device.opens, 4);
  EXPECT_EQ(bench.status, DeviceStatus::Unplugged | DeviceStatus::Stale);
  const DeviceNews news = bench.session.News();
  EXPECT_EQ(news.phase, DevicePhase::Searching);
  EXPECT_EQ(news.trouble, DeviceTrouble::Permission);
  EXPECT_EQ(news.says, "the scripted device is not there; plug it in");
  EXPECT_EQ(news.lost, 0U);
  bench.device.there = true;
  bench.Run(1100);
  EXPECT_EQ(bench.session.News().phase, DevicePhase::Running);
}

TEST(DeviceSession, NoForceUntilItIsHomed)
{
  Bench bench;
  bench.device.homed = false;
  bench.Run(1000);
  EXPECT_TRUE(Has(bench.status, DeviceStatus::NotHomed));
  for (const Wrench& said : bench.device.said)
    ASSERT_EQ(said.force, glm::dvec3(0.0));
  EXPECT_EQ(bench.session.News().phase, DevicePhase::Homing);
  EXPECT_EQ(bench.session.News().advice, "move the grip");
  bench.device.homed = true;
  const std::size_t before = bench.device.said.size();
  bench.Run(600);
  EXPECT_EQ(bench.device.said[before].force, glm::dvec3(0.0));
  EXPECT_LT(glm::length(bench.device.said[before + 10].force), 0.4) << "it ramps in";
  EXPECT_EQ(bench.device.said.back().force, glm::dvec3(0, 0, 2));
}

TEST(DeviceSession, PosesThatAreNoneAreNotHandedOn)
{
  Bench bench;
  bench.device.sample.pose.position = { 1, 2, 3 };
  bench.Run(600);
  bench.device.sample.pose.position.x = std::numeric_limits<double>::quiet_NaN();
  bench.Run(2);
  EXPECT_TRUE(Has(bench.status, DeviceStatus::Fault));
  EXPECT_EQ(bench.sample.pose.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(bench.device.force.force, glm::dvec3(0.0));
  bench.device.sample.pose = { { 1, 2, 4 }, { 2, 0, 0, 0 } };
  bench.Run(2);
  EXPECT_TRUE(Has(bench.status, DeviceStatus::Fault)) << "a quaternion that turns nothing";
}

TEST(DeviceSession, ASilentDeviceIsStale)
{
  Bench bench;
  bench.Run(10);
  bench.device.fresh = false;
  bench.Run(10);
  EXPECT_EQ(bench.status, DeviceStatus::Stale);
  EXPECT_EQ(bench.session.News().stale, 10U);
}

TEST(DeviceSession, WhoeverDoesNotWriteIsAStall)
{
  Bench bench;
  bench.Run(700);
  for (int ms = 0; ms < 45; ++ms) // HAPTIC stands; the driver goes on
    bench.dueNs = bench.session.Step(bench.nowNs += TickNs);
  EXPECT_EQ(bench.device.force.force, glm::dvec3(0.0));
}

TEST(DeviceSession, ClosingLeavesNoForceAndOpensAgain)
{
  Bench bench;
  bench.Run(700);
  bench.session.Close();
  EXPECT_FALSE(bench.device.open);
  EXPECT_EQ(bench.device.force.force, glm::dvec3(0.0));
  EXPECT_EQ(bench.session.News().phase, DevicePhase::Closed);
  bench.dueNs = 0;
  const std::size_t before = bench.device.said.size();
  bench.Run(10);
  EXPECT_EQ(bench.session.News().phase, DevicePhase::Running);
  EXPECT_EQ(bench.device.said.at(before).force, glm::dvec3(0.0));
}

TEST(DeviceSession, ExceptionsOfADriverAreItsTroubles)
{
  for (int kind = 0; kind < 3; ++kind)
  {
    Bench bench;
    bench.Run(5);
    bench.device.exchanging = [kind]
    {
      if (kind == 0)
        throw std::bad_alloc();
      if (kind == 1)
        throw std::runtime_error("a library's own words");
      throw Cancelled();
    };
    bench.Run(5);
    EXPECT_TRUE(Has(bench.status, DeviceStatus::Unplugged));
    EXPECT_FALSE(bench.device.open) << "it was closed";
    bench.device.exchanging = [] {};
    bench.Run(1100);
    EXPECT_EQ(bench.session.News().phase, DevicePhase::Running);
  }
}

TEST(DeviceSession, AnOpeningThatGoesOnIsLeft)
{
  Bench bench;
  bench.device.opening = [&](const DriverOpening& how)
  {
    how.says("loading the firmware, try 2 of 10");
    EXPECT_EQ(bench.session.News().phase, DevicePhase::Opening);
    EXPECT_EQ(bench.session.News().says, "loading the firmware, try 2 of 10");
    EXPECT_FALSE(how.cancelled());
    bench.session.Cancel();
    EXPECT_TRUE(how.cancelled());
    throw Cancelled();
  };
  bench.Run(3000);
  EXPECT_EQ(bench.device.opens, 1);
}

// A boot that fails takes longer than the pause: what it said is there to be read all the same.
TEST(DeviceSession, ThePauseBeginsWhenATryHasEnded)
{
  Bench bench;
  bench.device.there = false;
  bench.device.opening = [&](const DriverOpening& how)
  {
    how.says("loading the firmware");
    bench.nowNs += 3'000 * TickNs;
  };
  bench.Run(1);
  for (int ms = 0; ms < 900; ++ms)
  {
    bench.Run(1);
    ASSERT_EQ(bench.session.News().phase, DevicePhase::Searching) << ms;
  }
  EXPECT_EQ(bench.device.opens, 1);
  bench.Run(200);
  EXPECT_EQ(bench.device.opens, 2);
}

TEST(DeviceSession, WhatIsNotSaneIsAFaultAndForceRampsInAfterIt)
{
  Bench bench;
  bench.Run(700);
  ASSERT_EQ(bench.device.force.force, glm::dvec3(0, 0, 2));
  bench.device.sample.sane = false;
  bench.Run(2);
  EXPECT_TRUE(Has(bench.status, DeviceStatus::Fault));
  EXPECT_EQ(bench.device.force.force, glm::dvec3(0.0));
  bench.device.sample.sane = true;
  bench.Run(5);
  EXPECT_LT(glm::length(bench.device.force.force), 0.3);
}

TEST(DeviceSession, AWarningStaysWhileItRunsAndAdviceIsAskedAgain)
{
  Bench bench;
  bench.device.opening = [](const DriverOpening& how) { how.warns("nobody guards it"); };
  bench.Run(150);
  EXPECT_EQ(bench.session.News().phase, DevicePhase::Running);
  EXPECT_EQ(bench.session.News().warning, "nobody guards it");
  EXPECT_EQ(bench.session.News().advice, "move the grip");
  bench.device.there = false;
  bench.Run(1);
  EXPECT_EQ(bench.session.News().warning, "");
}

// 1,000 times: gone at some moment of any phase, no force from the very tick on, back again.
TEST(DeviceSession, AThousandUnplugs)
{
  Bench bench;
  std::mt19937 random(11);
  std::uniform_int_distribution<int> upTo(0, 1500);
  for (int round = 0; round < 1000; ++round)
  {
    bench.device.homed = upTo(random) > 300;
    bench.Run(1 + upTo(random));
    bench.device.homed = true;
    bench.Run(upTo(random));
    bench.device.there = false;
    const bool wasOpen = bench.device.open;
    bench.Run(1);
    ASSERT_EQ(bench.device.force.force, glm::dvec3(0.0)) << round;
    ASSERT_FALSE(bench.device.open) << round;
    ASSERT_TRUE(Has(bench.status, DeviceStatus::Unplugged)) << round;
    ASSERT_TRUE(wasOpen) << round;
    ASSERT_EQ(bench.session.News().says, "the scripted device is gone") << round;
    bench.Run(upTo(random));
    bench.device.there = true;
    const std::size_t before = bench.device.said.size();
    bench.Run(1005);
    ASSERT_EQ(bench.session.News().phase, DevicePhase::Running) << round;
    ASSERT_EQ(bench.device.said.at(before).force, glm::dvec3(0.0)) << "the first exchange";
    for (std::size_t n = before + 1; n < bench.device.said.size(); ++n)
      ASSERT_LE(
        glm::length(bench.device.said[n].force) - glm::length(bench.device.said[n - 1].force),
        2.0 + 1e-9);
    bench.device.said.clear();
  }
}

} // namespace
