#include "Studies/FracturedBlocks.h"
#include "Studies/SimulatedOperator.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using hasp::OperatorHelp;
using hasp::OperatorResult;
using hasp::OperatorSettings;
using hasp::OperatorTask;
using hasp::RigidPose;

const OperatorTask& Task()
{
  static const OperatorTask task = hasp::TaskOf(hasp::MakeFracturedBlocks(
    { .sideMm = { 20, 16, 16 }, .spacingMm = 0.6, .points = 1024, .coarsest = 64, .seed = 5 }));
  return task;
}

RigidPose Off(const glm::dvec3& mm, const glm::dvec3& degrees)
{
  return { Task().truth.position + mm,
    hasp::TurnBy(glm::radians(degrees)) * Task().truth.orientation };
}

double ErrorMm(const OperatorResult& result)
{
  return hasp::RmsWay(Task().moved, Task().truth, result.pose);
}

void ExpectSound(const OperatorResult& result)
{
  EXPECT_EQ(result.overLimit, 0U);
  EXPECT_EQ(result.notFinite, 0U);
  EXPECT_LE(result.largestForceN, OperatorHelp::TouchSteps().limits.force * (1.0 + 1e-9));
  EXPECT_TRUE(std::isfinite(ErrorMm(result)));
}

TEST(SimulatedOperator, WhatNobodyIsLikeIsRefused)
{
  const auto refused = [](auto change)
  {
    OperatorSettings settings;
    change(settings);
    EXPECT_THROW(hasp::PutInPlace(Task(), Task().truth, settings, {}, 1), std::invalid_argument);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([=](auto& s) { s.speedMmPerS = nan; });
  refused([](auto& s) { s.aimMm = -1.0; });
  refused([](auto& s) { s.comfortN = s.pushN; });
  refused([](auto& s) { s.patience = 0; });
  refused([](auto& s) { s.givesUpS = HUGE_VAL; });
  refused([](auto& s) { s.hand.massKg = 0.0; });
  refused([](auto& s) { s.hand.damperNsPerMm = 10.0; }); // too long a step for it
  refused([=](auto& s) { s.hand.tremorMm = nan; });
  EXPECT_THROW(
    hasp::PutInPlace(Task(), Task().truth, {}, { .levels = 0 }, 1), std::invalid_argument);
  EXPECT_THROW(hasp::PutInPlace(Task(), Off({ nan, 0, 0 }, glm::dvec3(0.0)), {}, {}, 1),
    std::invalid_argument);
  OperatorTask nothing = Task();
  nothing.moved.clear();
  EXPECT_THROW(hasp::PutInPlace(nothing, Task().truth, {}, {}, 1), std::invalid_argument);
  OperatorTask crooked = Task();
  crooked.push = { 0, 0, -2 };
  EXPECT_THROW(hasp::PutInPlace(crooked, Task().truth, {}, {}, 1), std::invalid_argument);
}

TEST(SimulatedOperator, OfOneSeedDoesTheSameAgain)
{
  const RigidPose start = Off({ 3, -2, 12 }, { 4, -5, 3 });
  OperatorSettings settings = hasp::MakeOperator(4);
  settings.givesUpS = 4.0;
  const OperatorResult a = hasp::PutInPlace(Task(), start, settings, {}, 8);
  const OperatorResult b = hasp::PutInPlace(Task(), start, settings, {}, 8);
  const OperatorResult c = hasp::PutInPlace(Task(), start, settings, {}, 9);
  EXPECT_EQ(a.pose, b.pose);
  EXPECT_EQ(a.seconds, b.seconds);
  EXPECT_NE(a.pose, c.pose);
}

TEST(SimulatedOperator, WhoAimsRightWithSnapToFitEndsAtTheTruth)
{
  OperatorSettings settings;
  settings.aimMm = settings.aimDegrees = 0.0;
  const OperatorResult result =
    hasp::PutInPlace(Task(), Off({ 3, -2, 12 }, { 4, -5, 3 }), settings, { .snap = true }, 3);
  ExpectSound(result);
  EXPECT_TRUE(result.content);
  EXPECT_LT(result.seconds, settings.givesUpS);
  // The push, 1.5 N, presses the face of 320 mm^2 in by 0.1 mm: F / (k A).
  EXPECT_LT(ErrorMm(result), 0.25);
}

TEST(SimulatedOperator, FeelsItsWayFromAnAimThatIsOff)
{
  int content = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    const OperatorResult result = hasp::PutInPlace(
      Task(), Off({ 3, -2, 12 }, { 4, -5, 3 }), hasp::MakeOperator(seed), {}, seed);
    ExpectSound(result);
    content += result.content;
    if (result.content)
    {
      EXPECT_LT(ErrorMm(result), 0.5) << seed; // where it aims is 1 to 3 mm off
    }
  }
  EXPECT_GE(content, 3);
}

// It is carried from there to where it aims; with an aim that is as far off no place fits, and it
// does not say that one does.
TEST(SimulatedOperator, FarOffAndTurnedItEndsWithoutAFitAndSaysSo)
{
  OperatorSettings settings;
  settings.aimDegrees = 90.0;
  settings.givesUpS = 12.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    settings.aimMm = seed <= 2 ? 40.0 : 3.0; // beside the block, and askew on it
    const OperatorResult result =
      hasp::PutInPlace(Task(), Off({ 25, -20, 24 }, { 0, 90, 0 }), settings, {}, seed);
    ExpectSound(result);
    EXPECT_FALSE(result.content);
    EXPECT_GE(result.seconds, settings.givesUpS - 0.01);
    EXPECT_GT(ErrorMm(result), 2.0);
  }
}

// It begins inside of what it is put on, with the stiffest contact and a heavy hand.
TEST(SimulatedOperator, StaysWithinLimitsWhereAllIsWrong)
{
  OperatorSettings settings;
  settings.hand.massKg = 2.0;
  settings.hand.tremorMm = 2.0;
  settings.speedMmPerS = 500.0;
  settings.approachMmPerS = 100.0;
  settings.pushN = 9.0;
  settings.comfortN = 15.0;
  settings.givesUpS = 3.0;
  OperatorHelp help;
  help.step.contact.stiffness = 10.0F;
  help.snap = true;
  ExpectSound(hasp::PutInPlace(Task(), Off({ 1, 1, -8 }, { 10, 0, 20 }), settings, help, 2));
}

} // namespace
