// What the four views have in common.
#include "ViewsDesk.h"

#include "QVTKInteractor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace
{

using namespace hasp;
using namespace hasp::testing;

TEST(ViewGrid, ADoubleClickFillsTheSpaceAndAnotherBringsAllBack)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  const glm::dvec3 cross = desk.grid.Crosshair();
  const double height = desk.coronal.height();
  desk.coronal.setFocus();
  desk.DoubleClick(desk.coronal, { 50, 60 });
  desk.Settle();
  EXPECT_EQ(desk.grid.Maximised(), &desk.coronal);
  EXPECT_EQ(desk.coronal.size(), desk.grid.size());
  EXPECT_FALSE(desk.scene.isVisible());
  EXPECT_FALSE(desk.axial.isVisible());
  EXPECT_TRUE(desk.coronal.hasFocus());
  EXPECT_EQ(desk.grid.Crosshair(), cross) << "its first click was no click";

  desk.DoubleClick(desk.coronal, { 50, 60 });
  desk.Settle();
  EXPECT_EQ(desk.grid.Maximised(), nullptr);
  EXPECT_EQ(desk.coronal.height(), height);
  EXPECT_TRUE(desk.scene.isVisible());
  EXPECT_TRUE(desk.axial.isVisible());

  desk.grid.Maximise(&desk.scene);
  EXPECT_TRUE(desk.scene.hasFocus()) << "what had the keyboard is hidden";
  desk.DoubleClick(desk.scene, { 50, 60 });
  EXPECT_EQ(desk.grid.Maximised(), nullptr);
}

TEST(ViewGrid, ADoubleClickOfAToolIsTheTools)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  int presses = 0;
  vtkNew<vtkCallbackCommand> tool;
  tool->SetAbortFlagOnExecute(1);
  tool->SetClientData(&presses);
  tool->SetCallback(
    [](vtkObject*, unsigned long, void* seen, void*) { ++*static_cast<int*>(seen); });
  desk.axial.interactor()->AddObserver(vtkCommand::LeftButtonPressEvent, tool, 1.0F);
  const double window = desk.grid.Window();
  const glm::dvec3 cross = desk.grid.Crosshair();
  desk.DoubleClick(desk.axial, { 50, 60 });
  EXPECT_EQ(presses, 2) << "two dabs of a brush";
  desk.Drag(desk.axial, { 50, 60 }, { 120, 60 });
  EXPECT_EQ(desk.grid.Maximised(), nullptr);
  EXPECT_EQ(desk.grid.Window(), window);
  EXPECT_EQ(desk.grid.Crosshair(), cross);
}

TEST(ViewGrid, ViewsHaveTheirNames)
{
  ViewsDesk desk;
  for (const char* name : { "view.scene", "view.axial", "view.coronal", "view.sagittal" })
    EXPECT_EQ(desk.grid.findChildren<QWidget*>(name).size(), 1) << name;
}

TEST(ViewGrid, BoneHasItsWindowAndOtherGreysTheirQuantiles)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  EXPECT_EQ(desk.grid.Window(), 1000.0);
  EXPECT_EQ(desk.grid.Level(), 400.0);
  // A 200th of the samples are 0 and one 5000; all others lie evenly between 200 and 300.
  int n = 0;
  const auto image = ImageOf(UprightGrid(),
    [&n](const glm::dvec3&)
    {
      const int of = n++ % 200;
      return of == 0 ? 0.0 : of == 199 ? 5000.0 : 200.0 + 0.5 * of;
    });
  desk.grid.SetImage(image, false);
  EXPECT_NEAR(desk.grid.Window(), 98.0, 2.0);
  EXPECT_NEAR(desk.grid.Level(), 250.0, 2.0);
}

TEST(ViewGrid, TheCrosshairStaysInTheImage)
{
  ViewsDesk desk(ImageOf(TurnedGrid(), Ramp));
  desk.grid.SetCrosshair({ 1000.0, 20.0, -300.0 });
  const GridGeometry grid = TurnedGrid();
  const glm::dvec3 index = grid.WorldToIndex(desk.grid.Crosshair());
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_GE(index[axis], -1e-9);
    EXPECT_LE(index[axis], grid.dims[axis] - 1 + 1e-9);
  }
  EXPECT_TRUE(desk.axial.GreyValue());
}

TEST(ViewGrid, ASliceIsShownInThe3DViewAndAway)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  const auto props = [&] { return desk.scene.Renderer()->GetViewProps()->GetNumberOfItems(); };
  const int before = props();
  desk.grid.SetWindowLevel(1e5, -5e4); // all of it white
  desk.scene.Renderer()->GetActiveCamera()->SetPosition(0, 0, -300);
  desk.scene.Renderer()->GetActiveCamera()->SetFocalPoint(0, 0, 0);
  desk.scene.Renderer()->GetActiveCamera()->SetViewUp(0, -1, 0);
  EXPECT_LT(qRed(Drawn(desk.scene).pixel(MiddleOf(desk.scene))), 100);
  desk.Key(desk.axial, Qt::Key_V);
  EXPECT_EQ(props(), before + 1);
  EXPECT_GT(qRed(Drawn(desk.scene).pixel(MiddleOf(desk.scene))), 240);
  desk.Key(desk.axial, Qt::Key_V);
  EXPECT_EQ(props(), before);
}

TEST(ViewGrid, MovingTheCrosshairDrawsNo3DFrame)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  const auto before = desk.scene.Frames();
  desk.grid.SetCrosshair({ 5, 6, 7 });
  desk.Settle();
  EXPECT_EQ(desk.scene.Frames(), before);
}

TEST(SceneView, ParallelProjectionKeepsTheSizeOfWhatIsInTheMiddle)
{
  ViewsDesk desk;
  vtkCamera* camera = desk.scene.Renderer()->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, -400, 0);
  camera->SetViewUp(0, 0, 1);
  const auto size = [&] {
    return desk.scene.PixelOf({ 50, 0, 0 })->x() - desk.scene.PixelOf({ -50, 0, 0 })->x();
  };
  const double pixels = size();
  EXPECT_NEAR(pixels * desk.scene.MmPerPixel(), 100.0, 1e-6);
  desk.Key(desk.scene, Qt::Key_5);
  EXPECT_TRUE(desk.scene.IsParallel());
  EXPECT_NEAR(size(), pixels, 1e-6 * pixels);
  EXPECT_NEAR(size() * desk.scene.MmPerPixel(), 100.0, 1e-6);
  camera->SetParallelScale(0.5 * camera->GetParallelScale());
  desk.Key(desk.scene, Qt::Key_5);
  EXPECT_FALSE(desk.scene.IsParallel());
  EXPECT_NEAR(size(), 2.0 * pixels, 1e-6 * pixels) << "and back, as it was zoomed meanwhile";
}

TEST(ViewGrid, TheViewWithTheKeyboardHasTheWiderFrame)
{
  ViewsDesk desk(ImageOf(UprightGrid(), Ramp));
  const auto third = [](FrameView& view) { return QColor(view.Picture().pixel(2, 60)); };
  desk.coronal.setFocus();
  EXPECT_EQ(third(desk.coronal), FrameOf(SliceAxis::Coronal).colour);
  desk.axial.setFocus();
  EXPECT_NE(third(desk.coronal), FrameOf(SliceAxis::Coronal).colour);
  EXPECT_EQ(third(desk.axial), FrameOf(SliceAxis::Axial).colour);
}

} // namespace
