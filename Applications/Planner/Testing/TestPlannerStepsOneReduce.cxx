// Reduce: fragments in hand, by small steps, and by themselves.
#include "StepsOneDesk.h"

#include "Planning/PlanLists.h"
#include "Steps/FragmentMaking.h"
#include "Steps/FragmentTable.h"
#include "Steps/ImportPanel.h"
#include "Steps/ReducePanel.h"
#include "Tools/DistanceColours.h"
#include "vtkHaspOutputFile.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProp3D.h"
#include "vtkRenderer.h"

#include <QCheckBox>
#include <QtTest>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double GapMm = 3.0;

struct ReduceDesk : StepsOneDesk
{
  explicit ReduceDesk(const CanaryFolder& folder)
    : StepsOneDesk(folder),
      import(this->planner),
      panel(this->planner)
  {
    WriteVolume(TwoBalls(GapMm), folder.File("scan.mha"));
    this->import.ImportPath(QString::fromStdString(folder.File("scan.mha")));
    this->Settle();
    this->planner.scene.SetIsovalue(226.0);
    for (const int side : { 1, -1 })
      EXPECT_TRUE(AddBoneAt(this->planner, BallMiddle(GapMm, side)));
    this->Settle();
    this->planner.scene.LookFrom('A');
    this->Settle();
    this->left = this->Now().fragments.at(0).id;
    this->right = this->Now().fragments.at(1).id;
  }
  const PlanPose& PoseOf(PlanId id) const
  {
    return FindPlanObject<PlanFragment>(this->Now(), id)->scanToPlanned;
  }
  /// A fragment is in hand, or none is.
  bool WaitForHand(bool holds)
  {
    return this->desk.Wait([&] { return this->panel.Grab().State().held.empty() != holds; });
  }

  ImportPanel import;
  ReducePanel panel;
  PlanId left = 0, right = 0;
};

TEST(PlannerReduce, SaysWhatItNeeds)
{
  const CanaryFolder folder;
  StepsOneDesk desk(folder);
  ReducePanel panel(desk.planner);
  EXPECT_FALSE(panel.StillNeeds().isEmpty());
  EXPECT_FALSE(StepsOneDesk::Find<QAbstractButton>(panel, "reduce.grab").isEnabled());
  StepsOneDesk::Click(panel, "reduce.auto"); // disabled: nothing
  EXPECT_EQ(desk.Steps(), 0U);
}

