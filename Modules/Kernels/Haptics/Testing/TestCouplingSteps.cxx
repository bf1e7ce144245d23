// What one tick of the coupling does with an answer, in closed form: contacts that say what they
// are told to.
#include "Haptics/VirtualCoupling.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

using hasp::CouplingTick;
using hasp::RigidPose;
using hasp::TurnBy;

struct Told : hasp::ToolContact
{
  Answer answer;
  int asked = 0;
  Answer At(const RigidPose&) noexcept override
  {
    ++this->asked;
    return this->answer;
  }
};

RigidPose At(double x, double y, double z)
{
  return { { x, y, z }, { 1, 0, 0, 0 } };
}

/// One step a tick, of travel and clearance and no more, for the tool's farthest point.
TEST(CouplingSteps, NoneIsLongerThanTravelAndClearance)
{
  hasp::VirtualCouplingSettings settings;
  settings.steps = 1;
  settings.travelMm = 0.1;
  settings.radiusMm = 10.0;
  Told told;
  told.answer.clearanceMm = 0.3;
  hasp::VirtualCoupling moved(settings), turned(settings);
  EXPECT_EQ(moved.Tick(At(3, 0, 4), told).status, CouplingTick::Travelling);
  EXPECT_NEAR(glm::length(moved.Tool().position), 0.4, 1e-12);
  EXPECT_NEAR(moved.Tool().position.z, 0.32, 1e-9);
  turned.Tick({ glm::dvec3(0.0), TurnBy({ 0, 1, 0 }) }, told);
  EXPECT_NEAR(hasp::RotationVector(turned.Tool().orientation).y, 0.04, 1e-12);
}

TEST(CouplingSteps, TurnsAreAboutTheWorldsAxes)
{
  Told told;
  told.answer.clearanceMm = 1e6;
  hasp::VirtualCoupling coupling;
  const glm::dquat held = TurnBy({ 0.3, 1.2, -0.5 });
  coupling.Place({ glm::dvec3(0.0), held });
  const glm::dquat device = TurnBy({ 0.5, 0, 0 }) * held;
  coupling.Tick({ glm::dvec3(0.0), device }, told);
  const glm::dquat left = device * glm::conjugate(coupling.Tool().orientation);
  EXPECT_LT(glm::length(hasp::RotationVector(left)), 1e-9);
  EXPECT_NEAR(glm::length(coupling.Tool().orientation), 1.0, 1e-15);
}

/// Attraction turns the tool until the spring's torque is as large: 120 tanh(300 a / 120) = 30.
TEST(CouplingSteps, AttractionPullsAndTurns)
{
  Told told;
  told.answer.sums.attractedArea = 1.0;
  told.answer.sums.attraction = { { 0, 0.5, 0 }, { 0, 0, 30 } };
  hasp::VirtualCoupling coupling;
  for (int n = 0; n < 200; ++n)
    coupling.Tick({}, told);
  EXPECT_NEAR(hasp::RotationVector(coupling.Tool().orientation).z, 0.4 * std::atanh(0.25), 1e-3);
  EXPECT_NEAR(coupling.Tool().position.y, 4.0 / 0.33 * std::atanh(0.5 / 4.0), 0.02);
}

/// What attracts is asked again where the tool has gone, also in free space; and is then at rest.
TEST(CouplingSteps, WhatAttractsIsAskedTwice)
{
  Told told;
  told.answer.clearanceMm = 1e6;
  told.answer.sums.attractedArea = 1.0;
  told.answer.sums.attraction.force.z = -0.3;
  hasp::VirtualCoupling coupling;
  const CouplingTick tick = coupling.Tick({}, told);
  EXPECT_EQ(tick.evaluations, 2);
  EXPECT_EQ(told.asked, 2);
  EXPECT_EQ(tick.status, CouplingTick::Good);
  EXPECT_LT(tick.residual, 0.05);
}

TEST(CouplingSteps, TheResidualIsTheWorseOfForceAndTorque)
{
  hasp::VirtualCouplingSettings settings;
  settings.steps = 1;
  Told told;
  told.answer.sums.contact = { { 1, 0, 0 }, { 0, 0, 60 } };
  EXPECT_NEAR(hasp::VirtualCoupling(settings).Tick({}, told).residual, 0.5, 1e-12);
  told.answer.sums.contact = { { 3, 0, 0 }, { 0, 0, 60 } };
  EXPECT_NEAR(hasp::VirtualCoupling(settings).Tick({}, told).residual, 0.75, 1e-12);
}

TEST(CouplingSteps, WithoutTimeThereIsNoSecondAnswer)
{
  Told told;
  told.answer.sums.contact.force.z = 3.0;
  hasp::VirtualCoupling patient, hurried;
  EXPECT_GT(patient.Tick({}, told).evaluations, 1);
  told.asked = 0;
  told.answer.last = true;
  const CouplingTick tick = hurried.Tick({}, told);
  EXPECT_EQ(tick.evaluations, 1);
  EXPECT_EQ(told.asked, 1);
  EXPECT_EQ(tick.status, CouplingTick::Travelling);
}

TEST(CouplingSteps, APoseHasATurnOfLengthOne)
{
  EXPECT_TRUE(hasp::IsPose({ glm::dvec3(1.0), { 1.0005, 0, 0, 0 } }));
  EXPECT_FALSE(hasp::IsPose({ glm::dvec3(1.0), { 1.002, 0, 0, 0 } }));
  EXPECT_FALSE(hasp::IsPose({ glm::dvec3(1.0), { 0, 0, 0.998, 0 } }));
}

} // namespace
