// Transplants along a touched line, against Data's transplant and closed forms.
#include "Planning/TransplantPath.h"

#include "Planning/PlanEdits.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using glm::dvec3;
constexpr double RoundingMm = 1e-9;

/// A straight jaw along x, cut at 0 and at 80 (cuts 3 and 4); its stumps are fragments 5 and 6.
hasp::Plan Jaw()
{
  hasp::Plan plan;
  plan.volumes = { { 1, "", std::string(64, 'a') } };
  hasp::PlanFragment whole, left, right;
  whole.id = 2;
  left.id = 5;
  right.id = 6;
  whole.source = hasp::ComponentSource{ .volume = 1 };
  left.source = hasp::PieceSource{ 2, { -20, 0, 0 } };
  right.source = hasp::PieceSource{ 2, { 100, 0, 0 } };
  plan.fragments = { whole, left, right };
  hasp::PlanCut first, last;
  first.id = 3;
  last.id = 4;
  first.blade = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  last.blade = { { 80, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 } };
  first.fragments = last.fragments = { 2 };
  plan.cuts = { first, last };
  plan.nextId = 7;
  hasp::ValidatePlan(plan);
  return plan;
}

hasp::PlanTransplant InJaw()
{
  hasp::PlanTransplant transplant;
  transplant.id = 7;
  transplant.donor = 2;
  transplant.first = { 3, 5 };
  transplant.last = { 4, 6 };
  transplant.transplant.donor.axis = { { 500, 0, -170 }, { 500, 0, 170 } };
  return transplant;
}

const std::vector<dvec3> Path{ { -10, 0, 0 }, { 40, 0, 20 }, { 95, 0, 0 } };

