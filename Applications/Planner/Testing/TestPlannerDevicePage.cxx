// The page of the haptic device, with a plugin in the place of one.
#include "PlannerDesk.h"

#include "Devices/Drivers/DeviceSearch.h"

#include <fstream>
#include <sstream>

namespace
{

class PlannerDevicePage : public PlannerDesk
{
protected:
  PlannerDevicePage()
  {
    // The mouse, whatever this machine has.
    const std::filesystem::path config = this->folder / "home/config/hasp";
    std::filesystem::create_directories(config);
    std::ofstream(config / "devices.json") << R"({ "format": "hasp-devices-1", "device": "none" })";
  }
  /// Of the choice, behind what pushes, none, and all that is plugged in.
  int Named() const { return 2 + int(this->here.size()); }

  void ShowPage(PlannerProcess& planner) const
  {
    planner.Menu({ "menu.view", "view.device" });
    const std::string found = planner.Text("device.found");
    EXPECT_EQ(found == "No haptic device and no 6-DOF mouse", this->here.empty()) << found;
    for (const hasp::FoundDevice& device : this->here)
      EXPECT_NE(found.find(device.name), std::string::npos) << found;
  }
  static void UntilStateIs(PlannerProcess& planner, const std::string& words)
  {
    planner.WaitUntil(words,
      [&](const PlannerProcess::Json& now)
      {
        for (const auto& widget : now.at("widgets"))
          if (widget.at("name") == "device.state")
            return widget.value("text", std::string()).find(words) != std::string::npos;
        return false;
      });
  }
  std::string Settings() const
  {
    std::ifstream stream(this->folder / "home/config/hasp/devices.json");
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }
  const std::vector<hasp::FoundDevice> here = hasp::FindDevices();
  const std::string box = std::string("plugin:") + HASP_PLUGINS + "/DevicePluginSpringBox.so";
};

TEST_F(PlannerDevicePage, SaysThatThereIsNone)
{
  const auto planner = this->Open();
  ShowPage(*planner);
  EXPECT_EQ(planner->Text("device.state"), "No device is used: the mouse moves what is in hand.");
  EXPECT_FALSE(planner->Has("device.push.1")) << "no Falcon, no scale of its force";
  planner->Click("device.close");
  EXPECT_FALSE(planner->Has("device.state"));
  planner->CloseWindow();
  EXPECT_EQ(planner->ExitCode(), 0);
  EXPECT_EQ(planner->Output(), "");
  EXPECT_NE(this->Settings().find("\"none\""), std::string::npos) << "as it was";
}

TEST_F(PlannerDevicePage, UsesTheOneThatIsNamedAndKeepsIt)
{
  {
    const auto planner = this->Open();
    ShowPage(*planner);
    planner->Choose("device.use", Named());
    planner->SetText("device.named", this->box);
    UntilStateIs(*planner, "the device is running");
    EXPECT_EQ(planner->Text("device.pose"),
      "0.0 mm right, 0.0 up, 0.0 towards you; no button; pushed with 0.0 N");
    planner->Click("device.test");
    EXPECT_EQ(planner->Text("device.pose"),
      "0.0 mm right, 0.0 up, 0.0 towards you; no button; pushed with 0.0 N")
      << "nobody holds its button";
    std::filesystem::create_directories(HASP_TEST_PICTURES);
    planner->SavePicture(std::filesystem::path(HASP_TEST_PICTURES) / "PlannerDevicePage.png");
    EXPECT_NE(this->Settings().find("DevicePluginSpringBox.so"), std::string::npos);
    planner->Click("device.close");
    planner->CloseWindow();
    EXPECT_EQ(planner->ExitCode(), 0);
    EXPECT_EQ(planner->Output(), "");
  }
  const auto planner = this->Open();
  ShowPage(*planner);
  UntilStateIs(*planner, "the device is running");
  planner->SetText("device.named", "toaster");
  EXPECT_NE(planner->Text("device.refusal").find("a device is named falcon"), std::string::npos);
  EXPECT_NE(this->Settings().find("DevicePluginSpringBox.so"), std::string::npos)
    << "kept as it was";
  planner->Choose("device.use", 1);
  UntilStateIs(*planner, "No device is used");
  EXPECT_NE(this->Settings().find("\"none\""), std::string::npos);
  planner->CloseWindow();
}

} // namespace
