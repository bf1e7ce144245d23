// bin/hasp view as its user meets it, on a screen of Xvfb.
#include "HaspProcess.h"
#include "OlderOpenGL.h"
#include "ViewFixture.h"

#include <nlohmann/json.hpp>

namespace
{

constexpr unsigned long KeyQ = 0x71, KeyRight = 0xff53; // X11/keysymdef.h

TEST_F(HaspView, WithoutADisplayItSaysWhatToDo)
{
  this->Phantom();
  ExpectFailure(RunHasp(this->View({})), 4, "DISPLAY is not set");
  ExpectFailure(RunHasp(this->View({})), 4, "hasp render");
  ExpectFailure(RunHasp(this->View({}), {}, ":64999"), 4, "cannot be opened");
  TestScreen screen({ "-extension", "GLX" });
  REQUIRE_SCREEN(screen);
  ExpectFailure(RunHasp(this->View({}), {}, screen.Display()), 4, "has no OpenGL");
}

TEST_F(HaspView, WrongUseOpensNoWindow)
{
  this->Phantom();
  ExpectFailure(RunHasp(this->View({ "--output", "x.jpg" })), 1, ".png");
  ExpectFailure(RunHasp(this->View({ "--mapper", "splats" })), 1, "--mapper takes one of");
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const auto fail = [&](const Words& more, int code, const std::string& words)
  { ExpectFailure(RunHasp(this->View(more), {}, screen.Display()), code, words); };
  fail({ "--isovalue", "5000" }, 1, "values run from -1000 to ");
  fail({ "--mapper", "vtk", "--shadows" }, 1, "leave them out");
  fail({ "--compact" }, 1, "for --mapper cells");
  fail({ "--surface", this->Path("none.stl") }, 2, "no such");
  ExpectFailure(
    RunHasp({ "view", this->Path("none.mha") }, {}, screen.Display()), 2, "no such file");
}

TEST_F(HaspView, OldOpenGLIsSaidAndCellsStandIn)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const EnvironmentScope older(OlderOpenGL);
  for (const std::string mapper : { "raycast", "raycaching" })
  {
    const HaspRun run =
      RunHasp(this->View({ "--mapper", mapper, "--explain", "--output", this->Path("w.png") }), {},
        screen.Display());
    if (!HASP_WITH_EMBREE)
    {
      ExpectFailure(run, 4, "this window has 3.3");
      continue;
    }
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(this->Size("w.png"), std::make_pair(200, 150));
    EXPECT_EQ(run.err.find("hasp: warning: Active cells stand in, traced by rays on the CPU: "
                           "raycasting needs OpenGL 4.3, and this window has 3.3") != run.err.npos,
      mapper == "raycast")
      << run.err;
    EXPECT_EQ(run.err.find("warning"), run.err.rfind("warning")) << "said once";
    EXPECT_NE(run.out.find("traced: rasterising needs OpenGL 4.3, and this window has 3.3"),
      std::string::npos)
      << run.out;
  }
}

TEST_F(HaspView, TheCompleteWindowIsWritten)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const HaspRun run =
    RunHasp(this->View({ "--isovalue", "226", "--output", this->Path("w.png"), "--json" }), {},
      screen.Display());
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err.find("ERR"), std::string::npos) << run.err;
  EXPECT_EQ(this->Size("w.png"), std::make_pair(200, 150));
  EXPECT_EQ(nlohmann::json::parse(run.out).at("isovalue"), 226.0);
  const HaspRun far = RunHasp(
    this->View({ "--isovalue", "226", "--zoom", "0.01", "--output", this->Path("far.png") }), {},
    screen.Display()); // the surface is a dot
  ASSERT_EQ(far.exitCode, 0) << far.err;
  EXPECT_GT(ReadBytes(this->Path("w.png")).size(), 2 * ReadBytes(this->Path("far.png")).size());
}

TEST_F(HaspView, TheWindowIsWrittenWithAllItsPaths)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const HaspRun run =
    RunHasp(this->View({ "--path-trace", "12", "--explain", "--output", this->Path("w.png") }), {},
      screen.Display());
  if (!HASP_WITH_EMBREE)
    return ExpectFailure(run, 4, "Embree");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err.find("ERR"), std::string::npos) << run.err; // nor when it lets go of the GPU
  EXPECT_EQ(this->Size("w.png"), std::make_pair(200, 150));
  EXPECT_NE(run.out.find("12 samples a pixel"), std::string::npos) << run.out;
}

TEST_F(HaspView, VolumesAreShownWithoutASurface)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  const auto show = [&](const std::string& mapper)
  {
    const HaspRun run =
      RunHasp(this->View({ "--mapper", mapper, "--output", this->Path(mapper + ".png"), "--json" }),
        {}, screen.Display());
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return nlohmann::json::parse(run.out);
  };
  const nlohmann::json brightest = show("mip"), translucent = show("composite");
  EXPECT_FALSE(brightest.contains("isovalue"));
  EXPECT_EQ(brightest.at("window").at(0), -1000.0);
  EXPECT_FALSE(translucent.contains("window"));
  EXPECT_GT(translucent.at("isovalue"), 0.0);
  EXPECT_NE(ReadBytes(this->Path("mip.png")), ReadBytes(this->Path("composite.png")));
}

TEST_F(HaspView, CellsAreShownWithoutASlider)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  ASSERT_EQ(RunHasp({ "cells", this->Path("head.mha"), "--isovalue", "226", "--output",
                      this->Path("head.hcells") })
              .exitCode,
    0);
  const HaspRun run = RunHasp(
    { "view", this->Path("head.hcells"), "--output", this->Path("w.png") }, {}, screen.Display());
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(this->Size("w.png"), std::make_pair(800, 800));
}

TEST_F(HaspView, AnIdleWindowCostsNothingAndKeysAreHeard)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  ScreenUser user(screen.Display());
  OpenView view(this->View({ "--quiet" }), screen.Display());
  EXPECT_EQ(user.SeeWindow(), "hasp view"); // the file's name may be a patient's
  // It refines until it is complete; a minute is more than any machine takes for that.
  constexpr double Idle = 5.0; // of 500 ms: VTK 9.1 wakes up once a second
  double computes = Idle;
  for (int n = 0; n < 120 && computes >= Idle; ++n)
    computes = view.Computes();
  EXPECT_LT(computes, Idle);
  EXPECT_LT(view.Computes(), Idle);
  user.Press(KeyQ);
  EXPECT_EQ(view.ExitCode(), 0);
}

TEST_F(HaspView, TheCloseButtonEndsIt)
{
  this->Phantom();
  TestScreen screen;
  REQUIRE_SCREEN(screen);
  ScreenUser user(screen.Display());
  OpenView view(this->View({ "--quiet", "--mapper", "mesh" }), screen.Display());
  user.SeeWindow();
  user.Press(KeyRight);
  user.CloseWindow();
  EXPECT_EQ(view.ExitCode(), 0);
}

} // namespace
