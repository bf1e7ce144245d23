#include "Devices/MouseHeadPose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{

glm::dvec3 Place(hasp::MouseHeadPose& mouse)
{
  return mouse.Latest(1.0)->pose.position;
}

TEST(MouseHeadPose, SettingsOutOfRangeAreRefused)
{
  EXPECT_THROW(hasp::MouseHeadPose({ .reachMm = glm::dvec2(-1, 0) }), std::invalid_argument);
  EXPECT_THROW(hasp::MouseHeadPose({ .stepFactor = 1.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::MouseHeadPose({ .nearestMm = 700 }), std::invalid_argument);
  EXPECT_THROW(
    hasp::MouseHeadPose({ .rest = { { 0, 0, NAN }, { 1, 0, 0, 0 } } }), std::invalid_argument);
}

TEST(MouseHeadPose, RestsInTheMiddleAndReachesTheEdges)
{
  hasp::MouseHeadPose mouse({ .rest = { { 10, 20, 600 }, { 1, 0, 0, 0 } } });
  EXPECT_EQ(Place(mouse), glm::dvec3(10, 20, 600));
  EXPECT_EQ(mouse.Latest(77.0)->timeS, 77.0) << "always of now";
  mouse.SetPosition({ 1, -1 });
  EXPECT_EQ(Place(mouse), glm::dvec3(260, -130, 600));
  mouse.SetPosition({ -9, 1e300 });
  EXPECT_EQ(Place(mouse), glm::dvec3(-240, 170, 600)) << "beyond is the edge";
  mouse.SetPosition({ NAN, 0 });
  mouse.TurnWheel(INFINITY);
  EXPECT_EQ(Place(mouse), glm::dvec3(-240, 170, 600)) << "nonsense changes nothing";
  mouse.Reset();
  EXPECT_EQ(Place(mouse), glm::dvec3(10, 20, 600));
}

TEST(MouseHeadPose, TheWheelGoesAwayAndComesBack)
{
  hasp::MouseHeadPose mouse;
  mouse.TurnWheel(1);
  EXPECT_NEAR(Place(mouse).z, 660, 1e-9);
  mouse.TurnWheel(-2);
  EXPECT_NEAR(Place(mouse).z, 600 / 1.1, 1e-9);
  mouse.TurnWheel(-1000);
  EXPECT_EQ(Place(mouse).z, 150);
  mouse.TurnWheel(1000);
  EXPECT_EQ(Place(mouse).z, 3000);
}

} // namespace
