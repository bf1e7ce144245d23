#include "Evaluation/FitCertificate.h"
#include "PlanRebuild.h"
#include "Planning/PlanEdits.h"
#include "TransplantFixture.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <gtest/gtest.h>

using namespace hasp;
using namespace transplanttest;

namespace
{

/// The head's scan, volume 1, and the leg's, volume 2, which has a world of its own: there its
/// fibula stands at x = 0.
class PlanTransplants : public testing::Test
{
protected:
  PlanTransplants() { this->leg.grid.origin += FromHead; }

  /// jaw 3 and fibula 4; cut 5 is the resection's first, transplant 6 begins at its face; mitre
  /// guide 7.
  static Plan Case()
  {
    TransplantRecipe recipe = Recipe();
    recipe.donor.axis = Bow();
    recipe.findAxis = false;
    PlanTransplant transplant;
    transplant.donor = 4;
    transplant.first = { 5, 0 };
    transplant.transplant = JointsOf(recipe);
    transplant.transplant.vessel.clear();
    transplant.transplant.paddle.reset();
    for (glm::dvec3& place : transplant.transplant.donor.axis)
      place += FromHead;
    Plan plan;
    const auto add = [&]<typename T>(T object)
    {
      object.id = plan.nextId;
      plan = Apply(plan, AddObject<T>{ object });
    };
    add(PlanVolume{ 0, "", std::string(64, 'a') });
    add(PlanVolume{ 0, "", std::string(64, 'b') });
    PlanFragment bone;
    bone.source = ComponentSource{ 1, 226.0, Arch().PointAt(-50.0), 1.2 };
    add(bone);
    bone.source = ComponentSource{ 2, 226.0, Bow()[17] + FromHead, 1.2 };
    add(bone);
    add(PlanCut{ 0, "", recipe.resection.cuts[0].blade, { 3 } });
    add(transplant);
    add(PlanMitreGuide{ 0, "", 6, recipe.guide });
    return plan;
  }
  PlanImages Images() const { return { { 1, this->jaw.View() }, { 2, this->leg.View() } }; }
  /// Only the leg's.
  PlanImages Leg() const { return { { 2, this->leg.View() } }; }

