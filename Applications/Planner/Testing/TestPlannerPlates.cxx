// Plates, implants and transplants as a surgeon makes them: by touching bone and typing.
#include "StepsDesk.h"

#include "Grid/Phantom.h"
#include "Planning/PlanEditsFile.h"
#include "Planning/PlanLists.h"
#include "Steps/PlatePanel.h"
#include "vtkHaspVolumeView.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include <glm/geometric.hpp>

using namespace hasp;
using namespace hasp::testing;

namespace
{

TEST(PlatePanel, APlateGoesWhereItsFragmentIsPlanned)
{
  StepsDesk desk(ScanOfBar());
  desk.CutBar(0.0);
  const PlanId bone = desk.Now().fragments[0].id;
  desk.planner.plan.Do(MovedFragment(desk.Now(), bone, { { 0, 0, 4 } }));
  desk.Settle();
  PlatePanel panel(desk.planner);
  desk.Show(&panel);
  desk.Press("plate.new");
  for (const double x : { -12.0, 0.0, 12.0 })
    desk.Touch(Front(x) + glm::dvec3(0, 0, 4));
  ASSERT_EQ(desk.Now().plates.size(), 1U) << desk.TextOf("plate.fault").toStdString();
  EXPECT_EQ(desk.Now().plates[0].fragments, std::vector<PlanId>{ bone });
  for (const glm::dvec3& landmark : desk.Now().plates[0].recipe.landmarks)
    EXPECT_LT(OffBar(landmark - glm::dvec3(0, 0, 4)), SurfaceMm);
  desk.Press("plate.screws");
  desk.Touch(Front(-10.0) + glm::dvec3(0, 0, 4));
  desk.Touch(Front(10.0) + glm::dvec3(0, 0, 4));
  ASSERT_EQ(desk.Now().plates[0].recipe.screws.size(), 2U);
  desk.Type("plate.screw.length", "6");
  EXPECT_EQ(desk.Now().plates[0].recipe.screws[1].lengthMm, 6.0);
  EXPECT_EQ(desk.Now().plates[0].recipe.screws[0].lengthMm, 8.0);
  const Plan before = desk.Now();
  desk.Type("plate.bevel", "2.4"); // at most a third of the width
  EXPECT_EQ(desk.Now(), before);
  EXPECT_TRUE(desk.TextOf("plate.fault").contains("Bevel"));
}

TEST(PlatePanel, AnImplantsOutlineIsTyped)
{
  StepsDesk desk(ScanOfBar());
  PlatePanel panel(desk.planner);
  desk.Show(&panel);
  desk.Press("implant.new");
  const std::vector<glm::dvec3> outline{ { -9, -6, 0 }, { 0, -5, 4 }, { 9, -6, 0 } };
  desk.TypePoints("implant.outline", outline);
  ASSERT_EQ(desk.Now().implants.size(), 1U) << desk.TextOf("implant.fault").toStdString();
  EXPECT_EQ(desk.Now().implants[0].recipe.outline, outline);
  EXPECT_EQ(desk.Now().implants[0].volume, 1U);
  desk.Type("implant.axis", "0 -1 0");
  EXPECT_EQ(desk.Now().implants[0].recipe.axis, std::optional(glm::dvec3(0, -1, 0)));
  desk.Press("implant.axis.upright");
  EXPECT_FALSE(desk.Now().implants[0].recipe.axis);
}

vtkSmartPointer<vtkImageData> PhantomScan(PhantomAnatomy anatomy, const glm::ivec3& dims,
  const glm::dvec3& origin, const glm::dvec3& spacing)
{
  PhantomSettings settings;
  settings.anatomy = anatomy;
  const GridGeometry grid{ dims, origin, spacing, glm::dmat3(1) };
  return MakeImage(grid, SamplePhantom(grid, settings));
}

/// The phantom's jaw, and its leg in a world of its own, with all of Data's edits before the
/// transplant: jaw 3, cuts 4 and 5, stumps 6 and 7, the chin 8 resected, fibula 9.
class TransplantSteps : public ::testing::Test
{
protected:
  TransplantSteps()
  {
    this->desk.Add(
      PhantomScan(PhantomAnatomy::Fibula, { 22, 22, 239 }, { -12, -16, -179 }, { 1.1, 1.1, 1.5 }));
    std::ifstream file(HASP_TRANSPLANT_EDITS);
    std::ostringstream text;
    text << file.rdbuf();
    std::vector<PlanEdit> edits = ParseEdits(text.str());
    edits.erase(edits.begin(), edits.begin() + 2); // the volumes are there
    for (PlanEdit& edit : edits)
      if (auto* fragment = std::get_if<AddObject<PlanFragment>>(&edit))
        if (auto* bone = std::get_if<ComponentSource>(&fragment->object.source))
          bone->spacingMm = 1.6; // of these coarse scans
    this->wanted = std::get<AddObject<PlanTransplant>>(edits.at(8)).object;
    this->mitre = std::get<AddObject<PlanMitreGuide>>(edits.at(9)).object;
    edits.resize(8);
    EXPECT_TRUE(this->desk.planner.plan.Do(std::move(edits)));
    this->desk.Show(&this->panel);
    this->desk.Settle();
  }

