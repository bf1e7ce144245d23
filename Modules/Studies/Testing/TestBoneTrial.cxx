#include "BlockCase.h"

#include "Studies/BoneTrial.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace
{

const hasp::ReductionCase& Block()
{
  static const hasp::ReductionCase broken = BlockCase();
  return broken;
}

hasp::StandingBodies LowerStands()
{
  return { Block().trueBodyInWorld[0], std::nullopt, std::nullopt };
}

TEST(BoneTrial, RefusesWhatCannotBeMoved)
{
  EXPECT_THROW(hasp::TaskOf(Block(), 0, LowerStands()), std::invalid_argument); // it stands
  EXPECT_THROW(hasp::TaskOf(Block(), 3, LowerStands()), std::invalid_argument);
  EXPECT_THROW(hasp::TaskOf(Block(), 1, {}), std::invalid_argument);
  EXPECT_THROW(hasp::PutBoneTogether(Block(), {}, {}, 1, 0), std::invalid_argument);
}

TEST(BoneTrial, TheWayInIsWhereFacesLook)
{
  hasp::StandingBodies standing = LowerStands();
  const hasp::OperatorTask alone = hasp::TaskOf(Block(), 2, standing);
  EXPECT_GT(glm::dot(alone.push, { 0, 0, -1 }), 0.95); // rough faces look aside a little
  EXPECT_EQ(alone.others.partners.size(), 1U);         // the left piece is out of the way
  standing[1] = Block().trueBodyInWorld[1];
  const hasp::OperatorTask both = hasp::TaskOf(Block(), 2, standing);
  EXPECT_LT(both.push.x, -0.3); // to the left piece, too
  EXPECT_LT(both.push.z, -0.6);
  EXPECT_EQ(both.others.partners.size(), 2U);
  const hasp::RigidPose body = both.truth * both.moved[0].bodyInGroup;
  EXPECT_LT(glm::length(body.position - Block().trueBodyInWorld[2].position), 1e-9);
  EXPECT_LT(alone.truth.position.z, 2.0); // held at its face, not 4 mm above
}

TEST(BoneTrial, WithoutFacesThatAgreeTheWayInIsTheWayBack)
{
  hasp::ReductionCase lonely = Block();
  lonely.partners[2].clear();
  const glm::dvec3 back =
    glm::normalize(lonely.trueBodyInWorld[2].position - lonely.bodies[2].origin);
  EXPECT_GT(glm::dot(hasp::TaskOf(lonely, 2, LowerStands()).push, back), 1.0 - 1e-9);
}

TEST(BoneTrial, WhatHasTheLargestFacesComesNext)
{
  std::vector<std::size_t> order = hasp::OrderOfPieces(Block());
  ASSERT_EQ(order.size(), 2U);
  // Without the lower half among its partners the left piece meets nothing but the right one.
  hasp::ReductionCase chain = Block();
  chain.partners[1] = { 2 };
  order = hasp::OrderOfPieces(chain);
  EXPECT_EQ(order, (std::vector<std::size_t>{ 2, 1 }));
}

TEST(BoneTrial, PiecesGoInPlaceOneAfterTheOtherAndTheSameAgain)
{
  hasp::OperatorSettings who;
  who.aimMm = who.aimDegrees = 0.0;
  who.givesUpS = 12.0;
  hasp::OperatorHelp help;
  help.step.contact.stiffness = 0.5F;
  help.snap = true;
  const hasp::BoneTrial trial = hasp::PutBoneTogether(Block(), who, help, 3);
  ASSERT_EQ(trial.pieces.size(), 2U);
  EXPECT_EQ(trial.faults, 0U);
  for (std::size_t n = 0; n < 2; ++n)
  {
    const std::size_t piece = trial.pieces[n];
    const std::vector<hasp::GroupBody> moved{ { Block().bodies[piece].body, {} } };
    // They begin 12 mm away; without an error of aim what remains is the push and a search.
    EXPECT_LT(hasp::RmsWay(moved, Block().trueBodyInWorld[piece], trial.bodyInWorld[n]), 0.6);
  }
  EXPECT_GT(trial.seconds, 1.0);
  const hasp::BoneTrial first = hasp::PutBoneTogether(Block(), who, help, 3, 1);
  ASSERT_EQ(first.pieces.size(), 1U);
  EXPECT_EQ(first.bodyInWorld[0], trial.bodyInWorld[0]);
}

} // namespace
