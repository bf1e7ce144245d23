#include "Devices/Drivers/DeviceAddress.h"
#include "Devices/Drivers/DeviceList.h"
#include "Devices/Drivers/DeviceSearch.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseModels.h"
#include "Devices/Drivers/Testing/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{

using namespace hasp;
namespace fs = std::filesystem;

/// A system's files, in a folder.
class DeviceSearch : public ::testing::Test
{
protected:
  static void Write(const fs::path& file, const std::string& text)
  {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }
  void PlugFalcon(const std::string& port, int bus, int number)
  {
    const fs::path entry = this->folders.sys / "bus/usb/devices" / port;
    Write(entry / "idVendor", "0403\n");
    Write(entry / "idProduct", "cb48\n");
    Write(entry / "busnum", std::to_string(bus) + "\n");
    Write(entry / "devnum", std::to_string(number) + "\n");
    char node[32];
    std::snprintf(node, sizeof node, "bus/usb/%03d/%03d", bus, number);
    Write(this->folders.dev / node, "");
  }
  void PlugHid(const std::string& node, unsigned vendor, unsigned product, const char* name,
    const std::string& descriptor)
  {
    const fs::path entry = this->folders.sys / "class/hidraw" / node / "device";
    char id[40];
    std::snprintf(id, sizeof id, "HID_ID=0003:%08X:%08X\n", vendor, product);
    Write(entry / "uevent",
      std::string("DRIVER=hid-generic\n") + id + "HID_NAME=" + name + "\nHID_UNIQ=\n");
    Write(entry / "report_descriptor", descriptor);
    Write(this->folders.dev / node, "");
  }

  const TemporaryFolder root;
  const DeviceFolders folders{ this->root.Path / "sys", this->root.Path / "dev",
    this->root.Path / "spnav.sock" };
  const std::string multiAxis{ "\x05\x01\x09\x08\xa1\x01", 6 };
  const std::string mouse{ "\x05\x01\x09\x02\xa1\x01", 6 };
};

TEST_F(DeviceSearch, WhereThereIsNothingThereIsNothing)
{
  EXPECT_TRUE(FindDevices(this->folders).empty());
  fs::create_directories(this->folders.sys / "bus/usb/devices/1-1");
  fs::create_directories(this->folders.sys / "class/hidraw/hidraw0");
  EXPECT_TRUE(FindDevices(this->folders).empty());
}

TEST_F(DeviceSearch, FindsWhatIsPluggedIn)
{
  this->PlugFalcon("1-2.3", 1, 7);
  this->PlugFalcon("2-1", 2, 113);
  this->PlugHid("hidraw3", 0x256f, 0xc635, "SpaceMouse Compact", this->multiAxis);
  this->PlugHid("hidraw4", 0x256f, 0xc635, "SpaceMouse Compact", this->mouse);
  this->PlugHid("hidraw5", 0x256f, 0xc650, "CadMouse", this->multiAxis);
  this->PlugHid("hidraw6", 0x1234, 0xc635, "another maker's", this->multiAxis);
  const auto found = FindDevices(this->folders);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].address, "falcon:1-2.3");
  EXPECT_EQ(found[1].address, "falcon:2-1");
  EXPECT_EQ(found[0].name, "Novint Falcon");
  EXPECT_TRUE(found[0].force);
  EXPECT_EQ(found[2].address, "spacemouse:hidraw3");
  EXPECT_FALSE(found[2].force);
  EXPECT_NE(found[2].name.find("SpaceMouse Compact"), std::string::npos);
  for (const FoundDevice& device : found)
    EXPECT_EQ(device.mayOpen && device.driver, device.remedy.empty()) << device.remedy;
}

TEST_F(DeviceSearch, TakesWhatPushesBeforeWhatDoesNot)
{
  EXPECT_EQ(FirstUsable({}), "");
  const FoundDevice mouse{ .address = "spacemouse:hidraw0", .name = "a mouse" };
  const FoundDevice falcon{ .address = "falcon:1-1", .name = "Novint Falcon", .force = true };
  FoundDevice locked = falcon, unbuilt = falcon;
  locked.mayOpen = false;
  unbuilt.driver = false;
  EXPECT_EQ(FirstUsable({ mouse, falcon }), "falcon:1-1");
  EXPECT_EQ(FirstUsable({ locked, mouse, unbuilt }), "spacemouse:hidraw0");
  EXPECT_EQ(FirstUsable({ locked, unbuilt }), "");
}

TEST_F(DeviceSearch, ANameGetsItsPlace)
{
  FoundDevice locked{ .address = "falcon:1-1", .name = "Novint Falcon", .force = true };
  locked.mayOpen = false;
  const FoundDevice free{ .address = "falcon:1-2", .name = "Novint Falcon", .force = true };
  EXPECT_EQ(WithPlace("falcon", { locked, free }), "falcon:1-2");
  EXPECT_EQ(WithPlace("falcon:1-1", { locked, free }), "falcon:1-1");
  EXPECT_EQ(WithPlace("falcon", { locked }), "falcon");
  EXPECT_EQ(WithPlace("inverse3", { locked, free }), "inverse3");
}

