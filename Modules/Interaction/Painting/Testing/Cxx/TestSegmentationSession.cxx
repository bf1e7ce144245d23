// A broken jaw that is split by drags of a mouse.
#include "BrokenJaw.h"
#include "CellLabels.h"
#include "Segmenter.h"

#include "Isosurface/CellAttributes.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <thread>

namespace
{

using namespace hasp;
using namespace hasp::testing;

/// Share of the jaw's own bone, off the break, that has the label of its side.
double ShareOfTheirSide(JawScene& scene, Label right, Label left)
{
  const AnalyticSolid jaw = PhantomSolid({}, PhantomPart::Mandible);
  const GridView<const Label> map = scene.Map();
  int all = 0, theirs = 0;
  for (int k = 0; k < map.geometry.dims.z; ++k)
    for (int j = 0; j < map.geometry.dims.y; ++j)
      for (int i = 0; i < map.geometry.dims.x; ++i)
      {
        const glm::dvec3 at = map.geometry.IndexToWorld({ i, j, k });
        const double x = at.x - Menton().x + BreakMm;
        if (map(i, j, k) == 0 || std::abs(x) < 2.0 * VoxelMm || !(jaw.Distance(at).mm < -0.5))
          continue;
        ++all;
        theirs += map(i, j, k) == (x < 0.0 ? right : left);
      }
  EXPECT_GT(all, 1000);
  return double(theirs) / all;
}

TEST(SegmentationSession, TwoDragsGiveTwoFragmentsAndUndoTheLabelsFromBefore)
{
  JawScene scene;
  scene.Enable();
  const std::uint64_t none = scene.Hash();
  const Count changes(scene.session, vtkHaspSegmentationSession::LabelsChangedEvent);
  scene.Drag(2, -14.0, -8.0);
  ASSERT_TRUE(scene.session->Finish());
  const std::uint64_t one = scene.Hash();
  EXPECT_GT(scene.Voxels()[2], 1000) << "all that hangs together";
  EXPECT_EQ(scene.Voxels()[3], 0);
  scene.Drag(3, 6.0, 12.0);
  EXPECT_EQ(scene.strokes->GetNumberOfStrokes(), 2);
  ASSERT_TRUE(scene.session->Finish());
  // 0.9885 measured: marrow is hardly brighter than the break, and there the border is round.
  EXPECT_GT(ShareOfTheirSide(scene, 2, 3), 0.98);
  EXPECT_EQ(changes.times, 2);
  EXPECT_EQ(scene.session->GetNumberOfDrags(), 2);

  scene.Key("z"); // without Ctrl: nobody's
  EXPECT_EQ(scene.session->GetNumberOfDrags(), 2);
  scene.Key("z", "c");
  EXPECT_EQ(scene.strokes->GetNumberOfStrokes(), 1) << "at once";
  ASSERT_TRUE(scene.session->Finish());
  EXPECT_EQ(scene.Hash(), one);
  scene.Key("z", "c");
  scene.session->Finish();
  EXPECT_EQ(scene.Hash(), none);
  EXPECT_EQ(scene.strokes->GetNumberOfStrokes(), 0);
  EXPECT_FALSE(scene.session->Undo());
  EXPECT_TRUE(scene.session->GetRecipe().steps.empty());
  scene.Drag(2, -14.0, -8.0);
  scene.session->Finish();
  EXPECT_EQ(scene.Hash(), one) << "and all over again";
}

// Whether it was waiting, at work or done and not shown is all the same.
TEST(SegmentationSession, WhatIsGivenUpLeavesAllAsItWas)
{
  JawScene scene;
  scene.Enable();
  const std::uint64_t none = scene.Hash();
  scene.Drag(2, -14.0, -8.0);
  scene.session->Cancel();
  scene.session->Finish();
  EXPECT_EQ(scene.Hash(), none);
  scene.Drag(2, -14.0, -8.0);
  scene.session->Finish();
  const std::uint64_t one = scene.Hash();
  const auto before = scene.session->GetRecipe();
  scene.Drag(3, 6.0, 12.0);
  scene.Drag(4, 14.0, 20.0);
  scene.Key("Escape");
  EXPECT_EQ(scene.session->GetNumberOfDrags(), 1) << "what is shown stays";
  scene.session->Finish();
  EXPECT_EQ(scene.Hash(), one);
  EXPECT_EQ(scene.session->GetRecipe(), before);
  scene.Drag(3, 6.0, 12.0);
  scene.Drag(4, 14.0, 20.0);
  scene.Key("z", "c"); // the last alone
  scene.session->Finish();
  const auto voxels = scene.Voxels();
  EXPECT_EQ(voxels.count(4), 0u);
  EXPECT_GT(voxels.at(3), 1000);
  // And a session that goes while it is at work takes nobody along.
  scene.Drag(4, 14.0, 20.0);
  EXPECT_TRUE(scene.session->SetScan(nullptr));
  EXPECT_EQ(scene.session->GetImage(), nullptr);
}

TEST(SegmentationSession, SettledItIsWhatItsRecipeMakes)
{
  JawScene scene;
  scene.Enable();
  scene.Drag(2, -14.0, -8.0);
  scene.Drag(3, 6.0, 12.0);
  scene.session->Settle();
  const SegmentationRecipe recipe = scene.session->GetRecipe();
  ASSERT_EQ(recipe.steps.size(), 2u);
  EXPECT_EQ(std::get<SplitStep>(recipe.steps[1]).strokes, scene.session->GetStrokes());
  const auto made = SegmentScan(scene.scan, recipe);
  EXPECT_EQ(scene.Hash(), HashLabels(std::get<GridView<const Label>>(ViewImage(made.labels))));
  scene.session->Undo();
  scene.session->Undo();
  scene.session->Finish();
  EXPECT_EQ(scene.Voxels().size(), 1u);
}

TEST(SegmentationSession, TheMapperHasTheLabelsOfTheBoxThatChanged)
{
  JawScene scene;
  scene.Enable();
  const auto held = [&]
  {
    scene.window->Render();
    const ClusteredCells& cells = scene.mapper->GetCells();
    ClusteredCells truth = cells;
    AddLabels(truth, scene.Map());
    EXPECT_EQ(cells.labels, truth.labels);
    return std::set<Label>(cells.labels.begin(), cells.labels.end());
  };
  EXPECT_EQ(held(), (std::set<Label>{ 0 }));
  const void* extracted = scene.mapper->GetCells().corners.data();
  scene.Drag(2, -14.0, -8.0);
  scene.session->Finish();
  EXPECT_TRUE(held().count(2));
  scene.Drag(3, 6.0, 12.0);
  scene.session->Finish();
  EXPECT_TRUE(held().count(3));
  EXPECT_TRUE(scene.mapper->GetLabels().at(3).color) << "which is the palette's";
  scene.session->Undo();
  scene.session->Finish();
  EXPECT_FALSE(held().count(3));
  EXPECT_EQ(scene.mapper->GetCells().corners.data(), extracted) << "and no cell is made again";
}

TEST(SegmentationSession, WhatSplitsNothingIsSaid)
{
  JawScene scene;
  scene.Enable();
  scene.painter->EraseOn();
  const auto drag = [&] { scene.Drag(2, -14.0, -8.0); };
  EXPECT_NE(ErrorsOf(scene.session, drag).find("label is 0"), std::string::npos);
  EXPECT_EQ(scene.session->GetNumberOfDrags(), 0);
  scene.painter->EraseOff();
  const auto refused = [&](const char* setting)
  {
    EXPECT_EQ(ErrorsOf(scene.session, drag), "");
    EXPECT_NE(
      ErrorsOf(scene.session, [&] { scene.session->Finish(); }).find(setting), std::string::npos);
  };
  scene.session->SetNorm(3.0);
  refused("norm");
  scene.session->SetCrack(2.0);
  refused("crack");
  scene.session->SetBeta(-1.0);
  refused("beta");
  EXPECT_EQ(scene.session->GetNumberOfDrags(), 0);
  EXPECT_EQ(scene.Voxels().size(), 1u) << "nor is the threshold left";
  vtkNew<vtkImageData> empty;
  EXPECT_NE(ErrorsOf(scene.session, [&] { EXPECT_FALSE(scene.session->SetScan(empty)); }), "");
  EXPECT_NE(scene.session->GetImage(), nullptr) << "the scan stays";
  scene.session->SetScan(nullptr);
  EXPECT_NE(ErrorsOf(scene.session, drag).find("SetScan"), std::string::npos);
}

/// Counts timers, as a window system's interactor that runs.
class TimedInteractor : public vtkGenericRenderWindowInteractor
{
public:
  static TimedInteractor* New();
  vtkTypeMacro(TimedInteractor, vtkGenericRenderWindowInteractor);
  std::vector<int> timers; ///< VTK's numbers

protected:
  int InternalCreateTimer(int number, int, unsigned long) override
  {
    this->timers.push_back(number);
    return static_cast<int>(this->timers.size());
  }
  int InternalDestroyTimer(int) override { return 1; }
};
vtkStandardNewMacro(TimedInteractor);

TEST(SegmentationSession, LabelsComeWithATimerThatEndsWithTheWork)
{
  JawScene scene;
  vtkNew<TimedInteractor> interactor;
  interactor->SetRenderWindow(scene.window);
  interactor->SetInteractorStyle(nullptr);
  interactor->EnableRenderOff();
  interactor->Initialize();
  interactor->EnableRenderOn();
  scene.Enable();
  const Count begun(scene.session, vtkHaspSegmentationSession::WorkStartedEvent),
    ended(scene.session, vtkHaspSegmentationSession::WorkEndedEvent),
    changes(scene.session, vtkHaspSegmentationSession::LabelsChangedEvent);
  EXPECT_TRUE(interactor->timers.empty()) << "nothing to do";
  const auto at = [&](unsigned long event, int x)
  {
    interactor->SetEventInformation(x, 112);
    interactor->InvokeEvent(event);
  };
  at(vtkCommand::LeftButtonPressEvent, 75);
  at(vtkCommand::MouseMoveEvent, 85);
  at(vtkCommand::LeftButtonReleaseEvent, 85);
  EXPECT_EQ(begun.times, 1);
  ASSERT_EQ(interactor->timers.size(), 1u);
  const auto fire = [&]
  {
    int number = interactor->timers.back();
    interactor->InvokeEvent(vtkCommand::TimerEvent, &number);
  };
  while (scene.session->IsWorking())
    std::this_thread::yield();
  EXPECT_EQ(changes.times, 0) << "RENDER has not asked";
  fire();
  EXPECT_EQ(changes.times, 1);
  EXPECT_EQ(ended.times, 1);
  const std::size_t timers = interactor->timers.size();
  fire();
  EXPECT_EQ(interactor->timers.size(), timers) << "nobody asks any more";
}

} // namespace
