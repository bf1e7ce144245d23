// What a planner is told: what was left out, what is out of date, what VTK complains of.
#include "StepsOneDesk.h"
#include "VtkMessages.h"

#include "Steps/ImportPanel.h"
#include "Steps/SplitPanel.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double JoinedMm = -4.0;    ///< the balls are one bone
constexpr glm::ivec3 Stray(2, 2, 2); ///< a voxel far from the balls

/// With a voxel of bone beside them.
vtkSmartPointer<vtkImageData> WithStray(const vtkSmartPointer<vtkImageData>& balls)
{
  balls->SetScalarComponentFromDouble(Stray.x, Stray.y, Stray.z, 0, 1000.0);
  return balls;
}

/// With that scan.
struct MessagesDesk : StepsOneDesk
{
  MessagesDesk(const CanaryFolder& folder, vtkImageData* scan)
    : StepsOneDesk(folder),
      import(this->planner),
      split(this->planner)
  {
    WriteVolume(scan, folder.File("scan.mha"));
    EXPECT_TRUE(this->Import(folder.File("scan.mha")));
    this->planner.scene.SetIsovalue(226.0);
  }
  bool Import(const std::string& path)
  {
    this->import.ImportPath(QString::fromStdString(path));
    return this->Settle();
  }

  ImportPanel import;
  SplitPanel split;
};

TEST(PlannerMessages, AFaultGoesWhenItIsTriedAgainAndNoOtherOne)
{
  const CanaryFolder folder;
  MessagesDesk desk(folder, TwoBalls(JoinedMm));
  int withdrawn = 0;
  QObject::connect(&desk.planner, &Planner::Withdrawn, &desk.planner, [&] { ++withdrawn; });
  ASSERT_TRUE(desk.Import(folder.File("none.mha")));
  ASSERT_EQ(desk.faults.size(), 1);
  EXPECT_EQ(withdrawn, 0);
  ASSERT_TRUE(desk.Import(folder.File("scan.mha")));
  EXPECT_EQ(withdrawn, 1);
  ASSERT_TRUE(desk.Import(folder.File("none.mha")));
  desk.planner.SayFault("The disk is full."); // which holds, whatever is imported
  const int before = withdrawn;
  ASSERT_TRUE(desk.Import(folder.File("scan.mha")));
  EXPECT_EQ(withdrawn, before);
}

TEST(PlannerMessages, BoneOfNoStrokeIsLeftOutAndSaidInPlainWords)
{
  const CanaryFolder folder;
  MessagesDesk desk(folder, WithStray(TwoBalls(JoinedMm)));
  desk.split.Paint().SetLabel(2);
  ASSERT_TRUE(desk.split.Paint().PaintAt(BallMiddle(JoinedMm, 1)));
  desk.split.Paint().SetLabel(3);
  ASSERT_TRUE(desk.split.Paint().PaintAt(BallMiddle(JoinedMm, -1)));
  StepsOneDesk::Click(desk.split, "split.make");
  ASSERT_TRUE(desk.Settle());
  EXPECT_EQ(desk.Now().fragments.size(), 2U);
  EXPECT_TRUE(desk.faults.isEmpty()) << desk.faults.join(' ').toStdString();
  ASSERT_FALSE(desk.said.isEmpty());
  EXPECT_EQ(desk.said.last().toStdString(),
    "Fragments made: 2. Left out is bone that no stroke is connected to: 1.0 mm³ (voxels: 1).");

  // It is a fragment of its own as soon as it is asked for.
  desk.split.Paint().SetLabel(4);
  ASSERT_TRUE(desk.split.Paint().PaintAt(
    ImageGeometry(desk.planner.scene.ShownImage()).IndexToWorld(glm::dvec3(Stray))));
  StepsOneDesk::Click(desk.split, "split.make");
  ASSERT_TRUE(desk.Settle());
  ASSERT_EQ(desk.Now().fragments.size(), 3U);
  EXPECT_TRUE(desk.faults.isEmpty()) << desk.faults.join(' ').toStdString();
  EXPECT_EQ(desk.said.last().toStdString(), "Fragments made: 1.");
  EXPECT_TRUE(desk.planner.scene.PropOf(desk.Now().fragments[2].id));
}

TEST(PlannerMessages, AStrokeThatMakesNoFragmentIsAFault)
{
  const CanaryFolder folder;
  MessagesDesk desk(folder, TwoBalls(JoinedMm));
  desk.split.Paint().SetLabel(2);
  ASSERT_TRUE(desk.split.Paint().PaintAt(BallMiddle(JoinedMm, 1)));
  desk.split.Paint().SetLabel(3);
  ASSERT_TRUE(desk.split.Paint().PaintAt({ 0.0, 0.0, 14.0 })); // in air
  StepsOneDesk::Click(desk.split, "split.make");
  ASSERT_TRUE(desk.Settle());
  EXPECT_EQ(desk.Now().fragments.size(), 1U);
  ASSERT_EQ(desk.faults.size(), 1);
  EXPECT_TRUE(desk.faults.last().contains("3 gets no bone")) << desk.faults.last().toStdString();
  EXPECT_TRUE(desk.faults.last().contains("Strokes that touch no bone: 1."));
}

TEST(PlannerMessages, StrokesBesideBoneAloneMakeNothingAndThatIsSaid)
{
  const CanaryFolder folder;
  MessagesDesk desk(folder, TwoBalls(JoinedMm));
  desk.split.Paint().SetLabel(2);
  ASSERT_TRUE(desk.split.Paint().PaintAt({ 0.0, 0.0, 14.0 })); // in air
  StepsOneDesk::Click(desk.split, "split.make");
  ASSERT_TRUE(desk.Settle());
  EXPECT_TRUE(desk.Now().fragments.empty());
  ASSERT_EQ(desk.faults.size(), 1);
  EXPECT_TRUE(desk.faults.last().startsWith("No fragment was made. label 2 gets no bone"))
    << desk.faults.last().toStdString();
}

TEST(PlannerMessages, WhatVtkSaysNamesNoFile)
{
  const CanaryFolder folder;
  vtkNew<vtkSphereSource> vtks;
  vtkNew<vtkHaspHapticInteractor> ours;
  std::vector<std::string> errors, warnings;
  ::testing::internal::CaptureStderr();
  {
    const VtkMessageCapture capture([&](const std::string& text) { warnings.push_back(text); },
      [&](const std::string& text) { errors.push_back(text); });
    vtkErrorWithObjectMacro(vtks.Get(), << "Unable to open " << folder.File("scan.mha"));
    vtkWarningWithObjectMacro(vtks.Get(), << "No header in " << folder.File("scan.mha"));
    vtkGenericWarningMacro(<< "Nothing is in " << folder.File("scan.mha"));
    vtkErrorWithObjectMacro(ours.Get(), << "There is no device; give it one");
    vtkWarningWithObjectMacro(ours.Get(), << "Nobody asks for frames");
    EXPECT_EQ(TakeVtkError(), ""); // they have been told
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(errors, (std::vector<std::string>{
                      "vtkSphereSource reports an error", "There is no device; give it one" }));
  EXPECT_EQ(warnings, std::vector<std::string>{ "Nobody asks for frames" });
}

} // namespace
