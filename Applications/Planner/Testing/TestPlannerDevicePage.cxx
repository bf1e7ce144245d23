// The page of the haptic device, with a plugin in the place of one.
#include "PlannerDesk.h"

#include <fstream>
#include <sstream>

namespace
{

class PlannerDevicePage : public PlannerDesk
{
protected:
  static constexpr int Named = 2; ///< of the choice, where nothing is plugged in

  static bool ShowPage(PlannerProcess& planner)
  {
    planner.Menu({ "menu.view", "view.device" });
    return planner.Text("device.found") == "No haptic device and no 6-DOF mouse";
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
  const std::string box = std::string("plugin:") + HASP_PLUGINS + "/DevicePluginSpringBox.so";
};

TEST_F(PlannerDevicePage, SaysThatThereIsNone)
{
  const auto planner = this->Open();
  if (!ShowPage(*planner))
    GTEST_SKIP() << "this machine has a device";
  EXPECT_EQ(planner->Text("device.state"), "No device is used: the mouse moves what is in hand.");
  EXPECT_FALSE(planner->Has("device.push.1")) << "no Falcon, no scale of its force";
  planner->Click("device.close");
  EXPECT_FALSE(planner->Has("device.state"));
  planner->CloseWindow();
  EXPECT_EQ(planner->ExitCode(), 0);
  EXPECT_EQ(planner->Output(), "");
  EXPECT_EQ(this->Settings(), "") << "nothing was set";
}

TEST_F(PlannerDevicePage, UsesTheOneThatIsNamedAndKeepsIt)
{
  {
    const auto planner = this->Open();
    if (!ShowPage(*planner))
      GTEST_SKIP() << "this machine has a device";
    planner->Choose("device.use", Named);
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
