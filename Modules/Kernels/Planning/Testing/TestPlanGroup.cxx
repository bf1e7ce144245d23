#include "Planning/PlanEdits.h"
#include "Planning/PlanLists.h"
#include "Planning/PlanUnits.h"

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{
using namespace hasp;

/// volume 1, fragments 2, 3, 4 and the locked 5, group 6 of 2 and 3, group 7 of 4 and 5.
Plan Case()
{
  Plan plan;
  plan = Apply(plan, AddObject<PlanVolume>{ { 1, "", std::string(64, 'a') } });
  for (PlanId id = 2; id <= 5; ++id)
  {
    PlanFragment fragment;
    fragment.id = id;
    fragment.source = ComponentSource{ 1, 226, { 0, 0, 0 } };
    fragment.locked = id == 5;
    fragment.scanToPlanned = { { 10.0 * id, -3, 7 },
      glm::angleAxis(0.3 * id, glm::normalize(glm::dvec3(1, 2, 3))) };
    plan = Apply(plan, AddObject<PlanFragment>{ fragment });
  }
  plan = Apply(plan, AddObject<PlanGroup>{ { 6, "", { 2, 3 } } });
  return Apply(plan, AddObject<PlanGroup>{ { 7, "", { 4, 5 } } });
}

PlanPose PoseOf(const Plan& plan, PlanId id)
{
  return FindPlanObject<PlanFragment>(plan, id)->scanToPlanned;
}

std::string Refusal(const Plan& plan, const PlanEdit& edit)
{
  try
  {
    Apply(plan, edit);
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

TEST(PlanGroup, OneThatHoldsALockedFragmentDoesNotMove)
{
  const Plan plan = Case();
  const PoseFragments moved = MovedGroup(plan, 7, { { 1, 0, 0 }, { 1, 0, 0, 0 } });
  EXPECT_EQ(Refusal(plan, moved), "fragment 5: is locked; unlock it to move it");
  EXPECT_THROW(MovedGroup(plan, 2, {}), std::invalid_argument); // a fragment is no group
  EXPECT_THROW(MovedFragment(plan, 6, {}), std::invalid_argument);
  // Unlocked, all of it moves; locked again, it stays.
  PlanFragment loose = plan.fragments[3];
  loose.locked = false;
  const Plan unlocked = Apply(plan, ChangeObject<PlanFragment>{ loose });
  const Plan after = Apply(unlocked, moved);
  EXPECT_EQ(PoseOf(after, 5).position, PoseOf(plan, 5).position + glm::dvec3(1, 0, 0));
  EXPECT_EQ(PoseOf(after, 4).position, PoseOf(plan, 4).position + glm::dvec3(1, 0, 0));
}

TEST(PlanGroup, KeepsItsMembersToEachOtherHoweverOftenItMoves)
{
  Plan plan = Case();
  const auto apart = [](const Plan& of) // a place of 3 in the axes of 2
  {
    return PoseOf(of, 2).PlaceBack(PoseOf(of, 3).Place({ 40, -20, 60 }));
  };
  const glm::dvec3 before = apart(plan);
  for (int n = 0; n < 1000; ++n)
    plan =
      Apply(plan, MovedGroup(plan, 6,
                    { { std::sin(n), 0.5, -1.0 },
                      glm::angleAxis(0.01 * n, glm::normalize(glm::dvec3(n % 7 - 3, 1, 2))) }));
  EXPECT_LT(glm::distance(apart(plan), before), 1e-8);
  EXPECT_NEAR(glm::length(PoseOf(plan, 3).orientation), 1.0, 1e-12);
  EXPECT_EQ(PoseOf(plan, 4), PoseOf(Case(), 4));
}

TEST(PlanGroup, TakenApartItLeavesEveryPoseToTheLastBit)
{
  Plan plan = Case();
  plan =
    Apply(plan, MovedGroup(plan, 6, { { 1, 2, 3 }, { std::sqrt(0.5), 0, std::sqrt(0.5), 0 } }));
  const Plan apart = Apply(plan, RemoveObject{ 6 });
  EXPECT_EQ(apart.fragments, plan.fragments);
  EXPECT_EQ(apart.groups.size(), 1U);
  // A group again, of other members: nothing jumps.
  const Plan again = Apply(apart, AddObject<PlanGroup>{ { 8, "", { 3, 4 } } });
  EXPECT_EQ(again.fragments, plan.fragments);
}

TEST(PlanGroup, AMotionOfOneFragmentIsThatOfAGroupOfOne)
{
  const Plan plan = Case();
  const PlanPose motion{ { 4, 5, 6 }, glm::angleAxis(0.7, glm::dvec3(0, 1, 0)) };
  const PoseFragments one = MovedFragment(plan, 2, motion);
  ASSERT_EQ(one.poses.size(), 1U);
  EXPECT_EQ(one.poses[0], MovedGroup(plan, 6, motion).poses[0]);
  const glm::dvec3 place(3, -8, 11); // the motion comes after the pose
  EXPECT_LT(glm::distance(
              one.poses[0].scanToPlanned.Place(place), motion.Place(PoseOf(plan, 2).Place(place))),
    1e-12);
}

TEST(PlanUnits, AreGroupsAndFragmentsAloneInTheirOrder)
{
  Plan plan = Case();
  PlanFragment alone;
  alone.id = 8;
  alone.source = ComponentSource{ 1, 226, { 0, 0, 0 } };
  plan = Apply(plan, AddObject<PlanFragment>{ alone });
  plan = Apply(plan, AddObject<PlanGroup>{ { 9, "", { 3, 8 } } });
  const std::vector<PlanId> all{ 3, 8, 5, 2, 77, 4 };
  const std::vector<PlanUnit> units = UnitsOf(plan, all);
  // 3 ties group 9 to group 6; 77 is none; 5 keeps 4 in its place.
  const std::vector<PlanUnit> expected{ { 6, { 3, 8, 2 }, false }, { 7, { 5, 4 }, true } };
  EXPECT_EQ(units, expected);
  EXPECT_EQ(UnitsOf(Apply(plan, AddObject<PlanGroup>{ { 10, "", { 4, 2 } } }), all).size(), 1u);
  plan = Apply(plan, RemoveObject{ 6 });
  EXPECT_EQ(UnitsOf(plan, std::vector<PlanId>{ 2, 3 }).size(), 2u) << "each for itself again";
  EXPECT_TRUE(UnitsOf(plan, {}).empty());
}

} // namespace
