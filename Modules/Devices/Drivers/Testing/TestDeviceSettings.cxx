#include "Devices/Drivers/DeviceSettings.h"
#include "Devices/Drivers/Testing/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace
{

using namespace hasp;
namespace fs = std::filesystem;

class DeviceSettingsTest : public ::testing::Test
{
protected:
  const TemporaryFolder here;
  const fs::path& folder = this->here.Path;
};

TEST_F(DeviceSettingsTest, AreTheDefaultsWhereThereIsNoFile)
{
  const DeviceSettings none = ReadDeviceSettings(this->folder / "none.json");
  EXPECT_EQ(none.device, "");
  EXPECT_EQ(none.falcon.countsPerNm, FalconSettings().countsPerNm);
  EXPECT_NO_THROW(ReadDeviceSettings({}));
}

#if HASP_WITH_JSON
TEST_F(DeviceSettingsTest, ComeBackAsTheyWereWritten)
{
  DeviceSettings settings;
  settings.device = "plugin:box.so:held";
  settings.falcon.firmware = "a file";
  settings.falcon.countsPerNm = 6543.21;
  settings.falcon.lights = false;
  settings.falcon.eventCharacter = true;
  settings.spaceMouse.fullMmPerS = 30;
  settings.spaceMouse.fullRadPerS = 0.7;
  settings.inverse3.address = "ws://127.0.0.1:12345";
  settings.inverse3.allowRemote = true;
  settings.inverse3.deviceId = "0042";
  settings.inverse3.grip = false;
  const fs::path file = this->folder / "made/for/it/devices.json";
  WriteDeviceSettings(file, settings);
  const DeviceSettings back = ReadDeviceSettings(file);
  EXPECT_EQ(FormatDeviceSettings(back), FormatDeviceSettings(settings));
  EXPECT_EQ(back.device, settings.device);
  EXPECT_EQ(back.falcon.countsPerNm, 6543.21);
  EXPECT_EQ(back.inverse3.deviceId, "0042");
}

TEST_F(DeviceSettingsTest, WhatIsNotThereHasItsDefault)
{
  const DeviceSettings some =
    ParseDeviceSettings(R"({"format":"hasp-devices-1","falcon":{"countsPerNm":4000}})");
  EXPECT_EQ(some.falcon.countsPerNm, 4000);
  EXPECT_TRUE(some.falcon.lights);
  EXPECT_EQ(some.inverse3.address, HaplySettings().address);
}

TEST_F(DeviceSettingsTest, SlipsAreRefusedWithTheirKey)
{
  const auto refused = [](const std::string& more, const std::string& key)
  {
    try
    {
      ParseDeviceSettings(R"({"format":"hasp-devices-1",)" + more + "}");
      ADD_FAILURE() << more;
    }
    catch (const std::exception& error)
    {
      EXPECT_NE(std::string(error.what()).find(key), std::string::npos) << error.what();
    }
  };
  refused(R"("falcon":{"countsPerNM":4000})", "falcon has 1 keys");
  refused(R"("falcon":{"countsPerNm":"4000"})", "falcon.countsPerNm");
  refused(R"("falcon":{"countsPerNm":-1})", "falcon.countsPerNm");
  refused(R"("falcon":{"countsPerNm":1e300})", "falcon.countsPerNm");
  refused(R"("falcon":[])", "falcon must be an object");
  refused(R"("falcon":{"lights":1})", "falcon.lights");
  refused(R"("device":"toaster")", "device");
  refused(R"("device":7)", "device");
  refused(R"("tracker":{})", "1 keys");
  refused(R"("spacemouse":{"fullMmPerS":1e9})", "spacemouse.fullMmPerS");
  EXPECT_THROW(ParseDeviceSettings("{}"), std::invalid_argument);
  EXPECT_THROW(ParseDeviceSettings("[]"), std::invalid_argument);
  EXPECT_THROW(ParseDeviceSettings("{"), std::runtime_error);
  EXPECT_THROW(ParseDeviceSettings(""), std::runtime_error);
  EXPECT_THROW(ParseDeviceSettings(R"({"format":"hasp-devices-2"})"), std::invalid_argument);
}

TEST_F(DeviceSettingsTest, ALargeFileIsNotRead)
{
  const fs::path file = this->folder / "large.json";
  std::ofstream(file) << std::string(100'000, ' ');
  EXPECT_THROW(ReadDeviceSettings(file), std::runtime_error);
}
#endif

} // namespace
