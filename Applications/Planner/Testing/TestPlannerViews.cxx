// The 3D view, driven by the mouse and the keyboard.
#include "ConeScene.h"
#include "ViewsDesk.h"

#include "QVTKInteractor.h"
#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <QApplication>
#include <QMouseEvent>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace
{

using namespace hasp;
using namespace hasp::testing;

glm::dvec3 Direction(SceneView& view)
{
  std::array<double, 3> towards;
  view.Renderer()->GetActiveCamera()->GetDirectionOfProjection(towards.data());
  return { towards[0], towards[1], towards[2] };
}

/// Degrees that the camera has turned by a drag.
double TurnedBy(ViewsDesk& desk, const QPoint& from, const QPoint& to, double framesAimed)
{
  LookFromTheFront(desk.scene);
  desk.scene.framesAimed = framesAimed;
  desk.Settle();
  const glm::dvec3 before = Direction(desk.scene);
  desk.Drag(desk.scene, from, to);
  const glm::dvec3 after = Direction(desk.scene);
  desk.Wait([&] { return !desk.scene.IsMoving(); });
  return vtkMath::DegreesFromRadians(std::acos(glm::dot(before, after)));
}

TEST(SceneView, ADragTurnsTheSameWithFewerPixels)
{
  ViewsDesk desk;
  AddCone(desk.scene);
  const QPoint from(60, 60), to(235, 150);
  const double full = TurnedBy(desk, from, to, 0.0);
  EXPECT_GT(full, 20.0);
  bool fewer = false;
  QObject::connect(&desk.scene, &FrameView::Shown, &desk.scene,
    [&] { fewer = fewer || desk.scene.Share() < 1.0; });
  const double half = TurnedBy(desk, from, to, Absurd);
  EXPECT_TRUE(fewer);
  // A pixel of the smaller window in 87: each end is rounded to one.
  EXPECT_NEAR(half, full, 0.01 * full);
}

TEST(SceneView, HasVtksMouse)
{
  ViewsDesk desk;
  AddCone(desk.scene);
  vtkCamera* camera = desk.scene.Renderer()->GetActiveCamera();
  const auto begin = [&]
  {
    LookFromTheFront(desk.scene);
    desk.scene.framesAimed = 0.0;
  };
  const auto direction = [&] { return Direction(desk.scene); };
  const glm::dvec3 ahead(0, 1, 0);
  const QPoint from(100, 100), to(140, 60);

  begin();
  desk.Drag(desk.scene, from, to, Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_LT(glm::distance(direction(), ahead), 1e-9) << "Shift+left moves";
  EXPECT_LT(camera->GetFocalPoint()[0], -1.0) << "what is seen goes along to the right";
  begin();
  desk.Drag(desk.scene, from, to, Qt::MiddleButton);
  EXPECT_LT(camera->GetFocalPoint()[0], -1.0) << "the middle button moves";
  begin();
  desk.Drag(desk.scene, from, to, Qt::RightButton);
  EXPECT_LT(camera->GetDistance(), 290.0) << "right, up: closer";
  begin();
  desk.Wheel(desk.scene, 1);
  EXPECT_LT(camera->GetDistance(), 299.0) << "wheel: closer";
  begin();
  desk.Drag(desk.scene, from, to, Qt::LeftButton, Qt::ControlModifier);
  EXPECT_LT(glm::distance(direction(), ahead), 1e-9) << "Ctrl+left rolls";
  EXPECT_GT(std::abs(camera->GetViewUp()[0]), 0.01);
}

TEST(SceneView, ADoubleClickTurnsNothing)
{
  ViewsDesk desk;
  LookFromTheFront(desk.scene);
  const glm::dvec3 before = Direction(desk.scene);
  const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButtons buttons)
  {
    QMouseEvent event(type, at, Qt::LeftButton, buttons, {});
    QApplication::sendEvent(&desk.scene, &event);
  };
  send(QEvent::MouseButtonDblClick, { 100, 100 }, Qt::LeftButton);
  EXPECT_EQ(desk.grid.Maximised(), &desk.scene);
  send(QEvent::MouseMove, { 10, 290 }, Qt::LeftButton); // the view has moved under the pointer
  send(QEvent::MouseButtonRelease, { 10, 290 }, Qt::NoButton);
  EXPECT_EQ(Direction(desk.scene), before);
}

TEST(SceneView, NoKeyEndsAnything)
{
  ViewsDesk desk;
  const auto actor = AddCone(desk.scene);
  bool asked = false;
  vtkNew<vtkCallbackCommand> exit;
  exit->SetClientData(&asked);
  exit->SetCallback(
    [](vtkObject*, unsigned long, void* seen, void*) { *static_cast<bool*>(seen) = true; });
  desk.scene.interactor()->AddObserver(vtkCommand::ExitEvent, exit);
  for (const Qt::Key key : { Qt::Key_E, Qt::Key_Q, Qt::Key_P, Qt::Key_U, Qt::Key_3 })
    desk.Key(desk.scene, key);
  for (const Qt::Key key : { Qt::Key_E, Qt::Key_Q })
    desk.Key(desk.axial, key);
  desk.Settle();
  EXPECT_FALSE(asked);
  EXPECT_TRUE(desk.grid.isVisible());
  EXPECT_FALSE(desk.scene.renderWindow()->GetStereoRender()) << "3 is the window's";
}

TEST(SceneView, HasVtksKeys)
{
  ViewsDesk desk;
  const auto actor = AddCone(desk.scene);
  vtkCamera* camera = desk.scene.Renderer()->GetActiveCamera();
  desk.Key(desk.scene, Qt::Key_W);
  EXPECT_EQ(actor->GetProperty()->GetRepresentation(), VTK_WIREFRAME);
  desk.Key(desk.scene, Qt::Key_S);
  EXPECT_EQ(actor->GetProperty()->GetRepresentation(), VTK_SURFACE);
  const double distance = camera->GetDistance();
  camera->Dolly(3.0);
  desk.Key(desk.scene, Qt::Key_R);
  EXPECT_NEAR(camera->GetDistance(), distance, 1e-6 * distance);

  LookFromTheFront(desk.scene);
  const double far = camera->GetDistance();
  desk.Key(desk.scene, Qt::Key_PageUp);
  EXPECT_LT(camera->GetDistance(), far);
  desk.Key(desk.scene, Qt::Key_Left); // as a drag to the left: the patient's left side comes
  EXPECT_GT(camera->GetPosition()[0], 1.0);
  LookFromTheFront(desk.scene);
  desk.Key(desk.scene, Qt::Key_Up); // as a drag upwards: what is below comes
  EXPECT_LT(camera->GetPosition()[2], -1.0);

  LookFromTheFront(desk.scene);
  desk.scene.Draw();
  desk.Settle();
  const auto tip = desk.scene.PixelOf({ 20, 0, 0 }); // of the cone
  desk.Hover(desk.scene, tip->toPoint(), {});
  desk.Key(desk.scene, Qt::Key_F);
  // The cone's side towards the viewer is a few mm before its axis; a pixel is 0.7 mm.
  EXPECT_NEAR(camera->GetFocalPoint()[0], 20.0, 1.0);
  EXPECT_NEAR(camera->GetFocalPoint()[1], -4.2, 1.0) << "its surface, not its axis";
}

} // namespace
