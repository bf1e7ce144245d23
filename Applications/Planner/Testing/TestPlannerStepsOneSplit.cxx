// Split: what is painted becomes steps of the plan, labels and fragments.
#include "SplitDesk.h"

#include "Planning/PlanLists.h"
#include "Tools/StrokeEdits.h"
#include "View/BlobFile.h"
#include "vtkHaspOutputFile.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QListWidget>

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace
{

using namespace hasp;
using namespace hasp::testing;

std::set<std::uint16_t> LabelsIn(const std::vector<std::uint16_t>& samples)
{
  return { samples.begin(), samples.end() };
}

TEST(PlannerSplit, SaysWhatItNeeds)
{
  const CanaryFolder folder;
  StepsOneDesk desk(folder);
  SplitPanel panel(desk.planner);
  EXPECT_EQ(panel.StillNeeds(), "Import a scan first.");
  EXPECT_FALSE(StepsOneDesk::Find<QAbstractButton>(panel, "split.paint").isEnabled());
  EXPECT_FALSE(panel.Paint().PaintAt({ 0, 0, 0 })); // said, no crash and no step
  EXPECT_EQ(desk.faults.size(), 1);
  EXPECT_EQ(desk.Steps(), 0U);
}

TEST(PlannerSplit, AStrokeIsOneStepAndLabelsAreTheRecipes)
{
  const CanaryFolder folder;
  SplitDesk desk(folder);
  EXPECT_EQ(desk.panel.StillNeeds(), "");
  const std::size_t before = desk.Steps();
  StepsOneDesk::Click(desk.panel, "split.paint");
  desk.Paint(2, 1);
  ASSERT_EQ(desk.Steps(), before + 1) << desk.faults.join(' ').toStdString();
  ASSERT_EQ(desk.Now().segmentations.size(), 1U);
  desk.Paint(3, -1);
  EXPECT_EQ(desk.Steps(), before + 2);
  EXPECT_EQ(desk.Recipe().steps.size(), 2U); // a threshold and a split
  EXPECT_EQ(LabelsIn(desk.Shown()), (std::set<std::uint16_t>{ 0, 2, 3 }));
  EXPECT_EQ(desk.Shown(), desk.Segmented()); // to the last bit

  desk.planner.plan.Undo();
  desk.panel.Paint().Preview().Finish();
  EXPECT_EQ(LabelsIn(desk.Shown()), (std::set<std::uint16_t>{ 0, 2 }));
  EXPECT_EQ(desk.Shown(), desk.Segmented());
  desk.planner.plan.Undo();
  desk.panel.Paint().Preview().Finish();
  EXPECT_EQ(LabelsIn(desk.Shown()), (std::set<std::uint16_t>{ 0 }));
  EXPECT_TRUE(desk.Now().segmentations.empty());
  desk.planner.plan.Redo();
  desk.planner.plan.Redo();
  desk.panel.Paint().Preview().Finish();
  EXPECT_EQ(desk.Shown(), desk.Segmented());
}

TEST(PlannerSplit, ADragInASliceIsAStrokeToo)
{
  const CanaryFolder folder;
  SplitDesk desk(folder);
  const std::size_t before = desk.Steps();
  StepsOneDesk::Click(desk.panel, "split.paint");
  desk.Settle();
  const QPoint at = desk.desk.axial.PixelOf(BallMiddle(JoinedMm, 1)).value().toPoint();
  desk.desk.Drag(desk.desk.axial, at, at + QPoint(4, 0));
  ASSERT_EQ(desk.Steps(), before + 1) << desk.faults.join(' ').toStdString();
  // In the plane of the slice, at the middle of the ball.
  const auto& split = *SplitOf(desk.Now().segmentations.at(0));
  EXPECT_NEAR(split.strokes.at(0).points.at(0).z, desk.planner.views.Crosshair().z, 0.5);
}

TEST(PlannerSplit, TheEraserTakesStrokesAwayInOneStep)
{
  const CanaryFolder folder;
  SplitDesk desk(folder);
  StepsOneDesk::Click(desk.panel, "split.paint");
  desk.Paint(2, 1);
  desk.Paint(3, -1);
  const std::size_t before = desk.Steps();
  StepsOneDesk::Find<QCheckBox>(desk.panel, "split.eraser").setChecked(true);
  StepsOneDesk::Find<QDoubleSpinBox>(desk.panel, "split.radius").setValue(5.0);
  desk.Paint(3, -1);
  EXPECT_EQ(desk.Steps(), before + 1);
  EXPECT_EQ(LabelsIn(desk.Shown()), (std::set<std::uint16_t>{ 0, 2 }));
  EXPECT_EQ(desk.Shown(), desk.Segmented());
  desk.Paint(3, -1); // nothing is left there
  EXPECT_EQ(desk.Steps(), before + 1);
}

TEST(PlannerSplit, ErasedStrokesAreCutWhereTheEraserWas)
{
  const BrushStroke line{ 2, 1.0, { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } } };
  const BrushStroke ball{ 3, 1.0, { { 9, 9, 9 } } };
  const std::vector<BrushStroke> left =
    ErasedStrokes({ line, ball }, { { 0, 0.9, { { 1.5, -5, 0 }, { 1.5, 5, 0 } } } });
  ASSERT_EQ(left.size(), 3U);
  EXPECT_EQ(left[0].points, (std::vector<glm::dvec3>{ { 0, 0, 0 } }));
  EXPECT_EQ(left[1].points, (std::vector<glm::dvec3>{ { 3, 0, 0 } }));
  EXPECT_EQ(left[1].label, 2);
  EXPECT_EQ(left[2], ball);
}

