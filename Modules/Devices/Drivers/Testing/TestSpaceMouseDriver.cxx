#include "Devices/Drivers/Testing/FakeSpacenavd.h"
#include "Devices/Drivers/Testing/SpaceMouseBench.h"

#include "Devices/Drivers/SpaceMouse/SpacenavSocket.h"
#include "Grid/Progress.h"
#include "Grid/Testing/CountNew.h"

#include <stdexcept>

namespace
{

using namespace hasp;
using namespace hasp::test;

class SpaceMouseDriverTest : public SpaceMouseBench
{
};

TEST_F(SpaceMouseDriverTest, SettingsOutOfRangeAreRefused)
{
  const auto make = [](const SpaceMouseSettings& settings)
  { SpaceMouseDriver driver(std::make_unique<SpacenavSocket>(), settings); };
  EXPECT_NO_THROW(make({}));
  EXPECT_THROW(make({ .fullMmPerS = -1 }), std::invalid_argument);
  EXPECT_THROW(make({ .fullRadPerS = std::nan("") }), std::invalid_argument);
  EXPECT_THROW(make({ .staleS = 0 }), std::invalid_argument);
  EXPECT_THROW(make({ .waitMs = 21 }), std::invalid_argument);
  EXPECT_THROW(make({ .workspaceMm = { 1, 0, 1 } }), std::invalid_argument);
  EXPECT_THROW(make({ .followS = 2 }), std::invalid_argument);
  EXPECT_THROW(SpaceMouseDriver(nullptr), std::invalid_argument);
  EXPECT_THROW(SpaceMouseHid(nullptr), std::invalid_argument);
}

TEST_F(SpaceMouseDriverTest, IsADeviceWithoutForce)
{
  const DeviceProfile& profile = this->Driver.Profile();
  EXPECT_NO_THROW(ValidateDeviceProfile(profile));
  EXPECT_EQ(profile.name, "spacemouse");
  EXPECT_EQ(profile.poseAxes, 6);
  EXPECT_EQ(profile.forceAxes, 0);
  EXPECT_EQ(profile.peakForceN, 0.0);
  EXPECT_EQ(SpaceMouseDriver(std::make_unique<SpacenavSocket>()).Profile().name, "spacenavd");
}

TEST_F(SpaceMouseDriverTest, FullDeflectionMovesAtTheRateThatIsSet)
{
  for (const bool whole : { false, true })
  {
    this->Driver.Close();
    this->Driver.Open({});
    const glm::dvec3 from = this->At(0).pose.position;
    DriverSample sample;
    for (int ms = 0; ms <= 400; ms += 8)
    {
      if (whole)
        this->Says(Report(1, { 350, 0, 0, 0, 0, 0 }));
      else
      {
        this->Says(Report(1, { 350, 0, 0 }));
        this->Says(Report(2, { 0, 0, 0 }));
      }
      sample = this->At((whole ? 1000 : 0) + ms);
    }
    // From the exchange that heard it first: 400 ms at 60 mm/s.
    EXPECT_NEAR(sample.pose.position.x - from.x, 24.0, 1e-9);
    EXPECT_EQ(sample.pose.position.y, from.y);
    EXPECT_TRUE(sample.fresh && sample.homed);
  }
}

TEST_F(SpaceMouseDriverTest, FullTwistTurnsAtTheRateThatIsSet)
{
  this->Driver.Open({});
  DriverSample sample;
  for (int ms = 0; ms <= 1000; ms += 10)
  {
    this->Says(Report(2, { 0, 0, 350 })); // clockwise from above: about -y
    sample = this->At(ms);
  }
  const glm::dvec3 turned = RotationVector(sample.pose.orientation);
  EXPECT_NEAR(turned.y, -1.5, 1e-9);
  EXPECT_NEAR(turned.x, 0.0, 1e-12);
  EXPECT_EQ(sample.pose.position, glm::dvec3(0.0));
}

/// Where the hand moves the cap the pose goes: each axis of both layouts, through the whole driver.
TEST_F(SpaceMouseDriverTest, SignOfEachAxisThroughTheDriver)
{
  const glm::dvec3 ways[6] = { { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 }, { 1, 0, 0 }, { 0, 0, 1 },
    { 0, -1, 0 } };
  std::int64_t ms = 0;
  for (int axis = 0; axis < 12; ++axis)
  {
    std::array<int, 6> counts{};
    counts[static_cast<std::size_t>(axis % 6)] = 350;
    this->Driver.Open({});
    const RigidPose from = this->At(ms).pose;
    if (axis < 6)
      this->Says(Report(1, { counts[0], counts[1], counts[2], counts[3], counts[4], counts[5] }));
    else
    {
      this->Says(Report(1, { counts[0], counts[1], counts[2] }));
      this->Says(Report(2, { counts[3], counts[4], counts[5] }));
    }
    this->At(ms + 10);
    const RigidPose to = this->At(ms + 20).pose;
    const glm::dvec3 moved = to.position - from.position;
    const glm::dvec3 turned = RotationVector(to.orientation * glm::conjugate(from.orientation));
    const glm::dvec3& way = ways[axis % 6];
    EXPECT_LT(glm::distance(moved, axis % 6 < 3 ? 0.6 * way : glm::dvec3(0)), 1e-9) << axis;
    EXPECT_LT(glm::distance(turned, axis % 6 < 3 ? glm::dvec3(0) : 0.015 * way), 1e-9) << axis;
    ms += 1000;
  }
}

TEST_F(SpaceMouseDriverTest, TheDescriptorSaysWhatFullDeflectionIs)
{
  // -500 to 500; -100 to 100
  for (const auto& [hex, full] : { std::pair{ "0501160cfe26f4010930093109320933093409358102", 500 },
         std::pair{ "0501159c25640930093109320933093409358102", 100 } })
  {
    this->Driver.Close();
    this->Device->descriptor = FromHex(hex);
    this->Driver.Open({});
    const std::int64_t ms = 1'000'000 / full; // later each time
    const double from = this->At(ms).pose.position.x;
    this->Says(Report(1, { full / 2, 0, 0 }));
    this->At(ms + 10);
    EXPECT_NEAR(this->At(ms + 20).pose.position.x - from, 0.3, 1e-12) << full;
  }
}

TEST_F(SpaceMouseDriverTest, WithoutAGoodDescriptorTheUsualRangeHolds)
{
  for (const Bytes& descriptor : { Bytes{}, FromHex("ff"), FromHex("0501150025010930") })
  {
    this->Device->descriptor = descriptor;
    SpaceMouseHid source(std::make_unique<FakeHidTransport>(this->Device));
    source.Open({});
    EXPECT_NE(source.Axes().fault, nullptr);
    this->Says(Report(1, { 175, 0, 0 }));
    SixDofState state;
    EXPECT_TRUE(source.Read(state, 0).push);
    EXPECT_EQ(state.push.x, 0.5);
  }
}

TEST_F(SpaceMouseDriverTest, OvershootMovesNoFaster)
{
  this->Driver.Open({});
  this->Says(Report(1, { 500, 32767, -32768 }));
  this->At(0);
  const glm::dvec3 moved = this->At(100).pose.position;
  EXPECT_NEAR(moved.x, 6.0, 1e-12);
  EXPECT_NEAR(moved.y, 6.0, 1e-12);
  EXPECT_NEAR(moved.z, 6.0, 1e-12);
}

TEST_F(SpaceMouseDriverTest, WhatIsHeldMovesNoLongerThanAFreshOne)
{
  for (const int tickMs : { 1, 3, 4, 7, 16, 33, 99, 100 })
  {
    this->Driver.Open({});
    const std::int64_t from = 10'000 * tickMs;
    const double x = this->At(from).pose.position.x;
    this->Says(Report(1, { 350, 0, 0, 0, 0, 350 })); // and then nothing
    this->At(from);
    DriverSample sample;
    for (int ms = tickMs; ms <= 2000; ms += tickMs)
      sample = this->At(from + ms);
    const double movedMm = sample.pose.position.x - x;
    EXPECT_LE(movedMm, 6.0 + 1e-9) << tickMs; // 100 ms of 60 mm/s
    EXPECT_GT(movedMm, 6.0 - 0.06 * tickMs - 1e-9) << tickMs;
    this->Driver.Close();
  }
}

/// A device whose other half fell silent: pushes go on, the turn that was said last does not.
TEST_F(SpaceMouseDriverTest, EachHalfGrowsStaleOnItsOwn)
{
  this->Driver.Open({});
  this->Says(Report(2, { 350, 0, 0 }));
  DriverSample sample;
  for (int ms = 0; ms <= 500; ms += 10)
  {
    this->Says(Report(1, { 350, 0, 0 }));
    sample = this->At(ms);
  }
  EXPECT_NEAR(sample.pose.position.x, 30.0, 1e-9);
  EXPECT_NEAR(RotationVector(sample.pose.orientation).x, 0.15, 1e-9);
}

TEST_F(SpaceMouseDriverTest, NothingLeapsAfterAPause)
{
  this->Driver.Open({});
  this->At(0);
  this->Says(Report(1, { 350, 0, 0 }));
  EXPECT_EQ(this->At(5000).pose.position.x, 0.0); // what is said now was not so before
  EXPECT_EQ(this->At(9000).pose.position.x, 0.0); // nor is it so now
  this->Says(Report(1, { 350, 0, 0 }));
  this->At(9010);
  EXPECT_EQ(this->At(9000).pose.position.x, 0.0); // time that goes back is none
}

TEST_F(SpaceMouseDriverTest, ButtonsOfEveryModelInBothLayouts)
{
  std::int64_t ms = 0;
  for (const SpaceMouseModel& model : SpaceMouseModels())
    for (const bool whole : { false, true })
    {
      this->Device->is.vendor = model.vendor;
      this->Device->is.product = model.product;
      this->Device->is.productName = model.name;
      this->Device->descriptor = whole ? WholeDescriptor : HalvesDescriptor;
      this->Driver.Open({});
      const RigidPose from = this->At(ms).pose;
      this->Says(whole ? Report(1, { 0, 350, 0, 0, 0, 0 }) : Report(1, { 0, 350, 0 }));
      this->At(ms += 10);
      EXPECT_NEAR(this->At(ms += 10).pose.position.z - from.position.z, 0.6, 1e-9) << model.name;
      for (std::size_t n = 0; n < model.buttonBits.size(); ++n)
      {
        const std::uint8_t bit = model.buttonBits[n];
        this->Says(ButtonReport(std::uint64_t{ 1 } << bit, bit < 16 ? 3 : 7));
        EXPECT_EQ(this->At(ms += 10).buttons, 1u << n) << model.name << " " << n;
      }
      this->Says(ButtonReport(0, 3));
      EXPECT_EQ(this->At(ms += 10).buttons, 0u) << model.name;
      this->Says(Report(1, { 0, -350, 0 })); // back to the middle
      this->At(ms += 10);
      this->At(ms += 10);
      this->Driver.Close();
    }
}

TEST_F(SpaceMouseDriverTest, ButtonsAndRatesAreLetGoWithTheDevice)
{
  this->Driver.Open({});
  this->Says(ButtonReport(2, 3));
  this->Says(Report(1, { 350, 0, 0, 350, 0, 0 }));
  EXPECT_EQ(this->At(0).buttons, 2u);
  const RigidPose pose = this->At(20).pose;
  EXPECT_GT(pose.position.x, 1.0);
  this->Driver.Close();
  this->Driver.Open({});
  const DriverSample sample = this->At(40);
  EXPECT_EQ(sample.buttons, 0u);
  EXPECT_EQ(sample.pose.position, pose.position); // it stays where it was
}

TEST_F(SpaceMouseDriverTest, TheLightIsOnWhileItIsOpen)
{
  this->Driver.Open({});
  ASSERT_EQ(this->Device->written.size(), 1u);
  EXPECT_EQ(this->Device->written[0], FromHex("0401"));
  this->Driver.Close();
  ASSERT_EQ(this->Device->written.size(), 2u);
  EXPECT_EQ(this->Device->written[1], FromHex("0400"));
  this->Driver.Close();
  EXPECT_EQ(this->Device->written.size(), 2u);
  EXPECT_EQ(this->Device->closed, 1);
}

TEST_F(SpaceMouseDriverTest, ADeviceWithoutALightIsNoneTheWorse)
{
  this->Device->takesLight = false;
  this->Driver.Open({});
  this->Says(ButtonReport(1, 3));
  EXPECT_EQ(this->At(0).buttons, 1u);
  this->Driver.Close();
}

TEST_F(SpaceMouseDriverTest, SaysItsBattery)
{
  this->Driver.Open({});
  EXPECT_FALSE(this->Driver.BatteryPercent());
  this->Says(FromHex("175a00"));
  this->At(0);
  EXPECT_EQ(this->Driver.BatteryPercent(), 90);
  this->Driver.Close();
  EXPECT_FALSE(this->Driver.BatteryPercent());
}

TEST_F(SpaceMouseDriverTest, TakesAllThatIsThereInOneExchange)
{
  this->Driver.Open({});
  for (int n = 0; n < 60; ++n)
    this->Says(Report(1, { 0, 0, n, 0, 0, 0 }));
  this->Says(Report(1, { 350, 0, 0, 0, 0, 0 }));
  this->At(0);
  EXPECT_TRUE(this->Device->reports.empty());
  const glm::dvec3 moved = this->At(100).pose.position;
  EXPECT_NEAR(moved.x, 6.0, 1e-12); // the newest holds
  EXPECT_EQ(moved.y, 0.0);
}

TEST_F(SpaceMouseDriverTest, AFloodDoesNotKeepTheExchange)
{
  this->Driver.Open({});
  for (int n = 0; n < 10'000; ++n)
    this->Says(FromHex("ff00"));
  this->At(0);
  EXPECT_EQ(this->Driver.WrongCount(), 128u);
  EXPECT_EQ(this->Device->reports.size(), 10'000u - 128u);
}

TEST_F(SpaceMouseDriverTest, SaysWhatItOpens)
{
  std::string said;
  this->Driver.Open({ .says = [&](const std::string& what) { said += what + "\n"; } });
  EXPECT_EQ(said, "looking for a SpaceMouse\nopening the SpaceMouse Compact\n");
}

TEST_F(SpaceMouseDriverTest, IsCancelledBeforeItOpens)
{
  EXPECT_THROW(this->Driver.Open({ .cancelled = [] { return true; } }), Cancelled);
  EXPECT_EQ(this->Device->opened, 0);
}

TEST_F(SpaceMouseDriverTest, WhatIsNoSpaceMouseIsClosedAgain)
{
  this->Device->is.usage = 2;
  try
  {
    this->Driver.Open({});
    ADD_FAILURE();
  }
  catch (const DeviceError& error)
  {
    EXPECT_EQ(error.trouble, DeviceTrouble::Protocol);
  }
  EXPECT_FALSE(this->Device->open);
}

TEST_F(SpaceMouseDriverTest, ExchangesTakeNoMemoryOfTheirOwn)
{
  SpacenavSocket none;
  FakeSpacenavd daemon;
  daemon.Begin();
  SpaceMouseDriver driver(std::make_unique<SpacenavSocket>(daemon.Path()), AtOnce);
  driver.Open({});
  daemon.Accept();
  for (int n = 0; n < 100; ++n)
  {
    daemon.Motion(std::array{ n, 0, 0, n, 0, 0 });
    daemon.Send({ 1, n % 32 });
    const std::size_t before = NewCount();
    driver.Exchange({}, n * Ms);
    EXPECT_EQ(NewCount(), before);
  }
}

/// One driver, two sources: what the daemon says moves the pose as what a device says.
TEST_F(SpaceMouseDriverTest, TheDaemonMovesThePoseToo)
{
  FakeSpacenavd daemon;
  daemon.Begin();
  SpaceMouseDriver driver(std::make_unique<SpacenavSocket>(daemon.Path()), AtOnce);
  driver.Open({});
  daemon.Accept();
  daemon.Motion(std::array{ 500, 250, -500, 0, 0, 0 });
  driver.Exchange({}, 0);
  for (int ms = 10; ms <= 3000; ms += 10)
    driver.Exchange({}, ms * Ms); // it has fallen silent
  const DriverSample sample = driver.Exchange({}, 4000 * Ms);
  EXPECT_NEAR(glm::distance(sample.pose.position, { 6.0, 3.0, 6.0 }), 0.0, 1e-9);
  daemon.End();
  EXPECT_THROW(driver.Exchange({}, 5000 * Ms), DeviceError);
}

} // namespace
