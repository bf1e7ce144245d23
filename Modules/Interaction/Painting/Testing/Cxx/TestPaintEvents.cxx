// Whose the mouse is, and what is said when.
#include "PaintScene.h"

#include "vtkInteractorStyleTrackballCamera.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using namespace hasp;
using namespace hasp::testing;

/// A ball in the middle: pixels within 50 of (100, 100) show it.
struct Scene : PaintScene
{
  Scene()
  {
    this->renderer->AddActor(BallActor(20.0));
    this->Enable();
  }
  Heard heard{ this->painter };
};

std::size_t DepthBytes(vtkHaspSeedPainter* painter)
{
  ResourceList list;
  painter->ListResources(list);
  return list.at(0).bytes;
}

TEST(PaintEvents, AStrokeStartsChangesAndEnds)
{
  Scene scene;
  scene.Drag({ { 90, 100 }, { 100, 100 }, { 110, 100 } });
  EXPECT_EQ(scene.heard.said, "SCCCE") << "two moves, and the last place at the end";
  scene.heard.said.clear();
  scene.Drag({ { 90, 100 } });
  EXPECT_EQ(scene.heard.said, "SE") << "a click";
  EXPECT_EQ(scene.painter->GetNumberOfPieces(), 1) << "and no more of the last one";
  scene.heard.said.clear();
  scene.Drag({ { 90, 100 }, { 91, 100 } }); // less than a quarter of the radius
  EXPECT_EQ(scene.heard.said, "SCE") << "the last point, at the end";
  EXPECT_EQ(scene.painter->GetNumberOfPoints(0), 2);
}

TEST(PaintEvents, WhatIsPaintedIsThereWhenItIsSaid)
{
  Scene scene;
  scene.painter->SetLabel(7);
  scene.painter->SetRadiusMm(3.0);
  scene.Press({ 90, 100 });
  EXPECT_TRUE(scene.painter->IsPainting());
  EXPECT_EQ(scene.painter->GetStroke().label, 7);
  EXPECT_EQ(scene.painter->GetStroke().radiusMm, 3.0);
  EXPECT_EQ(scene.painter->GetStroke().points.size(), 1u);
  scene.Release({ 90, 100 });
  EXPECT_FALSE(scene.painter->IsPainting());
  scene.painter->EraseOn();
  scene.Drag({ { 90, 100 } });
  EXPECT_EQ(scene.painter->GetStroke().label, 0);
}

TEST(PaintEvents, EscapeTakesTheStrokeBackAndTheRestOfTheDrag)
{
  Scene scene;
  const Count moves(scene.interactor, vtkCommand::MouseMoveEvent),
    keys(scene.interactor, vtkCommand::KeyPressEvent),
    releases(scene.interactor, vtkCommand::LeftButtonReleaseEvent);
  scene.Press({ 90, 100 });
  scene.Hover({ 100, 100 });
  scene.Say(vtkCommand::KeyPressEvent, { 100, 100 }, "", "Escape");
  EXPECT_EQ(scene.heard.said, "SCX");
  EXPECT_TRUE(scene.painter->GetPieces().empty());
  EXPECT_FALSE(scene.painter->IsPainting());
  scene.Hover({ 110, 100 });
  scene.Release({ 110, 100 });
  EXPECT_EQ(scene.heard.said, "SCX");
  EXPECT_EQ(moves.times + keys.times + releases.times, 0) << "the camera does not jump";
  scene.Say(vtkCommand::KeyPressEvent, { 100, 100 }, "", "Escape");
  EXPECT_EQ(keys.times, 1) << "with no stroke it is somebody else's";
  scene.Drag({ { 90, 100 } });
  EXPECT_EQ(scene.painter->GetNumberOfPieces(), 1);
}

TEST(PaintEvents, APressBesideTheSurfaceIsTheStyles)
{
  Scene scene;
  const Count presses(scene.interactor, vtkCommand::LeftButtonPressEvent),
    moves(scene.interactor, vtkCommand::MouseMoveEvent),
    releases(scene.interactor, vtkCommand::LeftButtonReleaseEvent);
  scene.Drag({ { 10, 10 }, { 100, 100 } });
  EXPECT_EQ(scene.heard.said, "");
  EXPECT_EQ(presses.times + moves.times + releases.times, 3);
  scene.Drag({ { 100, 100 }, { 10, 10 } });
  EXPECT_EQ(scene.heard.said, "SCE");
  EXPECT_EQ(presses.times + moves.times + releases.times, 3);
}

