#include "HaspProcess.h"

#include <nlohmann/json.hpp>

namespace
{

class HaspReport : public HaspTest
{
};

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
    EXPECT_LT(row.at("error"), 0.3) << row; // pixels; see BallScene: 0.05 a standard deviation
  }
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
    EXPECT_LE(row.at("error"), 1e-4) << row; // mm, or folders accepted with a fault
}

} // namespace
