// Guides as a surgeon makes them: by touching bone, typing and ticking.
#include "StepsDesk.h"

#include "Planning/PlanLists.h"
#include "Steps/GuidePanel.h"

#include <QDoubleSpinBox>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

using namespace hasp;
using namespace hasp::testing;

namespace
{

/// A guide panel beside the bar, which a cut goes through.
class GuideSteps : public ::testing::Test
{
protected:
  GuideSteps() : cut(this->desk.CutBar(0.0)), panel(this->desk.planner)
  {
    this->desk.Show(&this->panel);
  }
  void TouchGuide()
  {
    this->desk.Press("guide.new");
    for (const double x : { -12.0, -4.0, 4.0, 12.0 })
      this->desk.Touch(Front(x));
    this->desk.planner.tools.Take(nullptr);
    ASSERT_EQ(this->desk.Now().guides.size(), 1U) << this->desk.TextOf("guide.fault").toStdString();
  }
  const PlanGuide& Guide() const { return this->desk.Now().guides.at(0); }

  StepsDesk desk{ ScanOfBar() };
  PlanId cut;
  GuidePanel panel;
};

TEST_F(GuideSteps, ANewOneComesIntoThePlanWhenItIsComplete)
{
  this->desk.Press("guide.new");
  this->desk.Touch(Front(-12.0));
  EXPECT_TRUE(this->desk.Now().guides.empty());
  EXPECT_FALSE(this->desk.TextOf("guide.fault").isEmpty()); // what it still needs
  const std::size_t steps = this->desk.Steps();
  this->desk.Touch(Front(12.0));
  ASSERT_EQ(this->desk.Now().guides.size(), 1U);
  EXPECT_EQ(this->desk.Steps(), steps + 1);
  EXPECT_TRUE(this->desk.TextOf("guide.fault").isEmpty());
  EXPECT_EQ(this->Guide().bone, this->desk.Now().fragments[0].id);
  EXPECT_EQ(this->Guide().cuts, std::vector<PlanId>{ this->cut });
  EXPECT_EQ(this->Guide().recipe.isovalue, 226.0);
  for (const glm::dvec3& landmark : this->Guide().recipe.landmarks)
    EXPECT_LT(OffBar(landmark), SurfaceMm);
  // The bar's normal in front; of grey values that are whole numbers, in samples of 1 mm.
  EXPECT_LT(glm::distance(this->Guide().recipe.withdrawal, glm::dvec3(0, -1, 0)), 0.15);
  this->desk.planner.plan.Undo();
  EXPECT_TRUE(this->desk.Now().guides.empty());
  this->desk.planner.plan.Redo();
  EXPECT_EQ(this->desk.Now().guides.size(), 1U);
}

TEST_F(GuideSteps, WhatIsTypedIsInThePlanAndUndone)
{
  this->TouchGuide();
  const PlanGuide before = this->Guide();
  const std::size_t steps = this->desk.Steps();
  this->desk.Type("guide.gap", "0.5");
  EXPECT_EQ(this->Guide().recipe.gapMm, 0.5);
  EXPECT_EQ(this->desk.Steps(), steps + 1);
  this->desk.Press("guide.clearance.fdm");
  EXPECT_EQ(this->Guide().recipe.clearanceMm, FdmClearanceMm);
  this->desk.Type("guide.withdrawal", "0 -3 0");
  EXPECT_EQ(this->Guide().recipe.withdrawal, glm::dvec3(0, -1, 0));
  this->desk.Choose("guide.outline", 1);
  EXPECT_EQ(this->Guide().recipe.outline, GuideOutline::Closed);
  this->desk.Press(("guide.cut." + std::to_string(this->cut)).c_str());
  EXPECT_TRUE(this->Guide().cuts.empty());
  this->desk.Choose("guide.side", 2);
  EXPECT_EQ(this->Guide().side, BodySide::Right);
  EXPECT_EQ(this->desk.Steps(), steps + 6);
  for (int n = 0; n < 6; ++n)
    this->desk.planner.plan.Undo();
  EXPECT_EQ(this->Guide(), before);
  EXPECT_EQ(static_cast<QDoubleSpinBox*>(this->desk.Find("guide.gap"))->value(), 0.3);
}

TEST_F(GuideSteps, WhatIsNotLegalIsRefusedInWordsAndLeavesThePlan)
{
  this->TouchGuide();
  const Plan before = this->desk.Now();
  this->desk.Type("guide.thickness", "0.3"); // thinner than two steps of its grid
  EXPECT_EQ(this->desk.Now(), before);
  const QString fault = this->desk.TextOf("guide.fault");
  EXPECT_TRUE(fault.contains("Thickness") && fault.contains("0.3")) << fault.toStdString();
  EXPECT_FALSE(fault.contains("thicknessMm"));
  this->desk.Type("guide.thickness", "3");
  EXPECT_EQ(this->Guide().recipe.thicknessMm, 3.0);
  EXPECT_TRUE(this->desk.TextOf("guide.fault").isEmpty());
  this->desk.Type("guide.withdrawal", "up");
  EXPECT_FALSE(this->desk.TextOf("guide.fault").isEmpty());
}

TEST_F(GuideSteps, PinsAndTheLabelAreTouched)
{
  this->TouchGuide();
  this->desk.Press("guide.pins");
  this->desk.Touch(Front(-9.0));
  this->desk.Touch(Front(9.0));
  ASSERT_EQ(this->Guide().recipe.holes.size(), 2U);
  EXPECT_EQ(this->Guide().recipe.holes[0].axis, this->Guide().recipe.withdrawal);
  this->desk.Type("guide.pin.diameter", "2"); // of the chosen one: the last
  EXPECT_EQ(this->Guide().recipe.holes[0].diameterMm, 3.0);
  EXPECT_EQ(this->Guide().recipe.holes[1].diameterMm, 2.0);
  this->desk.Type("guide.withdrawal", "0 -1 0");
  EXPECT_EQ(this->Guide().recipe.holes[0].axis, glm::dvec3(0, -1, 0)); // pins go with it
  this->desk.Press("guide.label");
  this->desk.Touch(Front(4.0));
  ASSERT_EQ(this->Guide().recipe.labels.size(), 1U);
  EXPECT_EQ(this->Guide().recipe.labels[0].kind, GuideLabelKind::Case);
  EXPECT_GT(this->Guide().recipe.labels[0].right.x, 0.99); // the patient's left, as one looks
  this->desk.Press("guide.label.remove");
  EXPECT_TRUE(this->Guide().recipe.labels.empty());
}

TEST_F(GuideSteps, AnAreaIsPaintedByDragsOnBone)
{
  this->desk.Press("guide.new");
  this->desk.Type("guide.brush", "4");
  this->desk.Press("guide.paint");
  const std::size_t steps = this->desk.Steps();
  const glm::dvec3 eye = EyeOf(this->desk.views.scene);
  this->desk.Drag(Front(-10.0), this->desk.PixelOf(Front(10.0)) - this->desk.PixelOf(Front(-10.0)));
  EXPECT_EQ(EyeOf(this->desk.views.scene), eye);
  ASSERT_EQ(this->desk.Now().guides.size(), 1U) << this->desk.TextOf("guide.fault").toStdString();
  EXPECT_EQ(this->desk.Steps(), steps + 1);
  ASSERT_EQ(this->Guide().recipe.strokes.size(), 1U);
  const GuideStroke& stroke = this->Guide().recipe.strokes[0];
  EXPECT_EQ(stroke.radiusMm, 4.0);
  EXPECT_GE(stroke.points.size(), 8U); // 20 mm, of ten moves
  for (const glm::dvec3& point : stroke.points)
    EXPECT_LT(OffBar(point), SurfaceMm);
  EXPECT_LT(glm::distance(this->Guide().recipe.withdrawal, glm::dvec3(0, -1, 0)), 0.15);
  this->desk.Press("guide.wipe");
  this->desk.Drag(Front(0.0), { 6, 0 });
  ASSERT_EQ(this->Guide().recipe.strokes.size(), 2U);
  EXPECT_TRUE(this->Guide().recipe.strokes[1].erased);
  this->desk.Drag(glm::dvec3(0, 0, 25.0), { 30, 20 }); // beside bone
  EXPECT_NE(EyeOf(this->desk.views.scene), eye);
  EXPECT_EQ(this->Guide().recipe.strokes.size(), 2U);
}

TEST_F(GuideSteps, ItIsMadeAndSaysWhenItIsOutOfDate)
{
  this->TouchGuide();
  const Plan before = this->desk.Now();
  this->desk.Type("guide.spacing", "0.8"); // too coarse for the slot of a saw of 1 mm
  EXPECT_TRUE(this->desk.TextOf("guide.fault").contains("cut 3"));
  EXPECT_NE(this->desk.Now(), before); // the plan takes it: another cut may do
  this->desk.Type("guide.spacing", "0.7");
  EXPECT_EQ(this->desk.TextOf("guide.fault"), "");
  EXPECT_TRUE(this->desk.TextOf("guide.status").contains("has not been made"));
  this->desk.Press("guide.make");
  this->desk.Settle();
  EXPECT_EQ(this->desk.TextOf("guide.status"), "In date.") << this->desk.said.toStdString();
  PlanCut moved = this->desk.Now().cuts[0];
  moved.blade.point.x += 1.0;
  this->desk.planner.plan.Do(ChangeObject<PlanCut>{ moved });
  const QString status = this->desk.TextOf("guide.status");
  EXPECT_TRUE(status.contains("out of date") && status.contains("cut")) << status.toStdString();
}

} // namespace