TEST(PlannerSplit, FragmentsAreCalledByTheirOwnNumbersUnlessTheirLabelsHaveNames)
{
  const CanaryFolder folder;
  SplitDesk desk(folder);
  auto& list = StepsOneDesk::Find<QListWidget>(desk.panel, "split.label");
  list.item(1)->setText("chin");
  ASSERT_TRUE(desk.Settle());
  desk.panel.Paint().SetLabel(2);
  ASSERT_TRUE(desk.panel.Paint().PaintAt(BallMiddle(JoinedMm, 1)));
  desk.panel.Paint().SetLabel(3);
  ASSERT_TRUE(desk.panel.Paint().PaintAt(BallMiddle(JoinedMm, -1)));
  StepsOneDesk::Click(desk.panel, "split.make");
  ASSERT_TRUE(desk.Settle());
  ASSERT_EQ(desk.Now().fragments.size(), 2U);
  EXPECT_EQ(desk.Now().fragments[0].name, CalledObject(desk.Now(), desk.Now().fragments[0].id));
  EXPECT_EQ(desk.Now().fragments[1].name, "chin");
}

TEST(PlannerSplit, FragmentsAreOneStepAndTheirMapIsKept)
{
  const CanaryFolder folder;
  SplitDesk desk(folder);
  desk.panel.Paint().SetLabel(2); // without a pointer
  ASSERT_TRUE(desk.panel.Paint().PaintAt(BallMiddle(JoinedMm, 1)));
  desk.panel.Paint().SetLabel(3);
  ASSERT_TRUE(desk.panel.Paint().PaintAt(BallMiddle(JoinedMm, -1)));
  const std::size_t before = desk.Steps();
  StepsOneDesk::Click(desk.panel, "split.make");
  ASSERT_TRUE(desk.Settle());
  ASSERT_EQ(desk.Now().fragments.size(), 2U) << desk.faults.join(' ').toStdString();
  EXPECT_EQ(desk.Steps(), before + 1);
  const PlanDocument& document = desk.planner.plan.Document();
  const std::string blob = LabelMapOf(desk.Now(), document.parts, desk.Now().segmentations[0].id);
  const auto map = ReadLabelBlob(desk.planner.plan.Folder(), blob, {});
  const std::vector<std::uint16_t> made = desk.Segmented();
  EXPECT_EQ(std::memcmp(map->GetScalarPointer(), made.data(), 2 * made.size()), 0);
  for (const PlanFragment& fragment : desk.Now().fragments)
    EXPECT_TRUE(desk.planner.scene.PropOf(fragment.id)) << fragment.id;
  StepsOneDesk::Click(desk.panel, "split.make"); // again: they are there
  ASSERT_TRUE(desk.Settle());
  EXPECT_EQ(desk.Steps(), before + 1);

  // Painted on, the map is out of date until it is made again.
  ASSERT_TRUE(desk.panel.Paint().PaintAt({ 0, 6, 0 }));
  EXPECT_THROW(
    LabelMapOf(desk.Now(), document.parts, desk.Now().segmentations[0].id), std::invalid_argument);
  StepsOneDesk::Click(desk.panel, "split.make");
  desk.planner.jobs.CancelAll();
  ASSERT_TRUE(desk.Settle());
  EXPECT_EQ(desk.Steps(), before + 2); // the stroke
  EXPECT_EQ(desk.Now().fragments.size(), 2U);
}

