// bin/hasp view for eyes before a screen.
#include "Devices/HeadPath.h"
#include "ViewFixture.h"

#include <cmath>
#include <future>

namespace
{

using namespace hasp;

using HaspViewEyes = HaspView;

TEST_F(HaspViewEyes, TwoEyesAreDrawnAndListed)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const HaspRun run =
    RunHasp(this->View({ "--stereo", "interlaced", "--screen", "520x390", "--sketch",
              this->Path("s.png"), "--output", this->Path("w.png"), "--explain" }),
      {}, screen.Display());
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err.find("ERR"), std::string::npos) << run.err;
  EXPECT_EQ(this->Size("w.png"), std::make_pair(200, 150));
  EXPECT_EQ(this->Size("s.png"), std::make_pair(1200, 720));
  EXPECT_NE(run.out.find("eye pictures"), std::string::npos) << run.out;
}

TEST_F(HaspViewEyes, WithoutOpenXRItIsSaidWhatToDo)
{
  this->Phantom();
  if (HASP_WITH_OPENXR) // as configured: a message that is gone must fail, not skip
    GTEST_SKIP() << "this build has OpenXR";
  ExpectFailure(RunHasp(this->View({ "--stereo", "openxr" })), 4, "HASP_ENABLE_OPENXR=ON");
}

TEST_F(HaspViewEyes, AHeadThatCannotBeFollowedIsTold)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const auto fail = [&](const Words& more, int code, const std::string& words)
  { ExpectFailure(RunHasp(this->View(more), {}, screen.Display()), code, words); };
  const auto head = [](const std::string& source) {
    return Words{ "--screen", "520x320", "--head", source };
  };
  fail({ "--head", "mouse" }, 1, "give --screen or --hmd too");
  fail({ "--head", "mouse", "--screen", "520x320", "--output", this->Path("w.png") }, 1,
    "leave out --head");
  fail(head("telepathy"), 1, "--head must be mouse, opentrack");
  fail(head("opentrack:0"), 1, "port from 1 to 65535");
  fail(head("opentrack:4242x"), 1, "port from 1 to 65535");
  fail(head("opentrack:no-address:4242"), 1, "--head: opentrack: the address");
  fail(head(this->Path("none.csv")), 2, "--head: ");
  fail(head(this->Path("none.so")), 2, "--head: ");
  const auto more = [](Words words, const Words& behind)
  {
    words.insert(words.end(), behind.begin(), behind.end());
    return words;
  };
  const Words calibration{ "--head-calibration", this->Path("none.json") };
  fail(more(head("opentrack"), calibration), 2, "--head-calibration: ");
  fail(more(head("mouse"), calibration), 1, "the mouse is none");
  fail(more(head("mouse"), { "--head-position", "0,0,100" }), 1, "--head: ");
  fail({ "--record-head", this->Path("r.csv") }, 1, "--head");
  fail(more(head("mouse"), { "--record-head", this->Path("none/r.csv") }), 1, "folder");
  fail(more(head("mouse"), { "--record-head", this->Path("r.txt") }), 1, ".csv");
  const std::string path = this->Path("path.csv");
  WriteHeadPath(path, HeadPath{ {} });
  fail(more(head(path), { "--record-head", path }), 1, "--record-head and --head");
}

TEST_F(HaspViewEyes, WhatTheHeadDidIsWrittenWhenTheWindowCloses)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const HeadPose there{ { 40.0, -20.0, 550.0 }, { 1.0, 0.0, 0.0, 0.0 } };
  WriteHeadPath(this->Path("path.csv"), HeadPath{ { 3.0, there } });
  ScreenUser user(screen.Display());
  OpenView view(
    this->View({ "--quiet", "--mapper", "mesh", "--screen", "520x320", "--stereo", "anaglyph",
      "--head", this->Path("path.csv"), "--record-head", this->Path("recorded.csv") }),
    screen.Display());
  user.SeeWindow();
  user.CloseWindow();
  ASSERT_EQ(view.ExitCode(), 0);
  const HeadPath recorded = ReadHeadPath(this->Path("recorded.csv"));
  EXPECT_EQ(recorded.front().timeS, 0.0);
  for (const TimedHeadPose& timed : recorded)
    EXPECT_EQ(timed.pose.position, there.position);
}

TEST_F(HaspViewEyes, WhatDrawsTwoPicturesWritesNone)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const auto fail = [&](const Words& more, const std::string& words)
  { ExpectFailure(RunHasp(this->View(more), {}, screen.Display()), 1, words); };
  for (const std::string layout : { "dual-window", "quad-buffer" })
    fail({ "--stereo", layout, "--output", this->Path("w.png") }, "makes two");
  fail({ "--stereo", "dual-window", "--full-screen" }, "--right-window-at");
  fail({ "--stereo", "anaglyph", "--right-window-at", "10,10" }, "dual-window");
}

/// Whichever of the two windows the user closes.
TEST_F(HaspViewEyes, TheCloseButtonOfTheRightEyesWindowEndsBoth)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  ScreenUser user(screen.Display());
  OpenView view(this->View({ "--quiet", "--mapper", "mesh", "--stereo", "dual-window",
                  "--right-window-at", "300,0" }),
    screen.Display());
  std::string title = user.SeeWindow();
  if (title != "hasp view, right eye")
    title = user.SeeWindow();
  ASSERT_EQ(title, "hasp view, right eye");
  user.CloseWindow();
  EXPECT_EQ(view.ExitCode(), 0);
}

TEST_F(HaspViewEyes, TheMouseDragsTheSliderInTheRightEyesWindow)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const auto isoValueAfterDrag = [&](double share)
  {
    ScreenUser user(screen.Display());
    auto run = std::async(std::launch::async,
      [&]
      {
        return RunHasp(this->View({ "--quiet", "--json", "--mapper", "mesh", "--stereo",
                         "dual-window", "--right-window-at", "300,0" }),
          {}, screen.Display());
      });
    while (user.SeeWindow() != "hasp view, right eye")
      ;
    const auto column = [](double at) { return static_cast<int>(200 * (0.1 + 0.8 * at)); };
    user.Drag(column(0.5), 138, column(share), 138); // ViewOverlay.cxx: 0.08 of the height
    user.CloseWindow();
    const std::string out = run.get().out;
    const auto at = out.find("\"isovalue\":");
    return at == out.npos ? NAN : std::stod(out.substr(at + 11));
  };
  const double low = isoValueAfterDrag(0.0), high = isoValueAfterDrag(1.0);
  const double quarter = isoValueAfterDrag(0.25);
  EXPECT_LT(low, high);
  EXPECT_NEAR((quarter - low) / (high - low), 0.25, 2.0 / 160.0); // two pixels of the slider
}

} // namespace
