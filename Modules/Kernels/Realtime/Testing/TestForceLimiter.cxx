#include "Grid/Testing/CountNew.h"
#include "Realtime/ForceLimiter.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Tick = 0.001;

hasp::ForceLimits NoRamp()
{
  hasp::ForceLimits limits;
  limits.rampInS = 0.0;
  return limits;
}

TEST(ForceLimiter, WhatIsNoLimitIsRefused)
{
  EXPECT_THROW(hasp::ForceLimiter({ .force = -1.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::ForceLimiter({ .torque = NaN }), std::invalid_argument);
  EXPECT_THROW(hasp::ForceLimiter({ .forceSlew = 0.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::ForceLimiter({ .torqueSlew = NaN }), std::invalid_argument);
  EXPECT_THROW(hasp::ForceLimiter({ .rampInS = HUGE_VAL }), std::invalid_argument);
}

// Whatever comes in, what goes out is finite, within the limit and within the slew.
TEST(ForceLimiter, NothingWrongEverLeaves)
{
  hasp::ForceLimiter limiter(NoRamp());
  const hasp::ForceLimits& limits = limiter.Limits();
  std::mt19937 random(5);
  std::uniform_int_distribution<int> kind(0, 9);
  std::normal_distribution<double> normal;
  const auto number = [&]
  {
    switch (kind(random))
    {
      case 0:
        return NaN;
      case 1:
        return std::numeric_limits<double>::infinity();
      case 2:
        return -std::numeric_limits<double>::max();
      case 3:
        return std::numeric_limits<double>::denorm_min();
      default:
        return 20.0 * normal(random);
    }
  };
  hasp::Wrench last;
  for (int n = 0; n < 20'000; ++n)
  {
    const hasp::Wrench wanted{ { number(), 10 * normal(random), 0 }, { 0, number(), number() } };
    const double seconds = n % 100 == 7 ? NaN : Tick;
    const hasp::Wrench out = limiter.Limit(wanted, seconds);
    ASSERT_TRUE(hasp::IsFinite(out));
    ASSERT_LE(glm::length(out.force), limits.force * (1.0 + 1e-15));
    ASSERT_LE(glm::length(out.torque), limits.torque * (1.0 + 1e-15));
    ASSERT_LE(glm::length(out.force) - glm::length(last.force), limits.forceSlew * Tick + 1e-12);
    last = out;
  }
}

TEST(ForceLimiter, ClampsByNormAndKeepsTheDirection)
{
  hasp::ForceLimiter limiter(NoRamp());
  const hasp::Wrench out = limiter.Limit({ { 30, 40, 0 }, { 0, 0, -1000 } }, 1.0);
  EXPECT_NEAR(out.force.x, 8.0 * 0.6, 1e-12);
  EXPECT_NEAR(out.force.y, 8.0 * 0.8, 1e-12);
  EXPECT_NEAR(out.torque.z, -180.0, 1e-12);
}

TEST(ForceLimiter, GrowsByTheSlewAndShrinksAtOnce)
{
  hasp::ForceLimiter limiter(NoRamp());
  EXPECT_NEAR(limiter.Limit({ { 8, 0, 0 }, {} }, Tick).force.x, 2.0, 1e-12);
  EXPECT_NEAR(limiter.Limit({ { 8, 0, 0 }, {} }, Tick).force.x, 4.0, 1e-12);
  EXPECT_NEAR(limiter.Limit({ { 1, 0, 0 }, {} }, Tick).force.x, 1.0, 1e-12);
  EXPECT_NEAR(limiter.Limit({ { -8, 0, 0 }, {} }, Tick).force.x, -2.0, 1e-12) << "through zero";
  EXPECT_EQ(limiter.Limit({ { NaN, 0, 0 }, {} }, Tick).force.x, 0.0);
}

// A slew without a bound is allowed; without time nothing grows all the same.
TEST(ForceLimiter, WithoutTimeNothingGrowsHoweverFastItMay)
{
  hasp::ForceLimits limits = NoRamp();
  limits.forceSlew = limits.torqueSlew = std::numeric_limits<double>::infinity();
  hasp::ForceLimiter limiter(limits);
  for (const double seconds : { 0.0, NaN, -1.0 })
  {
    const hasp::Wrench out = limiter.Limit({ { 5, 0, 0 }, { 0, 50, 0 } }, seconds);
    EXPECT_EQ(out.force, glm::dvec3(0.0)) << seconds;
    EXPECT_EQ(out.torque, glm::dvec3(0.0)) << seconds;
  }
  EXPECT_EQ(limiter.Limit({ { 5, 0, 0 }, {} }, Tick).force.x, 5.0);
}

// Torque has a slew, a limit and a ramp of its own.
TEST(ForceLimiter, TorqueIsLimitedAsForceIs)
{
  hasp::ForceLimiter slewed(NoRamp());
  EXPECT_NEAR(slewed.Limit({ {}, { 0, 0, 180 } }, Tick).torque.z, 60.0, 1e-12);
  EXPECT_NEAR(slewed.Limit({ {}, { 0, 0, 180 } }, Tick).torque.z, 120.0, 1e-12);
  EXPECT_NEAR(slewed.Limit({ {}, { 0, 0, 10 } }, Tick).torque.z, 10.0, 1e-12);
  hasp::ForceLimits limits;
  limits.torqueSlew = 1e9;
  hasp::ForceLimiter ramped(limits);
  for (int n = 1; n <= 500; ++n)
    ASSERT_NEAR(ramped.Limit({ {}, { 0, 900, 0 } }, Tick).torque.y, 180.0 * n / 500.0, 1e-9);
}

TEST(ForceLimiter, AfterARestartForceGrowsFromZero)
{
  hasp::ForceLimiter limiter(NoRamp());
  for (int n = 0; n < 10; ++n)
    limiter.Limit({ { 8, 0, 0 }, { 0, 0, 180 } }, Tick);
  limiter.Restart();
  const hasp::Wrench out = limiter.Limit({ { 8, 0, 0 }, { 0, 0, 180 } }, Tick);
  EXPECT_NEAR(out.force.x, 2.0, 1e-12);
  EXPECT_NEAR(out.torque.z, 60.0, 1e-12);
}

TEST(ForceLimiter, RampsInAfterTheStart)
{
  hasp::ForceLimits limits;
  limits.forceSlew = 1e9;
  hasp::ForceLimiter limiter(limits);
  for (int round = 0; round < 2; ++round)
  {
    for (int n = 1; n <= 500; ++n)
      ASSERT_NEAR(limiter.Limit({ { 0, 100, 0 }, {} }, Tick).force.y, 8.0 * n / 500.0, 1e-9);
    EXPECT_NEAR(limiter.Limit({ { 0, 100, 0 }, {} }, Tick).force.y, 8.0, 1e-12);
    limiter.Restart();
  }
}

TEST(ForceLimiter, ATickTakesNoMemory)
{
  hasp::ForceLimiter limiter;
  const std::size_t before = hasp::test::NewCount();
  for (int n = 0; n < 50; ++n)
    limiter.Limit({ { -1, 0.1 * n, 0 }, {} }, Tick);
  EXPECT_EQ(hasp::test::NewCount(), before);
}

} // namespace