TEST(PaintEvents, OtherButtonsAreTheStylesAndNobodysWithinAStroke)
{
  Scene scene;
  const Count presses(scene.interactor, vtkCommand::RightButtonPressEvent),
    releases(scene.interactor, vtkCommand::RightButtonReleaseEvent),
    wheels(scene.interactor, vtkCommand::MouseWheelForwardEvent);
  const auto others = [&]
  {
    scene.Say(vtkCommand::RightButtonPressEvent, { 100, 100 });
    scene.Say(vtkCommand::RightButtonReleaseEvent, { 100, 100 });
    scene.Say(vtkCommand::MouseWheelForwardEvent, { 100, 100 });
    return presses.times + releases.times + wheels.times;
  };
  EXPECT_EQ(others(), 3);
  scene.Press({ 100, 100 });
  EXPECT_EQ(others(), 3);
  scene.Release({ 100, 100 });
  EXPECT_EQ(others(), 6);
}

// VTK's styles keep a drag's events to themselves, its release among them.
TEST(PaintEvents, AfterEachDragOfVtksOwnStyleOnePaintsAgain)
{
  Scene scene;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  scene.interactor->SetInteractorStyle(style);
  scene.interactor->Enable();
  scene.Press({ 10, 10 });
  ASSERT_NE(style->GetState(), VTKIS_NONE) << "the camera's";
  scene.Hover({ 11, 10 });
  scene.Release({ 11, 10 });
  EXPECT_EQ(style->GetState(), VTKIS_NONE);
  EXPECT_EQ(scene.heard.said, "");
  scene.Press({ 100, 100 });
  EXPECT_EQ(style->GetState(), VTKIS_NONE);
  scene.Release({ 100, 100 });
  EXPECT_EQ(scene.heard.said, "SE");
}

TEST(PaintEvents, AModifierIsWhatIsHeldAloneAtThePress)
{
  constexpr std::pair<int, const char*> Asked[] = { { vtkHaspSeedPainter::NoModifier, "" },
    { vtkHaspSeedPainter::ShiftModifier, "s" }, { vtkHaspSeedPainter::ControlModifier, "c" },
    { vtkHaspSeedPainter::AltModifier, "a" } };
  Scene scene;
  for (const auto& [modifier, asked] : Asked)
    for (const std::string held : { "", "s", "c", "a", "sc" })
    {
      scene.painter->SetModifier(modifier);
      scene.heard.said.clear();
      scene.Say(vtkCommand::LeftButtonPressEvent, { 100, 100 }, held);
      scene.Release({ 100, 100 }); // let go before the button
      EXPECT_EQ(scene.heard.said, held == asked ? "SE" : "") << modifier << held;
    }
}

TEST(PaintEvents, ShiftAndTheWheelAndKeysChangeTheRadius)
{
  Scene scene;
  const Count wheels(scene.interactor, vtkCommand::MouseWheelForwardEvent);
  scene.Say(vtkCommand::MouseWheelForwardEvent, { 100, 100 }, "s");
  EXPECT_NEAR(scene.painter->GetRadiusMm(), 2.2, 1e-12);
  scene.Say(vtkCommand::MouseWheelBackwardEvent, { 100, 100 }, "s");
  EXPECT_NEAR(scene.painter->GetRadiusMm(), 2.0, 1e-12);
  scene.Say(vtkCommand::KeyPressEvent, { 100, 100 }, "", "plus");
  EXPECT_NEAR(scene.painter->GetRadiusMm(), 2.2, 1e-12);
  scene.Say(vtkCommand::KeyPressEvent, { 100, 100 }, "", "minus");
  EXPECT_EQ(scene.heard.said, "RRRR");
  EXPECT_EQ(wheels.times, 0);
  scene.Say(vtkCommand::MouseWheelForwardEvent, { 100, 100 });
  EXPECT_EQ(wheels.times, 1) << "the camera's";
  for (int n = 0; n < 100; ++n)
    scene.Say(vtkCommand::MouseWheelForwardEvent, { 100, 100 }, "s");
  EXPECT_EQ(scene.painter->GetRadiusMm(), 50.0);
}

TEST(PaintEvents, ALargerBrushWithinADragIsANewPieceThatGoesOn)
{
  Scene scene;
  scene.Press({ 90, 100 });
  scene.Hover({ 100, 100 });
  scene.Say(vtkCommand::MouseWheelForwardEvent, { 100, 100 }, "s");
  scene.Hover({ 110, 100 });
  scene.Release({ 110, 100 });
  const auto& pieces = scene.painter->GetPieces();
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].radiusMm, 2.0);
  EXPECT_NEAR(pieces[1].radiusMm, 2.2, 1e-12);
  EXPECT_EQ(pieces[0].points.back(), pieces[1].points.front());
}

TEST(PaintEvents, ALostReleaseEndsAtTheNextPress)
{
  Scene scene;
  scene.Press({ 90, 100 });
  scene.Press({ 110, 100 });
  EXPECT_EQ(scene.heard.said, "SES");
  EXPECT_EQ(scene.painter->GetNumberOfPieces(), 1);
  scene.Release({ 110, 100 });
  EXPECT_EQ(scene.heard.said, "SESE");
}

