#include "Devices/TrackerCalibration.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

using namespace hasp;

const std::string Head = "trackerXMm,trackerYMm,trackerZMm,roomXMm,roomYMm,roomZMm\n";
const std::string Sightings =
  "trackerXMm,trackerYMm,trackerZMm,qw,qx,qy,qz,roomXMm,roomYMm,roomZMm\n";

TEST(CalibrationPairs, AreReadAsTheyStand)
{
  const auto pairs = ParseCalibrationPairs(Head + "1,2,3,4,5,6\r\n-1e2,0.5,0,260,-160,0");
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].trackerMm, glm::dvec3(1, 2, 3));
  EXPECT_EQ(pairs[0].roomMm, glm::dvec3(4, 5, 6));
  EXPECT_EQ(pairs[1].trackerMm, glm::dvec3(-100, 0.5, 0));
  EXPECT_EQ(pairs[1].roomMm, glm::dvec3(260, -160, 0));
  EXPECT_TRUE(ParseCalibrationPairs(Head).empty()); // too few is for the fit to say
}

TEST(CalibrationPairs, WhatIsWrongIsSaidByItsLineAndNeverRepeated)
{
  const auto fault = [](const std::string& text) -> std::string
  {
    try
    {
      ParseCalibrationPairs(text);
      return "taken";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_EQ(std::string(error.what()).find("Jane"), std::string::npos) << error.what();
      return error.what();
    }
  };
  const auto expect = [&](const std::string& text, const std::string& words)
  { EXPECT_NE(fault(text).find(words), std::string::npos) << fault(text); };
  expect("", "line 1: it must be trackerXMm");
  expect("Jane\n", "line 1: it must be trackerXMm");
  expect(Head + "1,2,3,4,5\n", "line 2: there must be 6 numbers");
  expect(Head + "1,2,3,4,5,6,7\n", "line 2: something stands behind");
  expect(Head + "1,2,3,4,5,6\n1,2,Jane,4,5,6\n", "line 3: column 3 is no number");
  expect(Head + "1,2,3,4,5,6\n\n", "line 3: column 1 is no number");
  expect(Head + "1 ,2,3,4,5,6\n", "line 2: there must be 6 numbers");
  std::string many = Head;
  for (int n = 0; n < 10'001; ++n)
    many += "1,2,3,4,5,6\n";
  expect(many, "line 10002: there are more than 10000 pairs");
}

TEST(CalibrationPairs, AFileThatIsNotThereIsAnError)
{
  EXPECT_THROW(ReadCalibrationPairs("no-such-points.csv"), std::runtime_error);
}

TEST(MarkerSightings, AreReadAsTheyStand)
{
  const auto sightings =
    ParseMarkerSightings(Sightings + "1,2,3,0,0.6,0,-0.8,4,5,600\r\n-1e2,0.5,0,1,0,0,0,0,40,610");
  ASSERT_EQ(sightings.size(), 2U);
  EXPECT_EQ(sightings[0].marker.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(sightings[0].marker.orientation, glm::dquat(0, 0.6, 0, -0.8));
  EXPECT_EQ(sightings[0].head.position, glm::dvec3(4, 5, 600));
  EXPECT_EQ(sightings[0].head.orientation, glm::dquat(1, 0, 0, 0));
  EXPECT_EQ(sightings[1].marker.position, glm::dvec3(-100, 0.5, 0));
  EXPECT_EQ(sightings[1].head.position, glm::dvec3(0, 40, 610));
  EXPECT_TRUE(ParseMarkerSightings(Sightings).empty()); // too few is for the fit to say
}

TEST(MarkerSightings, WhatIsWrongIsSaidByItsLine)
{
  const auto expect = [&](const std::string& text, const std::string& words)
  {
    try
    {
      ParseMarkerSightings(text);
      ADD_FAILURE() << "taken: " << words;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const std::string good = "1,2,3,1,0,0,0,4,5,600\n";
  expect(Head + good, "sightings of the marker: line 1: it must be trackerXMm");
  expect(Sightings + "1,2,3,1,0,0,0,4,5\n", "line 2: there must be 10 numbers");
  expect(Sightings + good + "1,2,3,1,1,0,0,4,5,600\n", "line 3: "); // no unit quaternion
  expect(Sightings + "20000,2,3,1,0,0,0,4,5,600\n", "line 2: ");    // 20 m
  expect(Sightings + good + "0.2,0.1,1,1,0,0,0,0,0.04,0.6\n", "line 3: the eyes are 0.6"); // metres
  expect(Sightings + good + good + "1,2,3,1,0,0,0,nan,5,6\n", "line 4"); // no number
  std::string many = Sightings;
  for (int n = 0; n < 10'001; ++n)
    many += good;
  expect(many, "line 10002: there are more than 10000 sightings");
  EXPECT_THROW(ReadMarkerSightings("no-such-sightings.csv"), std::runtime_error);
}

} // namespace