TEST(PlannerSplit, PiecesAndBonesNeedNoPainting)
{
  const CanaryFolder folder;
  SplitDesk desk(folder, 3.0);
  StepsOneDesk::Click(desk.panel, "split.pieces");
  ASSERT_TRUE(desk.Settle());
  ASSERT_EQ(desk.Now().fragments.size(), 2U) << desk.faults.join(' ').toStdString();
  desk.planner.plan.Undo();
  desk.planner.plan.Undo();
  EXPECT_TRUE(desk.Now().segmentations.empty());
  desk.planner.views.SetCrosshair(BallMiddle(3.0, 1));
  StepsOneDesk::Click(desk.panel, "split.bone.crosshair");
  StepsOneDesk::Click(desk.panel, "split.bone.pick");
  ASSERT_TRUE(desk.Settle());
  desk.desk.Click(desk.desk.scene, desk.Front(-1));
  ASSERT_TRUE(desk.Settle());
  ASSERT_EQ(desk.Now().fragments.size(), 2U) << desk.faults.join(' ').toStdString();
  const auto& picked = std::get<ComponentSource>(desk.Now().fragments[1].source);
  const glm::dvec3 front = BallMiddle(3.0, -1) + glm::dvec3(0, -BallMm, 0);
  EXPECT_LT(glm::distance(picked.seed, front), 0.5); // a pixel is 0.2 mm
  EXPECT_EQ(desk.planner.tools.InHand(), nullptr);
}

TEST(PlannerSplit, LabelsThatAreAddedAreThePlansOnceThereIsAStroke)
{
  const CanaryFolder folder;
  SplitDesk desk(folder);
  auto& list = StepsOneDesk::Find<QListWidget>(desk.panel, "split.label");
  EXPECT_EQ(list.count(), 2);
  EXPECT_EQ(list.item(0)->text(), "label 2"); // fragments have numbers of their own
  StepsOneDesk::Click(desk.panel, "split.label.add");
  EXPECT_EQ(list.count(), 3);
  EXPECT_EQ(desk.panel.Paint().Label(), 4); // it is chosen
  ASSERT_TRUE(desk.panel.Paint().PaintAt(BallMiddle(JoinedMm, 1)));
  EXPECT_EQ(desk.Recipe().names.size(), 3U);
  const std::size_t before = desk.Steps();
  StepsOneDesk::Click(desk.panel, "split.label.add");
  EXPECT_EQ(desk.Steps(), before + 1);
  EXPECT_EQ(desk.Recipe().names.size(), 4U);
  desk.planner.plan.Undo();
  EXPECT_EQ(list.count(), 3);
}

} // namespace
