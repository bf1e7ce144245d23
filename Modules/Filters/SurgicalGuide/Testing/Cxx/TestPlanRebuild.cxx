#include "CutFixture.h"
#include "Evaluation/MeshCheck.h"
#include "PlanRebuild.h"
#include "Planning/PlanEdits.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace cuttest;
using namespace hasp;

namespace
{

constexpr double Disc = M_PI * 36.0; // of the bar's section, mm2

/// volume 1, the bar; bone 2 of it; cut 3 across it at 0, pieces 4 (left) and 5; cut 6 across 5 at
/// 10, pieces 7 and 8 of it; segmentation 9, whose label 1 is what is right of -10, as bone 10;
/// group 11 of 4 and 5, transplant 12 of 4.7 mm and more out of 2, whose first joint lies in cut
/// 3's face of 4.
Plan BarPlan()
{
  Plan plan;
  const auto add = [&]<typename T>(T object)
  {
    object.id = plan.nextId;
    plan = Apply(plan, AddObject<T>{ object });
  };
  const auto fragment = [](const auto& source)
  {
    PlanFragment made;
    made.source = source;
    return made;
  };
  add(PlanVolume{ 0, "", std::string(64, 'a') });
  add(fragment(ComponentSource{ 1, 226.0, { 3, 0, 0 }, 0.5 }));
  const auto blade = [](double x) {
    return Osteotomy{ { x, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 30.0, 30.0, 1.0 };
  };
  add(PlanCut{ 0, "", blade(0), { 2 } });
  add(fragment(PieceSource{ 2, { -10, 0, 0 } }));
  add(fragment(PieceSource{ 2, { 10, 0, 0 } }));
  add(PlanCut{ 0, "", blade(10), { 5 } });
  add(fragment(PieceSource{ 5, { 5, 0, 0 } }));
  add(fragment(PieceSource{ 5, { 15, 0, 0 } }));
  add(PlanSegmentation{ 0, "", 1, std::string(64, 'b') });
  add(fragment(LabelSource{ 9, 1, 226.0, 0.5 }));
  add(PlanGroup{ 0, "", { 4, 5 } });
  PlanTransplant transplant;
  transplant.donor = 2;
  transplant.first = { 3, 4 };
  transplant.transplant.joints =
    MitreJoints(std::vector<glm::dvec3>{ { -0.5, 0, 0 }, { 20, 0, 0 } });
  transplant.transplant.outward = { { 0, 0, 1 } };
  transplant.transplant.donor = { { { -26, 0, 0 }, { 26, 0, 0 } }, { 0, 0, 1 }, 6.0, 8.0 };
  add(transplant);
  return plan;
}

struct Bar
{
  BoneScan scan = ScanOfBar();
  std::vector<std::uint8_t> labels = std::vector<std::uint8_t>(scan.samples.size());

  Bar()
  {
    for (int k = 0; k < this->scan.grid.dims.z; ++k)
      for (int j = 0; j < this->scan.grid.dims.y; ++j)
        for (int i = 0; i < this->scan.grid.dims.x; ++i)
          if (this->scan.grid.IndexToWorld(glm::dvec3(i, j, k)).x > -10.0)
            this
              ->labels[(std::size_t(k) * this->scan.grid.dims.y + j) * this->scan.grid.dims.x + i] =
              1;
  }
  PlanImages Images() const
  {
    return { { 1, this->scan.View() },
      { 9, GridView<const std::uint8_t>{ this->labels.data(), this->scan.grid } } };
  }
};

std::string Refusal(PlanRebuild& rebuild, PlanId object)
{
  try
  {
    rebuild.Make(object);
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

TEST(PlanRebuild, PiecesHaveTheClosedFormsVolumes)
{
  const Bar bar;
  PlanRebuild rebuild(BarPlan(), bar.Images());
  const double whole = Disc * 40.0 + 4.0 / 3.0 * M_PI * 216.0, end = 2.0 / 3.0 * M_PI * 216.0;
  EXPECT_NEAR(rebuild.Make(2).volumeMm3, whole, 0.01 * whole);
  const RebuiltPart left = rebuild.Make(4);
  EXPECT_NEAR(left.volumeMm3, Disc * 19.5 + end, 0.01 * whole);
  EXPECT_TRUE(CheckMesh(left.mesh).Sound());
  ASSERT_EQ(left.cuts.size(), 1U);
  EXPECT_EQ(left.cuts[0].cut, 3U);
  EXPECT_NEAR(left.cuts[0].measure.areaMm2, Disc, 0.02 * Disc);
  EXPECT_EQ(left.inputs, PartInputs(BarPlan(), 4));
  // A piece of a piece: of both cuts.
  const RebuiltPart middle = rebuild.Make(7);
  EXPECT_NEAR(middle.volumeMm3, Disc * 9.0, 0.02 * Disc * 9.0);
  ASSERT_EQ(middle.cuts.size(), 2U);
  EXPECT_EQ(middle.cuts[1].cut, 6U);
  EXPECT_NEAR(rebuild.Make(8).volumeMm3, Disc * 9.5 + end, 0.01 * whole);
}

TEST(PlanRebuild, ALabelIsABone)
{
  const Bar bar;
  PlanRebuild rebuild(BarPlan(), bar.Images());
  const double volume = Disc * 30.0 + 2.0 / 3.0 * M_PI * 216.0;
  EXPECT_NEAR(rebuild.Make(10).volumeMm3, volume, 0.02 * volume); // labels are whole voxels
}

TEST(PlanRebuild, AGroupIsItsKeptFragmentsAsPlanned)
{
  const Bar bar;
  Plan plan = BarPlan();
  const glm::dquat turn = glm::angleAxis(0.5, glm::dvec3(0, 0, 1));
  plan = Apply(plan, PoseFragments{ { { 5, { { 0, 0, 50 }, turn } } } });
  PlanRebuild rebuild(plan, bar.Images());
  const RebuiltPart both = rebuild.Make(11), left = rebuild.Make(4), right = rebuild.Make(5);
  EXPECT_TRUE(CheckMesh(both.mesh).Sound());
  const double sum = left.volumeMm3 + right.volumeMm3;
  EXPECT_NEAR(both.volumeMm3, sum, 0.01 * sum); // sampled anew
  const auto middleOf = [](const TriangleMesh& mesh, bool above)
  {
    glm::dvec3 low(1e9), high(-1e9);
    for (const glm::dvec3& p : mesh.points)
      if ((p.z > 25.0) == above)
      {
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    return 0.5 * (low + high);
  };
  TriangleMesh moved = right.mesh;
  for (glm::dvec3& p : moved.points)
    p = glm::dvec3(0, 0, 50) + turn * p;
  // Edges are rounded by up to 0.8 spacings of 0.5 mm, and the cut's is at one end alone.
  EXPECT_LT(glm::distance(middleOf(both.mesh, true), middleOf(moved, true)), 0.2);
  EXPECT_LT(glm::distance(middleOf(both.mesh, false), middleOf(left.mesh, false)), 0.2);
  PlanRebuild resected(Apply(plan, SetFragmentState{ { 5 } }), bar.Images());
  EXPECT_NEAR(resected.Make(11).volumeMm3, left.volumeMm3, 0.01 * left.volumeMm3);
  PlanRebuild none(Apply(plan, SetFragmentState{ { 4, 5 } }), bar.Images());
  EXPECT_EQ(Refusal(none, 11), "group 11: none of its fragments is kept");
}

TEST(PlanRebuild, AGuideSaysItsCaseSideAndPlan)
{
  const Bar bar;
  Plan plan = Apply(BarPlan(), SetCaseLabel{ "7" });
  PlanGuide guide{ 13, "", 1, {}, {}, BodySide::Left };
  guide.recipe.landmarks = { { -18, 0, 6 }, { 18, 0, 6 } };
  guide.recipe.widthMm = 6;
  guide.recipe.spacingMm = 0.3;
  GuideLabel& label = guide.recipe.labels.emplace_back();
  label.point = { 0, 0, 6 };
  label.right = { 1, 0, 0 };
  label.heightMm = 3.6;
  label.kind = GuideLabelKind::Case;
  plan = Apply(plan, AddObject<PlanGuide>{ guide });
  const std::string text = GuideLabelText("7", BodySide::Left, PlanHash(plan));
  ASSERT_EQ(text.size(), 12U); // "7 L 3FA41B2C"
  const RebuiltPart made = PlanRebuild(plan, bar.Images()).Make(13);
  label.kind = GuideLabelKind::Text;
  label.text = text;
  plan = Apply(plan, ChangeObject<PlanGuide>{ guide });
  EXPECT_EQ(PlanRebuild(plan, bar.Images()).Make(13).mesh.points, made.mesh.points);
}

TEST(PlanRebuild, ATransplantIsRecutWhenTheCutMoves)
{
  const Bar bar;
  Plan plan = BarPlan();
  PlanRebuild rebuild(plan, bar.Images());
  const RebuiltPart before = rebuild.Make(12);
  ASSERT_EQ(before.segments.size(), 1U);
  EXPECT_NEAR(before.segments[0].cut.lengthMm, 20.5, 1e-9);
  EXPECT_NEAR(before.volumeMm3, Disc * 20.5, 0.02 * Disc * 20.5);
  EXPECT_EQ(before.segments[0].triangles, before.mesh.triangles.size());
  ASSERT_EQ(before.joints.size(), 2U);
  EXPECT_NEAR(before.joints[0].fit.contactMm2, Disc, 0.05 * Disc); // of the same bar
  const JointFit& bare = before.joints[1].fit;                     // the plan names no jaw
  EXPECT_EQ(bare.contactMm2 + bare.gapMm2 + bare.overlapMm2, 0.0);
  EXPECT_NEAR(bare.stepMm2, Disc, 0.05 * Disc);
  PlanTransplant apart = plan.transplants[0];
  apart.first.cut = 0;
  apart.transplant.joints[0].point.x = 0.5; // the jaw's face is at -0.5
  PlanRebuild loose(Apply(plan, ChangeObject<PlanTransplant>{ apart }), bar.Images());
  const RebuiltPart far = loose.Make(12);
  EXPECT_NEAR(far.joints[0].gapMm, 1.0, 0.1);
  EXPECT_EQ(far.joints[0].overlapMm, 0.0);
  EXPECT_TRUE(before.warnings.empty()); // though there is no bone at the other end
  ASSERT_EQ(far.warnings.size(), 1U);
  EXPECT_EQ(far.warnings[0].find("joints[0]: a gap of "), 0U) << far.warnings[0];
  EXPECT_NE(far.warnings[0].find("at most 0.5 mm are asked for"), std::string::npos);
  apart.mostGapMm = 2.0;
  PlanRebuild allowed(Apply(plan, ChangeObject<PlanTransplant>{ apart }), bar.Images());
  EXPECT_TRUE(allowed.Make(12).warnings.empty());
  PlanCut cut = plan.cuts[0];
  cut.blade.point.x = 4.0;
  plan = Apply(plan, ChangeObject<PlanCut>{ cut });
  PlanRebuild moved(plan, bar.Images());
  EXPECT_NEAR(moved.Make(12).segments[0].cut.lengthMm, 16.5, 1e-9);
}

TEST(PlanRebuild, WhatIsMissingOrImpossibleIsNamedByIds)
{
  const Bar bar;
  Plan plan = BarPlan();
  EXPECT_EQ(ImagesOf(plan, 4), std::vector<PlanId>{ 1 });
  EXPECT_EQ(ImagesOf(plan, 10), (std::vector<PlanId>{ 1, 9 }));
  PlanRebuild blind(plan, {});
  EXPECT_EQ(Refusal(blind, 4), "fragment 4: volume 1 is not among those given");
  EXPECT_EQ(Refusal(blind, 3).find("cut 3: nothing is made of it"), 0U);
  PlanImplant implant{ 13, "", 1, {} };
  implant.recipe.outline = { { 0, 0, 6 }, { 5, 0, 6 }, { 0, 5, 6 } };
  plan = Apply(plan, AddObject<PlanImplant>{ implant });
  PlanFragment far = plan.fragments[0];
  far.id = 14;
  far.source = ComponentSource{ 1, 226.0, { 0, 0, 25 }, 0.5 };
  plan = Apply(plan, AddObject<PlanFragment>{ far });
  PlanRebuild rebuild(plan, bar.Images());
  EXPECT_EQ(Refusal(rebuild, 13).find("implant 13: "), 0U);
  EXPECT_EQ(Refusal(rebuild, 14).find("fragment 14: there is no bone at source.seed"), 0U);
  EXPECT_THROW(rebuild.Make(4, [](double) { return false; }), Cancelled);
  // Of another part, with the fragment that is at fault.
  plan = Apply(plan, AddObject<PlanGroup>{ { 15, "", { 4, 14 } } });
  PlanGuide guide{ 16, "", 14, {}, {}, BodySide::Left };
  guide.recipe.landmarks = { { -18, 0, 6 }, { 18, 0, 6 } };
  plan = Apply(plan, AddObject<PlanGuide>{ guide });
  PlanRebuild others(plan, bar.Images());
  EXPECT_EQ(Refusal(others, 15).find("group 15: fragment 14: there is no bone at source.seed"), 0U);
  EXPECT_EQ(Refusal(others, 16).find("guide 16: fragment 14: there is no bone at source.seed"), 0U);
}

TEST(PlanRebuild, RefusalsSayOnceWhatTheyAreOf)
{
  const Bar bar;
  PlanPlate plate{ 13, "", 1, {}, {} };
  plate.recipe.landmarks = { { -18, 0, 40 }, { 18, 0, 40 } }; // in the air
  PlanRebuild rebuild(Apply(BarPlan(), AddObject<PlanPlate>{ plate }), bar.Images());
  const std::string said = Refusal(rebuild, 13);
  EXPECT_EQ(said.find("plate 13: "), 0U) << said;
  EXPECT_EQ(said.find("plate: "), std::string::npos) << said;
}

} // namespace
