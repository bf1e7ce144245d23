// bin/hasp calibrate as its user meets it.
#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace
{

using Words = std::vector<std::string>;

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
  EXPECT_NE(run.err.find("measure again, first point 6 ("), std::string::npos) << run.err;
  const auto last = run.out.find("point 6: ");
  ASSERT_NE(last, std::string::npos) << run.out;
  EXPECT_GT(std::stod(run.out.substr(last + 9)), 30.0) << run.out;
}

/// The marker hangs 90 mm above the eyes and 30 mm behind them, a quarter turn about y: its x axis
/// is the head's -z, its z axis the head's x. The head's axes are the tracker's x, -z and y.
TEST_F(HaspCalibrate, SightingsFindHowTheMarkerSitsOnTheHead)
{
  const std::string columns =
    "trackerXMm,trackerYMm,trackerZMm,qw,qx,qy,qz,roomXMm,roomYMm,roomZMm\n";
  // Eyes at (0, 0, 600) and (50, 40, 500) of the room, the marker at (0, 90, 30) from them there,
  // (x, z, 1000 - y) for the tracker; its turn is -90 degrees about x after 90 about y.
  const std::string seen = "0,630,910,0.5,-0.5,0.5,-0.5,0,0,600\n"
                           "50,530,870,-0.5,0.5,-0.5,0.5,50,40,500\n";
  this->WriteText("sightings.csv", columns + seen);
  const Words sightings{ "--sightings", this->Path("sightings.csv") };
  const HaspRun run = this->Calibrate(std::string(Columns) + Corners, sightings);
  if (!HASP_WITH_EIGEN)
    return ExpectFailure(run, 2, "HASP_ENABLE_EIGEN=ON");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.out.find("2 sightings, residual 0.00 mm RMS"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("sighting 2: 0.00 mm"), std::string::npos) << run.out;
  const auto expect = [&](const char* key, const std::vector<double>& truth, double sign)
  {
    const auto file = nlohmann::json::parse(ReadBytes(this->Path("desk.json")));
    for (std::size_t n = 0; n < truth.size(); ++n)
      EXPECT_NEAR(sign * file.at(key)[n].get<double>(), truth[n], 1e-9) << key << " " << n;
  };
  expect("trackerInRoomMm", { 0, 1000, 0 }, 1);
  expect("eyesInMarkerMm", { 30, -90, 0 }, 1);
  const auto file = nlohmann::json::parse(ReadBytes(this->Path("desk.json")));
  const double root = std::sqrt(0.5), sign = file.at("headToMarker")[0] < 0.0 ? -1 : 1;
  expect("headToMarker", { root, 0, -root, 0 }, sign);

  this->WriteText("sightings.csv", columns + seen + "0,630,910,0.5,-0.5,0.5,-0.5,0,12,600\n");
  const HaspRun off =
    this->Calibrate(std::string(Columns) + Corners, { sightings[0], sightings[1], "--json" });
  ASSERT_EQ(off.exitCode, 0) << off.err;
  const auto result = nlohmann::json::parse(off.out);
  EXPECT_NEAR(result.at("sightings_residuals_mm")[2].get<double>(), 8.0, 1e-9); // of 12, a third
  EXPECT_NEAR(result.at("sightings_rms_mm").get<double>(), std::sqrt((16 + 16 + 64) / 3.0), 1e-9);
}

TEST_F(HaspCalibrate, SightingsThatAreNoneLeaveNothing)
{
  const std::string points = std::string(Columns) + Corners;
  const Words sightings{ "--sightings", this->Path("sightings.csv") };
  ExpectFailure(this->Calibrate(points, sightings), 2, "no such file");
  this->WriteText("sightings.csv", Columns);
  Words both = sightings;
  both.insert(both.end(), { "--eyes-in-marker", "0,-90,30" });
  ExpectFailure(this->Calibrate(points, both), 1, "--eyes-in-marker excludes --sightings");
  if (HASP_WITH_EIGEN)
  {
    ExpectFailure(this->Calibrate(points, sightings), 2, "line 1: it must be trackerXMm");
    this->WriteText(
      "sightings.csv", "trackerXMm,trackerYMm,trackerZMm,qw,qx,qy,qz,roomXMm,roomYMm,roomZMm\n");
    ExpectFailure(this->Calibrate(points, sightings), 2, "there is no sighting");
  }
  EXPECT_EQ(this->Names(), (Words{ "points.csv", "sightings.csv" }));
}

/// Metres, centimetres and inches fit as well as millimetres do.
TEST_F(HaspCalibrate, AnotherUnitIsRefused)
{
  if (!HASP_WITH_EIGEN)
    GTEST_SKIP() << "nothing is fitted";
  const auto corners = [](double unit)
  {
    std::ostringstream text;
    text << Columns;
    for (const auto& [x, y, z] :
      { std::array{ -260.0, -160.0, 0.0 }, std::array{ 260.0, -160.0, 0.0 },
        std::array{ 260.0, 160.0, 0.0 }, std::array{ 0.0, 0.0, 600.0 } })
      text << x / unit << ',' << y / unit << ',' << z / unit << ',' << x << ',' << y << ',' << z
           << '\n';
    return text.str();
  };
  for (const auto& [unit, words] : { std::pair{ 1000.0, "the room is 1000 times as wide" },
         { 25.4, "the room is 25.4 times as wide" }, { 0.001, "the room is 0.001 times" },
         { 1.11, "are the tracker's numbers millimetres?" }, { 0.89, "must be 0.9 to 1.1" } })
    ExpectFailure(this->Calibrate(corners(unit)), 2, words);
  EXPECT_EQ(this->Names(), (Words{ "points.csv" }));
  for (const double unit : { 1.09, 0.91 })
    EXPECT_EQ(this->Calibrate(corners(unit)).exitCode, 0) << unit;
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
