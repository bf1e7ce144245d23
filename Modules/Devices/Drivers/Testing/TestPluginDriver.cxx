#include "Devices/Drivers/Plugin/PluginDriver.h"
#include "Grid/Progress.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace
{

using hasp::DeviceTrouble;

const std::string Folder = HASP_TEST_PLUGINS;
const std::string Good = Folder + "/DevicePlugin0.so";

/// That `use` throws DeviceError of that kind, which says so and names no file.
void ExpectTrouble(
  const std::function<void()>& use, DeviceTrouble trouble, const char* says, const char* where)
{
  try
  {
    use();
    ADD_FAILURE() << where << ": nothing was wrong";
  }
  catch (const hasp::DeviceError& error)
  {
    EXPECT_EQ(error.trouble, trouble) << where << ": " << error.what();
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos)
      << where << ": " << error.what();
    EXPECT_EQ(std::string(error.what()).find(".so"), std::string::npos) << error.what();
  }
}

TEST(PluginDriver, WhatIsNoPluginIsRefusedWithTheReason)
{
  const std::string text =
    (std::filesystem::temp_directory_path() / ("hasp-no-device-plugin-" + std::to_string(getpid())))
      .string();
  std::ofstream(text) << "no library";
  const struct
  {
    std::string file, settings;
    DeviceTrouble trouble;
    const char* says;
  } cases[] = {
    { "/nowhere/device.so", "", DeviceTrouble::Address, "there is no such file" },
    { "libc.so.6", "", DeviceTrouble::Address, "there is no such file" },
    { Folder, "", DeviceTrouble::Address, "there is no such file" },
    { "", "", DeviceTrouble::Address, "there is no such file" },
    { text, "", DeviceTrouble::Address, "no shared library that can be loaded" },
    { Folder + "/DevicePlugin6.so", "", DeviceTrouble::Address, "no shared library" },
    { Folder + "/DevicePlugin5.so", "", DeviceTrouble::Address,
      "no function HaspGetHapticDevicePlugin" },
    { Folder + "/DevicePlugin4.so", "", DeviceTrouble::Address, "gives no table" },
    { Folder + "/DevicePlugin1.so", "", DeviceTrouble::Address,
      "version 2, this Hasp loads version 1; compile it with this Hasp's HapticDevicePlugin.h" },
    { Folder + "/DevicePlugin2.so", "", DeviceTrouble::Address,
      "table has 16 bytes, must be 56 or more" },
    { Folder + "/DevicePlugin3.so", "", DeviceTrouble::Address,
      "lacks describe, open, exchange or close" },
    { Good, "?", DeviceTrouble::Address, "does not understand its settings" },
    { Good, "??", DeviceTrouble::Address, "does not understand its settings" },
    { Good, "P", DeviceTrouble::Protocol, "poseAxes is 4, must be 3 or 6" },
    { Good, "F", DeviceTrouble::Protocol, "peakForceN is nan" },
    { Good, "M", DeviceTrouble::Protocol, "movingMassKg is 0, must be in" },
    { Good, "B", DeviceTrouble::Protocol, "buttons is 33, must be in [0, 32]" },
  };
  for (const auto& c : cases)
    ExpectTrouble(
      [&] { const hasp::PluginDriver driver(c.file, c.settings); }, c.trouble, c.says, c.says);
  std::filesystem::remove(text);
}

TEST(PluginDriver, WhyADeviceDoesNotOpenIsTold)
{
  const struct
  {
    const char* settings;
    DeviceTrouble trouble;
    const char* says;
  } cases[] = {
    { "absent", DeviceTrouble::Absent, "is it plugged in and switched on" },
    { "busy", DeviceTrouble::Busy, "another program has its device" },
    { "forbidden", DeviceTrouble::Permission, "does not let this user" },
    { "odd", DeviceTrouble::Absent, "is it plugged in" },
  };
  for (const auto& c : cases)
  {
    hasp::PluginDriver driver(Good, c.settings);
    for (int again = 0; again < 3; ++again)
      ExpectTrouble([&] { driver.Open({}); }, c.trouble, c.says, c.settings);
    ExpectTrouble([&] { driver.Exchange({}, 0); }, DeviceTrouble::Gone, "not open", c.settings);
    driver.Close(); // nothing
  }
}

TEST(PluginDriver, IsNotOpenedWhereItWasAskedToLeave)
{
  hasp::PluginDriver driver(Good);
  hasp::DriverOpening how;
  how.cancelled = [] { return true; };
  EXPECT_THROW(driver.Open(how), hasp::Cancelled);
  EXPECT_THROW(driver.Exchange({}, 0), hasp::DeviceError);
}

TEST(PluginDriver, SamplesArriveAndWrenchesGoOutWithinTheProfile)
{
  hasp::PluginDriver driver(Good);
  EXPECT_EQ(driver.Profile().name, "te?[31mst??") << "nothing a terminal would obey";
  EXPECT_EQ(driver.Profile().peakForceN, 5.0);
  std::string said;
  hasp::DriverOpening how;
  how.says = [&](const std::string& text) { said = text; };
  driver.Open(how);
  EXPECT_EQ(said, "opening te?[31mst??");
  const hasp::DriverSample sample = driver.Exchange({ { 1, -2, 3 }, {} }, 7);
  EXPECT_TRUE(sample.fresh && sample.homed);
  EXPECT_EQ(sample.pose, (hasp::RigidPose{ { 1, -2, 3 }, { 1, 0, 0, 0 } }));
  EXPECT_EQ(sample.buttons, 2u);
  EXPECT_EQ(driver.Exchange({ { 0, 50, 0 }, {} }, 8).pose.position, glm::dvec3(0, 5, 0));
  EXPECT_EQ(driver.Exchange({ { NAN, 0, 0 }, {} }, 9).pose.position, glm::dvec3(0));
  EXPECT_EQ(driver.Advice(), "");

  hasp::PluginDriver torques(Good, "t");
  torques.Open({});
  torques.Exchange({}, 0);
  EXPECT_EQ(torques.Exchange({ {}, { 4, 5, -6 } }, 1).pose.position, glm::dvec3(4, 5, -6));
}

