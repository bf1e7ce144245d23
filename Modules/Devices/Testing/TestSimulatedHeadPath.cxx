#include "Devices/SimulatedHeadPath.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{

TEST(SimulatedHeadPath, SettingsOutOfRangeAreRefused)
{
  EXPECT_THROW(hasp::SimulatedHeadPath({ .reachMm = glm::dvec3(-1, 0, 0) }), std::invalid_argument);
  EXPECT_THROW(
    hasp::SimulatedHeadPath({ .reachDegrees = glm::dvec3(0, 90, 0) }), std::invalid_argument);
  EXPECT_THROW(hasp::SimulatedHeadPath({ .noiseMm = NAN }), std::invalid_argument);
  EXPECT_THROW(
    hasp::SimulatedHeadPath({ .jitterS = 0.01 }).Record(0, 1, 60), std::invalid_argument);
  EXPECT_THROW(hasp::SimulatedHeadPath().Record(0, 0, 60), std::invalid_argument);
  EXPECT_THROW(hasp::SimulatedHeadPath().Record(0, 1e6, 60), std::invalid_argument);
}

/// A minute of it moves as a person does: within reach, most of the reach is used, at speeds of
/// people who look around (some 100 mm/s), never faster than 1 m/s.
TEST(SimulatedHeadPath, MovesAsAPersonDoes)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    const hasp::SimulatedHeadPath path({ .seed = seed });
    glm::dvec3 most(0.0);
    double mean = 0.0, fastest = 0.0;
    constexpr int Count = 6000;
    for (int n = 0; n < Count; ++n)
    {
      const hasp::HeadPose pose = path.At(n * 0.01);
      ASSERT_EQ(hasp::FaultOf(pose), hasp::HeadPoseFault::None);
      most = glm::max(most, glm::abs(pose.position - glm::dvec3(0, 0, 600)));
      const double speed = glm::length(path.VelocityMmPerS(n * 0.01));
      mean += speed / Count;
      fastest = std::max(fastest, speed);
    }
    EXPECT_TRUE(glm::all(glm::lessThanEqual(most, glm::dvec3(150, 60, 120))));
    EXPECT_TRUE(glm::all(glm::greaterThan(most, 0.5 * glm::dvec3(150, 60, 120))));
    EXPECT_GT(mean, 50.0);
    EXPECT_LT(mean, 250.0);
    EXPECT_LT(fastest, 1000.0);
  }
}

TEST(SimulatedHeadPath, VelocityIsTheDerivative)
{
  const hasp::SimulatedHeadPath path({ .seed = 7 });
  const double h = 1e-5; // error of the central difference: h^2 / 6 of the third derivative, 1e-8
  for (double t = -3.0; t < 30.0; t += 0.37)
  {
    const glm::dvec3 difference = (path.At(t + h).position - path.At(t - h).position) / (2 * h);
    EXPECT_LT(glm::length(difference - path.VelocityMmPerS(t)), 1e-5) << t;
  }
}

TEST(SimulatedHeadPath, WhatIsRecordedIsTruthAndNoiseOfTheStatedSize)
{
  const hasp::SimulatedHeadSettings settings{
    .noiseMm = 0.4, .noiseDegrees = 0.2, .jitterS = 0.004
  };
  const hasp::SimulatedHeadPath simulated(settings);
  const hasp::HeadPath path = simulated.Record(12.0, 60.0, 60.0);
  ASSERT_EQ(path.size(), 3600u);
  EXPECT_NO_THROW(hasp::ValidateHeadPath(path));
  double length2 = 0.0, angle2 = 0.0, late2 = 0.0;
  for (std::size_t n = 0; n < path.size(); ++n)
  {
    const hasp::HeadPose truth = simulated.At(path[n].timeS);
    const glm::dvec3 off = path[n].pose.position - truth.position;
    length2 += glm::dot(off, off);
    const double cosine = std::abs(glm::dot(path[n].pose.orientation, truth.orientation));
    angle2 += std::pow(2.0 * std::acos(std::min(1.0, cosine)), 2);
    const double late = path[n].timeS - (12.0 + n / 60.0);
    EXPECT_LE(std::abs(late), 0.004 + 1e-12);
    late2 += late * late;
  }
  // Of 3600 samples: the mean square of three axes is within 5 standard deviations, 5 / sqrt(5400).
  EXPECT_NEAR(std::sqrt(length2 / 3600) / (std::sqrt(3.0) * 0.4), 1.0, 0.035);
  EXPECT_NEAR(std::sqrt(angle2 / 3600) / (std::sqrt(3.0) * glm::radians(0.2)), 1.0, 0.035);
  EXPECT_NEAR(std::sqrt(late2 / 3600) / (0.004 / std::sqrt(3.0)), 1.0, 0.05);
}

TEST(SimulatedHeadPath, SeedsMakePathsAndPathsAreRepeatable)
{
  const hasp::SimulatedHeadPath a({ .seed = 3 }), b({ .seed = 3 }), c({ .seed = 4 });
  EXPECT_EQ(a.At(1.5).position, b.At(1.5).position);
  EXPECT_GT(glm::length(a.At(1.5).position - c.At(1.5).position), 1.0);
  EXPECT_EQ(a.Record(0, 1, 60).size(), 60u);
}

} // namespace
