#include "AnalyticFields.h"
#include "Grid/Testing/CountNew.h"
#include "Haptics/MapField.h"
#include "Haptics/PointProxy.h"
#include "SampledDistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace
{

using hasp::PointProxy;
using hasp::ProxyTick;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
// Where a proxy counts as resting: 1e-4 of a step, here 0.1 mm; a slanted way there adds some.
constexpr double RestMm = 1e-4;

/// Free where z > |x| tan(slope), along y. A distance.
struct Groove : hasp::ImplicitField
{
  double slope;
  explicit Groove(double slope) : slope(slope) {}
  Sample At(const glm::dvec3& p) const noexcept override
  {
    const double side = p.x < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 n(-side * std::sin(this->slope), 0.0, std::cos(this->slope));
    return { glm::dot(p, n), n };
  }
};

/// A room's corner: free where x, y and z are all above 0.
struct Corner : hasp::ImplicitField
{
  Sample At(const glm::dvec3& p) const noexcept override
  {
    if (p.x <= p.y && p.x <= p.z)
      return { p.x, { 1, 0, 0 } };
    return p.y <= p.z ? Sample{ p.y, { 0, 1, 0 } } : Sample{ p.z, { 0, 0, 1 } };
  }
};

/// Grey values: any smooth function will do.
struct Hills : hasp::ImplicitField
{
  double level = 0.0;
  Sample At(const glm::dvec3& p) const noexcept override
  {
    return { 3.0 * (p.z - std::sin(0.5 * p.x) - this->level),
      { -1.5 * std::cos(0.5 * p.x), 0.0, 3.0 } };
  }
};

struct NoField : hasp::ImplicitField
{
  Sample At(const glm::dvec3&) const noexcept override { return { NaN, glm::dvec3(0.0) }; }
};

ProxyTick Ticks(
  PointProxy& proxy, const glm::dvec3& device, const hasp::ImplicitField& field, int ticks = 100)
{
  ProxyTick tick;
  for (int n = 0; n < ticks; ++n)
    tick = proxy.Tick(device, field);
  return tick;
}

PointProxy Placed(const glm::dvec3& at, const hasp::PointProxySettings& settings = {})
{
  PointProxy proxy(settings);
  proxy.Place(at);
  return proxy;
}

TEST(PointProxy, WhatIsNoSettingIsRefused)
{
  const auto refused = [](auto change)
  {
    hasp::PointProxySettings settings;
    change(settings);
    EXPECT_THROW(PointProxy{ settings }, std::invalid_argument);
  };
  refused([](auto& s) { s.stiffness = 0.0; });
  refused([](auto& s) { s.forceLimit = NaN; });
  refused([](auto& s) { s.radiusMm = -1.0; });
  refused([](auto& s) { s.friction = -0.1; });
  refused([](auto& s) { s.stepMm = HUGE_VAL; });
  refused([](auto& s) { s.steps = 0; });
}

TEST(PointProxy, PositionsAndFieldsThatAreNoneGiveNoForce)
{
  const hasp::test::HalfSpace ground;
  PointProxy proxy = Placed({ 0, 0, 1 });
  for (const glm::dvec3& bad : { glm::dvec3(NaN, 0, 0), glm::dvec3(0, HUGE_VAL, 0) })
  {
    const ProxyTick tick = proxy.Tick(bad, ground);
    EXPECT_EQ(tick.onDevice, glm::dvec3(0.0));
    EXPECT_FALSE(tick.settled);
    EXPECT_EQ(proxy.Position(), glm::dvec3(0, 0, 1));
  }
  const ProxyTick tick = proxy.Tick({ 0, 0, 1 }, NoField());
  EXPECT_EQ(tick.onDevice, glm::dvec3(0.0));
  EXPECT_FALSE(tick.settled);
}

TEST(PointProxy, FollowsWhereNothingIsInTheWay)
{
  const hasp::test::HalfSpace ground;
  PointProxy proxy = Placed({ 0, 0, 50 });
  const ProxyTick tick = proxy.Tick({ 20, -5, 30 }, ground);
  EXPECT_LT(glm::length(tick.proxy - glm::dvec3(20, -5, 30)), RestMm);
  EXPECT_FALSE(tick.touches);
  EXPECT_LT(glm::length(tick.onDevice), RestMm);
}

TEST(PointProxy, OnAPlaneItIsTheFootOfThePerpendicular)
{
  const hasp::test::HalfSpace ground;
  for (const double radius : { 0.0, 2.0 })
  {
    PointProxy proxy = Placed({ 0, 0, 5 }, { .radiusMm = radius });
    const ProxyTick tick = Ticks(proxy, { 7, -3, -4 }, ground);
    EXPECT_LT(glm::length(tick.proxy - glm::dvec3(7, -3, radius)), RestMm);
    EXPECT_TRUE(tick.touches && tick.settled);
    EXPECT_LT(glm::length(tick.normal - glm::dvec3(0, 0, 1)), 1e-12);
    EXPECT_NEAR(tick.onDevice.z, 4.0 * std::tanh(0.33 * (4.0 + radius) / 4.0), RestMm);
    EXPECT_LE(tick.samples, 3) << "at rest";
  }
}

TEST(PointProxy, OnABallItIsOnTheDevicesRay)
{
  const hasp::test::Ball ball(10.0);
  for (const double radius : { 0.0, 1.5 })
  {
    PointProxy proxy = Placed({ 0, 0, 20 }, { .radiusMm = radius });
    for (int n = 0; n <= 600; ++n) // half round it, 2 mm inside
    {
      const double angle = 0.005 * n;
      const glm::dvec3 ray(std::sin(angle), 0.3, std::cos(angle));
      const glm::dvec3 device = 8.0 * glm::normalize(ray);
      const ProxyTick tick = n == 0 ? Ticks(proxy, device, ball) : Ticks(proxy, device, ball, 4);
      // Steps of 0.1 mm bend by 0.1^2 / 2 R off the ball; where it rests they are small.
      ASSERT_LT(glm::length(tick.proxy - (10.0 + radius) * glm::normalize(ray)), 2e-3) << n;
      ASSERT_GE(glm::length(tick.proxy), 10.0 + radius - RestMm);
    }
  }
}

TEST(PointProxy, InAGrooveItIsOnTheEdgeBelowTheDevice)
{
  for (const double degrees : { 20.0, 45.0, 70.0 })
    for (const double radius : { 0.0, 1.0 })
    {
      const double slope = degrees * std::acos(-1.0) / 180.0;
      PointProxy proxy = Placed({ 1, 0, 30 }, { .radiusMm = radius });
      const ProxyTick tick = Ticks(proxy, { 0.2, 5, -10 }, Groove(slope), 300);
      // The ball's middle is radius / cos(slope) above the edge.
      EXPECT_LT(glm::length(tick.proxy - glm::dvec3(0, 5, radius / std::cos(slope))), 1e-3)
        << degrees << ' ' << radius;
    }
}

TEST(PointProxy, OnAFlankOfAGrooveItIsTheFootOfThePerpendicular)
{
  const double slope = 0.6;
  const Groove groove(slope);
  PointProxy proxy = Placed({ 10, 0, 30 });
  const glm::dvec3 n(-std::sin(slope), 0, std::cos(slope));
  const glm::dvec3 foot = glm::dvec3(std::cos(slope), 0, std::sin(slope)) * 12.0;
  const ProxyTick tick = Ticks(proxy, foot - 3.0 * n, groove, 300);
  EXPECT_LT(glm::length(tick.proxy - foot), RestMm * 3);
}

TEST(PointProxy, InACornerItIsTheCorner)
{
  PointProxy proxy = Placed({ 3, 4, 5 });
  const ProxyTick tick = Ticks(proxy, { -2, -1, -3 }, Corner(), 100);
  EXPECT_LT(glm::length(tick.proxy), 1e-3);
  EXPECT_LT(glm::length(glm::cross(tick.onDevice, glm::dvec3(2, 1, 3))), 1e-2);
}

// However far and however fast: the proxy remembers its side. A penalty of the same plate lets go.
TEST(PointProxy, AThinPlateHolds)
{
  for (const double thickness : { 0.2, 1.0, 5.0 })
    for (const double speed : { 0.1, 1.0, 3.0 })
    {
      const hasp::test::Plate plate(0.5 * thickness);
      PointProxy proxy = Placed({ 0, 0, 5 });
      ProxyTick tick;
      for (double z = 5.0; z > -30.0; z -= speed)
      {
        tick = proxy.Tick({ 0.5 * (5.0 - z), 0, z }, plate);
        ASSERT_GE(tick.proxy.z, 0.5 * thickness - RestMm) << thickness << ' ' << speed;
        ASSERT_LE(glm::length(tick.onDevice), 4.0);
      }
      tick = Ticks(proxy, { 17, 0, -30 }, plate, 20);
      EXPECT_NEAR(tick.proxy.x, 17.0, RestMm);
      EXPECT_NEAR(tick.proxy.z, 0.5 * thickness, RestMm);
    }
}

TEST(PointProxy, GreyValuesAreAsGoodAsDistances)
{
  Hills hills;
  PointProxy proxy = Placed({ 0, 0, 10 });
  for (double x = -10.0; x < 10.0; x += 0.02)
  {
    const ProxyTick tick = Ticks(proxy, { x, 1, -1.5 }, hills, 2);
    const glm::dvec3& p = tick.proxy;
    ASSERT_NEAR(p.z, std::sin(0.5 * p.x), 1e-2) << x; // tangents of 0.1 mm, bent by 1/4 /mm
  }
  // The device pulls along the normal, once at rest.
  const ProxyTick tick = Ticks(proxy, { 2.0, 1, -1.5 }, hills, 200);
  const glm::dvec3 n = hills.At(tick.proxy).gradient;
  EXPECT_LT(glm::length(glm::cross(glm::normalize(n), glm::normalize(tick.onDevice))), 0.01);
}

// The isovalue moves: a tick later the proxy is on the new surface.
TEST(PointProxy, AnIsovalueThatChangesIsFeltInATick)
{
  Hills hills;
  PointProxy proxy = Placed({ 0, 0, 10 });
  Ticks(proxy, { 2, 1, -1 }, hills);
  for (const double level : { 0.5, 1.5, -0.5 })
  {
    hills.level = level;
    const glm::dvec3 p = proxy.Tick({ 2, 1, -1 }, hills).proxy;
    EXPECT_NEAR(p.z, std::sin(0.5 * p.x) + level, 1e-2) << level;
  }
}

// A ball of 8 mm baked on a turned grid of 0.7 x 1.1 x 1.6 mm, and started far outside of its band.
TEST(PointProxy, BakedMapsHoldAsTheirBodiesDo)
{
  const hasp::testing::SampledDistance ball(
    hasp::testing::Ball(glm::dvec3(0.0), 8.0), hasp::testing::SkewGrid({ 64, 48, 32 }));
  const hasp::MapField field(
    std::make_shared<hasp::DistanceMap>(ball.View(), hasp::DistanceMapSettings{ .rangeMm = 3.0 }));
  PointProxy proxy = Placed({ 0, 3, 16 });
  for (int n = 0; n < 60; ++n) // at 1 mm a tick, past its middle
    proxy.Tick({ 0, 3, 16.0 - std::min(n, 10) * 1.0 }, field);
  const glm::dvec3 ray = glm::normalize(glm::dvec3(0, 3, 6));
  // Trilinear: h^2 / 8 R = 0.04 mm off with 1.6 mm; int16 adds nothing.
  EXPECT_NEAR(glm::length(proxy.Position()), 8.0, 0.05);
  EXPECT_LT(glm::length(glm::cross(proxy.Position() / 8.0, ray)), 0.05);
  for (int n = 0; n < 40; ++n)
    proxy.Tick({ 0, 3, 16.0 - 0.5 * n }, field); // past the middle: it slides round
  EXPECT_NEAR(glm::length(proxy.Position()), 8.0, 0.05);
}

// Fields that are flat somewhere: outside a proxy goes on step by step and is still stopped.
TEST(PointProxy, FlatFieldsStopItWhereTheySlope)
{
  struct Flat : hasp::ImplicitField
  {
    Sample At(const glm::dvec3& p) const noexcept override
    {
      return p.z > 1.0 ? Sample{ 1.0, glm::dvec3(0.0) } : Sample{ p.z, { 0, 0, 1 } };
    }
  } flat;
  PointProxy proxy = Placed({ 0, 0, 40 });
  EXPECT_LT(Ticks(proxy, { 0, 0, 30 }, flat, 1).proxy.z, 37.0) << "32 steps of 0.1 mm";
  EXPECT_NEAR(Ticks(proxy, { 0, 0, -3 }, flat).proxy.z, 0.0, RestMm);
}

// mu = tan of the cone: at a depth h the proxy rests while the device is less than mu h aside.
TEST(PointProxy, FrictionRestsWithinItsConeAndSlidesBeyondIt)
{
  const hasp::test::HalfSpace ground;
  constexpr double Mu = 0.4, Depth = 2.0;
  PointProxy proxy = Placed({ 0, 0, 5 }, { .friction = Mu });
  Ticks(proxy, { 0, 0, -Depth }, ground);
  for (double aside = 0.0; aside < 3.0; aside += 0.01)
  {
    const ProxyTick tick = proxy.Tick({ aside, 0, -Depth }, ground);
    ASSERT_NEAR(tick.proxy.x, std::max(0.0, aside - Mu * Depth), 2 * RestMm) << aside;
    ASSERT_LE(-tick.onDevice.x, Mu * tick.onDevice.z + RestMm);
  }
  const double rests = proxy.Position().x;
  for (double aside = 3.0; aside > 3.0 - 1.9 * Mu * Depth; aside -= 0.01)
  {
    EXPECT_NEAR(proxy.Tick({ aside, 0, -Depth }, ground).proxy.x, rests, 2 * RestMm);
  }
}

TEST(NearestAbove, AgreesWithSearch)
{
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  for (int trial = 0; trial < 300; ++trial)
  {
    const int planes = trial % 4;
    glm::dvec3 at[3], n[3];
    for (int i = 0; i < planes; ++i)
    {
      at[i] = 0.3 * vector();
      n[i] = glm::normalize(vector());
    }
    const glm::dvec3 goal = vector(), x = hasp::NearestAbove(goal, at, n, planes);
    for (int i = 0; i < planes; ++i)
      ASSERT_GE(glm::dot(x - at[i], n[i]), -1e-6);
    for (int guess = 0; guess < 200; ++guess)
    {
      const glm::dvec3 other = x + 0.2 * vector();
      bool above = true;
      for (int i = 0; i < planes; ++i)
        above = above && glm::dot(other - at[i], n[i]) >= 0.0;
      if (above)
      {
        ASSERT_GE(glm::length(other - goal), glm::length(x - goal) - 1e-9);
      }
    }
  }
}

TEST(PointProxy, ATickTakesNoMemory)
{
  const Groove groove(0.8);
  PointProxy proxy = Placed({ 0, 0, 5 }, { .friction = 0.2 });
  const std::size_t before = hasp::test::NewCount();
  for (int n = 0; n < 100; ++n)
    proxy.Tick({ 0.1 * n, 0, 3.0 - 0.1 * n }, groove);
  EXPECT_EQ(hasp::test::NewCount(), before);
}

} // namespace
