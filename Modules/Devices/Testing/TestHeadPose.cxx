#include "Devices/HeadPose.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

TEST(HeadPose, WhatIsNoPoseIsRefusedWithItsFigure)
{
  using Fault = hasp::HeadPoseFault;
  const struct
  {
    hasp::HeadPose pose;
    Fault fault;
    const char* says;
  } cases[] = {
    { { { NaN, 0, 0 }, { 1, 0, 0, 0 } }, Fault::NotFinite, "not finite" },
    { { { 0, 0, Infinity }, { 1, 0, 0, 0 } }, Fault::NotFinite, "not finite" },
    { { { 0, 0, 0 }, { 1, 0, NaN, 0 } }, Fault::NotFinite, "not finite" },
    { { { 0, 10'001, 0 }, { 1, 0, 0, 0 } }, Fault::TooFar, "10001 mm" },
    { { { 1e300, 0, 0 }, { 1, 0, 0, 0 } }, Fault::TooFar, "10000; are the units mm?" },
    { { { 0, 0, 0 }, { 0, 0, 0, 0 } }, Fault::NotUnit, "length is 0" },
    { { { 0, 0, 0 }, { 1.002, 0, 0, 0 } }, Fault::NotUnit, "1.002" },
    { { { 0, 0, 0 }, { 1e300, 0, 0, 0 } }, Fault::NotUnit, "inf" },
  };
  for (const auto& c : cases)
  {
    EXPECT_EQ(hasp::FaultOf(c.pose), c.fault) << c.says;
    try
    {
      hasp::ValidateHeadPose(c.pose);
      ADD_FAILURE() << c.says;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(c.says), std::string::npos) << error.what();
    }
  }
}

TEST(HeadPose, TheEdgesOfWhatIsLegalPass)
{
  for (const hasp::HeadPose& pose :
    { hasp::HeadPose{}, hasp::HeadPose{ { 0, 0, -10'000 }, { 0, 0, 0, -1 } },
      hasp::HeadPose{ { 0, 0, 0 }, { 0.9991, 0, 0, 0 } } })
  {
    EXPECT_EQ(hasp::FaultOf(pose), hasp::HeadPoseFault::None);
    EXPECT_NO_THROW(hasp::ValidateHeadPose(pose));
  }
}

/// The convention of the header, by where the nose and the right ear go.
TEST(HeadPose, TurnsGoWhereTheConventionSays)
{
  const glm::dvec3 nose(0, 0, -1), right(1, 0, 0);
  const double turn = 0.3;
  EXPECT_LT((hasp::HeadOrientation(turn, 0, 0) * nose).x, -0.29) << "yaw: to the left";
  EXPECT_GT((hasp::HeadOrientation(0, turn, 0) * nose).y, 0.29) << "pitch: up";
  EXPECT_GT((hasp::HeadOrientation(0, 0, turn) * right).y, 0.29) << "roll: the right ear up";
  // Yaw first, about the room's axis; roll last, about the head's: it moves no nose.
  const glm::dvec3 a = hasp::HeadOrientation(0.4, 0.2, 0.0) * nose,
                   b = hasp::HeadOrientation(0.4, 0.2, 0.7) * nose;
  EXPECT_LT(glm::length(a - b), 1e-15);
  EXPECT_NEAR(a.y, std::sin(0.2), 1e-15);
}

TEST(HeadPose, TheClockGoesForward)
{
  const double before = hasp::SteadySeconds();
  EXPECT_GE(hasp::SteadySeconds(), before);
}

} // namespace
