#include "Evaluation/StepAndGap.h"
#include "PartMeshes.h"

#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

namespace
{

using hasp::MeasuredSurface;
using hasp::RigidPose;

MeasuredSurface Box(const glm::dvec3& low, const glm::dvec3& high)
{
  return MeasuredSurface(parttest::Blocks(
    { low.x, high.x }, { low.y, high.y }, { low.z, high.z }, [](int, int, int) { return true; }));
}

RigidPose AnyPose(int seed)
{
  const parttest::Motion motion = parttest::AnyMotion(seed);
  return { motion.to, glm::quat_cast(motion.turn) };
}

/// Two halves of a plate of 20 x 20 x 4 mm, broken at x = 10.
struct Halves
{
  MeasuredSurface left = Box({ 0, 0, 0 }, { 10, 20, 4 }), right = Box({ 10, 0, 0 }, { 20, 20, 4 });

  hasp::StepAndGap Measure(const glm::dvec3& shift, int seed = 1) const
  {
    const RigidPose world = AnyPose(seed);
    return hasp::MeasureStepAndGap(this->left, world, this->right, world * RigidPose{ shift });
  }
};

TEST(StepAndGap, SettingsPosesAndPairsOutOfRangeAreRefused)
{
  const MeasuredSurface box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const auto refused = [](auto&& make) { EXPECT_THROW(make(), std::invalid_argument); };
  for (const hasp::StepAndGapSettings& s :
    { hasp::StepAndGapSettings{ 0.0 }, hasp::StepAndGapSettings{ 51.0 },
      hasp::StepAndGapSettings{ 5.0, 0.0 }, hasp::StepAndGapSettings{ 5.0, 2.0, 1.0 } })
    refused([&] { return hasp::MeasureStepAndGap(box, {}, box, {}, s); });
  refused([&] { return hasp::MeasureStepAndGap(box, { {}, { 2, 0, 0, 0 } }, box, {}); });
  refused([] { return hasp::MeasureTrueStepAndGap({}, {}, {}); });
  const hasp::FacePair good{ {}, {}, { 0, 0, 1 }, { 1, 0, 0 } };
  for (int fault = 0; fault < 4; ++fault)
  {
    hasp::FacePair bad = good;
    fault == 0   ? bad.normal = { 0, 0, 0.9 }
    : fault == 1 ? bad.outward = { 2, 0, 0 }
    : fault == 2 ? bad.second = { std::nan(""), 0, 0 }
                 : (bad.weight = 0.0, bad.first);
    refused([&] { return hasp::MeasureTrueStepAndGap({ &bad, 1 }, {}, {}); });
  }
}

TEST(StepAndGap, HalvesApartOrInEachOtherHaveThatGap)
{
  const Halves halves;
  for (const double gap : { 0.0, 0.4, 3.0, -0.3, -1.5 })
  {
    const auto found = halves.Measure({ gap, 0, 0 });
    EXPECT_NEAR(found.gap.meanMm, gap, 1e-6) << gap;
    EXPECT_NEAR(found.gap.p5Mm, gap, 1e-6);
    EXPECT_NEAR(found.gap.p95Mm, gap, 1e-6);
    EXPECT_NEAR(found.gap.maxAbsMm, std::abs(gap), 1e-6);
    if (gap >= 0.0)
    {
      EXPECT_NEAR(found.gap.areaMm2, 80.0, 1e-6); // the whole face
    }
    else // what is nearer to the side of a half than to its face is no face; +- half a sample
    {
      EXPECT_NEAR(found.gap.areaMm2, (4 + 2 * gap) * (20 + 2 * gap), 2.5);
    }
    EXPECT_GT(found.step.samples, 100U);
    EXPECT_NEAR(found.step.maxAbsMm, 0.0, 1e-6);
  }
}

TEST(StepAndGap, AShiftedHalfStandsThatMuchHigherAndLowerBehind)
{
  const Halves halves;
  for (const double step : { 0.2, 1.0, -1.5 })
    for (const double gap : { 0.0, 0.5, 2.0 })
    {
      const auto found = halves.Measure({ gap, 0, step }, 2);
      EXPECT_NEAR(found.step.p95Mm, std::abs(step), 1e-6); // on one side of the plate
      EXPECT_NEAR(found.step.p5Mm, -std::abs(step), 1e-6); // and on the other
      EXPECT_NEAR(found.step.maxAbsMm, std::abs(step), 1e-6);
      EXPECT_NEAR(found.step.p50AbsMm, std::abs(step), 1e-6); // five sixths of the rim step
      EXPECT_NEAR(found.step.p95AbsMm, std::abs(step), 1e-6);
      EXPECT_NEAR(found.gap.p50Mm, gap, 1e-6);
      // The side that lies nearer to where the faces overlap counts a little more.
      EXPECT_LT(std::abs(found.step.meanMm), 0.2 * std::abs(step));
      // Of the rim, two sides of 20 mm step, and two of what faces each other do not.
      EXPECT_GT(found.step.meanAbsMm, 0.8 * std::abs(step));
      EXPECT_LE(found.step.meanAbsMm, std::abs(step) + 1e-6);
      EXPECT_NEAR(found.gap.meanMm, gap, 1e-6);
      EXPECT_NEAR(found.gap.areaMm2, 20 * (4 - std::abs(step)), gap == 0.0 ? 4.0 : 80.0);
    }
}

TEST(StepAndGap, AStepHigherThanTheRimIsSeenFromOneSide)
{
  const Halves halves;
  const auto found = halves.Measure({ 0.5, 0, -2.5 });
  EXPECT_NEAR(found.step.maxAbsMm, 2.5, 1e-6);
  EXPECT_NEAR(found.step.p95Mm, 2.5, 1e-6);
  EXPECT_NEAR(found.gap.areaMm2, 20 * 1.5, 2.5);
}

TEST(StepAndGap, WhatIsOutOfReachIsNotGuessed)
{
  const Halves halves;
  const auto found = halves.Measure({ 5.5, 0, 0 });
  EXPECT_EQ(found.gap.samples, 0U);
  EXPECT_EQ(found.step.samples, 0U);
  EXPECT_EQ(found.gap.maxAbsMm, 0.0);
}

TEST(StepAndGap, ATiltedHalfOpensAsItsAngle)
{
  const Halves halves;
  const double angle = glm::radians(5.0); // about the lower line of the break
  const RigidPose world = AnyPose(1);
  const RigidPose hinge{ { 10, 0, 0 }, hasp::TurnBy({ 0, angle, 0 }) };
  const auto found = hasp::MeasureStepAndGap(
    halves.left, world, halves.right, world * hinge * RigidPose{ { -10, 0, 0 } });
  EXPECT_NEAR(found.gap.meanMm, 2.0 * std::tan(angle), 0.01); // half way up the plate of 4 mm
  EXPECT_NEAR(found.gap.maxAbsMm, 4.0 * std::tan(angle), 0.02);
}

TEST(StepAndGap, ABallInHalvesHasNoStepHoweverRound)
{
  hasp::TriangleMesh upper = parttest::Ball(20, 60), lower = upper;
  for (glm::dvec3& p : upper.points)
    p.z = std::max(p.z, 0.0);
  for (glm::dvec3& p : lower.points)
    p.z = std::min(p.z, 0.0);
  const MeasuredSurface top(upper), bottom(lower);
  const auto found = hasp::MeasureStepAndGap(top, { { 0, 0, 0.2 } }, bottom, {}, { .rimMm = 3.0 });
  EXPECT_NEAR(found.gap.meanMm, 0.2, 1e-6);
  EXPECT_GT(found.step.samples, 1000U);
  EXPECT_LT(found.step.maxAbsMm, 0.05); // straight lines would differ by 6^2 / 40 = 0.9 mm
  const auto moved =
    hasp::MeasureStepAndGap(top, { { 0.5, 0, 0.2 } }, bottom, {}, { .rimMm = 1.0 });
  EXPECT_NEAR(moved.step.maxAbsMm, 0.5, 0.06); // and 0 across
  EXPECT_NEAR(moved.step.meanAbsMm, 0.5 * 2.0 / glm::pi<double>(), 0.03);
}

TEST(StepAndGap, CorrespondingPlacesAreExact)
{
  // The face x = 10 of the left half, its line along the upper side, each half in a place of its
  // own.
  const RigidPose left = AnyPose(1), right = AnyPose(2), world = AnyPose(3);
  std::vector<hasp::FacePair> pairs;
  for (int n = 0; n <= 20; ++n)
    for (int k = 0; k <= 4; ++k)
    {
      const glm::dvec3 place(10, n, k);
      pairs.push_back({ left.Inverse().Place(place), right.Inverse().Place(place),
        left.Inverse().Turn({ 1, 0, 0 }),
        k == 4 ? left.Inverse().Turn({ 0, 0, 1 }) : glm::dvec3(0) });
    }
  const RigidPose shifted = world * RigidPose{ { 0.7, -0.3, 0.4 } };
  const auto found = hasp::MeasureTrueStepAndGap(pairs, world * left, shifted * right);
  EXPECT_NEAR(found.gap.meanMm, 0.7, 1e-11);
  EXPECT_NEAR(found.step.meanMm, 0.4, 1e-11);
  EXPECT_NEAR(found.slide.meanMm, 0.5, 1e-11);
  EXPECT_NEAR(found.slide.maxAbsMm, 0.5, 1e-11);
  EXPECT_EQ(found.gap.samples, 105U);
  EXPECT_EQ(found.step.samples, 21U);
  const auto none = hasp::MeasureTrueStepAndGap(pairs, world * left, world * right);
  EXPECT_NEAR(none.gap.maxAbsMm + none.step.maxAbsMm + none.slide.maxAbsMm, 0.0, 1e-11);
}

} // namespace