std::string Refusal(const std::vector<dvec3>& path, double turnDeg = 0.0)
{
  hasp::Plan plan = Jaw();
  const double angle = turnDeg * std::acos(-1.0) / 180.0;
  plan.cuts[1].blade.normal = { -std::cos(angle), 0, std::sin(angle) };
  try
  {
    hasp::AlongPath(plan, InJaw(), path);
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

TEST(TransplantPath, WhatCannotBeLaidIsRefusedByThePlansNames)
{
  EXPECT_NE(Refusal({ { 0, 0, 0 } }).find("number of path's places is 1"), std::string::npos);
  EXPECT_NE(Refusal({ { 0, 0, 0 }, { 0, 0, 0 } }).find("path[1]"), std::string::npos);
  EXPECT_NE(Refusal({ { -10, 0, 0 }, { 10, 0, 0 }, { 95, 0, 0 } }).find("segments[0]'s length"),
    std::string::npos);
  const std::string tilted = Refusal(Path, 85.0);
  EXPECT_NE(tilted.find("transplant: cut 4: its angle with the path"), std::string::npos) << tilted;
  EXPECT_EQ(Refusal(Path), "");
}

TEST(TransplantPath, EndsLieInTheFacesAndCornersAreMitred)
{
  const hasp::Plan plan = Jaw();
  const auto made = hasp::AlongPath(plan, InJaw(), Path);
  const auto& joints = made.transplant.joints;
  ASSERT_EQ(joints.size(), 3U);
  EXPECT_NEAR(joints[0].point.x, -0.5, RoundingMm); // half a kerf behind the cut's middle
  EXPECT_NEAR(joints[2].point.x, 80.5, RoundingMm);
  EXPECT_NEAR(glm::distance(joints[0].normal, dvec3(1, 0, 0)), 0.0, RoundingMm);
  EXPECT_NEAR(glm::distance(joints[2].normal, dvec3(1, 0, 0)), 0.0, RoundingMm);
  const dvec3 before = joints[1].point - joints[0].point, after = joints[2].point - joints[1].point;
  EXPECT_NEAR(
    hasp::AngleOf(joints[1].normal, before), hasp::AngleOf(joints[1].normal, after), 1e-9);
  EXPECT_EQ(made.transplant.outward.size(), 2U);
  EXPECT_NO_THROW(hasp::LayOutSegments(hasp::TransplantOf(plan, made)));
}

TEST(TransplantPath, ThePathComesBackWhereStumpsHaveMoved)
{
  hasp::Plan plan = Jaw();
  plan.fragments[1].scanToPlanned = { { -4, 2, 1 },
    glm::angleAxis(0.2, glm::normalize(dvec3(1, 2, 3))) };
  plan.fragments[2].scanToPlanned = { { 6, -1, 0 }, glm::angleAxis(-0.1, dvec3(0, 1, 0)) };
  const auto made = hasp::AlongPath(plan, InJaw(), Path);
  const auto path = hasp::PathOf(plan, made);
  ASSERT_EQ(path.size(), 3U);
  // The inner place stays; the ends are on the lines that the legs were given along.
  EXPECT_NEAR(glm::distance(path[1], Path[1]), 0.0, RoundingMm);
  for (const int end : { 0, 2 })
    EXPECT_LT(glm::length(glm::cross(glm::normalize(path[std::size_t(end)] - Path[1]),
                glm::normalize(Path[std::size_t(end)] - Path[1]))),
      1e-9);
  // Along what came back nothing moves.
  const auto again = hasp::AlongPath(plan, made, path);
  for (std::size_t n = 0; n < 3; ++n)
    EXPECT_NEAR(glm::distance(again.transplant.joints[n].point, made.transplant.joints[n].point),
      0.0, RoundingMm);
}

TEST(TransplantPath, WithoutACutAnEndIsSquareWhereItIs)
{
  auto transplant = InJaw();
  transplant.first = {};
  const auto made = hasp::AlongPath(Jaw(), transplant, Path);
  const auto& joint = made.transplant.joints[0];
  EXPECT_NEAR(glm::distance(joint.point, Path[0]), 0.0, RoundingMm);
  EXPECT_NEAR(glm::distance(joint.normal, glm::normalize(Path[1] - Path[0])), 0.0, RoundingMm);
}

TEST(TransplantPath, OneMoreHalvesTheLongestLegAndOneLessTakesTheStraightest)
{
  const std::vector<dvec3> path{ { 0, 0, 0 }, { 30, 0, 0 }, { 30, 50, 0 } };
  const auto more = hasp::PathWithOneMore(path);
  ASSERT_EQ(more.size(), 4U);
  EXPECT_EQ(more[2], dvec3(30, 25, 0));
  EXPECT_EQ(hasp::PathWithOneLess(more), path);
  const std::vector<dvec3> full(hasp::MostPathPlaces, dvec3(0));
  EXPECT_EQ(hasp::PathWithOneMore(full).size(), hasp::MostPathPlaces);
  const std::vector<dvec3> straight{ { 0, 0, 0 }, { 30, 0, 0 } };
  EXPECT_EQ(hasp::PathWithOneLess(straight), straight);
}

// The seed of the long stump is far from its cut, that of the other one near.
TEST(TransplantPath, AStumpIsWhatIsKeptBeyondItsCut)
{
  hasp::Plan plan = Jaw();
  std::get<hasp::PieceSource>(plan.fragments[1].source).seed = { -200, 0, 0 };
  EXPECT_EQ(hasp::StumpOf(plan, plan.cuts[0], plan.cuts[1]), 5U);
  EXPECT_EQ(hasp::StumpOf(plan, plan.cuts[1], plan.cuts[0]), 6U);
  plan.cuts[0].blade.normal *= -1.0; // whichever way the blade looks
  EXPECT_EQ(hasp::StumpOf(plan, plan.cuts[0], plan.cuts[1]), 5U);
  plan.fragments[1].state = hasp::FragmentState::Resected;
  EXPECT_EQ(hasp::StumpOf(plan, plan.cuts[0], plan.cuts[1]), 0U);
}

TEST(TransplantPath, AcrossIsUprightOnTheLineAndNothingAlongIt)
{
  const auto across = [](std::size_t place, const dvec3& direction)
  { return hasp::AcrossPath(Path, place, direction); };
  const dvec3 leg = glm::normalize(Path[1] - Path[0]), whole = glm::normalize(Path[2] - Path[0]);
  for (const dvec3& direction : { dvec3(0, -3, 0), dvec3(0.2, -1, 0.3) })
  {
    ASSERT_TRUE(across(0, direction));
    EXPECT_NEAR(glm::dot(*across(0, direction), leg), 0.0, RoundingMm);
    EXPECT_NEAR(glm::length(*across(0, direction)), 1.0, RoundingMm);
    EXPECT_NEAR(glm::dot(*across(1, direction), whole), 0.0, RoundingMm);
  }
  EXPECT_LT(glm::distance(*across(2, { 0, -3, 0 }), dvec3(0, -1, 0)), RoundingMm);
  EXPECT_FALSE(across(0, leg));
  EXPECT_FALSE(across(1, -whole));
}

TEST(TransplantPath, TheLateralSideIsUprightOnTheAxis)
{
  const std::vector<dvec3> axis{ { 0, 0, -100 }, { 0, 0, 0 }, { 0, 20, 100 } };
  const dvec3 straight = hasp::LateralTowards(axis, { 7, 0, -50 });
  EXPECT_NEAR(glm::distance(straight, dvec3(1, 0, 0)), 0.0, RoundingMm);
  const dvec3 bent = hasp::LateralTowards(axis, { 3, 30, 50 });
  EXPECT_NEAR(glm::dot(bent, glm::normalize(dvec3(0, 20, 100))), 0.0, RoundingMm);
  EXPECT_THROW(hasp::LateralTowards(axis, { 0, 0, -50 }), std::invalid_argument);
  EXPECT_THROW(hasp::LateralTowards({}, { 0, 0, -50 }), std::invalid_argument);
}

} // namespace
