// Import: what becomes of files and folders, and what is said of them.
#include "ImportDesk.h"

#include "Planning/PlanLists.h"
#include "Steps/MissingInputs.h"
#include "Steps/SurfaceShelf.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBrowser>

#include <gtest/gtest.h>

#include <fstream>

namespace
{

using namespace hasp;
using namespace hasp::testing;

TEST(PlannerImport, AFaultyFileIsAFaultAndNoEdit)
{
  const CanaryFolder folder;
  WriteVolume(TwoBalls(2.0), folder.File("scan.mha"));
  std::filesystem::resize_file(folder.File("scan.mha"), 3000);
  ImportDesk desk(folder);
  ASSERT_TRUE(desk.Import(folder.File("scan.mha")));
  ASSERT_EQ(desk.faults.size(), 1);
  EXPECT_TRUE(desk.faults[0].contains(".mha")) << desk.faults[0].toStdString();
  EXPECT_TRUE(desk.Passport().contains("Fault")) << desk.Passport().toStdString();
  EXPECT_EQ(desk.Now(), Plan{});
  EXPECT_FALSE(desk.AllText().contains(CanaryFolder::Canary));
  ASSERT_TRUE(desk.Import(folder.File("none.mha")));
  EXPECT_EQ(desk.faults.size(), 2);
  EXPECT_EQ(desk.Now(), Plan{});
}

TEST(PlannerImport, AScanIsAPassportAnEditAndAShownVolume)
{
  const CanaryFolder folder;
  WriteVolume(TwoBalls(2.0), folder.File("scan.mha"));
  ImportDesk desk(folder);
  ASSERT_TRUE(desk.Import(folder.File("scan.mha")));
  ASSERT_EQ(desk.Now().volumes.size(), 1U) << desk.faults.join(' ').toStdString();
  EXPECT_EQ(desk.Steps(), 1U);
  EXPECT_EQ(desk.Now().volumes[0].name, "scan 1");
  const PlanId id = desk.Now().volumes[0].id;
  EXPECT_EQ(desk.planner.scene.ShownVolume(), id);
  ASSERT_TRUE(desk.planner.scene.ShownImage());
  for (const char* known : { "MetaImage", "60 × 32 × 32", "not said to be HU" })
    EXPECT_TRUE(desk.Passport().contains(QString::fromUtf8(known)))
      << known << " in " << desk.Passport().toStdString();
  EXPECT_FALSE(desk.AllText().contains(CanaryFolder::Canary));

  ASSERT_TRUE(desk.Import(folder.File("scan.mha"))); // once more: nothing to be done
  EXPECT_EQ(desk.Steps(), 1U);
  WriteVolume(TwoBalls(5.0), folder.File("donor.mha")); // a second one, for a donor's bone
  ASSERT_TRUE(desk.Import(folder.File("donor.mha")));
  ASSERT_EQ(desk.Now().volumes.size(), 2U);
  EXPECT_EQ(desk.planner.scene.ShownVolume(), desk.Now().volumes[1].id);
}

TEST(PlannerImport, ThePassportIsThatOfTheScanThatIsShownWhereverItComesFrom)
{
  const CanaryFolder folder;
  const QString known = QString::fromUtf8("60 × 32 × 32"), plan = folder.File("case.hasp").c_str();
  WriteVolume(TwoBalls(2.0), folder.File("scan.mha"));
  {
    ImportDesk desk(folder);
    ASSERT_TRUE(desk.Import(folder.File("scan.mha")));
    ASSERT_TRUE(desk.planner.plan.SaveAs(plan.toStdString()));
    ASSERT_TRUE(desk.Import(folder.File("none.mha"))); // is refused, and above it
    EXPECT_TRUE(desk.Passport().contains("Fault")) << desk.Passport().toStdString();
    EXPECT_TRUE(desk.Passport().contains(known)) << desk.Passport().toStdString();
    desk.planner.plan.BeginNew();
    EXPECT_EQ(desk.Passport(), "");
  }
  ImportDesk desk(folder, "other");
  ASSERT_TRUE(desk.planner.plan.Open(plan.toStdString()));
  EXPECT_EQ(desk.Passport(), "");
  desk.planner.scans.Put(ScanShelf::Read(folder.File("scan.mha"), {}, {})); // not by this panel
  ASSERT_TRUE(desk.Settle());
  EXPECT_TRUE(desk.Passport().contains(known)) << desk.Passport().toStdString();
}

TEST(PlannerImport, CancelLeavesThePlanAsItWas)
{
  const CanaryFolder folder;
  WriteVolume(TwoBalls(2.0), folder.File("scan.mha"));
  ImportDesk desk(folder);
  desk.panel.ImportPath(QString::fromStdString(folder.File("scan.mha")));
  desk.planner.jobs.CancelAll();
  ASSERT_TRUE(desk.Settle());
  EXPECT_EQ(desk.Now(), Plan{});
  EXPECT_TRUE(desk.faults.isEmpty());
  ASSERT_TRUE(desk.Import(folder.File("scan.mha"))); // and it works on
  EXPECT_EQ(desk.Now().volumes.size(), 1U);
}

TEST(PlannerImport, LabelsOfTheScanBecomeFragmentsInOneStep)
{
  const CanaryFolder folder;
  const auto scan = TwoBalls(4.0);
  WriteVolume(scan, folder.File("scan.mha"));
  const GridGeometry grid = ImageGeometry(scan);
  std::vector<std::uint16_t> labels;
  for (const std::int16_t sample :
    std::span(static_cast<const std::int16_t*>(scan->GetScalarPointer()), grid.Size()))
    labels.push_back(sample < 226 ? 0 : labels.size() % 60 < 30 ? 3 : 2);
  WriteLabels(MakeImage(grid, labels), { { 2, "chin", { 9, 8, 7 } } }, folder.File("l.seg.nrrd"));
  ImportDesk desk(folder);
  ASSERT_TRUE(desk.Import(folder.File("l.seg.nrrd"))); // there is no scan yet
  EXPECT_EQ(desk.faults.size(), 1);
  ASSERT_TRUE(desk.Import(folder.File("scan.mha")));
  ASSERT_TRUE(desk.Import(folder.File("l.seg.nrrd")));
  ASSERT_EQ(desk.Now().fragments.size(), 2U) << desk.faults.join(' ').toStdString();
  EXPECT_EQ(desk.Steps(), 2U);
  EXPECT_EQ(desk.Now().fragments[0].name, "chin");
  EXPECT_EQ(desk.Now().fragments[1].name, CalledObject(desk.Now(), desk.Now().fragments[1].id));
  EXPECT_EQ(desk.Now().fragments[0].colour, (std::array<std::uint8_t, 3>{ 9, 8, 7 }));
  for (const PlanFragment& fragment : desk.Now().fragments)
    EXPECT_TRUE(desk.planner.scene.PropOf(fragment.id));
  ASSERT_TRUE(desk.Import(folder.File("l.seg.nrrd"))); // once more: said, and no step
  EXPECT_EQ(desk.Steps(), 2U);
}

TEST(PlannerImport, ASurfaceBecomesAFragment)
{
  const CanaryFolder folder;
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(10.0);
  ball->Update();
  WriteSurface(ball->GetOutput(), folder.File("sherd.stl"));
  ImportDesk desk(folder);
  ASSERT_TRUE(desk.Import(folder.File("sherd.stl")));
  ASSERT_EQ(desk.Now().fragments.size(), 1U) << desk.faults.join(' ').toStdString();
  EXPECT_EQ(desk.Steps(), 1U);
  EXPECT_EQ(std::get<SurfaceSource>(desk.Now().fragments[0].source).thicknessMm, 0.0);
  EXPECT_TRUE(desk.planner.scene.PropOf(desk.Now().fragments[0].id));
}

TEST(PlannerImport, TrianglesGoWithTheirPlanAndComeBackWithIt)
{
  const CanaryFolder folder;
  vtkNew<vtkSphereSource> ball;
  ball->Update();
  WriteSurface(ball->GetOutput(), folder.File("sherd.stl"));
  ImportDesk desk(folder);
  ASSERT_TRUE(desk.Import(folder.File("sherd.stl")));
  const std::string hash = desk.Now().surfaces.at(0).hash;
  const PlanId fragment = desk.Now().fragments.at(0).id;
  const SurfaceShelf& shelf = SurfaceShelf::Of(desk.planner);
  ASSERT_TRUE(shelf.Find(hash));
  ASSERT_TRUE(desk.planner.scene.PropOf(fragment));
  const std::weak_ptr<const TriangleMesh> mesh = shelf.Find(hash);
  ASSERT_TRUE(desk.planner.plan.SaveAs(folder.File("sherd.hasp")));
  desk.planner.plan.BeginNew();
  EXPECT_TRUE(mesh.expired());
  EXPECT_FALSE(desk.planner.scene.PropOf(fragment));
  ASSERT_TRUE(desk.planner.plan.Open(folder.File("sherd.hasp")));
  ASSERT_TRUE(desk.Settle());
  EXPECT_TRUE(shelf.Find(hash));
  EXPECT_TRUE(desk.planner.scene.PropOf(fragment));
}

TEST(PlannerImport, ThePseudonymIsAStep)
{
  const CanaryFolder folder;
  ImportDesk desk(folder);
  auto& line = StepsOneDesk::Find<QLineEdit>(desk.panel, "import.case");
  line.setText("K-17");
  Q_EMIT line.editingFinished();
  Q_EMIT line.editingFinished(); // as Qt does when the window goes
  EXPECT_EQ(desk.Now().caseLabel, "K-17");
  EXPECT_EQ(desk.Steps(), 1U);
  desk.planner.plan.Undo();
  EXPECT_EQ(line.text(), "");
}

TEST(PlannerImport, AMissingScanIsFoundByWhatItHolds)
{
  const CanaryFolder folder;
  WriteVolume(TwoBalls(2.0), folder.File("scan.mha"));
  WriteVolume(TwoBalls(3.0), folder.File("other.mha"));
  const std::string plan = folder.File("plan.hasp");
  {
    ImportDesk desk(folder);
    ASSERT_TRUE(desk.Import(folder.File("scan.mha")));
    ASSERT_TRUE(desk.planner.plan.SaveAs(plan));
  }
  ImportDesk desk(folder, "elsewhere");
  ASSERT_TRUE(desk.Import(plan));
  auto& list = StepsOneDesk::Find<QListWidget>(desk.panel, "import.missing");
  ASSERT_EQ(list.count(), 1);
  EXPECT_EQ(list.item(0)->text(), "scan 1 is not here");
  auto& missing = *desk.panel.findChild<MissingInputs*>();
  missing.Locate(QString::fromStdString(folder.File("other.mha")));
  ASSERT_TRUE(desk.Settle());
  ASSERT_EQ(desk.faults.size(), 1);
  EXPECT_FALSE(desk.planner.scene.ShownImage());
  missing.Locate(QString::fromStdString(folder.File("scan.mha")));
  ASSERT_TRUE(desk.Settle());
  EXPECT_EQ(list.count(), 0);
  EXPECT_TRUE(desk.planner.scene.ShownImage());
  EXPECT_FALSE(desk.planner.plan.IsModified()); // where it lies is no part of a plan
}

} // namespace
