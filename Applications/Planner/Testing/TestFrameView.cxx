// Frames of a view: when they are drawn, and of how many pixels.
#include "ConeScene.h"
#include "ViewsDesk.h"

#include "QVTKInteractor.h"
#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkRenderWindow.h"

#include <QElapsedTimer>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

namespace
{

using namespace hasp;
using namespace hasp::testing;

TEST(FrameView, ManyRequestsAreOneFrame)
{
  ViewsDesk desk;
  const auto before = desk.scene.Frames();
  for (int i = 0; i < 100; ++i)
    desk.scene.Draw();
  EXPECT_EQ(desk.scene.Frames(), before) << "not within the call";
  desk.Settle();
  EXPECT_EQ(desk.scene.Frames(), before + 1);
}

TEST(FrameView, RequestsOfVtkAreFramesLikeOthers)
{
  ViewsDesk desk;
  int drawn = 0; // by the window itself, whoever asked
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&drawn);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* seen, void*) { ++*static_cast<int*>(seen); });
  desk.scene.renderWindow()->AddObserver(vtkCommand::StartEvent, count);
  const auto before = desk.scene.Frames();
  for (int i = 0; i < 100; ++i)
    desk.scene.interactor()->Render();
  desk.Settle();
  EXPECT_EQ(desk.scene.Frames(), before + 1);
  EXPECT_EQ(drawn, 1);
}

TEST(FrameView, DrawsNothingAtRest)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  AddCone(desk.scene);
  desk.Settle();
  const std::array before{ desk.scene.Frames(), desk.axial.Frames(), desk.coronal.Frames(),
    desk.sagittal.Frames() };
  EXPECT_FALSE(desk.Wait([] { return false; }, 500));
  const std::array after{ desk.scene.Frames(), desk.axial.Frames(), desk.coronal.Frames(),
    desk.sagittal.Frames() };
  EXPECT_EQ(after, before);
}

TEST(FrameView, GoesOnAsLongAsAMapperRefines)
{
  ViewsDesk desk;
  int left = 5, begun = 0;
  desk.scene.before = [&] { ++begun; };
  desk.scene.after = [&] { return --left > 0; };
  const auto before = desk.scene.Frames();
  desk.scene.Draw();
  desk.Settle();
  EXPECT_EQ(desk.scene.Frames(), before + 5);
  EXPECT_EQ(begun, 5);
}

TEST(FrameView, ARequestWithinAFrameIsTheNextFrame)
{
  ViewsDesk desk;
  bool once = true;
  desk.scene.before = [&]
  {
    if (std::exchange(once, false))
      desk.scene.Draw();
  };
  const auto before = desk.scene.Frames();
  desk.scene.Draw();
  desk.Settle();
  EXPECT_EQ(desk.scene.Frames(), before + 2);
}

TEST(FrameView, AHiddenViewDrawsOnceItIsSeen)
{
  ViewsDesk desk;
  desk.grid.Maximise(&desk.axial);
  desk.Settle();
  const auto hidden = desk.scene.Frames();
  desk.scene.Draw();
  desk.Settle();
  EXPECT_EQ(desk.scene.Frames(), hidden);
  EXPECT_TRUE(desk.scene.Picture().isNull());
  desk.grid.Maximise(nullptr);
  desk.Settle();
  EXPECT_GT(desk.scene.Frames(), hidden);
}

TEST(FrameView, DrawsFewerPixelsWhileSomethingMoves)
{
  ViewsDesk desk;
  AddCone(desk.scene);
  desk.Settle();
  const int full = desk.scene.renderWindow()->GetSize()[0];
  EXPECT_EQ(desk.scene.Share(), 1.0);

  desk.scene.framesAimed = Absurd;
  double least = 1.0;
  int fewest = full;
  QObject::connect(&desk.scene, &FrameView::Shown, &desk.scene,
    [&]
    {
      least = std::min(least, desk.scene.Share());
      fewest = std::min(fewest, desk.scene.renderWindow()->GetSize()[0]);
    });
  desk.Drag(desk.scene, { 100, 100 }, { 160, 120 });
  QElapsedTimer sinceMotion;
  sinceMotion.start();
  desk.Settle();
  EXPECT_EQ(least, 0.5);
  EXPECT_NEAR(fewest, 0.5 * full, 1.0);

  EXPECT_TRUE(desk.Wait([&] { return desk.scene.Share() == 1.0; }));
  EXPECT_LE(sinceMotion.elapsed(), 500) << "ms after the last motion";
  desk.Settle();
  EXPECT_EQ(desk.scene.renderWindow()->GetSize()[0], full);
}

TEST(FrameView, KeepsItsPixelsWithinADrag)
{
  ViewsDesk desk;
  AddCone(desk.scene);
  desk.scene.framesAimed = 0.0;
  desk.Settle();
  desk.Press(desk.scene, { 100, 100 });
  desk.scene.framesAimed = Absurd;
  desk.Move(desk.scene, { 120, 110 });
  desk.scene.Moving(); // a tool says so, too
  EXPECT_EQ(desk.scene.Share(), 1.0);
  desk.Release(desk.scene, { 120, 110 });
  EXPECT_EQ(desk.scene.Share(), 0.5) << "from then on it may";
}

TEST(FrameView, KeepsAllPixelsWhereFramesAreFastEnough)
{
  ViewsDesk desk;
  desk.scene.framesAimed = 0.01;
  desk.scene.Draw();
  desk.Settle();
  desk.scene.Moving();
  EXPECT_EQ(desk.scene.Share(), 1.0);
}

} // namespace