TEST(PaintEvents, SwitchedOffWithinAStrokeItIsEnded)
{
  Scene scene;
  scene.Press({ 90, 100 });
  scene.painter->EnabledOff();
  EXPECT_EQ(scene.heard.said, "SE");
  EXPECT_EQ(scene.painter->GetNumberOfPieces(), 1);
  const Count presses(scene.interactor, vtkCommand::LeftButtonPressEvent);
  scene.Press({ 90, 100 });
  EXPECT_EQ(presses.times, 1);
}

TEST(PaintEvents, APainterMayEndInItsOwnEvent)
{
  Scene scene;
  vtkNew<vtkCallbackCommand> off;
  off->SetCallback([](vtkObject* painter, unsigned long, void*, void*)
    { static_cast<vtkHaspSeedPainter*>(painter)->EnabledOff(); });
  scene.painter->AddObserver(vtkHaspSeedPainter::StrokeChangedEvent, off);
  scene.Drag({ { 90, 100 }, { 100, 100 }, { 110, 100 } });
  EXPECT_EQ(scene.heard.said, "SCCE") << "with the last place, as at a release";
  EXPECT_FALSE(scene.painter->GetEnabled());
}

TEST(PaintEvents, ARendererAboveWithItsOwnCameraHasItsOwnMouse)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(20.0));
  scene.window->SetNumberOfLayers(2);
  vtkNew<vtkRenderer> above;
  above->SetLayer(1);
  above->SetViewport(0.0, 0.0, 0.55, 0.55);
  scene.window->AddRenderer(above);
  scene.Enable();
  Heard heard(scene.painter);
  scene.Drag({ { 105, 105 } });
  EXPECT_EQ(heard.said, "");
  scene.Drag({ { 115, 115 } });
  EXPECT_EQ(heard.said, "SE");
  above->InteractiveOff(); // as a marker of axes
  scene.Drag({ { 105, 105 } });
  EXPECT_EQ(heard.said, "SESE");
}

TEST(PaintEvents, NothingIsThereUnlessOnePaints)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(20.0));
  scene.window->Render();
  EXPECT_EQ(scene.renderer->GetViewProps()->GetNumberOfItems(), 1);
  EXPECT_EQ(DepthBytes(scene.painter), 0u);
  scene.Enable();
  scene.window->Render();
  EXPECT_EQ(DepthBytes(scene.painter), 0u) << "the pointer is not here";
  scene.Hover({ 100, 100 });
  EXPECT_EQ(DepthBytes(scene.painter), Side * Side * sizeof(float));
  scene.Say(vtkCommand::LeaveEvent, { 0, 0 });
  scene.window->Render();
  EXPECT_EQ(DepthBytes(scene.painter), 0u) << "freed with the next frame";
  scene.painter->EnabledOff();
  EXPECT_EQ(scene.renderer->GetViewProps()->GetNumberOfItems(), 1);
}

TEST(PaintEvents, BoundsAreThoseOfTheSceneWithoutABrush)
{
  Scene scene;
  scene.Hover({ 100, 100 });
  double with[6], without[6];
  scene.renderer->ComputeVisiblePropBounds(with);
  scene.painter->EnabledOff();
  scene.renderer->ComputeVisiblePropBounds(without);
  for (int n = 0; n < 6; ++n)
    EXPECT_EQ(with[n], without[n]);
}

TEST(PaintEvents, WrongValuesAreSaidAndChangeNothing)
{
  Scene scene;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double mm : { 0.0, -1.0, 50.1, nan })
    EXPECT_NE(ErrorsOf(scene.painter, [&] { scene.painter->SetRadiusMm(mm); }).find("(0, 50] mm"),
      std::string::npos);
  EXPECT_EQ(scene.painter->GetRadiusMm(), 2.0);
  for (const int label : { 0, -1, 65536 })
    EXPECT_NE(ErrorsOf(scene.painter, [&] { scene.painter->SetLabel(label); }).find("[1, 65535]"),
      std::string::npos);
  EXPECT_EQ(scene.painter->GetLabel(), 2);
  EXPECT_NE(ErrorsOf(scene.painter, [&] { scene.painter->SetLabelColor(2, 0.5, nan, 0.5); })
              .find("components in [0, 1]"),
    std::string::npos);
  vtkNew<vtkHaspSeedPainter> alone;
  EXPECT_NE(ErrorsOf(alone, [&] { alone->EnabledOn(); }).find("interactor"), std::string::npos);
  EXPECT_FALSE(alone->GetEnabled());
  double at[3] = { 1, 2, 3 };
  EXPECT_FALSE(scene.painter->GetPoint(0, 0, at));
  EXPECT_EQ(at[0], 1.0);
}

TEST(PaintEvents, WhatItHoldsMayGoFirst)
{
  vtkNew<vtkHaspSeedPainter> painter;
  {
    Scene scene;
    painter->SetRenderer(scene.renderer);
    painter->EnabledOn();
    scene.Press({ 100, 100 });
  }
  EXPECT_EQ(painter->GetRenderer(), nullptr);
  painter->EnabledOff();
  painter->EnabledOn();
}

} // namespace
