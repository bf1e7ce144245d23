#include "ReportFixture.h"

namespace
{

TEST_F(HaspReport, WrongUseIsOne)
{
  ExpectFailure(RunHasp({ "report" }), 1, "NAME");
  ExpectFailure(RunHasp({ "report", "nonsense" }), 1, "known are");
  ExpectFailure(
    RunHasp({ "report", "stereo", "--json", this->Path("none/x.json") }), 1, "does not exist");
  ExpectFailure(
    RunHasp({ "report", "stereo", "--html", this->Path("x.txt") }), 1, "must end in .html");
  EXPECT_TRUE(this->Names().empty());
}

#if HASP_WITH_CELLS
TEST_F(HaspReport, WhatIsNoVolumeIsTwoBeforeAnythingIsMeasured)
{
  this->WriteText("Erika.mha", "\x89HCELL\r\n");
  this->WriteText("Erika.txt", "Dear colleague,\n");
  for (const char* report : { "cells", "isosurface" })
  {
    ExpectFailure(RunHasp({ "report", report, "--volume", this->Path("Erika.mha") }), 2,
      "the .mha file: holds active cells");
    ExpectFailure(RunHasp({ "report", report, "--volume", this->Path("Erika.txt") }), 2,
      "the file: is of no kind that is read");
  }
}
#endif

TEST_F(HaspReport, WritesWhatItMeasured)
{
  const HaspRun run = RunHasp({ "report", "stereo", "stereo", "--quick", "--seed", "7", "--json",
    this->Path("s.json"), "--html", this->Path("s.html") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto report = nlohmann::json::parse(ReadBytes(this->Path("s.json")));
  EXPECT_EQ(report.at("report"), "stereo"); // once, though named twice
  EXPECT_EQ(report.at("seed"), 7);
  EXPECT_EQ(report.at("quick"), true);
  for (const auto& row : report.at("rows"))
  {
    EXPECT_EQ(row.at("quick"), true);
    // pixels; see BallScene: 0.05 a standard deviation. Memory is a figure without an error.
    EXPECT_LT(row.value("error", 0.0), 0.3) << row;
  }
  EXPECT_LT(Row(report, "stereo.memory.peak").at("value"), 2.0); // GiB
  for (const std::string layout : { "side-by-side", "top-bottom", "anaglyph", "interlaced",
         "checkerboard", "dual-window", "quad-buffer" })
    for (const std::string kind : { "", ".hmd" })
    {
      // pixels: the bar is 0.5, a disc of rows or fields alone has its middle known to 0.2
      EXPECT_LT(Row(report, "stereo.disparity.max@" + layout + kind).at("value"), 0.25) << layout;
    }
#if HASP_WITH_CELLS
  for (const char* mapper : { "clustered", "raycaching" })
    EXPECT_EQ(
      Row(report, std::string("stereo.silhouette@") + mapper).value("bar_missed", true), false);
#endif
  ASSERT_FALSE(report.at("unused").empty());
  for (const auto& resource : report.at("unused"))
    EXPECT_EQ(resource.at("bytes"), 0) << resource;
  EXPECT_NE(ReadBytes(this->Path("s.html")).find("<svg"), std::string::npos);
}

TEST_F(HaspReport, ImportKeepsPlacesAndAcceptsNoFaultyFolder)
{
  const HaspRun run = RunHasp({ "report", "import", "--quick", "--json", this->Path("i.json") });
  ASSERT_EQ(run.exitCode, 0) << run.err; // places in extreme volumes are held by the report itself
  const auto report = nlohmann::json::parse(ReadBytes(this->Path("i.json")));
  ASSERT_GE(report.at("rows").size(), 5U);
  for (const auto& row : report.at("rows"))
    EXPECT_LE(row.value("error", 0.0), 1e-4) << row; // mm, or folders accepted with a fault
}

#if HASP_WITH_CELLS
/// Bytes, errors and counts; of times only that they are there, of rays a fifth of their bar.
TEST_F(HaspReport, CellsAreSmallLosslessAndWhereTheSurfaceIs)
{
  const HaspRun run = RunHasp({ "report", "cells", "--quick", "--volume", this->Path("none.inv3"),
    "--json", this->Path("c.json"), "--html", this->Path("c.html") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto report = Json::parse(ReadBytes(this->Path("c.json")));
  const auto value = [&](const std::string& id)
  { return Row(report, id).at("value").get<double>(); };
  EXPECT_LE(value("cells.bytes.exact"), 0.22);
  EXPECT_EQ(Row(report, "cells.bytes.exact").at("error"), 0.0);
  EXPECT_LE(value("cells.bytes.compact"), 0.14);
  EXPECT_LE(value("cells.compact.rms"), 0.005); // voxel
  EXPECT_EQ(value("cells.compact.changed"), 0.0);
  EXPECT_EQ(Row(report, "cells.extract").at("error"), 0.0);
  EXPECT_EQ(Row(report, "cells.edit").at("error"), 0.0);
  EXPECT_EQ(Row(report, "cells.edit.compact").at("error"), 0.0);
  EXPECT_LE(value("cells.depth.max"), 1e-3); // voxel
  EXPECT_LE(value("cells.missed"), 1e-4);
  EXPECT_GT(value("cells.frame.large"), 0.0);
  EXPECT_EQ(Row(report, "cells.stream.gib@256").at("error"), 0.0);
  EXPECT_LE(value("cells.stream.gib@256"), 0.5); // windows of OpenGL by software take most of it
  if (!Row(report, "cells.rays").contains("absent"))
  {
    EXPECT_GT(value("cells.rays"), 0.1); // a fifth of its bar
    EXPECT_LE(value("cells.rays.memory"), 1.0 / 15);
    EXPECT_EQ(value("cells.missed.random"), 0.0);
  }
  EXPECT_TRUE(Row(report, "cells.bytes.exact@cranium").contains("absent"));
}

/// Errors, counts and bytes, at half their bars where those are of time; and a short walk.
TEST_F(HaspReport, RaysFillACacheThatShowsTheTruthAndDoesNotGrow)
{
  const HaspRun run = RunHasp({ "report", "raycaching", "--quick", "--soak=60", "--volume",
    this->Path("none.inv3"), "--json", this->Path("r.json") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto report = Json::parse(ReadBytes(this->Path("r.json")));
  const auto value = [&](const std::string& id)
  { return Row(report, id).at("value").get<double>(); };
  const auto error = [&](const std::string& id)
  { return Row(report, id).at("error").get<double>(); };
  EXPECT_GE(value("raycaching.psnr"), 40.0);
  EXPECT_GE(value("raycaching.psnr.centre"), 40.0);
  EXPECT_LE(value("raycaching.depth.median"), 0.01); // voxel
  EXPECT_LE(value("raycaching.holes"), 0.005);
  EXPECT_EQ(value("raycaching.bricks.unique"), 1.0);
  // Half a frame since the pose came, one of delay, two until it is seen; no pose is missed.
  for (const char* id : { "raycaching.head.error", "raycaching.head.error.unpredicted" })
    EXPECT_NE(Row(report, id)
                .at("data")
                .get<std::string>()
                .find("asked half-way between two poses, 3.50 frames from pose to picture"),
      std::string::npos)
      << Row(report, id);
  EXPECT_LE(value("raycaching.stereo.bricks"), 1.3);
  EXPECT_GT(value("raycaching.stereo.second@cache"), 0.0);
  for (const std::string path : { "", ".fly", ".jitter", ".sweep" })
  {
    EXPECT_GE(error("raycaching.speedup.skipping" + path + "@auto"), 33.0) << path;
    EXPECT_GE(error("raycaching.speedup.skipping" + path + "@cache"), 33.0) << path;
  }
  if (!Row(report, "raycaching.cost.lit@auto").contains("absent"))
  {
    EXPECT_LE(error("raycaching.cost.lit@auto"), 0.06); // FLIP
    EXPECT_LE(value("raycaching.cost.lit@auto"), 0.5);  // twice its bar
    EXPECT_TRUE(Row(report, "raycaching.cost.lit@cache").contains("absent"));
    EXPECT_NEAR(value("raycaching.ao.slope"), -0.5, 0.1);
    EXPECT_NEAR(value("raycaching.ao.slope.casts"), -0.5, 0.25); // of few pixels, quick
    EXPECT_LE(value("raycaching.ao.floor"), 0.05);
  }
  for (const char* id : { "psnr", "psnr.centre", "depth.median", "holes", "holes.unpredicted",
         "bricks.unique", "cost.lit@auto", "ao.slope", "speedup.primary@cache",
         "speedup.skipping@auto", "speedup.vtk@auto", "first95.cut@cache", "first95.jump@auto",
         "cost.isovalue", "cost.isovalue@cache", "soak.cache" })
  {
    const Json row = Row(report, "raycaching." + std::string(id));
    EXPECT_TRUE(row.contains("absent") || row.contains("bar_missed")) << id;
  }
  EXPECT_NE(run.out.find("rows that missed their bar: "), std::string::npos) << run.out;
  EXPECT_EQ(value("raycaching.soak.cache"), 0.0);
  EXPECT_EQ(value("raycaching.soak.bricks.unique"), 1.0);
  EXPECT_EQ(value("raycaching.soak.errors"), 0.0);
  EXPECT_LE(Row(report, "raycaching.soak.memory").at("n"), 60);
  ExpectFailure(RunHasp({ "report", "raycaching", "--soak=5" }), 1, "--soak");
}

TEST_F(HaspReport, ExtremeCasesComeOutAsPredicted)
{
  const HaspRun run = RunHasp({ "report", "stability", "--quick", "--json", this->Path("s.json") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto report = Json::parse(ReadBytes(this->Path("s.json")));
  for (const Json& row : report.at("stability"))
    EXPECT_EQ(row.at("pass"), true) << row;
  EXPECT_GE(report.at("stability").size(), 400U);
}
#endif

} // namespace
