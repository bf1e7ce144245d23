#include "Planning/TransplantRecipe.h"
#include "Planning/TransplantRecipeFile.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

using glm::dvec3;

/// Square cuts at x = -30 and, beyond a corner of 0.6 radians at the origin, 40 mm along.
const dvec3 Beyond(std::cos(0.6), std::sin(0.6), 0);

hasp::TransplantRecipe Valid()
{
  hasp::TransplantRecipe r;
  const double kerf = 1.0; // sawn within the defect
  r.resection.cuts = { { { { -30 + 0.5 * kerf, 2, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, 30, 30, kerf },
                         8 },
    { { (40 - 0.5 * kerf) * Beyond, Beyond, { 0, 0, 1 }, 30, 30, kerf }, 8 } };
  r.path = { { -25, 0, 0 }, { 0, 0, 0 }, 50.0 * Beyond };
  r.outward = { { 0, 0, 1 } };
  r.donor.axis = { { 500, 7, -170 }, { 500, 7, 170 } };
  r.donor.lateral = { 0, 1, 0 };
  r.vessel = { { 500, 20, -170 }, { 500, 20, 170 } };
  r.paddle =
    hasp::SkinPaddle{ { { 500, 30, -60 }, { 510, 30, -50 }, { 490, 30, -50 } }, { 500, 12, -70 } };
  return r;
}

template <typename Work>
std::string Fault(Work work)
{
  try
  {
    work();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

std::string FaultOf(const std::function<void(hasp::TransplantRecipe&)>& change)
{
  hasp::TransplantRecipe recipe = Valid();
  change(recipe);
  return Fault([&] { hasp::LayOutSegments(hasp::JointsOf(recipe)); });
}

TEST(TransplantRecipe, EveryNumberOutOfItsRangeIsNamed)
{
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const auto expect =
    [](const std::function<void(hasp::TransplantRecipe&)>& change, const char* text)
  {
    const std::string fault = FaultOf(change);
    EXPECT_NE(fault.find(text), std::string::npos) << fault;
  };
  EXPECT_EQ(FaultOf([](auto&) {}), "");
  expect([](auto& r) { r.resection.spacingMm = 9; }, "cut recipe: spacingMm is 9");
  expect([](auto& r) { r.resection.cuts.pop_back(); }, "number of resection.cuts is 1");
  expect([](auto& r) { r.path.resize(1); }, "number of path's places is 1");
  expect([](auto& r) { r.path.resize(7); }, "number of path's places is 7");
  expect([&](auto& r) { r.path[1].y = nan; }, "path[1]");
  expect([](auto& r) { r.path[1] = r.path[0]; }, "the distance of path[1] from the place before");
  expect([](auto& r) { r.outward.clear(); }, "number of outward is 0");
  expect([](auto& r) { r.outward[0] = { 0, 0, 2 }; }, "outward[0]'s length");
  expect([](auto& r) { r.rollDeg = 200; }, "rollDeg is 200");
  expect([](auto& r) { r.leastSegmentMm = 0; }, "leastSegmentMm is 0");
  expect([&](auto& r) { r.mostGapMm = infinite; }, "mostGapMm is inf");
  expect([](auto& r) { r.mostOverlapMm = -1; }, "mostOverlapMm is -1");
  expect([&](auto& r) { r.donorIsovalue = nan; }, "donor.isovalue is nan");
  expect([](auto& r) { r.donor.axis.resize(1); }, "number of donor.axis' places is 1");
  expect(
    [](auto& r)
    {
      r.findAxis = true;
      r.donor.axis.push_back({ 500, 7, 180 });
    },
    "number of donor.axis' places is 3, must be in [2, 2]");
  expect([](auto& r) { r.donor.axis[1] = r.donor.axis[0]; }, "donor.axis[1]");
  expect([](auto& r) { r.donor.lateral = { 0, 0, 0 }; }, "donor.lateral");
  expect([](auto& r) { r.donor.radiusMm = 51; }, "donor.radiusMm is 51");
  expect([](auto& r) { r.donor.keepMm = -1; }, "donor.keepMm is -1");
  expect([](auto& r) { r.startOffsetMm = -1; }, "donor.startOffsetMm is -1");
  expect([](auto& r) { r.kerfMm = 0; }, "donor.kerfMm is 0");
  expect([](auto& r) { r.betweenMm = 101; }, "donor.betweenMm is 101");
  expect([](auto& r) { r.vessel.resize(1); }, "number of donor.vessel's places is 1");
  expect([](auto& r) { r.paddle->outline.resize(2); }, "donor.paddle.outline's places is 2");
  expect([&](auto& r) { r.paddle->perforator.x = nan; }, "donor.paddle.perforator");
  expect([](auto& r) { r.guide.beyondMm = 0; }, "guide.beyondMm is 0");
  expect([&](auto& r) { r.guide.spacingMm = nan; }, "guide.spacingMm is nan");
}

TEST(TransplantRecipe, WhatCannotBePlannedIsNamed)
{
  const auto expect =
    [](const std::function<void(hasp::TransplantRecipe&)>& change, const char* text)
  {
    const std::string fault = FaultOf(change);
    EXPECT_NE(fault.find(text), std::string::npos) << fault;
  };
  expect(
    [](auto& r)
    {
      r.resection.cuts[0].blade.normal = { 0, 0, 1 };
      r.resection.cuts[0].blade.along = { 1, 0, 0 };
    },
    "resection.cuts[0]: its angle with the path is 90, must be at most 60 degrees");
  // 30 mm long, but 15 were left of them.
  expect([](auto& r) { r.resection.cuts[0].blade.point.x = -14.5; },
    "segments[0]'s length is 15, must be at least leastSegmentMm (20 mm)");
  // Beyond the corner the segment would run backwards; a length has no sign.
  expect([](auto& r) { r.resection.cuts[0].blade.point.x = 40; }, "segments[0]'s length is -39.5");
  expect([](auto& r) { r.path[2] = { -40, 0.001, 0 }; }, "segments[1]'s length is -47");
  // Straight: 75 + 75 of 340 mm stay.
  expect(
    [](auto& r)
    {
      r.path[2] = 200.0 * Beyond;
      r.resection.cuts[1].blade.point = 180.0 * Beyond;
    },
    "mm too short: its 2 segments");
  EXPECT_NE(FaultOf([](auto& r) { r.startOffsetMm = 120.0; }).find("too short"), std::string::npos);
}

TEST(TransplantRecipe, SegmentsReachFromStumpToStumpAndFollowTheCuts)
{
  hasp::TransplantRecipe recipe = Valid();
  const auto lengths = [&]
  {
    const auto segments = hasp::LayOutSegments(hasp::JointsOf(recipe));
    return dvec3(segments.at(0).lengthMm, segments.at(1).lengthMm, segments.at(1).wedgeRadians);
  };
  EXPECT_LT(glm::distance(lengths(), dvec3(30, 40, 0.3)), 1e-12);
  // A cut 5 mm nearer takes 5 mm of its own segment alone.
  recipe.resection.cuts[1].blade.point -= 5.0 * Beyond;
  EXPECT_LT(glm::distance(lengths(), dvec3(30, 35, 0.3)), 1e-12);
  // An oblique one, moved along its normal, takes 5 / cos; its normal may look either way.
  recipe.resection.cuts[0].blade.normal = { -std::cos(0.5), 0, std::sin(0.5) };
  recipe.resection.cuts[0].blade.along = { 0, 1, 0 };
  const dvec3 before = lengths();
  recipe.resection.cuts[0].blade.point += 5.0 * recipe.resection.cuts[0].blade.normal;
  EXPECT_NEAR(lengths().x - before.x, 5.0 / std::cos(0.5), 1e-12);
  EXPECT_EQ(lengths().y, before.y);
  // The face is the far one of the kerf: a wider saw in the same place leaves a shorter stump.
  const double wide = lengths().x;
  recipe.resection.cuts[0].blade.kerfMm = 2.0;
  EXPECT_NEAR(lengths().x - wide, 0.5 / std::cos(0.5), 1e-12);
}

TEST(TransplantRecipe, ARollTurnsTheLateralSideAboutEachSegment)
{
  hasp::TransplantRecipe recipe = Valid();
  recipe.rollDeg = 90.0;
  const hasp::Transplant plan = hasp::JointsOf(recipe);
  ASSERT_EQ(plan.outward.size(), 2U);
  EXPECT_LT(glm::distance(plan.outward[0], dvec3(0, -1, 0)), 1e-12);
  EXPECT_LT(glm::distance(plan.outward[1], glm::cross(Beyond, dvec3(0, 0, 1))), 1e-12);
}

TEST(TransplantRecipe, TheDonorsBladesTakeTheirKerfOutsideOfTheSegments)
{
  hasp::TransplantRecipe recipe = Valid();
  recipe.startOffsetMm = 10.0;
  const hasp::Transplant plan = hasp::JointsOf(recipe);
  const auto segments = hasp::LayOutSegments(plan);
  EXPECT_NEAR(segments[0].fromMm, 75 + 10 + 1, 1e-12);
  const auto cuts = hasp::DonorCuts(plan, segments);
  ASSERT_EQ(cuts.size(), 4U);
  for (std::size_t n = 0; n < cuts.size(); ++n)
  {
    EXPECT_NO_THROW(hasp::ValidateOsteotomy(cuts[n]));
    const bool start = n % 2 == 0;
    const hasp::TransplantJoint& plane = start ? segments[n / 2].start : segments[n / 2].end;
    EXPECT_NEAR(glm::dot(cuts[n].point - plane.point, plane.normal), start ? -0.5 : 0.5, 1e-12);
    EXPECT_NEAR(glm::dot(cuts[n].normal, plane.normal), 1.0, 1e-12);
  }
}

TEST(TransplantRecipe, AFileIsReadAsItWasWrittenAndStrictly)
{
  hasp::TransplantRecipe recipe = Valid();
  recipe.guide.beyondMm = 17.5;
  recipe.fromLastTip = true;
  const std::string text = hasp::FormatTransplantRecipe(recipe);
  EXPECT_EQ(hasp::ParseTransplantRecipe(text), recipe);
  recipe.paddle.reset();
  EXPECT_EQ(hasp::ParseTransplantRecipe(hasp::FormatTransplantRecipe(recipe)), recipe);
  const auto fault = [&](const std::string& from, const std::string& to)
  {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    return Fault([&] { hasp::ParseTransplantRecipe(changed); });
  };
  EXPECT_NE(fault("rollDeg", "secret").find("is unknown"), std::string::npos);
  EXPECT_EQ(fault("rollDeg", "secret").find("secret"), std::string::npos);
  EXPECT_NE(fault("transplant-recipe-1", "transplant-recipe-9").find("format"), std::string::npos);
  EXPECT_NE(
    fault("hasp-cut-recipe-1", "hasp-cut-recipe-9").find("cut recipe: format"), std::string::npos);
  EXPECT_NE(fault("\"radiusMm\": 9.0,", "").find("donor.radiusMm is missing"), std::string::npos);
  EXPECT_NE(
    fault("\"beyondMm\": 17.5", "\"beyondMm\": true").find("guide.beyondMm must be a number"),
    std::string::npos);
  EXPECT_NE(
    fault("\"beyondMm\": 17.5", "\"beyondMm\": 1").find("guide.beyondMm is 1"), std::string::npos);
  EXPECT_NE(Fault([] { hasp::ParseTransplantRecipe("{"); }).find("no JSON"), std::string::npos);
  EXPECT_NE(
    Fault([] { hasp::ReadTransplantRecipe("/nowhere/t.json"); }).find("the file is not there"),
    std::string::npos);
}

} // namespace
