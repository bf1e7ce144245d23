// bin/hasp view for eyes before a screen.
#include "ViewFixture.h"

namespace
{

using HaspViewEyes = HaspView;

TEST_F(HaspViewEyes, TwoEyesFollowTheMouseAndAreListed)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const HaspRun run =
    RunHasp(this->View({ "--stereo", "interlaced", "--screen", "520x390", "--head", "mouse",
              "--sketch", this->Path("s.png"), "--output", this->Path("w.png"), "--explain" }),
      {}, screen.Display());
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err.find("ERR"), std::string::npos) << run.err;
  EXPECT_EQ(this->Size("w.png"), std::make_pair(200, 150));
  EXPECT_EQ(this->Size("s.png"), std::make_pair(1200, 720));
  EXPECT_NE(run.out.find("mouse"), std::string::npos) << run.out;
}

TEST_F(HaspViewEyes, WithoutOpenXRItIsSaidWhatToDo)
{
  this->Phantom();
  const HaspRun run = RunHasp(this->View({ "--stereo", "openxr" }));
  if (run.err.find("HASP_ENABLE_OPENXR") == run.err.npos)
    GTEST_SKIP() << "this build has OpenXR";
  ExpectFailure(run, 4, "--stereo openxr: ");
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
  fail({ "--head", "mouse" }, 1, "--screen");
  fail(head("telepathy"), 1, "--head must be mouse, opentrack");
  fail(head("opentrack:0"), 1, "port from 1 to 65535");
  fail(head("opentrack:4242x"), 1, "port from 1 to 65535");
  fail(head("opentrack:no-address:4242"), 2, "--head: ");
  fail(head(this->Path("none.csv")), 2, "--head: ");
  fail(head(this->Path("none.so")), 2, "--head: ");
  Words calibrated = head("mouse");
  calibrated.insert(calibrated.end(), { "--head-calibration", this->Path("none.json") });
  fail(calibrated, 2, "--head-calibration: ");
}

} // namespace
