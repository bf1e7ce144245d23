#include "GuideFixture.h"

#include <glm/trigonometric.hpp>

using namespace guidetest;

namespace
{

double AngleDeg(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::degrees(std::acos(glm::dot(a, b) / glm::length(a) / glm::length(b)));
}

glm::dvec3 AxisOf(vtkHaspGuideFilter* filter)
{
  glm::dvec3 axis;
  filter->GetInsertionAxis(&axis.x);
  return axis;
}

/// A cap of a ball of 20 mm, 65 degrees to all sides of `middle`, painted.
hasp::GuideRecipe Cap(const glm::dvec3& middle)
{
  hasp::GuideRecipe r;
  const glm::dvec3 x = glm::normalize(glm::cross(middle, { 0, 0, 1 })), y = glm::cross(middle, x);
  for (const double turn : { 0.0, 20.0, 40.0, 58.0 })
    for (int n = 0; n < (turn > 0 ? 12 : 1); ++n)
    {
      const double t = glm::radians(turn), around = glm::radians(30.0 * n);
      const glm::dvec3 p =
        20.0 * (std::cos(t) * middle + std::sin(t) * (std::cos(around) * x + std::sin(around) * y));
      r.strokes.push_back({ { p }, 5, false });
    }
  r.edgeRadiusMm = 0;
  r.thicknessMm = 3;
  r.spacingMm = 1.0;
  return r;
}

TEST(InsertionAxis, IsAsGivenUnlessASearchIsAskedFor)
{
  const auto ct = ScanOf(hasp::AnalyticSphere({}, 20), glm::dvec3(1.5), 0.2);
  auto r = Cap({ 1, 0, 0 });
  r.withdrawal = { 0.8, 0.6, 0 };
  Answer answer(ct, r);
  ASSERT_EQ(answer.error, "");
  EXPECT_EQ(AxisOf(answer.filter), r.withdrawal);
  EXPECT_EQ(answer.filter->GetUndercutShare(), -1);
}

TEST(InsertionAxis, TheSearchTurnsToWhereACapIsNotUndercut)
{
  // Along its middle nothing of the cap faces away, nor within 90 - 65 degrees of it.
  const auto ct = ScanOf(hasp::AnalyticSphere({}, 20), glm::dvec3(1.5), 0.2);
  const glm::dvec3 middle = glm::normalize(glm::dvec3(1, 0.3, 0.2));
  auto r = Cap(middle);
  const glm::dvec3 side = glm::normalize(glm::cross(middle, { 0, 0, 1 }));
  r.withdrawal = std::cos(glm::radians(55.0)) * middle + std::sin(glm::radians(55.0)) * side;
  r.axisSearchDeg = 60;
  Answer answer(ct, r);
  ASSERT_EQ(answer.error, "");
  const glm::dvec3 axis = AxisOf(answer.filter);
  EXPECT_NEAR(glm::length(axis), 1, 1e-12);
  EXPECT_LT(AngleDeg(axis, middle), 25 + 5);
  EXPECT_LT(answer.filter->GetUndercutShare(), 0.03);
  // A search that may not reach so far goes as far as it may.
  r.axisSearchDeg = 10;
  Answer near(ct, r);
  ASSERT_EQ(near.error, "");
  EXPECT_NEAR(AngleDeg(AxisOf(near.filter), r.withdrawal), 10, 0.1);
  EXPECT_NEAR(AngleDeg(AxisOf(near.filter), middle), 45, 2);
  EXPECT_GT(near.filter->GetUndercutShare(), answer.filter->GetUndercutShare() + 0.05);
}

TEST(InsertionAxis, BoneInTheWayIsGoneAround)
{
  // A second ball above the first, along the direction given.
  const auto ct = ScanOf({ "two balls",
                           [](const glm::dvec3& p)
                           {
                             return std::max(14 - glm::length(p + glm::dvec3(0, 0, 18)),
                               9 - glm::length(p - glm::dvec3(0, 0, 24)));
                           },
                           1 },
    glm::dvec3(1.5), 0);
  hasp::GuideRecipe r;
  r.edgeRadiusMm = 0;
  r.thicknessMm = 2.5;
  r.spacingMm = 0.6;
  r.landmarks = { { -3, 0, -18 + std::sqrt(196 - 9.0) }, { 3, 0, -18 + std::sqrt(196 - 9.0) } };
  r.widthMm = 8;
  Answer given(ct, r);
  EXPECT_NE(given.error.find("nothing is left"), std::string::npos) << given.error;
  r.axisSearchDeg = 40;
  Answer found(ct, r);
  ASSERT_EQ(found.error, "");
  // From 28 mm below it, a ball of 9 and a region of 7 mm are passed at 35 degrees.
  EXPECT_GT(AngleDeg(AxisOf(found.filter), { 0, 0, 1 }), 25);
  EXPECT_LT(found.filter->GetUndercutShare(), 0.1);
}

TEST(InsertionAxis, WhatNoDirectionReachesIsNamed)
{
  const auto ct = ScanOf(hasp::AnalyticSphere({}, 20), glm::dvec3(1.5), 0.2);
  auto r = Cap({ 1, 0, 0 });
  r.strokes.resize(1);
  r.withdrawal = { -1, 0, 0 };
  r.axisSearchDeg = 30;
  Answer answer(ct, r);
  EXPECT_NE(answer.error.find("axisSearchDeg"), std::string::npos) << answer.error;
}

TEST(InsertionAxis, BoneThatIsNotThereIsNotTheDirectionsFault)
{
  const auto ct = ScanOf(hasp::AnalyticSphere({}, 20), glm::dvec3(1.5), 0.2);
  hasp::GuideRecipe r;
  r.spacingMm = 0.6;
  r.thicknessMm = 2.8;
  r.landmarks = { { 26, 0, 0 }, { 26, 2, 0 } };
  r.withdrawal = { 1, 0, 0 };
  r.axisSearchDeg = 30;
  Answer answer(ct, r);
  EXPECT_NE(answer.error.find("landmarks[0] is over 3 mm from bone"), std::string::npos)
    << answer.error;
}

TEST(InsertionAxis, SawPlanesMustSuitTheDirectionFound)
{
  const auto ct = ScanOf(hasp::AnalyticSphere({}, 20), glm::dvec3(1.5), 0.2);
  auto r = Cap({ 1, 0, 0 });
  // A saw plane 30 degrees from the direction given, and along the one found.
  r.withdrawal = { 0.5, std::sqrt(0.75), 0 };
  r.axisSearchDeg = 60;
  r.slots = { { { 20, 0, 0 }, { std::sqrt(0.75), 0.5, 0 }, 1.5 } };
  r.slots[0].guidingHeightMm = 0;
  r.clearanceMm = 0.3;
  Answer answer(ct, r);
  EXPECT_NE(answer.error.find("slots[0].normal"), std::string::npos) << answer.error;
}

} // namespace