TEST(PluginDriver, WhatCannotBeIsDroppedAndThenTheEnd)
{
  const struct
  {
    const char* settings;
    const char* says;
  } cases[] = {
    { "N", "not finite" },
    { "I", "not finite" },
    { "f", "further than 10 m" },
    { "q", "not unit" },
    { "z", "not unit" },
    { "b", "buttons that its profile does not have" },
    { "7", "none of NONE, GIVEN and LOST" },
  };
  for (const auto& c : cases)
  {
    hasp::PluginDriver driver(Good, c.settings);
    for (int session = 0; session < 3; ++session)
    {
      driver.Open({});
      const hasp::DriverSample good = driver.Exchange({ { 1, 2, 3 }, {} }, 0);
      EXPECT_TRUE(good.fresh) << c.settings;
      for (int n = 1; n < hasp::PluginDriver::MostWrong; ++n)
      {
        const hasp::DriverSample again = driver.Exchange({ { 3, 2, 1 }, {} }, n);
        EXPECT_FALSE(again.fresh) << c.settings;
        EXPECT_EQ(again.pose, good.pose) << c.settings;
        EXPECT_EQ(again.buttons, good.buttons) << c.settings;
      }
      ExpectTrouble([&] { driver.Exchange({}, 100); }, DeviceTrouble::Protocol, c.says, c.settings);
      driver.Close();
    }
  }
}

TEST(PluginDriver, WrongNowAndThenIsNoEnd)
{
  hasp::PluginDriver driver(Good, "s");
  driver.Open({});
  int fresh = 0;
  for (int n = 0; n < 1000; ++n)
    fresh += driver.Exchange({}, n).fresh;
  EXPECT_EQ(fresh, 21); // the first, and each 50th
}

TEST(PluginDriver, NothingNewIsNoFaultHoweverOften)
{
  hasp::PluginDriver driver(Good, "n");
  driver.Open({});
  const hasp::DriverSample good = driver.Exchange({ { 1, 2, 3 }, {} }, 0);
  for (int n = 0; n < 1000; ++n)
  {
    const hasp::DriverSample again = driver.Exchange({}, n);
    EXPECT_FALSE(again.fresh);
    EXPECT_TRUE(again.homed);
    EXPECT_EQ(again.pose, good.pose);
  }
}

TEST(PluginDriver, ADeviceThatGoesMayComeBack)
{
  hasp::PluginDriver driver(Good, "l");
  for (int again = 0; again < 5; ++again)
  {
    driver.Open({});
    EXPECT_TRUE(driver.Exchange({}, 0).fresh);
    ExpectTrouble([&] { driver.Exchange({}, 1); }, DeviceTrouble::Gone, "unplugged", "l");
    driver.Close();
    driver.Close();
  }
}

TEST(PluginDriver, WhatAProfileSaysDecidesWhatIsRead)
{
  hasp::PluginDriver position(Good, "3");
  position.Open({});
  for (int n = 0; n < 5; ++n)
    EXPECT_EQ(position.Exchange({}, n).pose.orientation, glm::dquat(1, 0, 0, 0));

  hasp::PluginDriver input(Good, "0");
  input.Open({});
  for (int n = 0; n < 5; ++n)
  {
    const hasp::DriverSample sample = input.Exchange({ { 1, 1, 1 }, {} }, n);
    EXPECT_TRUE(sample.fresh);
    EXPECT_EQ(sample.pose.position, glm::dvec3(0)) << "no force where there are no motors";
    EXPECT_EQ(sample.buttons, n == 0 ? 2u : 0x80000000u);
  }

  hasp::PluginDriver homing(Good, "h");
  homing.Open({});
  EXPECT_TRUE(homing.Exchange({}, 0).homed);
  EXPECT_FALSE(homing.Exchange({}, 1).homed);
}

TEST(PluginDriver, AdviceIsCutAndPrintable)
{
  hasp::PluginDriver driver(Good, "a");
  EXPECT_EQ(driver.Advice(), "");
  driver.Open({});
  EXPECT_EQ(driver.Advice(), "Move?[31m it" + std::string(188, 'x'));
  driver.Close();
  EXPECT_EQ(driver.Advice(), "");

  hasp::PluginDriver without(Folder + "/DevicePlugin7.so", "a");
  without.Open({});
  EXPECT_EQ(without.Advice(), "");
  EXPECT_EQ(hasp::PluginDriver(Folder + "/DevicePlugin8.so").Profile().name, "");
}

TEST(PluginDriver, TwoSessionsOfOneLibraryLiveSideBySide)
{
  auto a = std::make_unique<hasp::PluginDriver>(Good);
  hasp::PluginDriver b(Good, "l");
  a->Open({});
  b.Open({});
  EXPECT_TRUE(a->Exchange({}, 0).fresh);
  a.reset();
  EXPECT_EQ(b.Exchange({ { 1, 0, 0 }, {} }, 0).pose.position, glm::dvec3(1, 0, 0));
}

} // namespace
