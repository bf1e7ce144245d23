#include "Devices/PluginHeadPose.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace
{

const std::string Folder = HASP_TEST_PLUGINS;

std::string Refusal(const std::string& file, const std::string& settings = {})
{
  try
  {
    const hasp::PluginHeadPose source(file, settings);
    return {};
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()).find(".so"), std::string::npos) << error.what();
    return error.what();
  }
}

TEST(PluginHeadPose, WhatIsNoPluginIsRefusedWithTheReason)
{
  const std::string text =
    (std::filesystem::temp_directory_path() / ("hasp-no-plugin-" + std::to_string(getpid())))
      .string();
  std::ofstream(text) << "no library";
  const struct
  {
    std::string file, settings;
    const char* says;
  } cases[] = {
    { "/nowhere/tracker.so", "", "there is no such file" },
    { "libc.so.6", "", "there is no such file" }, // which the loader's own search would find
    { Folder, "", "there is no such file" },
    { text, "", "no shared library that can be loaded" },
    { Folder + "/HeadPosePlugin6.so", "", "no shared library that can be loaded" },
    { Folder + "/HeadPosePlugin5.so", "", "no function HaspGetHeadPosePlugin" },
    { Folder + "/HeadPosePlugin4.so", "", "gives no table" },
    { Folder + "/HeadPosePlugin1.so", "", "version 2, this Hasp loads version 1" },
    { Folder + "/HeadPosePlugin2.so", "", "table has 16 bytes, must be 40 or more" },
    { Folder + "/HeadPosePlugin3.so", "", "lacks open, poll or close" },
    { Folder + "/HeadPosePlugin0.so", "absent", "could not open its tracker" },
  };
  for (const auto& c : cases)
    EXPECT_NE(Refusal(c.file, c.settings).find(c.says), std::string::npos)
      << c.says << "\n"
      << Refusal(c.file, c.settings);
  std::filesystem::remove(text);
}

TEST(PluginHeadPose, ItsPosesArriveWithTheirAge)
{
  hasp::PluginHeadPose source(Folder + "/HeadPosePlugin0.so");
  for (double now = 3.0; now < 4.0; now += 0.1)
  {
    const auto pose = source.Latest(now);
    ASSERT_TRUE(pose);
    EXPECT_DOUBLE_EQ(pose->timeS, now - 0.01);
    EXPECT_DOUBLE_EQ(pose->pose.position.x, 100.0 * std::sin(now));
    EXPECT_EQ(pose->pose.orientation, glm::dquat(1, 0, 0, 0));
  }
  EXPECT_EQ(source.TrackerName(), "te?[31mst??") << "nothing a terminal would obey";
  EXPECT_STREQ(source.Name(), "plugin");
  EXPECT_TRUE(source.TakeWarnings().empty());
}

TEST(PluginHeadPose, WhenItLiesTheViewStaysAndAWarningComesOnce)
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
    { "a", "an age" },
    { "A", "an age" },
    { "7", "none of NONE, GIVEN and LOST" },
    { "l", "tracker is gone" },
  };
  for (const auto& c : cases)
  {
    hasp::PluginHeadPose source(Folder + "/HeadPosePlugin0.so", c.settings);
    const auto good = source.Latest(1.0);
    ASSERT_TRUE(good);
    for (double now = 1.1; now < 2.0; now += 0.1)
    {
      const auto again = source.Latest(now);
      ASSERT_TRUE(again);
      EXPECT_EQ(again->timeS, good->timeS) << c.settings;
      EXPECT_EQ(again->pose.position, good->pose.position) << c.settings;
    }
    const auto warnings = source.TakeWarnings();
    ASSERT_EQ(warnings.size(), 1u) << c.settings;
    EXPECT_NE(warnings[0].find(c.says), std::string::npos) << warnings[0];
    source.Latest(3.0);
    EXPECT_TRUE(source.TakeWarnings().empty());
  }
}

TEST(PluginHeadPose, NothingNewIsNoFault)
{
  hasp::PluginHeadPose source(Folder + "/HeadPosePlugin0.so", "n");
  EXPECT_TRUE(source.Latest(1.0));
  EXPECT_DOUBLE_EQ(source.Latest(2.0)->timeS, 0.99);
  EXPECT_TRUE(source.TakeWarnings().empty());
}

TEST(PluginHeadPose, TwoSessionsOfOneLibraryLiveSideBySide)
{
  auto a = std::make_unique<hasp::PluginHeadPose>(Folder + "/HeadPosePlugin0.so");
  hasp::PluginHeadPose b(Folder + "/HeadPosePlugin0.so", "l");
  EXPECT_TRUE(a->Latest(1.0));
  EXPECT_TRUE(b.Latest(1.0));
  a.reset();
  EXPECT_DOUBLE_EQ(b.Latest(2.0)->timeS, 0.99);
}

} // namespace
