#include "Evaluation/MeshCheck.h"
#include "TransplantBuilder.h"
#include "TransplantFixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

using namespace transplanttest;

namespace
{

class TransplantBuilder : public testing::Test
{
protected:
  hasp::MadeTransplant Make(const hasp::TransplantRecipe& recipe) const
  {
    return hasp::MakeTransplant(ImageOf(this->jaw), ImageOf(this->leg), recipe);
  }
  std::string Fault(const hasp::TransplantRecipe& recipe) const
  {
    try
    {
      this->Make(recipe);
    }
    catch (const std::exception& error)
    {
      return error.what();
    }
    return "";
  }

  const cuttest::BoneScan jaw = ScanOfJaw(), leg = ScanOfLeg();
};

/// Of a mesh's points, the farthest ahead along a direction.
double Farthest(const hasp::TriangleMesh& mesh, const glm::dvec3& from, const glm::dvec3& along)
{
  double most = -1e30;
  for (const glm::dvec3& p : mesh.points)
    most = std::max(most, glm::dot(p - from, along));
  return most;
}

TEST_F(TransplantBuilder, FillsTheJawAndSaysHowItsJointsMeet)
{
  const hasp::MadeTransplant made = this->Make(Recipe());
  for (const std::string& warning : made.warnings)
    ADD_FAILURE() << warning;
  ASSERT_EQ(made.segments.size(), 2U);
  ASSERT_EQ(made.joints.size(), 3U);
  ASSERT_EQ(made.onDonor.size(), 2U);
  ASSERT_EQ(made.donorCuts.size(), 4U);
  const double bend = std::acos(glm::dot(glm::normalize(Recipe().path[1] - Recipe().path[0]),
    glm::normalize(Recipe().path[2] - Recipe().path[1])));
  EXPECT_NEAR(made.joints[1].bendRadians, bend, 1e-9);
  EXPECT_NEAR(made.joints[0].wedgeRadians, 0.0, 1e-6);
  // The bow leans the segments a little, so that the wedge in the bone is not quite the bend.
  EXPECT_NEAR(made.joints[1].wedgeRadians, bend, 0.03);
  for (const hasp::MadeJoint& joint : made.joints)
  {
    EXPECT_GT(joint.fit.contactMm2, 80.0);
    EXPECT_LT(joint.gapMm, 0.05);
    EXPECT_LT(joint.overlapMm, 0.05);
  }
  for (std::size_t n = 0; n < 2; ++n)
  {
    const hasp::PlacedSegment& segment = made.segments[n];
    EXPECT_TRUE(hasp::CheckMesh(segment.mesh).Sound());
    EXPECT_TRUE(hasp::CheckMesh(made.onDonor[n]).Sound());
    EXPECT_NEAR(segment.cut.lengthMm, glm::distance(Recipe().path[n], Recipe().path[n + 1]), 1e-9);
    // On the donor it lies between its planes, around the leg.
    EXPECT_LT(Farthest(made.onDonor[n], segment.cut.end.point, segment.cut.end.normal), 0.02);
    EXPECT_LT(Farthest(made.onDonor[n], segment.cut.start.point, -segment.cut.start.normal), 0.02);
    EXPECT_LT(Farthest(made.onDonor[n], { 150, 0, 0 }, { 1, 0, 0 }), 12.0);
  }
  ASSERT_EQ(made.vessel.size(), 2U);
  ASSERT_TRUE(made.paddle);
  EXPECT_EQ(made.paddle->segment, 0U);
  ASSERT_GT(made.plan.donor.axis.size(), 30U);
  for (const glm::dvec3& p : made.plan.donor.axis)
    if (std::abs(p.z) < 140.0)
    {
      // The triangle's middle is 0.4 mm off the line of the bow; the canal is 0.5 mm.
      EXPECT_NEAR(p.x, 150.0, 0.6);
      EXPECT_NEAR(p.y, 0.4 - 5.0 * (1.0 - p.z * p.z / (170.0 * 170.0)), 0.6);
    }
}

TEST_F(TransplantBuilder, FollowsACutThatMoves)
{
  hasp::TransplantRecipe recipe = Recipe();
  const double before = glm::distance(recipe.path[1], recipe.path[2]);
  hasp::Osteotomy& blade = recipe.resection.cuts[1].blade;
  blade.point += 5.0 * blade.normal; // into the defect, square on the path
  const hasp::MadeTransplant made = this->Make(recipe);
  EXPECT_TRUE(made.warnings.empty());
  EXPECT_NEAR(made.segments[0].cut.lengthMm, glm::distance(recipe.path[0], recipe.path[1]), 1e-9);
  EXPECT_NEAR(made.segments[1].cut.lengthMm, before - 5.0, 1e-9);
  // The mesh ends in the stump's face, 5 mm nearer, and the two still meet.
  const glm::dvec3 face = recipe.path[2] + 5.0 * blade.normal;
  EXPECT_NEAR(Farthest(made.segments[1].mesh, face, -blade.normal), 0.0, 0.02);
  EXPECT_GT(made.joints[2].fit.contactMm2, 80.0);
}

TEST_F(TransplantBuilder, WhatIsMadeButNotAsItShouldBeIsAWarning)
{
  hasp::TransplantRecipe recipe = Recipe();
  recipe.resection.resected.clear();
  recipe.resection.cuts[0].blade.widthMm = 4.0;
  recipe.vessel = { { 142, 2, 100 }, { 142, 2, 150 } };
  recipe.paddle->perforator.z = 160;
  // The path passes below the jaw.
  for (glm::dvec3& place : recipe.path)
    place.z -= 40.0;
  const hasp::MadeTransplant made = this->Make(recipe);
  const std::string all =
    std::accumulate(made.warnings.begin(), made.warnings.end(), std::string());
  for (const char* text :
    { "resection.cuts[0] does not part the bone", "resection.resected names no fragment",
      "segments[0] has none of donor.vessel", "segments[1] has none of donor.vessel",
      "paddle.perforator lies along none", "joints[2]: its bones do not meet" })
    EXPECT_NE(all.find(text), std::string::npos) << text << "\n" << all;
  EXPECT_FALSE(made.paddle);
}

TEST_F(TransplantBuilder, AGapThatIsTooWideIsAWarning)
{
  // Of the stump's face the upper half is sawn 0.8 mm shorter.
  hasp::TransplantRecipe recipe = Recipe();
  recipe.resection.cuts.insert(recipe.resection.cuts.begin() + 1, recipe.resection.cuts[0]);
  hasp::Osteotomy& blade = recipe.resection.cuts[1].blade;
  blade.widthMm = 16.0;
  blade.point += -0.8 * blade.normal + glm::dvec3(0, 0, 0.5 * blade.widthMm);
  recipe.mostGapMm = 0.2;
  const hasp::MadeTransplant made = this->Make(recipe);
  const std::string all =
    std::accumulate(made.warnings.begin(), made.warnings.end(), std::string());
  EXPECT_NE(all.find("joints[0]: a gap of 0."), std::string::npos) << all;
  EXPECT_NEAR(made.joints[0].fit.gapMm3 / made.joints[0].fit.gapMm2, 0.8, 0.05);
}

TEST_F(TransplantBuilder, WhatCannotBeMadeIsNamed)
{
  hasp::TransplantRecipe recipe = Recipe();
  recipe.donor.axis = { { 150, 60, -173 }, { 150, 60, 173 } };
  EXPECT_NE(this->Fault(recipe).find("no bone between the tips"), std::string::npos);
  recipe = Recipe();
  recipe.donor.axis[1].z = 260;
  EXPECT_NE(this->Fault(recipe).find("mm along donor.axis"), std::string::npos)
    << this->Fault(recipe);
  recipe = Recipe();
  recipe.donor.axis[1].z = -150;
  EXPECT_NE(this->Fault(recipe).find("less than 30 mm apart"), std::string::npos);
  recipe = Recipe();
  recipe.startOffsetMm = 140.0;
  EXPECT_NE(this->Fault(recipe).find("too short"), std::string::npos) << this->Fault(recipe);
  recipe = Recipe();
  recipe.resection.cuts[0].blade.point.z -= 60.0;
  EXPECT_NE(this->Fault(recipe).find("cuts[0] does not meet bone"), std::string::npos)
    << this->Fault(recipe);
  recipe = Recipe();
  recipe.donor.radiusMm = 2.0;
  EXPECT_NE(this->Fault(recipe).find("three times donor.radiusMm"), std::string::npos)
    << this->Fault(recipe);
}

} // namespace
