#include "CountNew.h"
#include "Haptics/ForceLimiter.h"
#include "Haptics/PassivityObserver.h"

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

// A device pushed through a spring and back: what it holds on the way, nothing at the end.
TEST(PassivityObserver, ReadsTheSpringsEnergyAndNoneAtTheEnd)
{
  hasp::PassivityObserver observer;
  const double k = 0.5;
  for (int n = 0; n <= 20'000; ++n)
  {
    const double x = 2.0 * std::sin(std::acos(-1.0) * n / 20'000);
    observer.Tick({ { x, 0, 0 }, { 1, 0, 0, 0 } }, { { -k * x, 0, 0 }, {} });
    if (n == 10'000)
    {
      EXPECT_NEAR(observer.Energy(), 0.5 * k * 4.0, 1e-3); // held for one of 1e4 steps
    }
  }
  EXPECT_NEAR(observer.Energy(), 0.0, 1e-3);
}

// Forces one step late push out more than they took in: sum of k v^2 T.
TEST(PassivityObserver, SeesTheEnergyOfALateForce)
{
  hasp::PassivityObserver observer;
  const double k = 5.0;
  double late = 0.0;
  for (int n = 0; n <= 100; ++n)
  {
    const double x = 2.0 * std::sin(std::acos(-1.0) * n / 100.0);
    observer.Tick({ { x, 0, 0 }, { 1, 0, 0, 0 } }, { { -k * late, 0, 0 }, {} });
    late = x;
  }
  EXPECT_LT(observer.Energy(), -0.1);
  EXPECT_LT(observer.Lowest(), -0.1);
  observer.Tick({ { NaN, 0, 0 }, { 1, 0, 0, 0 } }, {});
  EXPECT_TRUE(std::isfinite(observer.Energy()));
}

TEST(PassivityObserver, CountsTurns)
{
  hasp::PassivityObserver observer;
  for (int n = 0; n <= 100; ++n)
    observer.Tick({ glm::dvec3(0.0), hasp::TurnBy({ 0, 0, 0.01 * n }) }, { {}, { 0, 0, -30 } });
  EXPECT_NEAR(observer.Energy(), 30.0, 1e-9);
}

TEST(PassivityController, ActsOnALateSpringWithBoundedDamping)
{
  const auto run = [](int delay)
  {
    hasp::PassivityController controller;
    std::array<double, 4> late{};
    double worst = 0.0;
    for (int n = 0; n <= 2000; ++n)
    {
      const double x = 1.0 + std::cos(2.0 * std::acos(-1.0) * 20.0 * n * Tick);
      late[n % 4] = x;
      const double wanted = -2.0 * late[(n + 4 - delay) % 4];
      const hasp::Wrench out =
        controller.Tick({ { x, 0, 0 }, { 1, 0, 0, 0 } }, { { wanted, 0, 0 }, {} });
      worst = std::max(worst, std::abs(out.force.x - wanted));
    }
    EXPECT_EQ(controller.Activations() > 0, worst > 0.0);
    EXPECT_LE(worst, 0.005 * 2.0 * std::acos(-1.0) * 20.0 * 1.05) << "damping is bounded";
    return controller.Activations();
  };
  // On a cosine of 20 Hz and 1 mm at 2 N/mm a force held a tick gives back k v^2 T/2 = 8 mJ/s more
  // than it took, and 3 ticks late 56 mJ/s; 4 mJ are there to begin with.
  EXPECT_GT(run(3), 100U);
  EXPECT_THROW(hasp::PassivityController({ .damping = 0.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::PassivityController({ .allowance = NaN }), std::invalid_argument);
}

// Pressed and let go at the pace of a hand: nothing to control.
TEST(PassivityController, IsSilentOnWhatAHandDoesToASpring)
{
  hasp::PassivityController controller;
  for (int n = 0; n <= 2000; ++n)
  {
    const double x = 5.0 - 5.0 * std::cos(std::acos(-1.0) * n / 1000.0);
    const hasp::Wrench wanted{ { -0.33 * x, 0, 0 }, {} };
    const hasp::Wrench out = controller.Tick({ { x, 0, 0 }, { 1, 0, 0, 0 } }, wanted);
    ASSERT_EQ(out.force, wanted.force);
  }
  EXPECT_EQ(controller.Activations(), 0U);
}

TEST(ForceLimiter, ATickTakesNoMemory)
{
  hasp::ForceLimiter limiter;
  hasp::PassivityController controller;
  const std::size_t before = hasp::test::NewCount();
  for (int n = 0; n < 50; ++n)
    limiter.Limit(
      controller.Tick({ { 0.1 * n, 0, 0 }, { 1, 0, 0, 0 } }, { { -1, 0, 0 }, {} }), Tick);
  EXPECT_EQ(hasp::test::NewCount(), before);
}

} // namespace
