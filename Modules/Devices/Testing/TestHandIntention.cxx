#include "Devices/HandIntention.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace
{

using namespace hasp;

const RigidPose Start{ { 1, 2, 3 }, TurnBy({ 0.2, -0.1, 0.3 }) };
const RigidPose There{ { 11, -8, 4 }, TurnBy({ 0.5, 0.4, -0.9 }) };

TEST(HandIntention, WhatIsNoMotionIsRefused)
{
  const double nan = std::nan("");
  const auto refused = [](const HandMotion& motion)
  { EXPECT_THROW(HandIntention(Start, { motion }), std::invalid_argument); };
  refused(HoldMotion{ 0.0 });
  refused(HoldMotion{ nan });
  refused(HoldMotion{ 1e9 });
  refused(MinimumJerkMotion{ { { nan, 0, 0 } }, 1.0 });
  refused(MinimumJerkMotion{ { {}, { 2, 0, 0, 0 } }, 1.0 });
  refused(ChirpMotion{ .reachMm = { 0, nan, 0 } });
  refused(ChirpMotion{ .fromHz = -1.0 });
  refused(ChirpMotion{ .toHz = 1e4 });
  refused(ImpactMotion{ { 0, 0, 1e6 } });
  EXPECT_THROW(HandIntention({ { 1e9, 0, 0 } }), std::invalid_argument);
  EXPECT_THROW(HandIntention({}, {}, { .reachMm = -1.0 }), std::invalid_argument);
  EXPECT_THROW(HandIntention({}, {}, { .reachRad = nan }), std::invalid_argument);
}

TEST(HandIntention, NothingPlannedStaysWhereItIs)
{
  const HandIntention plan(Start);
  for (const double t : { -1.0, 0.0, 1e6 })
  {
    EXPECT_EQ(plan.At(t).pose.position, Start.position);
    EXPECT_EQ(plan.At(t).pose.orientation, Start.orientation);
    EXPECT_EQ(plan.At(t).velocityMmPerS, glm::dvec3(0.0));
  }
}

TEST(HandIntention, MinimumJerkIsTheFifthDegreePolynomial)
{
  const HandIntention plan(Start, { MinimumJerkMotion{ There, 2.0 } });
  const IntendedPose middle = plan.At(1.0);
  EXPECT_LT(glm::length(middle.pose.position - 0.5 * (Start.position + There.position)), 1e-14);
  // The fastest moment: 15/8 of the mean speed.
  EXPECT_NEAR(glm::length(middle.velocityMmPerS),
    15.0 / 8.0 * glm::length(There.position - Start.position) / 2.0, 1e-12);
  for (const double t : { 0.0, 2.0 })
  {
    EXPECT_LT(glm::length(plan.At(t).velocityMmPerS), 1e-12);
    EXPECT_LT(glm::length(plan.At(t).turnRadPerS), 1e-12);
  }
  const IntendedPose end = plan.At(3.0);
  EXPECT_LT(glm::length(end.pose.position - There.position), 1e-13);
  EXPECT_NEAR(std::abs(glm::dot(end.pose.orientation, There.orientation)), 1.0, 1e-14);
}

TEST(HandIntention, ImpactGoesStraightOnAndMotionsFollowEachOther)
{
  const HandIntention plan(
    Start, { HoldMotion{ 0.5 }, ImpactMotion{ { 0, 0, -1000 }, 0.25 }, HoldMotion{ 1.0 } });
  EXPECT_EQ(plan.DurationS(), 1.75);
  EXPECT_EQ(plan.At(0.4).pose.position, Start.position);
  EXPECT_LT(glm::length(plan.At(0.6).pose.position - glm::dvec3(1, 2, 3 - 100)), 1e-10);
  EXPECT_EQ(plan.At(0.6).velocityMmPerS, glm::dvec3(0, 0, -1000));
  EXPECT_LT(glm::length(plan.At(1.0).pose.position - glm::dvec3(1, 2, 3 - 250)), 1e-10);
  EXPECT_EQ(plan.At(1.0).velocityMmPerS, glm::dvec3(0));
}

/// Whatever the motion: velocities are the derivatives of poses. Central differences of 1e-6 s are
/// good to their square times the third derivative, and to 1e-16 * 100 mm / 1e-6 s of rounding.
TEST(HandIntention, VelocitiesAreDerivativesOfPoses)
{
  constexpr double H = 1e-6;
  const HandIntention plan(Start,
    { MinimumJerkMotion{ There, 1.0 },
      ChirpMotion{ { 5, 0, -3 }, { 0.1, 0.0, 0.0 }, 1.0, 8.0, 1.0 },
      ImpactMotion{ { 100, 50, 0 }, 0.5 } },
    { .reachMm = 0.1 });
  for (double t = 0.011; t < plan.DurationS() + 0.2; t += 0.037)
  {
    const IntendedPose before = plan.At(t - H), now = plan.At(t), after = plan.At(t + H);
    const glm::dvec3 v = (after.pose.position - before.pose.position) / (2.0 * H);
    EXPECT_LT(glm::length(v - now.velocityMmPerS), 1e-5) << t;
    const glm::dvec3 w =
      RotationVector(after.pose.orientation * glm::conjugate(before.pose.orientation)) / (2.0 * H);
    EXPECT_LT(glm::length(w - now.turnRadPerS), 1e-5) << t;
  }
}

TEST(HandIntention, TremorStaysInItsReachAndItsBand)
{
  const HandIntention plan({}, {}, { .reachMm = 0.1, .seed = 7 });
  // Zero crossings of each axis over 20 s: between 8 and 12 Hz, two a period. A sum of three sines
  // beats, and a beat may lose or add a few.
  constexpr double Seconds = 20.0, Step = 1e-4;
  for (int axis = 0; axis < 3; ++axis)
  {
    int crossings = 0;
    double before = plan.At(0.0).pose.position[axis], most = 0.0;
    for (double t = Step; t < Seconds; t += Step)
    {
      const double now = plan.At(t).pose.position[axis];
      crossings += (now > 0) != (before > 0);
      most = std::max(most, std::abs(now));
      before = now;
    }
    EXPECT_GT(crossings, 2 * 7.5 * Seconds);
    EXPECT_LT(crossings, 2 * 12.5 * Seconds);
    EXPECT_LE(most, 0.1);
    EXPECT_GT(most, 0.05);
  }
}

TEST(HandIntention, TheSeedDecidesAboutTheTremorAlone)
{
  const auto at = [](std::uint64_t seed)
  { return HandIntention(Start, {}, { .reachMm = 0.1, .seed = seed }).At(0.3).pose.position; };
  EXPECT_EQ(at(1), at(1));
  EXPECT_NE(at(1), at(2));
  EXPECT_LT(glm::length(at(2) - Start.position), 0.1 * std::sqrt(3.0));
}

} // namespace
