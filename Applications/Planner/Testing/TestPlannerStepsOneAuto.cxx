// Fragments that are put together by themselves, against the truth of a phantom that was broken.
#include "StepsOneDesk.h"

#include "Planning/PlanLists.h"
#include "Steps/ImportPanel.h"
#include "Steps/ReducePanel.h"
#include "Studies/FractureCaseMaker.h"
#include "Studies/FractureCases.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkProp3D.h"

#include <QTreeWidget>
#include <QtTest>

#include <gtest/gtest.h>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double SpacingMm = 1.2; ///< coarse, so that it is quick
constexpr int MostMs = 600'000;

/// A jaw whose pieces went 3 mm and 3 degrees apart: labels 2 cranium, 3 the chin, which stay.
MadeFractureCase BrokenJaw()
{
  const FractureCase broken = BrokenMandible({ .spacingMm = SpacingMm, .crackMm = 0.0, .seed = 5 });
  const std::vector<std::int16_t> intact = IntactPhantom(broken.geometry, broken.settings);
  return MakeFractureCase({ intact.data(), broken.geometry }, broken.settings, {},
    { .shiftMm = 3.0, .turnDegrees = 3.0, .seed = 5 });
}

/// How far the middle of a label's bone is from where it belongs, mm.
double Off(const MadeFractureCase& made, Label label, const PlanPose& pose)
{
  for (const FractureCaseFragment& fragment : made.truth.fragments)
    if (fragment.label == label)
      return glm::distance(
        pose.Place(fragment.anatomicalToFractured.Place(fragment.centroidAnatomicalMm)),
        fragment.centroidAnatomicalMm);
  return 0.0;
}

/// In a window of the planner's usual size every word of the rows can be read.
void ExpectReadable(QWidget& panel, const QTreeWidget& tree)
{
  panel.resize(300, 1100);
  panel.show();
  QTest::qWait(100);
  for (QTreeWidgetItemIterator item(const_cast<QTreeWidget*>(&tree)); *item; ++item)
  {
    const QRect row = tree.visualItemRect(*item);
    const int box = (*item)->data(0, Qt::CheckStateRole).isValid()
                      ? tree.style()->pixelMetric(QStyle::PM_IndicatorWidth)
                      : 0;
    const QRect words = tree.fontMetrics().boundingRect(
      QRect(0, 0, row.width() - box, 10'000), Qt::TextWordWrap, (*item)->text(0));
    EXPECT_GE(row.height(), words.height()) << (*item)->text(0).toStdString();
    EXPECT_LE(row.right(), tree.viewport()->width());
  }
}

TEST(PlannerAutomatic, FragmentsComeWithinTheKnownTruthInOneStep)
{
  const CanaryFolder folder;
  const MadeFractureCase made = BrokenJaw();
  const GridGeometry& grid = made.fractured.geometry;
  WriteVolume(MakeImage(grid, made.fractured.samples), folder.File("scan.mha"));
  WriteLabels(MakeImage(grid, made.fractured.truth), {}, folder.File("labels.seg.nrrd"));
  StepsOneDesk desk(folder);
  ImportPanel import(desk.planner);
  ReducePanel panel(desk.planner);
  import.ImportPath(QString::fromStdString(folder.File("scan.mha")));
  ASSERT_TRUE(desk.Settle());
  desk.planner.scene.SetIsovalue(226.0);
  import.ImportPath(QString::fromStdString(folder.File("labels.seg.nrrd")));
  ASSERT_TRUE(desk.Settle()) << desk.faults.join(' ').toStdString();

  auto& table = StepsOneDesk::Find<QTreeWidget>(panel, "reduce.fragments");
  std::vector<PlanId> ids;
  for (const PlanFragment& fragment : desk.Now().fragments)
    ids.push_back(fragment.id);
  ASSERT_GT(ids.size(), 2U);
  StepsOneDesk::Click(panel, "reduce.auto"); // nothing stays: it says what to do
  ASSERT_TRUE(desk.Settle());
  ASSERT_FALSE(desk.faults.isEmpty());
  EXPECT_TRUE(desk.faults.last().contains("lock")) << desk.faults.last().toStdString();
  table.topLevelItem(1)->setSelected(true); // the chin
  StepsOneDesk::Click(panel, "reduce.lock");
  table.topLevelItem(0)->setCheckState(2, Qt::Checked); // the cranium is only touched
  const std::size_t before = desk.Steps();
  desk.faults.clear();

  StepsOneDesk::Click(panel, "reduce.auto");
  desk.planner.jobs.CancelAll();
  ASSERT_TRUE(desk.Settle());
  EXPECT_EQ(desk.Steps(), before);
  StepsOneDesk::Click(panel, "reduce.auto");
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk.planner.jobs.IsIdle(); }, MostMs));
  auto& proposals = StepsOneDesk::Find<QTreeWidget>(panel, "reduce.proposals");
  ASSERT_EQ(std::size_t(proposals.topLevelItemCount()), ids.size())
    << desk.faults.join(' ').toStdString();
  EXPECT_EQ(desk.Steps(), before);
  const auto at = [&] { return desk.planner.scene.PropOf(ids[4])->GetMatrix()->GetElement(0, 3); };
  const double was = at();
  StepsOneDesk::Click(panel, "reduce.preview"); // in the view, not in the plan
  EXPECT_NE(at(), was);
  EXPECT_EQ(desk.Steps(), before);
  // In so coarse a scan little holds the condyle: it says so, and is left out unless it is asked
  // for.
  QTreeWidgetItem& condyle = *proposals.topLevelItem(2);
  EXPECT_TRUE(condyle.text(0).contains("wide")) << condyle.text(0).toStdString();
  EXPECT_EQ(condyle.checkState(0), Qt::Unchecked);
  ExpectReadable(panel, proposals);
  proposals.topLevelItem(3)->setCheckState(0, Qt::Checked);
  StepsOneDesk::Click(panel, "reduce.take");
  ASSERT_EQ(desk.Steps(), before + 1) << desk.faults.join(' ').toStdString();
  for (const PlanFragment& fragment : desk.Now().fragments)
  {
    const auto label = Label(std::get<LabelSource>(fragment.source).label);
    const double off = Off(made, label, fragment.scanToPlanned);
    if (label <= 4) // what stays, and the condyle
      EXPECT_EQ(fragment.scanToPlanned, PlanPose{}) << "label " << label;
    else // 3 mm off when they began; a voxel is what may be left
      EXPECT_LT(off, SpacingMm) << "label " << label;
  }
  EXPECT_TRUE(proposals.isHidden() || proposals.topLevelItemCount() == 0); // they are taken
  desk.planner.plan.Undo();
  EXPECT_EQ(desk.Now().fragments[4].scanToPlanned, PlanPose{});
}

} // namespace
