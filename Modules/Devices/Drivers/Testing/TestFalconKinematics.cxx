#include "Devices/Drivers/Falcon/FalconKinematics.h"

#include "Grid/FinitePose.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace hasp;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// In the part of the reach that hands use: round, 50 mm wide, all but the ends of its depth.
glm::dvec3 RandomPose(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  glm::dvec3 p;
  do
    p = { 50.0 * unit(random), 50.0 * unit(random), -2.5 + 47.5 * unit(random) };
  while (std::hypot(p.x, p.y) > 50.0 || !FalconAnglesAt(p));
  return p;
}
} // namespace

// The equations of the leg, written once more from the thesis's loop closure with all three angles.
TEST(FalconKinematics, AnglesCloseEachLeg)
{
  constexpr double a = 60, b = 102.5, c = 14.43, d = 11.25, e = 11.25, f = -25, r = 40, s = -23.09;
  std::mt19937 random(1);
  for (int n = 0; n < 1000; ++n)
  {
    const glm::dvec3 p = RandomPose(random);
    const glm::dvec3 angles = FalconAnglesAt(p).value();
    for (int i = 0; i < 3; ++i)
    {
      const double phi = (105.0 - 120.0 * i) * Pi / 180.0;
      const double u = std::cos(phi) * p.x + std::sin(phi) * p.y - r;
      const double v = -std::sin(phi) * p.x + std::cos(phi) * p.y - s;
      const double w = p.z + 125.0;
      const double t3 = std::acos((v + f) / b);
      const double l = d + e + b * std::sin(t3);
      const double t2 = std::atan2(w - a * std::sin(angles[i]), u + c - a * std::cos(angles[i]));
      EXPECT_NEAR(u + c, a * std::cos(angles[i]) + l * std::cos(t2), 1e-10);
      EXPECT_NEAR(w, a * std::sin(angles[i]) + l * std::sin(t2), 1e-10);
      // The elbow outwards: the arm's angle is the smaller of the two that reach.
      EXPECT_LT(angles[i], t2);
    }
  }
}

