// bin/hasp calibrate as its user meets it.
#include "HaspProcess.h"

#include <nlohmann/json.hpp>

namespace
{

class HaspCalibrate : public HaspTest
{
protected:
  static constexpr const char* Columns =
    "trackerXMm,trackerYMm,trackerZMm,roomXMm,roomYMm,roomZMm\n";
  HaspRun Calibrate(const std::string& points, const std::vector<std::string>& more = {})
  {
    this->WriteText("points.csv", points);
    std::vector<std::string> words{ "calibrate", this->Path("points.csv"), "--output",
      this->Path("desk.json") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
};

/// The tracker stands 1 m above the screen, a quarter turn about x: room = (x, -z + 1000, y).
constexpr const char* Corners = "-260,0,1160,-260,-160,0\n"
                                "260,0,1160,260,-160,0\n"
                                "260,0,840,260,160,0\n"
                                "-260,0,840,-260,160,0\n"
                                "0,600,1000,0,0,600\n";

TEST_F(HaspCalibrate, FindsTheTrackerAndSaysWhatIsLeft)
{
  const HaspRun run =
    this->Calibrate(std::string(Columns) + Corners, { "--eyes-in-marker", "0,-90,30", "--json" });
  if (!HASP_WITH_EIGEN)
    return ExpectFailure(run, 2, "HASP_ENABLE_EIGEN=ON");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_LT(nlohmann::json::parse(run.out).at("rms_mm").get<double>(), 1e-9);
  const auto file = nlohmann::json::parse(ReadBytes(this->Path("desk.json")));
  const auto& place = file.at("trackerInRoomMm");
  EXPECT_NEAR(place[0].get<double>(), 0.0, 1e-9);
  EXPECT_NEAR(place[1].get<double>(), 1000.0, 1e-9);
  EXPECT_NEAR(place[2].get<double>(), 0.0, 1e-9);
  EXPECT_EQ(file.at("eyesInMarkerMm"), nlohmann::json({ 0.0, -90.0, 30.0 }));
}

TEST_F(HaspCalibrate, APointThatWasMistakenStandsOut)
{
  const HaspRun run = this->Calibrate(std::string(Columns) + Corners + "100,300,900,100,160,300\n");
  if (!HASP_WITH_EIGEN)
    return ExpectFailure(run, 2, "HASP_ENABLE_EIGEN=ON");
  ASSERT_EQ(run.exitCode, 0) << run.err; // 60 mm off in y
  EXPECT_NE(run.out.find("6 points, residual "), std::string::npos) << run.out;
  const auto last = run.out.find("point 6: ");
  ASSERT_NE(last, std::string::npos) << run.out;
  EXPECT_GT(std::stod(run.out.substr(last + 9)), 30.0) << run.out;
}

TEST_F(HaspCalibrate, WhatCannotBeFittedLeavesNothing)
{
  const std::string columns = Columns;
  ExpectFailure(this->Calibrate("Erika Mustermann\n"), 2, "line 1: it must be trackerXMm");
  ExpectFailure(this->Calibrate(columns + "1,2,3,4,5\n"), 2, "line 2");
  const HaspRun few = this->Calibrate(columns + "0,0,0,0,0,0\n1,0,0,1,0,0\n");
  EXPECT_EQ(few.exitCode, 2) << few.err;
  const HaspRun line = this->Calibrate(columns + "0,0,0,0,0,0\n1,0,0,1,0,0\n2,0,0,2,0,0\n");
  EXPECT_EQ(line.exitCode, 2) << line.err;
  ExpectFailure(
    RunHasp({ "calibrate", this->Path("none.csv"), "--output", this->Path("desk.json") }), 2,
    "no such file");
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "points.csv" }));
}

} // namespace
