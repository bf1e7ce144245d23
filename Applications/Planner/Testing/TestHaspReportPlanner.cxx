#include "ReportFixture.h"

namespace
{

/// Counts, shares and bytes at their bars; of times only that they are there, and that a mesh made
/// anew takes longer.
TEST_F(HaspReport, ThePlannerDragsInContactRestsAndKeepsNothing)
{
  const HaspRun run = RunHasp({ "report", "planner", "--quick", "--json", this->Path("p.json"),
    "--html", this->Path("p.html") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto report = Json::parse(ReadBytes(this->Path("p.json")));
  const Json& fps = Row(report, "planner.drag.fps");
  if (fps.contains("absent"))
  {
    ASSERT_NE(fps.at("absent").get<std::string>().find("no screen"), std::string::npos) << fps;
    GTEST_SKIP() << fps.at("absent");
  }
  const auto value = [&](const std::string& id)
  { return Row(report, "planner." + id).at("value").get<double>(); };
  EXPECT_GT(value("first"), 0.0);
  EXPECT_EQ(value("idle.frames"), 0.0);
  for (const char* id : { "idle.frames", "reopened", "drag.share", "drag.touching" })
    EXPECT_EQ(Row(report, std::string("planner.") + id).value("bar_missed", true), false)
      << Row(report, std::string("planner.") + id);
  EXPECT_GT(value("drag.fps"), 0.0);
  EXPECT_GT(value("drag.tick"), 0.0);
  EXPECT_LT(fps.at("error"), 40.0); // of 255: half of the pixels along an axis
  EXPECT_LT(value("isovalue@256"), 1.0);
  EXPECT_LT(Row(report, "planner.isovalue@256").at("error"), 40.0);
  EXPECT_EQ(report.at("curves").size(), 4U);
  EXPECT_NE(ReadBytes(this->Path("p.html")).find("<svg"), std::string::npos);
}

} // namespace