TEST(FalconKinematics, ForwardUndoesInverse)
{
  std::mt19937 random(2);
  double worstMm = 0.0;
  int most = 0;
  for (int n = 0; n < 10'000; ++n)
  {
    const glm::dvec3 p = RandomPose(random);
    const auto found = FalconPositionAt(FalconAnglesAt(p).value());
    ASSERT_TRUE(found) << p.x << " " << p.y << " " << p.z;
    worstMm = std::max(worstMm, glm::distance(found->positionMm, p));
    most = std::max(most, found->iterations);
  }
  RecordProperty("worstM", std::to_string(1e-3 * worstMm));
  std::printf(
    "forward of inverse: worst %.2g m, most steps from the middle %d\n", 1e-3 * worstMm, most);
  EXPECT_LE(1e-3 * worstMm, 1e-9);
  EXPECT_LE(most, 10);
}

// The whole reach, its edge too, where arms are nearly stretched.
TEST(FalconKinematics, AllOfTheReachIsFound)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int reached = 0, most = 0;
  for (int n = 0; n < 100'000; ++n)
  {
    const glm::dvec3 p{ 90.0 * unit(random), 90.0 * unit(random), 70.0 * unit(random) };
    const auto angles = FalconAnglesAt(p);
    if (!angles)
      continue;
    ++reached;
    ASSERT_TRUE(IsFinite(*angles));
    const auto found = FalconPositionAt(*angles);
    ASSERT_TRUE(found) << p.x << " " << p.y << " " << p.z;
    ASSERT_LE(glm::distance(found->positionMm, p), 1e-6) << p.x << " " << p.y << " " << p.z;
    ASSERT_TRUE(FalconJacobian(p, *angles));
    most = std::max(most, found->iterations);
  }
  EXPECT_GT(reached, 30'000);
  EXPECT_LE(most, 10);
}

TEST(FalconKinematics, FollowsAHandInFourSteps)
{
  glm::dvec3 near(0.0);
  int most = 0;
  double t = 0.0;
  glm::dvec3 p(0.0);
  for (int n = 0; n < 20'000; ++n)
  {
    // 1 mm a tick along a path that turns through all of the space.
    glm::dvec3 next;
    double step = 0.02;
    do
      next = { 45 * std::sin(1.0 * (t + step)), 45 * std::sin(0.73 * (t + step)),
        40 * std::sin(0.57 * (t + step) + 1.0) };
    while (glm::distance(next, p) > 1.0 && (step *= 0.9) > 1e-9 && n > 0);
    t += step;
    p = next;
    const auto angles = FalconAnglesAt(p);
    if (!angles || std::hypot(p.x, p.y) > 50.0)
    {
      near = p;
      continue;
    }
    const auto found = FalconPositionAt(*angles, near);
    ASSERT_TRUE(found);
    if (n > 0)
      most = std::max(most, found->iterations);
    ASSERT_LE(glm::distance(found->positionMm, p), 1e-6);
    near = found->positionMm;
  }
  std::printf("most steps at 1 m/s: %d\n", most);
  EXPECT_LE(most, 4);
}

TEST(FalconKinematics, JacobianIsTheDifferenceOfPoses)
{
  std::mt19937 random(4);
  for (int n = 0; n < 1000; ++n)
  {
    const glm::dvec3 p = RandomPose(random);
    const glm::dvec3 angles = FalconAnglesAt(p).value();
    const auto jacobian = FalconJacobian(p, angles);
    ASSERT_TRUE(jacobian);
    for (int i = 0; i < 3; ++i)
    {
      constexpr double h = 1e-5;
      glm::dvec3 more = angles, less = angles;
      more[i] += h;
      less[i] -= h;
      const auto above = FalconPositionAt(more, p), below = FalconPositionAt(less, p);
      if (!above || !below) // over the edge
        continue;
      const glm::dvec3 difference = (above->positionMm - below->positionMm) / (2 * h);
      // Of second order: h^2 times a third derivative, of some 1e3 mm here.
      EXPECT_LE(glm::distance(difference, (*jacobian)[i]), 1e-5 * glm::length(difference) + 1e-5);
    }
  }
}

// The power of the motors is that of the grip.
TEST(FalconKinematics, PowerBalances)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double worst = 0.0;
  for (int n = 0; n < 10'000; ++n)
  {
    const glm::dvec3 p = RandomPose(random);
    const auto jacobian = FalconJacobian(p, FalconAnglesAt(p).value()).value();
    const glm::dvec3 force{ unit(random), unit(random), unit(random) };
    const glm::dvec3 turns{ unit(random), unit(random), unit(random) };
    const glm::dvec3 torque = FalconTorques(jacobian, force), moves = jacobian * turns;
    const double size = glm::length(force) * glm::length(moves);
    worst = std::max(worst, std::abs(glm::dot(torque, turns) - glm::dot(force, moves)) / size);
  }
  std::printf("power balance: worst %.2g\n", worst);
  EXPECT_LE(worst, 1e-9);
}

// By numbers that were computed elsewhere, from the same geometry: 1 N along z in the middle takes
// 0.0252 N m of each motor, and a count is 0.043 mm.
TEST(FalconKinematics, MiddleHasItsKnownFigures)
{
  const glm::dvec3 angles = FalconAnglesAt(glm::dvec3(0.0)).value();
  const auto jacobian = FalconJacobian(glm::dvec3(0.0), angles).value();
  const glm::dvec3 torques = FalconTorques(jacobian, { 0, 0, 1 });
  const double count = FalconAngleOfCount(1) - FalconAngleOfCount(0);
  EXPECT_NEAR(count * 180.0 / Pi, 0.036435, 1e-6);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(torques[i], 25.2, 0.05); // N mm, and outwards
    EXPECT_NEAR(glm::length(jacobian[i]) * count, 0.043, 0.001);
  }
}

TEST(FalconKinematics, OutsideIsRefused)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double far : { 81.0, 1e3, 1e200, inf, nan })
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : { 1.0, -1.0 })
      {
        glm::dvec3 p(0.0), angles = FalconAnglesAt(p).value();
        p[axis] = sign * far;
        EXPECT_FALSE(FalconAnglesAt(p)) << far;
        angles[axis] = sign * far;
        const auto found = FalconPositionAt(angles);
        // A turn of 2 pi n is none: 81 rad may be a legal angle but for turns, and is refused too.
        EXPECT_FALSE(found) << far;
        if (!std::isfinite(far))
        {
          EXPECT_FALSE(FalconPositionAt(FalconAnglesAt(glm::dvec3(0.0)).value(), p));
          EXPECT_FALSE(FalconJacobian(p, FalconAnglesAt(glm::dvec3(0.0)).value()));
        }
      }
}

// Whatever 16 bits say: a pose within the reach whose angles are these, or none.
TEST(FalconKinematics, AnyCountsGiveAPoseOrNone)
{
  std::mt19937 random(6);
  const int extremes[] = { -32768, -32767, -4096, -1, 0, 1, 4095, 9880, 32766, 32767 };
  std::uniform_int_distribution<int> any(-32768, 32767), near(-3000, 3000);
  int found = 0;
  const auto check = [&](const glm::ivec3& counts)
  {
    const glm::dvec3 angles(
      FalconAngleOfCount(counts.x), FalconAngleOfCount(counts.y), FalconAngleOfCount(counts.z));
    for (int i = 0; i < 3; ++i)
      ASSERT_NEAR(FalconCountOfAngle(angles[i]), counts[i], 1e-9);
    const auto pose = FalconPositionAt(angles);
    if (!pose)
      return;
    ++found;
    ASSERT_TRUE(IsFinite(pose->positionMm));
    ASSERT_LE(glm::distance(FalconAnglesAt(pose->positionMm).value(), angles), 1e-9);
  };
  for (const int a : extremes)
    for (const int b : extremes)
      for (const int c : extremes)
        check({ a, b, c });
  for (int n = 0; n < 20'000; ++n)
    check({ any(random), any(random), any(random) });
  const int before = found;
  for (int n = 0; n < 20'000; ++n)
    check({ near(random), near(random), near(random) });
  EXPECT_GT(found, before);
}
