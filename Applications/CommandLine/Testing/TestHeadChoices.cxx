#include "HeadChoices.h"

#include "Devices/PluginHeadPose.h"
#include "Failure.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace
{

using namespace hasp;
namespace fs = std::filesystem;

const std::string Plugin = HASP_TEST_PLUGIN;

class HeadChoicesTest : public ::testing::Test
{
protected:
  HeadChoicesTest() { fs::create_directories(this->Folder); }
  ~HeadChoicesTest() override { fs::remove_all(this->Folder); }
  std::string Path(const std::string& name) const { return (this->Folder / name).string(); }

  static HeadChoices From(const std::string& source, const std::string& calibration = {})
  {
    HeadChoices choices;
    choices.source = source;
    choices.calibration = calibration;
    return choices;
  }
  /// The exit code of a refusal, or 0; its text has `words`.
  static int Refusal(
    const HeadChoices& choices, const std::string& words, const HeadPose& rest = {})
  {
    try
    {
      MakeHeadTracker(choices, rest);
      return 0;
    }
    catch (const Failure& failure)
    {
      EXPECT_NE(std::string(failure.what()).find(words), std::string::npos) << failure.what();
      return int(failure.code);
    }
  }
  /// How many warnings a plugin's third pose has left.
  static std::size_t Warnings(const std::string& source)
  {
    const auto tracker = MakeHeadTracker(From(source), {});
    EXPECT_STREQ(tracker->Source().Name(), "plugin") << source;
    for (const double now : { 1.0, 2.0, 3.0 })
      tracker->At(now);
    return tracker->TakeWarnings().size();
  }

private:
  fs::path Folder = fs::temp_directory_path() / ("hasp-head-choices-" + std::to_string(getpid()));
};

/// The plugin under test is good without settings, lies from the second call on with "f", and with
/// "absent" has no tracker.
TEST_F(HeadChoicesTest, APluginHasItsSettingsBehindItsName)
{
  fs::create_directories(this->Path("dir.so.d"));
  for (const char* name :
    { "t.so", "t.so.1", "t.so.1.20", "dir.so.d/t.so", "dir.so.d/t.so.3", "a.sofa.so" })
  {
    fs::copy_file(Plugin, this->Path(name));
    EXPECT_EQ(Warnings(this->Path(name)), 0u) << name;
    EXPECT_EQ(Warnings(this->Path(name) + ":"), 0u) << name;
    EXPECT_EQ(Warnings(this->Path(name) + ":f"), 1u) << name;
    EXPECT_EQ(Warnings(this->Path(name) + ":f:1.so:2.so"), 1u) << name << ": at the first colon";
    EXPECT_EQ(Warnings(this->Path(name) + ":f=map.csv"), 1u) << name << ": no recording";
    EXPECT_EQ(Refusal(From(this->Path(name) + ":absent"), "could not open its tracker"), 2) << name;
  }
  for (const char* name : { "t.sob", "t.so.", "t.so.1.", "t.so.x", "t.so1", "t.so,f", "tso:f" })
    EXPECT_EQ(Refusal(From(this->Path(name)), "FILE.so:SETTINGS"), 1) << name;
}

TEST_F(HeadChoicesTest, WrongUseIsOneAndWhatCannotBeOpenedTwo)
{
  EXPECT_EQ(MakeHeadTracker({}, {}), nullptr);
  EXPECT_EQ(Refusal(From("telepathy"), "--head must be"), 1);
  HeadChoices seconds = From("mouse");
  seconds.predictionMs = 0.033;
  EXPECT_EQ(Refusal(seconds, "it is in ms"), 1);
  EXPECT_EQ(Refusal(From("mouse"), "--head: ", { { 0, 0, 149 }, { 1, 0, 0, 0 } }), 1);
  EXPECT_EQ(Refusal(From("mouse"), "", { { 0, 0, 151 }, { 1, 0, 0, 0 } }), 0);
  EXPECT_EQ(Refusal(From("opentrack:localhost:4242"), "--head: opentrack: the address"), 1);
  EXPECT_EQ(Refusal(From("opentrack:192.0.2.1:4242"), "none of this machine's"), 2);
  EXPECT_EQ(Refusal(From(this->Path("none.so")), "--head: "), 2);
  EXPECT_EQ(Refusal(From(this->Path("none.csv")), "--head: "), 2);
  std::ofstream(this->Path("broken.csv")) << "Erika\n";
  EXPECT_EQ(Refusal(From(this->Path("broken.csv")), "--head: head path: line 1"), 2);
}

TEST_F(HeadChoicesTest, TheMouseIsNotCalibrated)
{
  const std::string file = this->Path("desk.json");
  std::ofstream(file) << R"({ "format": "hasp-tracker-calibration-1", "trackerToRoom": [1,0,0,0],
    "trackerInRoomMm": [0,0,0], "eyesInMarkerMm": [0,0,0], "headToMarker": [1,0,0,0] })";
  EXPECT_EQ(Refusal(From("mouse", file), "the mouse is none"), 1);
  if (Refusal(From(Plugin, file), "HASP_ENABLE_JSON") != 0)
    GTEST_SKIP() << "this build has no files of calibrations";
  EXPECT_EQ(Refusal(From(Plugin, this->Path("none.json")), "--head-calibration: "), 2);
  std::ofstream(this->Path("broken.json")) << R"({ "format": "hasp-tracker-calibration-1" })";
  EXPECT_EQ(Refusal(From(Plugin, this->Path("broken.json")), "--head-calibration: "), 2);
}

} // namespace
