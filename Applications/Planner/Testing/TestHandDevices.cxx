// The haptic device of who sits there: found, opened, lent to tools, lost, and given up.
#include "Devices/Drivers/Testing/TemporaryFolder.h"
#include "StepsDesk.h"

#include "Steps/PanelWidgets.h"
#include "Tools/DevicePointer.h"
#include "Tools/GrabTool.h"
#include "Tools/HandDevices.h"
#include "Tools/LandmarkTool.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>

namespace
{
using namespace hasp;
using namespace hasp::testing;
namespace fs = std::filesystem;

constexpr int PatienceMs = 30'000;

class HandDevicesTest : public ::testing::Test
{
protected:
  HandDevicesTest()
  {
    fs::create_directories(this->root / "sys/bus/usb/devices");
    fs::create_directories(this->root / "dev/bus/usb/001");
    this->places = { .folders = { this->root / "sys", this->root / "dev", this->root / "spnav" },
      .settings = this->root / "config/devices.json",
      .guard = HASP_DEVICE_GUARD };
  }
  ~HandDevicesTest() override
  {
    this->desk.planner.tools.Take(nullptr);
    this->hand.reset();
  }
  static void Write(const fs::path& file, const std::string& text)
  {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }
  void PlugFalcon()
  {
    for (const auto& [name, text] : { std::pair{ "idVendor", "0403\n" }, { "idProduct", "cb48\n" },
           { "busnum", "1\n" }, { "devnum", "7\n" } })
      Write(this->root / "sys/bus/usb/devices/1-2" / name, text);
    Write(this->root / "dev/bus/usb/001/007", "");
  }
  /// The sample plugin, or a faulty one, as the user's device.
  void Use(const std::string& device)
  {
    DeviceSettings settings;
    settings.device = device;
    WriteDeviceSettings(this->places.settings, settings);
  }
  void Begin() { this->hand.emplace(this->desk.planner, this->places); }
  bool Until(const std::function<bool()>& holds)
  {
    return this->desk.views.Wait(holds, PatienceMs);
  }
  bool Runs() { return this->hand->News().phase == DevicePhase::Running; }

  const TemporaryFolder here;
  const fs::path& root = this->here.Path;
  HandDevices::Places places;
  StepsDesk desk{ ScanOfBar() };
  DevicePointer pointer{ this->desk.planner };
  LandmarkTool tool{ this->desk.planner, {} };
  std::optional<HandDevices> hand;
  const std::string box = std::string("plugin:") + HASP_PLUGINS + "/DevicePluginSpringBox.so";
};

TEST_F(HandDevicesTest, WithoutOneThereIsTheMouseAndNothingElse)
{
  this->Begin();
  EXPECT_TRUE(this->hand->Found().empty());
  EXPECT_EQ(this->hand->Address(), "");
  this->desk.planner.tools.Take(&this->tool);
  EXPECT_FALSE(this->pointer.IsOn());
  EXPECT_EQ(this->hand->Hold(), nullptr);
  EXPECT_EQ(this->hand->News().phase, DevicePhase::Closed) << "no thread";
  EXPECT_EQ(this->desk.said, "");
}

TEST_F(HandDevicesTest, IsOpenedForAToolAndGivenUpAfterIt)
{
  this->Use(this->box);
  this->Begin();
  EXPECT_EQ(this->hand->News().phase, DevicePhase::Closed) << "nobody wants it yet";
  this->desk.planner.tools.Take(&this->tool);
  EXPECT_TRUE(this->Until([&] { return this->pointer.IsOn(); }));
  EXPECT_TRUE(this->Runs());
  this->desk.planner.tools.Take(nullptr);
  EXPECT_FALSE(this->pointer.IsOn());
  EXPECT_TRUE(this->Runs()) << "for a while, as the next tool may want it";
  EXPECT_TRUE(this->Until([&] { return this->hand->News().phase == DevicePhase::Closed; }));
}

TEST_F(HandDevicesTest, WhoLooksAtItHasItAlone)
{
  this->Use(this->box);
  this->Begin();
  this->desk.planner.tools.Take(&this->tool);
  ASSERT_TRUE(this->Until([&] { return this->pointer.IsOn(); }));
  auto held = this->hand->Hold();
  ASSERT_NE(held, nullptr);
  EXPECT_FALSE(this->pointer.IsOn());
  EXPECT_EQ(this->desk.planner.openDevice(), nullptr);
  held.reset();
  this->hand->LetGo();
  EXPECT_TRUE(this->Until([&] { return this->pointer.IsOn(); }));
}

// A tool with a hand of its own changes over, too, and back to the mouse.
TEST_F(HandDevicesTest, AToolInHandFollows)
{
  this->Use(this->box);
  this->Begin();
  GrabTool grab(this->desk.planner);
  this->desk.planner.tools.Take(&grab);
  ASSERT_TRUE(this->Until([&] { return this->Runs(); }));
  ASSERT_TRUE(this->Until([&] { return this->desk.planner.openDevice() != nullptr; }));
  DeviceSettings none = this->hand->Settings();
  none.device = "none";
  this->hand->SetSettings(none);
  EXPECT_EQ(this->hand->News().phase, DevicePhase::Closed);
  EXPECT_EQ(this->desk.planner.openDevice(), nullptr);
  EXPECT_EQ(ReadDeviceSettings(this->places.settings).device, "none") << "kept";
}

TEST_F(HandDevicesTest, OneThatCannotBeIsSaidOnce)
{
  this->Use("plugin:/nonexistent.so");
  this->Begin();
  this->desk.planner.tools.Take(&this->tool);
  EXPECT_TRUE(this->desk.said.contains("there is no such file")) << this->desk.said.toStdString();
  this->desk.said.clear();
  this->desk.planner.tools.Take(nullptr);
  this->desk.planner.tools.Take(&this->tool);
  EXPECT_EQ(this->desk.said, "");
}

TEST_F(HandDevicesTest, IsFoundWhenItIsPluggedIn)
{
  this->Begin();
  this->PlugFalcon();
  EXPECT_TRUE(this->Until([&] { return this->hand->Found().size() == 1; }));
#if HASP_WITH_LIBUSB
  EXPECT_EQ(this->hand->Address(), "falcon:1-2");
#endif
  fs::remove_all(this->root / "sys/bus/usb/devices/1-2");
  fs::remove(this->root / "dev/bus/usb/001/007");
  EXPECT_TRUE(this->Until([&] { return this->hand->Found().empty(); }));
  EXPECT_EQ(this->hand->Address(), "");
}

TEST_F(HandDevicesTest, AFileThatIsNoneIsSaidAndLeftAlone)
{
  Write(this->places.settings, "{ \"format\": \"somebody else's\" }");
  this->Begin();
  EXPECT_TRUE(this->desk.said.contains("format")) << this->desk.said.toStdString();
  DeviceSettings settings;
  settings.device = "none";
  this->hand->SetSettings(settings);
  std::ifstream stream(this->places.settings);
  std::string text;
  std::getline(stream, text);
  EXPECT_EQ(text, "{ \"format\": \"somebody else's\" }");
}

} // namespace