  StepsDesk desk{ PhantomScan(
    PhantomAnatomy::Head, { 63, 54, 34 }, { -62, -92, -125 }, glm::dvec3(2.0)) };
  PlatePanel panel{ this->desk.planner };
  PlanTransplant wanted;
  PlanMitreGuide mitre;
};

TEST_F(TransplantSteps, DatasTransplantIsMadeByTouchingAndTyping)
{
  const Transplant& bone = this->wanted.transplant;
  this->desk.Press("transplant.new");
  this->desk.Press("transplant.path"); // the tool away again: it is typed
  std::vector<glm::dvec3> path;
  for (const TransplantJoint& joint : bone.joints)
    path.push_back(joint.point);
  this->desk.TypePoints("transplant.path", path);
  this->desk.Choose("transplant.first.cut", 1);
  this->desk.Choose("transplant.first.fragment", 2);
  this->desk.Choose("transplant.last.cut", 2);
  this->desk.Choose("transplant.last.fragment", 3);
  this->desk.Choose("transplant.donor", 5); // fragments 3, 6, 7, 8, 9
  this->desk.Press("transplant.look.donor");
  EXPECT_TRUE(this->desk.planner.scene.IsVisible(9));
  EXPECT_FALSE(this->desk.planner.scene.IsVisible(6));
  this->desk.Settle();
  this->desk.Press("transplant.tips");
  this->desk.Touch({ 0, 0, -171 });
  this->desk.Touch({ 0, 0, 171 });
  ASSERT_EQ(this->desk.Now().transplants.size(), 1U)
    << this->desk.TextOf("transplant.fault").toStdString();
  EXPECT_FALSE(this->desk.planner.scene.IsVisible(this->desk.Now().transplants[0].id))
    << "it lies in the jaw's world, and the leg is shown";
  this->desk.Type("transplant.lateral", "0.807391 -0.590017 0");
  this->desk.Type("transplant.between", "5");
  this->desk.views.Wait(
    [this] { return !this->desk.planner.jobs.IsIdle(); }, 2000); // it rests before
  this->desk.Settle();
  this->desk.TypePoints("transplant.vessel", bone.vessel);
  this->desk.TypePoints("transplant.paddle", bone.paddle->outline);
  this->desk.TypePoints("transplant.perforator", { bone.paddle->perforator });
  const PlanTransplant& made = this->desk.Now().transplants[0];
  EXPECT_EQ(made.donor, this->wanted.donor);
  EXPECT_EQ(made.first, this->wanted.first);
  EXPECT_EQ(made.last, this->wanted.last);
  ASSERT_EQ(made.transplant.joints.size(), bone.joints.size());
  for (std::size_t n = 0; n < bone.joints.size(); ++n)
  {
    // The file's numbers have four decimals, its normals six.
    EXPECT_LT(glm::distance(made.transplant.joints[n].point, bone.joints[n].point), 1e-3);
    EXPECT_LT(glm::distance(made.transplant.joints[n].normal, bone.joints[n].normal), 1e-4);
  }
  EXPECT_EQ(made.transplant.outward, bone.outward);
  EXPECT_LT(glm::distance(made.transplant.donor.lateral, bone.donor.lateral), 1e-5);
  EXPECT_EQ(made.transplant.betweenMm, bone.betweenMm);
  EXPECT_EQ(made.transplant.vessel, bone.vessel);
  EXPECT_EQ(made.transplant.paddle, bone.paddle);
  ASSERT_GT(made.transplant.donor.axis.size(), 20U) << this->desk.said.toStdString();
  for (std::size_t n = 1; n + 1 < made.transplant.donor.axis.size(); ++n)
  {
    const glm::dvec3& place = made.transplant.donor.axis[n];
    EXPECT_NEAR(place.y, -5.0 * (1.0 - place.z * place.z / 28'900.0), 2.0); // its bow
  }
  EXPECT_TRUE(this->desk.TextOf("transplant.segments").contains("Segment 2"));
  this->desk.Press("mitre.new");
  ASSERT_EQ(this->desk.Now().mitreGuides.size(), 1U);
  EXPECT_EQ(this->desk.Now().mitreGuides[0].choices, this->mitre.choices);
}

TEST_F(TransplantSteps, SegmentsComeAndGoAndWhatIsTooShortIsSaid)
{
  PlanTransplant transplant = this->wanted;
  transplant.id = this->desk.planner.plan.NewId();
  this->desk.planner.plan.Do(AddObject<PlanTransplant>{ transplant });
  this->desk.planner.scene.Select(transplant.id);
  this->desk.Press("transplant.more"); // the longest of 26 mm in two
  EXPECT_EQ(this->desk.Now().transplants[0].transplant.joints.size(), 3U);
  EXPECT_FALSE(this->desk.TextOf("transplant.fault").isEmpty());
  this->desk.Type("transplant.least", "10");
  this->desk.Press("transplant.more");
  ASSERT_EQ(this->desk.Now().transplants[0].transplant.joints.size(), 4U);
  EXPECT_EQ(this->desk.Now().transplants[0].transplant.outward.size(), 3U);
  this->desk.Press("transplant.less");
  EXPECT_EQ(this->desk.Now().transplants[0].transplant.joints.size(), 3U);
  this->desk.Type("transplant.keep", "170"); // no bone is left between the tips
  EXPECT_TRUE(this->desk.TextOf("transplant.segments").contains("too short"));
}

} // namespace