TEST(PlannerReduce, ADragOfTheMouseIsOneStep)
{
  const CanaryFolder folder;
  ReduceDesk desk(folder);
  StepsOneDesk::Click(desk.panel, "reduce.grab");
  ASSERT_EQ(desk.planner.tools.InHand(), &desk.panel.Grab());
  ASSERT_TRUE(desk.desk.Wait([&] { return desk.panel.Grab().State().isReady; }, 60'000));
  desk.Settle();
  const std::size_t before = desk.Steps();
  int told = 0;
  QObject::connect(&desk.planner.plan, &PlanSession::Changed, &desk.panel, [&] { ++told; });
  const QPoint at = desk.PixelOf(BallMiddle(GapMm, 1)),
               to = desk.PixelOf(BallMiddle(GapMm, 1) + glm::dvec3(4.0, 0.0, 5.0));
  desk.desk.Move(desk.desk.scene, at - QPoint(30, 20));
  desk.desk.scene.framesAimed = 1e6; // a drag is drawn with half the pixels: the hand does not jump
  desk.desk.Press(desk.desk.scene, at);
  ASSERT_TRUE(desk.WaitForHand(true));
  EXPECT_EQ(desk.desk.scene.Share(), 0.5);
  EXPECT_EQ(desk.panel.Grab().State().held, std::vector<PlanId>{ desk.left });
  for (int step = 1; step <= 10; ++step)
  {
    desk.desk.Move(desk.desk.scene, at + (to - at) * step / 10);
    QTest::qWait(20);
  }
  QTest::qWait(300);               // it comes after the pointer by a spring
  EXPECT_EQ(desk.Steps(), before); // not while it is in hand
  desk.desk.Release(desk.desk.scene, to);
  ASSERT_TRUE(desk.WaitForHand(false));
  desk.Settle();
  EXPECT_EQ(desk.Steps(), before + 1) << desk.faults.join(' ').toStdString();
  EXPECT_EQ(told, 1); // whoever follows the plan knows
  // Whole pixels, of some 0.4 mm, and the spring.
  EXPECT_LT(glm::distance(desk.PoseOf(desk.left).position, { 4.0, 0.0, 5.0 }), 1.0);
  EXPECT_EQ(desk.PoseOf(desk.right), PlanPose{});
  desk.planner.plan.Undo();
  desk.Settle();
  EXPECT_EQ(desk.PoseOf(desk.left), PlanPose{});
  const double* bounds = desk.planner.scene.PropOf(desk.left)->GetBounds();
  EXPECT_LT(bounds[0], BallMiddle(GapMm, 1).x); // the prop is back, too
  StepsOneDesk::Click(desk.panel, "reduce.grab");
  EXPECT_EQ(desk.planner.tools.InHand(), nullptr);
  EXPECT_EQ(desk.Steps(), before);
}

// On a busy machine no frame comes between the two.
TEST(PlannerReduce, APressRightAfterLettingGoTakesAnotherOne)
{
  const CanaryFolder folder;
  ReduceDesk desk(folder);
  StepsOneDesk::Click(desk.panel, "reduce.grab");
  ASSERT_TRUE(desk.desk.Wait([&] { return desk.panel.Grab().State().isReady; }, 60'000));
  desk.Settle();
  const QPoint left = desk.PixelOf(BallMiddle(GapMm, 1)),
               right = desk.PixelOf(BallMiddle(GapMm, -1));
  desk.desk.Press(desk.desk.scene, left);
  ASSERT_TRUE(desk.WaitForHand(true));
  desk.desk.Release(desk.desk.scene, left);
  desk.desk.Press(desk.desk.scene, right);
  EXPECT_EQ(desk.panel.Grab().State().held, std::vector<PlanId>{ desk.right }); // at once
  desk.desk.Release(desk.desk.scene, right);
}

// What is under the pointer is what is there by now, and not what was drawn before.
TEST(PlannerReduce, APressTakesWhatTheNextFrameWouldShow)
{
  const CanaryFolder folder;
  ReduceDesk desk(folder);
  StepsOneDesk::Click(desk.panel, "reduce.grab");
  ASSERT_TRUE(desk.desk.Wait([&] { return desk.panel.Grab().State().isReady; }, 60'000));
  desk.Settle();
  desk.desk.scene.Renderer()->GetActiveCamera()->Dolly(0.4); // half as large: nearer to the middle
  desk.desk.scene.Draw();
  const QPoint left = desk.PixelOf(BallMiddle(GapMm, 1));
  desk.desk.Press(desk.desk.scene, left);
  EXPECT_TRUE(desk.WaitForHand(true));
  desk.desk.Release(desk.desk.scene, left);
}

TEST(PlannerReduce, APressIsNeverLostWithoutAWord)
{
  const CanaryFolder folder;
  ReduceDesk desk(folder);
  const QPoint at = desk.PixelOf(BallMiddle(GapMm, 1));
  StepsOneDesk::Click(desk.panel, "reduce.grab");
  desk.desk.Press(desk.desk.scene, at); // what is felt is still prepared, as a rule
  const bool isHeld = !desk.panel.Grab().State().held.empty();
  EXPECT_NE(isHeld, desk.said.join(' ').contains("still being prepared"));
  desk.desk.Release(desk.desk.scene, at);
}

TEST(PlannerReduce, ALockedFragmentStaysInTheMousesHand)
{
  const CanaryFolder folder;
  ReduceDesk desk(folder);
  desk.planner.scene.Select(desk.left);
  StepsOneDesk::Click(desk.panel, "reduce.lock");
  ASSERT_TRUE(FindPlanObject<PlanFragment>(desk.Now(), desk.left)->locked);
  StepsOneDesk::Click(desk.panel, "reduce.grab");
  ASSERT_TRUE(desk.desk.Wait([&] { return desk.panel.Grab().State().isReady; }, 60'000));
  desk.Settle();
  const std::size_t before = desk.Steps();
  const QPoint at = desk.PixelOf(BallMiddle(GapMm, 1) + glm::dvec3(6.0, 0.0, 0.0));
  desk.desk.Drag(desk.desk.scene, at, at + QPoint(0, 20));
  desk.Settle();
  EXPECT_EQ(desk.PoseOf(desk.left), PlanPose{});
  EXPECT_EQ(desk.Steps(), before + (desk.PoseOf(desk.right) == PlanPose{} ? 0 : 1));
}

TEST(PlannerReduce, SmallStepsMoveAndTurnAboutTheMiddle)
{
  const CanaryFolder folder;
  ReduceDesk desk(folder);
  desk.planner.scene.Select(desk.left);
  StepsOneDesk::Click(desk.panel, "reduce.move.left");
  EXPECT_EQ(desk.PoseOf(desk.left).position, glm::dvec3(0.5, 0.0, 0.0));
  const glm::dvec3 middle = BallMiddle(GapMm, 1), before = desk.PoseOf(desk.left).Place(middle);
  StepsOneDesk::Click(desk.panel, "reduce.turn.zplus");
  // The middle of its voxels, and not of the ball.
  EXPECT_LT(glm::distance(desk.PoseOf(desk.left).Place(middle), before), 0.05);
  EXPECT_NEAR(2.0 * std::asin(desk.PoseOf(desk.left).orientation.z), glm::radians(1.0), 1e-9);
  EXPECT_EQ(desk.PoseOf(desk.right), PlanPose{});
  StepsOneDesk::Click(desk.panel, "reduce.back");
  EXPECT_EQ(desk.PoseOf(desk.left), PlanPose{});
  desk.planner.plan.Undo();
  EXPECT_NE(desk.PoseOf(desk.left), PlanPose{});

  auto& table = StepsOneDesk::Find<FragmentTable>(desk.panel, "reduce.fragments");
  table.selectAll();
  StepsOneDesk::Click(desk.panel, "reduce.group");
  ASSERT_EQ(desk.Now().groups.size(), 1U) << desk.faults.join(' ').toStdString();
  StepsOneDesk::Click(desk.panel, "reduce.move.superior");
  EXPECT_EQ(desk.PoseOf(desk.right).position, glm::dvec3(0.0, 0.0, 0.5)); // as one
  StepsOneDesk::Click(desk.panel, "reduce.ungroup");
  EXPECT_TRUE(desk.Now().groups.empty());
  StepsOneDesk::Click(desk.panel, "reduce.mirror");
  EXPECT_EQ(desk.Now().mirrors.size(), 1U);
  StepsOneDesk::Click(desk.panel, "reduce.mirror"); // it is there
  EXPECT_EQ(desk.Now().mirrors.size(), 1U);
}

TEST(PlannerReduce, ColoursSayTheGapAsItIsNow)
{
  const CanaryFolder folder;
  ReduceDesk desk(folder);
  DistanceColours colours(desk.planner);
  colours.SetFragments({ desk.left });
  EXPECT_EQ(colours.SurfaceOf(desk.left), nullptr);
  colours.SetOn(true);
  ASSERT_TRUE(desk.Settle());
  vtkPolyData* surface = colours.SurfaceOf(desk.left);
  ASSERT_TRUE(surface);
  const auto nearest = [&]
  {
    colours.Update();
    double range[2];
    surface->GetPointData()->GetArray("SignedDistance")->GetRange(range);
    return range[0];
  };
  // Of samples of 1 mm: the mesh's facets and the distance are off by 0.1 mm each.
  EXPECT_NEAR(nearest(), GapMm, 0.2);
  ASSERT_TRUE(desk.planner.plan.Do(MovedFragment(desk.Now(), desk.left, { { -2.0, 0.0, 0.0 } })));
  EXPECT_NEAR(nearest(), GapMm - 2.0, 0.2);
  ASSERT_TRUE(desk.planner.plan.Do(MovedFragment(desk.Now(), desk.right, { { 2.0, 0.0, 0.0 } })));
  EXPECT_NEAR(nearest(), GapMm - 4.0, 0.3); // inside, where they overlap
  colours.SetOn(false);
  EXPECT_EQ(colours.SurfaceOf(desk.left), nullptr);
  EXPECT_TRUE(desk.planner.scene.PropOf(desk.left));
}

} // namespace