TEST_F(DeviceSearch, SaysTheRuleWhereItMayNotBeOpened)
{
  this->PlugFalcon("1-1", 1, 2);
  fs::remove(this->folders.dev / "bus/usb/001/002"); // root may open anything that is there
  const auto found = FindDevices(this->folders);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].mayOpen);
  EXPECT_NE(
    found[0].remedy.find(found[0].driver ? "udev" : "HASP_ENABLE_LIBUSB"), std::string::npos);
}

TEST_F(DeviceSearch, FindsTheDaemonBehindItsSocket)
{
  Write(this->folders.spacenav, "no socket");
  EXPECT_TRUE(FindDevices(this->folders).empty());
  fs::remove(this->folders.spacenav);
  const int handle = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::snprintf(address.sun_path, sizeof address.sun_path, "%s", this->folders.spacenav.c_str());
  ASSERT_EQ(::bind(handle, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  const auto found = FindDevices(this->folders);
  ::close(handle);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].address, "spacenav:" + this->folders.spacenav.string());
  EXPECT_TRUE(found[0].mayOpen);
}

TEST_F(DeviceSearch, FilesThatLieAreNoDevices)
{
  this->PlugFalcon("1-1", 1, 2);
  for (const char* text : { "", "x", "-", "99999999999999999999", "1 2", "\xff\xff" })
  {
    Write(this->folders.sys / "bus/usb/devices/1-1/busnum", text);
    EXPECT_TRUE(FindDevices(this->folders).empty()) << text;
  }
  for (const char* text : { "", "HID_ID=", "HID_ID=0003", "HID_ID=0003:zz:cc",
         "HID_ID=::", "HID_ID=0003:FFFFFFFFFF:0000C635", "XHID_ID=0003:0000256F:0000C635" })
  {
    this->PlugHid("hidraw0", 0x256f, 0xc635, "SpaceMouse", this->multiAxis);
    Write(this->folders.sys / "class/hidraw/hidraw0/device/uevent", text);
    EXPECT_TRUE(FindDevices(this->folders).empty()) << text;
  }
}

TEST_F(DeviceSearch, ThisMachineIsAsked)
{
  EXPECT_NO_THROW(FindDevices()); // whatever it has
}

TEST(UdevRules, AreTheInstalledOnesAndNameEachModel)
{
  std::ifstream stream(HASP_UDEV_RULES);
  std::ostringstream text;
  text << stream.rdbuf();
  const std::string rules = UdevRules();
  EXPECT_EQ(rules, text.str());
  EXPECT_NE(rules.find("ATTR{idProduct}==\"cb48\""), std::string::npos);
  EXPECT_NE(rules.find("ATTRS{idVendor}==\"256f\""), std::string::npos);
  for (const SpaceMouseModel& model : SpaceMouseModels())
  {
    char product[8];
    std::snprintf(product, sizeof product, "%04x", model.product);
    if (model.vendor == 0x046d)
      EXPECT_NE(rules.find(product), std::string::npos) << model.name;
    else
      EXPECT_EQ(model.vendor, 0x256f) << model.name;
  }
}

TEST(DeviceAddress, IsADriverAndMore)
{
  EXPECT_EQ(ParseDeviceAddress("falcon").driver, "falcon");
  EXPECT_EQ(ParseDeviceAddress("falcon").rest, "");
  EXPECT_EQ(ParseDeviceAddress("inverse3:ws://localhost:1").rest, "ws://localhost:1");
  EXPECT_EQ(ParseDeviceAddress("plugin:a.so:b").rest, "a.so:b");
  for (const char* wrong : { "", "Falcon", "touch", ":falcon", "plugin", "plugin:" })
    try
    {
      ParseDeviceAddress(wrong);
      ADD_FAILURE() << wrong;
    }
    catch (const DeviceError& error)
    {
      EXPECT_EQ(error.trouble, DeviceTrouble::Address) << wrong;
    }
}

TEST(DeviceList, MakesEachDriverWithoutTouchingADevice)
{
  EXPECT_EQ(MakeDriver("spacenav:/nonexistent/socket")->Profile().forceAxes, 0);
  EXPECT_THROW(MakeDriver("plugin:/nonexistent.so"), DeviceError);
  for (const auto& [address, built] : { std::pair<const char*, bool>{ "falcon", HASP_WITH_LIBUSB },
         { "spacemouse", HASP_WITH_HIDAPI } })
    try
    {
      EXPECT_NE(MakeDriver(address), nullptr);
      EXPECT_TRUE(built) << address;
    }
    catch (const DeviceError& error)
    {
      EXPECT_FALSE(built) << address;
      EXPECT_EQ(error.trouble, DeviceTrouble::NotBuilt);
      EXPECT_NE(std::string(error.what()).find("HASP_ENABLE_"), std::string::npos);
    }
}

} // namespace
