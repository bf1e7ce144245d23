#include "Devices/TrackerCalibration.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <random>
#include <stdexcept>

namespace
{

glm::dquat AnyTurn(std::mt19937_64& random)
{
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random)));
}

glm::dvec3 AnyPoint(std::mt19937_64& random, double reach)
{
  std::uniform_real_distribution<double> even(-reach, reach);
  const double x = even(random), y = even(random);
  return { x, y, even(random) };
}

double Apart(const glm::dquat& a, const glm::dquat& b)
{
  return glm::length(glm::dvec4(a.x, a.y, a.z, a.w) * (glm::dot(a, b) < 0 ? -1.0 : 1.0) -
                     glm::dvec4(b.x, b.y, b.z, b.w));
}

template <class Call>
std::string Refusal(const Call& call)
{
  try
  {
    call();
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

TEST(TrackerCalibration, TheDefaultChangesNothing)
{
  const hasp::HeadPose pose{ { 1, 2, 3 }, hasp::HeadOrientation(0.1, 0.2, 0.3) };
  const hasp::HeadPose same = hasp::ToRoom({}, pose);
  EXPECT_EQ(same.position, pose.position);
  EXPECT_LT(Apart(same.orientation, pose.orientation), 1e-15);
}

TEST(TrackerCalibration, ToRoomIsTheMatrixProduct)
{
  std::mt19937_64 random(3);
  for (int n = 0; n < 100; ++n)
  {
    const hasp::TrackerCalibration c{ AnyTurn(random), AnyPoint(random, 2000),
      AnyPoint(random, 200), AnyTurn(random) };
    const hasp::HeadPose marker{ AnyPoint(random, 2000), AnyTurn(random) };
    const auto matrix = [](const glm::dquat& q, const glm::dvec3& t)
    {
      glm::dmat4 m = glm::mat4_cast(q);
      m[3] = glm::dvec4(t, 1);
      return m;
    };
    const glm::dmat4 headToRoom = matrix(c.trackerToRoom, c.trackerInRoomMm) *
                                  matrix(marker.orientation, marker.position) *
                                  matrix(c.headToMarker, c.eyesInMarkerMm);
    const hasp::HeadPose head = hasp::ToRoom(c, marker);
    EXPECT_LT(glm::length(head.position - glm::dvec3(headToRoom[3])), 1e-9);
    for (int a = 0; a < 3; ++a)
      EXPECT_LT(
        glm::length(glm::mat3_cast(head.orientation)[a] - glm::dvec3(headToRoom[a])), 1e-12);
  }
}

TEST(TrackerCalibration, WhatIsNoneIsRefused)
{
  using hasp::ValidateTrackerCalibration;
  hasp::TrackerCalibration c;
  c.trackerToRoom = glm::dquat(2, 0, 0, 0);
  EXPECT_THROW(ValidateTrackerCalibration(c), std::invalid_argument);
  c = {};
  c.trackerInRoomMm.x = NAN;
  EXPECT_THROW(ValidateTrackerCalibration(c), std::invalid_argument);
  c = {};
  c.eyesInMarkerMm.x = 1500;
  EXPECT_NE(Refusal([&] { ValidateTrackerCalibration(c); }).find("1500"), std::string::npos);
}

TEST(TrackerCalibration, TheMarkersSeatIsFoundAndNeedsNoLibrary)
{
  std::mt19937_64 random(9);
  const hasp::TrackerCalibration truth{ AnyTurn(random), { 0, 300, 50 }, { 10, -120, 40 },
    hasp::HeadOrientation(0.1, -0.3, 0.05) };
  hasp::TrackerCalibration known = truth;
  known.eyesInMarkerMm = {};
  known.headToMarker = { 1, 0, 0, 0 };
  std::vector<hasp::MarkerSighting> sightings;
  for (int n = 0; n < 5; ++n)
  {
    hasp::HeadPose marker{ AnyPoint(random, 800), AnyTurn(random) };
    const hasp::HeadPose head = hasp::ToRoom(truth, marker);
    if (n % 2)
      marker.orientation = -marker.orientation; // the same turn
    sightings.push_back({ marker, head });
  }
  const auto fit = hasp::FitMarkerToHead(known, sightings);
  EXPECT_LT(glm::length(fit.calibration.eyesInMarkerMm - truth.eyesInMarkerMm), 1e-9);
  EXPECT_LT(Apart(fit.calibration.headToMarker, truth.headToMarker), 1e-12);
  EXPECT_LT(fit.rmsMm, 1e-9);
  sightings[0].head.position.x += 5.0;
  EXPECT_NEAR(hasp::FitMarkerToHead(known, sightings).residualsMm[0], 4.0, 1e-9)
    << "one of five pulls the mean by a fifth";
  EXPECT_THROW(hasp::FitMarkerToHead(known, {}), std::invalid_argument);
  sightings[0].head.position = { 9000, 0, 0 };
  EXPECT_NE(Refusal([&] { hasp::FitMarkerToHead(known, sightings); }).find("mm from the marker"),
    std::string::npos);
}

#if HASP_WITH_EIGEN

std::vector<hasp::CalibrationPair> Pairs(
  const hasp::TrackerCalibration& c, const std::vector<glm::dvec3>& tracker)
{
  std::vector<hasp::CalibrationPair> pairs;
  for (const glm::dvec3& p : tracker)
    pairs.push_back({ p, c.trackerInRoomMm + c.trackerToRoom * p });
  return pairs;
}

/// The corners of a screen and points in the air before it.
const std::vector<glm::dvec3> Corners = { { -260, -160, 0 }, { 260, -160, 0 }, { 260, 160, 0 },
  { -260, 160, 0 } };
const std::vector<glm::dvec3> Around = { { -260, -160, 0 }, { 260, -160, 0 }, { 260, 160, 0 },
  { -260, 160, 0 }, { 0, 0, 400 }, { 150, -90, 250 } };

TEST(TrackerCalibration, ExactPointsGiveTheExactPlace)
{
  std::mt19937_64 random(1);
  for (int n = 0; n < 200; ++n)
  {
    const hasp::TrackerCalibration truth{ AnyTurn(random), AnyPoint(random, 3000) };
    std::vector<glm::dvec3> points = n % 3 ? Around : Corners;
    if (n % 3 == 2)
      points.resize(3);
    const auto fit = hasp::FitTrackerToRoom(Pairs(truth, points));
    EXPECT_LT(Apart(fit.calibration.trackerToRoom, truth.trackerToRoom), 1e-12);
    EXPECT_LT(glm::length(fit.calibration.trackerInRoomMm - truth.trackerInRoomMm), 1e-9);
    EXPECT_LT(fit.rmsMm, 1e-9);
    EXPECT_NEAR(fit.spreadRatio, 1.0, 1e-12);
    EXPECT_EQ(fit.residualsMm.size(), points.size());
  }
}

/// The mean of rms^2 over many calibrations is 3 s^2 (1 - 2 / N): Fitzpatrick, West, Maurer 1998.
TEST(TrackerCalibration, NoiseLeavesTheResidualThatTheorySays)
{
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0.0, 0.7);
  for (const std::size_t count : { std::size_t(4), std::size_t(6) })
  {
    const std::vector<glm::dvec3> points(Around.begin() + 6 - count, Around.end());
    double mean = 0.0;
    constexpr int Rounds = 4000;
    for (int n = 0; n < Rounds; ++n)
    {
      auto pairs = Pairs({ AnyTurn(random), { 10, 20, 30 } }, points);
      for (auto& pair : pairs)
        for (int a = 0; a < 3; ++a)
          pair.trackerMm[a] += noise(random);
      const auto fit = hasp::FitTrackerToRoom(pairs);
      double sum = 0.0;
      for (const double r : fit.residualsMm)
        sum += r * r;
      EXPECT_NEAR(std::sqrt(sum / count), fit.rmsMm, 1e-12);
      mean += fit.rmsMm * fit.rmsMm / Rounds;
    }
    // chi^2 of 3 N - 6 >= 6 degrees of freedom: the mean of 4000 is good to 1 %; five times that.
    EXPECT_NEAR(mean / (3 * 0.49 * (1.0 - 2.0 / count)), 1.0, 0.05) << count;
  }
}

/// No rotation nearby leaves smaller residuals: the least squares are the least.
TEST(TrackerCalibration, NoOtherPlaceFitsBetter)
{
  std::mt19937_64 random(4);
  std::normal_distribution<double> noise(0.0, 3.0);
  auto pairs = Pairs({ AnyTurn(random), { 10, 20, 30 } }, Around);
  for (auto& pair : pairs)
    for (int a = 0; a < 3; ++a)
      pair.roomMm[a] += noise(random);
  const auto fit = hasp::FitTrackerToRoom(pairs);
  std::normal_distribution<double> small(0.0, 1e-3);
  for (int n = 0; n < 2000; ++n)
  {
    const glm::dquat turn = glm::normalize(
      fit.calibration.trackerToRoom * glm::dquat(1, small(random), small(random), small(random)));
    const glm::dvec3 at = fit.calibration.trackerInRoomMm + AnyPoint(random, 0.3);
    double sum = 0.0;
    for (const auto& pair : pairs)
    {
      const glm::dvec3 off = at + turn * pair.trackerMm - pair.roomMm;
      sum += glm::dot(off, off);
    }
    EXPECT_GT(std::sqrt(sum / pairs.size()), fit.rmsMm);
  }
}

TEST(TrackerCalibration, StiffPointsAreFittedOrRefusedWithFigures)
{
  const hasp::TrackerCalibration truth{ hasp::HeadOrientation(0.4, 0.3, -0.2), { 100, 0, -50 } };
  const auto fitted = [&](double size, const glm::dvec3& at)
  {
    std::vector<glm::dvec3> points;
    for (const glm::dvec3& p : Around)
      points.push_back(p / 260.0 * size + at);
    return hasp::FitTrackerToRoom(Pairs(truth, points));
  };
  // A thousandth of a millimetre apart; ten metres; and that far from the origin, where 1e5 mm
  // leave 1.5e-11 mm of digits, over a spread of 100 mm.
  EXPECT_LT(Apart(fitted(1e-3, {}).calibration.trackerToRoom, truth.trackerToRoom), 1e-9);
  EXPECT_LT(Apart(fitted(1e4, {}).calibration.trackerToRoom, truth.trackerToRoom), 1e-12);
  EXPECT_LT(
    Apart(fitted(100, { 1e5, -1e5, 1e5 }).calibration.trackerToRoom, truth.trackerToRoom), 1e-11);
  for (const double width : { 0.0, 1e-9, 1.0, 3.0, 20.0 })
  {
    const auto pairs =
      Pairs(truth, { { -200, 0, 0 }, { -70, width, 0 }, { 80, -width, 0 }, { 200, 0, width } });
    const std::string why = Refusal([&] { hasp::FitTrackerToRoom(pairs); });
    EXPECT_EQ(why.empty(), width > 10.0) << width << why;
    EXPECT_EQ(why.find("almost on a line") != std::string::npos, width < 10.0) << why;
  }
  EXPECT_NE(Refusal(
              [&] {
                hasp::FitTrackerToRoom(Pairs(truth, { { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } }));
              })
              .find("all points are the same"),
    std::string::npos);
}

TEST(TrackerCalibration, PairsThatSayNothingAreRefused)
{
  const hasp::TrackerCalibration truth;
  const auto why = [](std::vector<hasp::CalibrationPair> pairs)
  { return Refusal([&] { hasp::FitTrackerToRoom(pairs); }); };
  EXPECT_NE(why({}).find("there are 0 pairs"), std::string::npos);
  EXPECT_NE(why(Pairs(truth, { { 0, 0, 0 }, { 1, 0, 0 } })).find("are 2 pairs"), std::string::npos);
  auto pairs = Pairs(truth, Around);
  pairs[2].roomMm.y = NAN;
  EXPECT_NE(why(pairs).find("pair 3 holds nan"), std::string::npos);
  pairs[2].roomMm.y = 1e9;
  EXPECT_NE(why(pairs).find("pair 3 holds 1e+09"), std::string::npos);
}

TEST(TrackerCalibration, MirroredPointsAreRefusedFlatNoisyOnesAreNot)
{
  std::mt19937_64 random(6);
  std::normal_distribution<double> noise(0.0, 0.5);
  for (int axis = 0; axis < 3; ++axis)
  {
    auto pairs = Pairs({ AnyTurn(random), { 1, 2, 3 } }, Around);
    for (auto& pair : pairs)
    {
      pair.trackerMm[axis] = -pair.trackerMm[axis];
      for (int a = 0; a < 3; ++a)
        pair.trackerMm[a] += noise(random);
    }
    EXPECT_NE(
      Refusal([&] { hasp::FitTrackerToRoom(pairs); }).find("mirror image"), std::string::npos);
  }
  // Four corners in a plane with noise: nobody can tell, and it is no fault.
  int refused = 0;
  for (int n = 0; n < 2000; ++n)
  {
    auto pairs = Pairs({ AnyTurn(random), { 1, 2, 3 } }, Corners);
    for (auto& pair : pairs)
      for (int a = 0; a < 3; ++a)
      {
        pair.trackerMm[a] += noise(random);
        pair.roomMm[a] += noise(random);
      }
    refused += !Refusal([&] { hasp::FitTrackerToRoom(pairs); }).empty();
  }
  EXPECT_LE(refused, 2) << "of 2000: fewer than one of a thousand, as the code says";
}

TEST(TrackerCalibration, AnotherUnitShowsInTheSpread)
{
  auto pairs = Pairs({}, Around);
  for (auto& pair : pairs)
    pair.trackerMm *= 0.001;
  EXPECT_NEAR(hasp::FitTrackerToRoom(pairs).spreadRatio, 1000.0, 1e-6);
}

#else

TEST(TrackerCalibration, WithoutEigenTheFitSaysWhatIsMissing)
{
  EXPECT_NE(
    Refusal([] { hasp::FitTrackerToRoom({}); }).find("HASP_ENABLE_EIGEN=ON"), std::string::npos);
}

#endif

#if HASP_WITH_JSON

TEST(TrackerCalibration, FilesComeBackToTheLastBit)
{
  std::mt19937_64 random(8);
  const hasp::TrackerCalibration truth{ AnyTurn(random), AnyPoint(random, 900),
    AnyPoint(random, 90), AnyTurn(random) };
  const std::string file =
    (std::filesystem::temp_directory_path() / ("hasp-calibration-" + std::to_string(getpid())))
      .string();
  hasp::WriteTrackerCalibration(file, truth);
  const hasp::TrackerCalibration again = hasp::ReadTrackerCalibration(file);
  std::filesystem::remove(file);
  EXPECT_EQ(again.trackerToRoom, truth.trackerToRoom);
  EXPECT_EQ(again.trackerInRoomMm, truth.trackerInRoomMm);
  EXPECT_EQ(again.eyesInMarkerMm, truth.eyesInMarkerMm);
  EXPECT_EQ(again.headToMarker, truth.headToMarker);
  EXPECT_THROW(hasp::ReadTrackerCalibration(file), std::runtime_error);
}

TEST(TrackerCalibration, WhatIsWrongInTheFileIsSaidByItsKey)
{
  const std::string good = hasp::FormatTrackerCalibration({});
  const auto why = [&](const std::string& from, const std::string& to)
  {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    return Refusal([&] { hasp::ParseTrackerCalibration(text); });
  };
  EXPECT_TRUE(Refusal([&] { hasp::ParseTrackerCalibration(good); }).empty());
  const struct
  {
    std::string from, to;
    const char* says;
  } cases[] = {
    { "{", "SECRET", "no JSON: a mistake at byte" },
    { "calibration-1", "calibration-2", "format is of another kind" },
    { "\"eyesInMarkerMm\"", "\"SECRET\"", "eyesInMarkerMm is missing" },
    { "{", "{ \"SECRET\": 1,", "there are 6 keys" },
    { "0.0", "\"SECRET\"", "trackerToRoom must be 4 numbers" },
    { "0.0", "0.0, 0.0", "trackerToRoom must be 4 numbers" },
    { "1.0", "1e999", "too large for any double" },
    { "1.0", "1.5", "length is 1.5" },
  };
  for (const auto& c : cases)
  {
    const std::string text = why(c.from, c.to);
    EXPECT_NE(text.find(c.says), std::string::npos) << c.says << "\n" << text;
    EXPECT_EQ(text.find("SECRET"), std::string::npos) << text;
  }
  EXPECT_FALSE(Refusal([] { hasp::ParseTrackerCalibration("[]"); }).empty());
  EXPECT_FALSE(Refusal([] { hasp::ParseTrackerCalibration(""); }).empty());
}

#else

TEST(TrackerCalibration, WithoutJsonItsFilesSayWhatIsMissing)
{
  EXPECT_NE(Refusal([] { hasp::FormatTrackerCalibration({}); }).find("HASP_ENABLE_JSON=ON"),
    std::string::npos);
}

#endif

} // namespace
