#include "Evaluation/FitCertificate.h"
#include "Evaluation/SlotFit.h"
#include "GuideClaims.h"
#include "GuideFixture.h"
#include "MitreGuide.h"
#include "TransplantFixture.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

using namespace guidetest;
using namespace transplanttest;

namespace
{

class MitreGuide : public testing::Test
{
protected:
  static hasp::Transplant Plan(hasp::TransplantRecipe recipe = Recipe())
  {
    recipe.donor.axis = Bow();
    recipe.findAxis = false;
    return hasp::JointsOf(recipe);
  }
  hasp::MitreGuide Guide(
    const hasp::Transplant& plan, const hasp::MitreGuideChoices& choices = {}) const
  {
    return hasp::MakeMitreGuideRecipe(plan, this->leg.View(), 226.0, choices);
  }
  std::string Fault(const hasp::Transplant& plan, const hasp::MitreGuideChoices& choices) const
  {
    try
    {
      this->Guide(plan, choices);
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return "";
  }

  const cuttest::BoneScan leg = ScanOfLeg(glm::dvec3(0.9));
};

TEST_F(MitreGuide, HasTheDonorsPlanesAsSlotsInTheWrittenMesh)
{
  const hasp::Transplant plan = Plan();
  const hasp::MitreGuide guide = this->Guide(plan);
  for (const std::string& warning : guide.warnings)
    ADD_FAILURE() << warning;
  EXPECT_EQ(guide.recipe.slots.size(), 4U);
  EXPECT_EQ(guide.recipe.holes.size(), 4U); // at both ends, and one a segment
  Answer answer(hasp::MakeImage(this->leg.grid, this->leg.samples), guide.recipe);
  ASSERT_EQ(answer.error, "");
  const hasp::TriangleMesh mesh = ThroughFile(answer.Guide());
  const hasp::TriangleTree tree(mesh);
  const std::vector<hasp::DonorSegment> segments = hasp::LayOutSegments(plan);
  for (std::size_t n = 0; n < 4; ++n)
  {
    // The segment's own plane, half a kerf beside the slot's middle; not the recipe's numbers.
    const hasp::DonorSegment& cut = segments[n / 2];
    const bool start = n % 2 == 0;
    const hasp::TransplantJoint& plane = start ? cut.start : cut.end;
    const glm::dvec3 middle = plane.point + (start ? -0.5 : 0.5) * plan.kerfMm * plane.normal;
    const glm::dmat3 axes = hasp::SawAxes(plane.normal, guide.recipe.withdrawal);
    const double up = glm::dot(guide.recipe.slots[n].point - middle, axes[2]);
    const hasp::SlotFit fit =
      hasp::FitSlot(tree, { middle + up * axes[2], axes[0], axes[1], 1.5, 20.0, 0.1 });
    EXPECT_GT(fit.places, 1000U);
    EXPECT_FALSE(fit.blockedAt);
    EXPECT_LT(std::abs(fit.offsetMm), 0.1);
    EXPECT_LT(fit.tiltDegrees, 0.5);
    EXPECT_NEAR(fit.widthMm, 1.5, 0.1);
    std::printf("slots[%zu]: %.3f mm and %.3f degrees off its plane, %.3f mm wide\n", n,
      fit.offsetMm, fit.tiltDegrees, fit.widthMm);
  }
}

TEST_F(MitreGuide, IsCertifiedGreen)
{
  const hasp::MitreGuide guide = this->Guide(Plan());
  Answer answer(hasp::MakeImage(this->leg.grid, this->leg.samples), guide.recipe);
  ASSERT_EQ(answer.error, "");
  hasp::FindSelfIntersectionsFunction intersections = [](const hasp::TriangleMesh&)
  { return std::vector<std::array<std::uint32_t, 2>>(); };
#if HASP_WITH_CGAL
  intersections = hasp::FindSelfIntersections;
#endif
  const hasp::FitCertificate certificate = hasp::CertifyFit(ThroughFile(answer.Guide()),
    this->leg.View(), hasp::ClaimsOf(guide.recipe, 0.95, {}), intersections);
  for (const hasp::FitFault& fault : certificate.faults)
    ADD_FAILURE() << fault.text;
}

TEST_F(MitreGuide, WhatLeavesNoRoomIsNamed)
{
  hasp::TransplantRecipe recipe = Recipe();
  recipe.betweenMm = 0.0;
  const hasp::Transplant close = Plan(recipe);
  EXPECT_NE(this->Fault(close, {}).find("slots[1] and slots[2] leave a wall of"), std::string::npos)
    << this->Fault(close, {});
  EXPECT_NE(this->Fault(close, {}).find("raise donor.betweenMm by"), std::string::npos);
  const hasp::Transplant plan = Plan();
  hasp::MitreGuideChoices choices;
  choices.guidingHeightMm = 2.0;
  EXPECT_NE(this->Fault(plan, choices).find("slots[0].guidingHeightMm is 2"), std::string::npos);
  choices = {};
  choices.beyondMm = 100.0; // beyond the tip
  EXPECT_NE(
    this->Fault(plan, choices).find("no bone on the donor's lateral side"), std::string::npos);
  choices = {};
  choices.pinDiameterMm = 0.0;
  EXPECT_TRUE(this->Guide(plan, choices).recipe.holes.empty());
  choices.pinDiameterMm = 3.0;
  choices.beyondMm = 5.0; // within the first box
  const hasp::MitreGuide guide = this->Guide(plan, choices);
  EXPECT_EQ(guide.recipe.holes.size(), 2U);
  ASSERT_EQ(guide.warnings.size(), 2U);
  EXPECT_NE(guide.warnings[0].find("no pin before the first cut"), std::string::npos);
}

TEST_F(MitreGuide, TheWallThatIsAskedForMakesRoom)
{
  // The remedy in the error is enough.
  hasp::TransplantRecipe recipe = Recipe();
  recipe.betweenMm = 0.0;
  const std::string fault = this->Fault(Plan(recipe), {}), before = "raise donor.betweenMm by ";
  const std::size_t at = fault.find(before);
  ASSERT_NE(at, std::string::npos) << fault;
  recipe.betweenMm += std::stod(fault.substr(at + before.size()));
  EXPECT_EQ(this->Fault(Plan(recipe), {}), "");
}

} // namespace
