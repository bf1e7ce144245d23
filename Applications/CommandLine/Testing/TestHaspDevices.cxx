// bin/hasp devices as its user meets it, with a plugin in the place of a device.
#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string Box = std::string("plugin:") + HASP_PLUGINS + "/DevicePluginSpringBox.so";

class HaspDevices : public HaspTest
{
protected:
  HaspDevices()
  {
    ::setenv("XDG_CONFIG_HOME", this->Path("config").c_str(), 1); // not the user's own settings
  }
  ~HaspDevices() override { ::unsetenv("XDG_CONFIG_HOME"); }

  static HaspRun Run(Words words)
  {
    words.insert(words.begin(), "devices");
    return RunHasp(words);
  }
  /// The same, with lines typed.
  HaspRun Typed(const Words& words, const std::string& lines) const
  {
    this->WriteText("typed", lines);
    const int before = ::dup(STDIN_FILENO);
    const int file = ::open(this->Path("typed").c_str(), O_RDONLY);
    ::dup2(file, STDIN_FILENO);
    ::close(file);
    const HaspRun run = Run(words);
    ::dup2(before, STDIN_FILENO);
    ::close(before);
    return run;
  }
};

TEST_F(HaspDevices, SaysWhatIsPluggedInAndEndsWell)
{
  const HaspRun run = Run({});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  const HaspRun json = Run({ "--json" });
  EXPECT_EQ(json.exitCode, 0);
  // Whatever this machine has: each is in both.
  const Json found = Json::parse(json.out).at("devices");
  for (const Json& device : found)
    EXPECT_NE(run.out.find(device.at("address").get<std::string>()), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("Hasp works with the mouse alone") == std::string::npos, !found.empty())
    << run.out;
}

TEST_F(HaspDevices, PrintsTheRulesThatAreInstalled)
{
  std::ifstream stream(HASP_UDEV_RULES);
  std::ostringstream rules;
  rules << stream.rdbuf();
  EXPECT_EQ(OutputOfHasp({ "devices", "--udev-rules" }), rules.str());
}

TEST_F(HaspDevices, WatchesANamedOne)
{
  const HaspRun run = Run({ "--device", Box, "--watch", "0.5" });
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.out.find("x 0.0 y 0.0 z 0.0 mm, buttons none, force x 0.0 y 0.0 z 0.0 N"),
    std::string::npos)
    << run.out;
  const HaspRun json = Run({ "--device", Box, "--json" });
  ASSERT_EQ(json.exitCode, 0) << json.err;
  const Json said = Json::parse(json.out);
  EXPECT_EQ(said.at("driver"), "plugin");
  EXPECT_TRUE(said.at("homed").get<bool>());
  EXPECT_GT(said.at("exchanges").get<int>(), 0);
  EXPECT_EQ(said.at("lost"), 0);
}

// Its button is down from the beginning: it may be stuck, and nobody's hand on it.
TEST_F(HaspDevices, DoesNotPushWhereTheButtonWasNeverUp)
{
  const HaspRun run = Run({ "--device", Box + ":held", "--test-force", "--watch", "0.8" });
  ExpectFailure(run, 3, "let go of it first");
  EXPECT_NE(run.out.find("buttons 0, force x 0.0 y 0.0 z 0.0 N"), std::string::npos) << run.out;
}

TEST_F(HaspDevices, PushesWhileAHandHoldsTheButton)
{
  const HaspRun run = Run({ "--device", Box + ":hand", "--test-force", "--watch", "2" });
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.out.find("force x 0."), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("buttons 0, force x"), std::string::npos) << run.out;
}

TEST_F(HaspDevices, FindsHowMuchOfAForceIsFelt)
{
  const HaspRun run =
    this->Typed({ "--device", Box + ":hand", "--calibrate", "--json" }, "0.8\n1.6\n2.4\n");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NEAR(Json::parse(run.out).at("share").get<double>(), 0.8, 1e-12);
  EXPECT_NE(run.err.find("spring scale"), std::string::npos) << run.err;

  ExpectFailure(
    this->Typed({ "--device", Box + ":hand", "--calibrate" }, "0.8\n"), 1, "ended before");
  ExpectFailure(
    this->Typed({ "--device", Box + ":hand", "--calibrate" }, "1\nx\n-2\n2\n\n"), 2, "3 times");
  ExpectFailure(
    this->Typed({ "--device", Box + ":hand", "--calibrate" }, "2.5\n1\n3\n"), 3, "scatter");
  ExpectFailure(
    this->Typed({ "--device", Box + ":hand", "--calibrate" }, "1e9\n100\n200\n300\n"), 2, "newton");
}

TEST_F(HaspDevices, SaysWhatIsWrongAndWhatToDo)
{
  ExpectFailure(Run({ "--device", "toaster" }), 1, "a device is named falcon");
  ExpectFailure(Run({ "--device", "plugin:" + this->Path("none.so") }), 1, "no such file");
  ExpectFailure(Run({ "--device", "spacenav:" + this->Path("none.sock") }), 2, "spacenavd");
  ExpectFailure(Run({ "--settings", this->Path("none.json") }), 2, "no such file");
  ExpectFailure(Run({ "--watch", "0" }), 1, "--watch");
  ExpectFailure(Run({ "--newton", "1" }), 1, "--test-force");
  ExpectFailure(Run({ "--test-force", "--newton", "4" }), 1, "--newton");
  this->WriteText(
    "devices.json", "{ \"format\": \"hasp-devices-1\", \"falcon\": { \"countsPerNm\": 0 } }");
  ExpectFailure(Run({ "--settings", this->Path("devices.json") }), 2, "countsPerNm");
#if HASP_WITH_LIBUSB
  ExpectFailure(Run({ "--device", "falcon" }), 2, "Falcon");
#else
  ExpectFailure(Run({ "--device", "falcon" }), 2, "HASP_ENABLE_LIBUSB");
#endif
}

} // namespace