  static constexpr glm::dvec3 FromHead{ -150.0, 0.0, 0.0 };
  cuttest::BoneScan jaw = ScanOfJaw(), leg = ScanOfLeg(glm::dvec3(0.9));
};

/// How far the planes of the guide's slots are from those of the segments, mm.
double FarthestSlot(const PartClaims& claims, const Transplant& transplant)
{
  double farthest = 0.0;
  const std::vector<Osteotomy> cuts = DonorCuts(transplant, LayOutSegments(transplant));
  EXPECT_EQ(claims.slots.size(), cuts.size());
  for (std::size_t n = 0; n < std::min(cuts.size(), claims.slots.size()); ++n)
    farthest = std::max(farthest,
      std::abs(glm::dot(claims.slots[n].point - cuts[n].point, glm::normalize(cuts[n].normal))));
  return farthest;
}

TEST_F(PlanTransplants, TheDonorMayBeAScanOfItsOwn)
{
  Plan plan = Case();
  PlanFragment stump;
  stump.id = 8;
  stump.source = PieceSource{ 3, Arch().PointAt(-55.0) };
  plan = Apply(plan, AddObject<PlanFragment>{ stump });
  PlanTransplant graft = plan.transplants[0];
  graft.first.fragment = 8;
  plan = Apply(plan, ChangeObject<PlanTransplant>{ graft });
  EXPECT_EQ(ImagesOf(plan, 6), (std::vector<PlanId>{ 1, 2 }));
  PlanRebuild rebuild(plan, this->Images());
  const RebuiltPart made = rebuild.Make(6);
  ASSERT_EQ(made.segments.size(), 2U);
  ASSERT_EQ(made.joints.size(), 3U);
  EXPECT_GT(made.joints[0].fit.contactMm2, 20.0); // of the head's bone and the leg's
  EXPECT_LT(made.joints[0].gapMm + made.joints[0].overlapMm, 0.5);
  EXPECT_TRUE(made.warnings.empty()) << made.warnings.front();
  std::size_t first = 0;
  for (const PlanSegment& segment : made.segments)
  {
    for (std::size_t n = first; n < first + segment.triangles; ++n)
    {
      const glm::dvec3 inHead = made.mesh.points[made.mesh.triangles[n].x];
      ASSERT_TRUE(inHead.y < -40.0 && inHead.z < -75.0); // at the chin
      const glm::dvec3 inLeg = segment.cut.donorToDefect.PlaceBack(inHead);
      ASSERT_LT(std::hypot(inLeg.x, inLeg.y), 20.0);
      ASSERT_GT(inLeg.z, segment.cut.fromMm - 171.0 - 10.0);
    }
    first += segment.triangles;
  }
}

TEST_F(PlanTransplants, AMitreGuideLiesOnTheDonorAndHolds)
{
  const Plan plan = Case();
  EXPECT_EQ(ImagesOf(plan, 7), std::vector<PlanId>{ 2 }); // not the head
  PlanRebuild rebuild(plan, this->Leg());
  const RebuiltPart guide = rebuild.Make(7);
  EXPECT_EQ(guide.inputs, PartInputs(plan, 7));
  ASSERT_TRUE(guide.check);
  EXPECT_TRUE(guide.warnings.empty());
  EXPECT_LT(FarthestSlot(guide.check->claims, TransplantOf(plan, plan.transplants[0])), 1e-9);
  for (const glm::dvec3& p : guide.mesh.points)
    ASSERT_TRUE(std::abs(p.x) < 40.0 && std::abs(p.y) < 40.0);
  FindSelfIntersectionsFunction intersections = [](const TriangleMesh&)
  { return std::vector<std::array<std::uint32_t, 2>>(); };
#if HASP_WITH_CGAL
  intersections = FindSelfIntersections;
#endif
  const FitCertificate certificate =
    CertifyFit(guide.mesh, guide.check->bone, guide.check->claims, intersections);
  for (const FitFault& fault : certificate.faults)
    ADD_FAILURE() << fault.text;
}

TEST_F(PlanTransplants, AMitreGuideFollowsTheCut)
{
  Plan plan = Case();
  const double before = TransplantOf(plan, plan.transplants[0]).joints[0].point.x;
  PlanCut cut = plan.cuts[0];
  cut.blade.point -= 4.0 * glm::normalize(cut.blade.normal); // a longer first segment
  plan = Apply(plan, ChangeObject<PlanCut>{ cut });
  PlanMitreGuide bare = plan.mitreGuides[0];
  bare.choices.pinDiameterMm = 0.0;
  plan = Apply(plan, ChangeObject<PlanMitreGuide>{ bare });
  const Transplant moved = TransplantOf(plan, plan.transplants[0]);
  EXPECT_GT(std::abs(moved.joints[0].point.x - before), 1.0);
  PlanRebuild rebuild(plan, this->Leg());
  const RebuiltPart guide = rebuild.Make(7);
  EXPECT_LT(FarthestSlot(guide.check->claims, moved), 1e-9);
  EXPECT_GT(FarthestSlot(guide.check->claims, TransplantOf(Case(), Case().transplants[0])), 1.0);
  EXPECT_TRUE(guide.check->claims.holes.empty());
}

TEST_F(PlanTransplants, WhatLeavesTheGuideNoRoomIsNamed)
{
  Plan plan = Case();
  PlanTransplant close = plan.transplants[0];
  close.transplant.betweenMm = 0.0;
  plan = Apply(plan, ChangeObject<PlanTransplant>{ close });
  PlanRebuild rebuild(plan, this->Leg());
  try
  {
    rebuild.Make(7);
    ADD_FAILURE();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()).find("mitre-guide 7: slots[1] and slots[2]"), 0U)
      << error.what();
  }
}

} // namespace
