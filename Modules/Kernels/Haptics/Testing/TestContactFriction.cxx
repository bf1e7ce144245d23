#include "AnalyticFields.h"
#include "Grid/Testing/CountNew.h"
#include "Haptics/ContactFriction.h"
#include "Haptics/FieldContact.h"
#include "Haptics/Solve6.h"
#include "Haptics/VirtualCoupling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using hasp::ContactFriction;
using hasp::RigidPose;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Mu = 0.3;

RigidPose At(double x, double y, double z)
{
  return { { x, y, z }, { 1, 0, 0, 0 } };
}

/// A foot on the ground, with friction, in a coupling.
struct Rubbed : hasp::ToolContact
{
  const hasp::test::HalfSpace ground;
  hasp::FieldContact foot{ std::vector<glm::dvec3>{
                             { 10, 10, 0 }, { -10, 10, 0 }, { 10, -10, 0 }, { -10, -10, 0 } },
    10.0, ground };
  ContactFriction friction;
  hasp::VirtualCoupling coupling;

  explicit Rubbed(double coefficient) : friction({ .coefficient = coefficient }) {}
  Answer At(const RigidPose& tool) noexcept override
  {
    Answer answer = this->foot.At(tool);
    this->friction.Add(tool, answer);
    return answer;
  }
  hasp::Wrench Ticks(const RigidPose& device, int ticks = 1)
  {
    hasp::Wrench last;
    for (int n = 0; n < ticks; ++n)
    {
      last = this->coupling.Tick(device, *this).onDevice;
      this->friction.Settle(this->coupling.Tool());
    }
    return last;
  }
};

TEST(ContactFriction, WhatIsNoSettingIsRefused)
{
  EXPECT_THROW(ContactFriction({ .coefficient = -0.1 }), std::invalid_argument);
  EXPECT_THROW(ContactFriction({ .coefficient = NaN }), std::invalid_argument);
  EXPECT_THROW(ContactFriction({ .coefficient = 0.1, .stiffness = 0.0 }), std::invalid_argument);
}

TEST(ContactFriction, WithoutCoefficientNothingIsAdded)
{
  Rubbed rubbed(0.0);
  rubbed.Ticks(At(0, 0, -3), 100);
  EXPECT_NEAR(rubbed.Ticks(At(2, 0, -3), 50).force.x, 0.0, 1e-9);
  EXPECT_FALSE(rubbed.friction.Sticks());
}

// Sticking, it is a spring of 0.5 N/mm in series with the coupling's 0.33.
TEST(ContactFriction, SticksAsASpringInSeries)
{
  Rubbed rubbed(Mu);
  rubbed.Ticks(At(0, 0, -6), 100);
  const double force = rubbed.Ticks(At(0.5, 0, -6), 100).force.x;
  // The coupling's secant falls where the normal force draws it; its own share is what is meant.
  const hasp::Wrench pull =
    rubbed.coupling.GetSettings().spring.Pull(At(0.5, 0, -6), rubbed.coupling.Tool());
  EXPECT_NEAR(force, -pull.force.x, 1e-9);
  EXPECT_NEAR(force, -0.5 * rubbed.coupling.Tool().position.x, 1e-3);
  EXPECT_LT(-force, Mu * rubbed.Ticks(At(0.5, 0, -6)).force.z);
}

TEST(ContactFriction, SlidesAtMuTimesTheNormalForce)
{
  Rubbed rubbed(Mu);
  rubbed.Ticks(At(0, 0, -3), 100);
  hasp::Wrench wrench;
  for (int n = 1; n <= 500; ++n)
    wrench = rubbed.Ticks(At(0.008 * n, 0.006 * n, -3));
  const double normal = wrench.force.z;
  // One tick behind, 0.01 mm: of 0.5 N/mm that friction has, and 0.33 that the coupling has.
  EXPECT_NEAR(std::hypot(wrench.force.x, wrench.force.y), Mu * normal, 0.0083);
  EXPECT_NEAR(wrench.force.y / wrench.force.x, 0.75, 0.01) << "against the motion";
}

TEST(ContactFriction, LetsGoWithTheContact)
{
  Rubbed rubbed(Mu);
  rubbed.Ticks(At(0, 0, -3), 100);
  rubbed.Ticks(At(1, 0, -3), 10);
  EXPECT_TRUE(rubbed.friction.Sticks());
  EXPECT_LT(glm::length(rubbed.Ticks(At(1, 0, 3), 20).force), 1e-9);
  EXPECT_FALSE(rubbed.friction.Sticks());
}

// A hand that rubs to and fro gets no energy out of it, and loses mu N for each mm.
TEST(ContactFriction, TakesEnergyAndGivesNone)
{
  Rubbed rubbed(Mu);
  hasp::Wrench held = rubbed.Ticks(At(0, 0, -3), 100);
  double energy = 0.0, way = 0.0, last = 0.0;
  for (int n = 1; n <= 8000; ++n)
  {
    const double x = 4.0 * std::sin(2.0 * std::acos(-1.0) * n / 2000.0);
    energy -= held.force.x * (x - last);
    way += std::abs(x - last);
    last = x;
    held = rubbed.Ticks(At(x, 0, -3));
  }
  const double normal = held.force.z;
  EXPECT_GT(energy, 0.5 * Mu * normal * way); // each turn is 1.2 N of spring before it slides again
  EXPECT_LT(energy, Mu * normal * way);
}

/// 10 N upwards that press at (3, 4, 0) from the tool's origin, world.
hasp::ToolContact::Answer PressedAt(double x, double y)
{
  hasp::ToolContact::Answer answer;
  answer.sums.contact.force = { 0, 0, 10 };
  answer.sums.contact.torque = glm::cross(glm::dvec3(x, y, 0), answer.sums.contact.force);
  return answer;
}

// The place that is held is the middle of pressure, on the tool: 0.5 N/mm along the surface and
// none along its normal, with the arm it has, and the secant's stiffness where it slides.
TEST(ContactFriction, PullsWhereItIsPressedAlongTheSurface)
{
  ContactFriction friction({ .coefficient = Mu });
  RigidPose tool{ { 7, -2, 1 }, hasp::TurnBy({ 0.4, -0.3, 1.0 }) };
  hasp::ToolContact::Answer answer = PressedAt(3, 4);
  friction.Add(tool, answer);
  EXPECT_EQ(answer.sums.contact.force, glm::dvec3(0, 0, 10)) << "nothing is held yet";
  friction.Settle(tool);
  tool.position += glm::dvec3(0.1, 0.0, 1.0);
  answer = PressedAt(3, 4);
  friction.Add(tool, answer);
  EXPECT_LT(glm::length(answer.sums.contact.force - glm::dvec3(-0.05, 0, 10)), 1e-12);
  EXPECT_LT(glm::length(answer.sums.contact.torque - glm::dvec3(40, -30, 0.2)), 1e-12);
  EXPECT_NEAR(answer.sums.matrix[hasp::UpperIndex(0, 0)], 0.5, 1e-12);

  tool.position.x += 99.9; // 50 N of spring, of which 3 are borne
  answer = PressedAt(3, 4);
  friction.Add(tool, answer);
  EXPECT_NEAR(answer.sums.contact.force.x, -3.0, 1e-12);
  EXPECT_NEAR(answer.sums.matrix[hasp::UpperIndex(0, 0)], 0.5 * 3.0 / 50.0, 1e-12);
  // It slides, and holds from now on where it is pressed now.
  answer = PressedAt(-5, 1);
  friction.Add(tool, answer);
  friction.Settle(tool);
  answer = PressedAt(-5, 1);
  friction.Add(tool, answer);
  EXPECT_NEAR(answer.sums.contact.force.x, -3.0, 1e-12);
  EXPECT_NEAR(answer.sums.contact.torque.z, 3.0, 1e-12);
}

// What it adds to the matrix holds back, and pushes nothing along the normal.
TEST(ContactFriction, MatrixIsPositiveSemidefinite)
{
  Rubbed rubbed(Mu);
  rubbed.Ticks(At(0, 0, -3), 100);
  const RigidPose tool{ { 0.2, 0.1, -0.02 }, hasp::TurnBy({ 0.01, 0.02, 0.3 }) };
  const hasp::Symmetric6 with = rubbed.At(tool).sums.matrix;
  const hasp::Symmetric6 without = rubbed.foot.At(tool).sums.matrix;
  hasp::Symmetric6 added{};
  for (std::size_t i = 0; i < 21; ++i)
    added[i] = with[i] - without[i];
  for (int trial = 0; trial < 729; ++trial)
  {
    hasp::Vector6 x;
    for (int i = 0, rest = trial; i < 6; ++i, rest /= 3)
      x[i] = (rest % 3 - 1) * (i < 3 ? 1.0 : 0.1);
    const hasp::Vector6 product = hasp::Multiply6(added, x);
    double form = 0.0;
    for (int i = 0; i < 6; ++i)
      form += x[i] * product[i];
    ASSERT_GE(form, -1e-9);
  }
  EXPECT_NEAR(added[hasp::UpperIndex(2, 2)], 0.0, 1e-9);
  EXPECT_NEAR(added[hasp::UpperIndex(0, 0)], 0.5, 1e-9);
}

TEST(ContactFriction, ATickTakesNoMemory)
{
  Rubbed rubbed(Mu);
  const std::size_t before = hasp::test::NewCount();
  for (int n = 0; n < 100; ++n)
    rubbed.Ticks(At(0.05 * n, 0, 1.0 - 0.04 * n));
  EXPECT_EQ(hasp::test::NewCount(), before);
}

} // namespace
