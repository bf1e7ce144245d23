// The window's part: who asks for frames, and whose the mouse is.
#include "vtkHaspHapticInteractor.h"

#include "HapticRenderScene.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"

#include <gtest/gtest.h>

#include <array>

namespace
{

using namespace hasp;
using namespace hasp::testing;

/// As a window system's: timers only once it is initialised.
class TimedInteractor : public vtkGenericRenderWindowInteractor
{
public:
  static TimedInteractor* New();
  vtkTypeMacro(TimedInteractor, vtkGenericRenderWindowInteractor);
  int timers = 0, made = 0; ///< how many, and VTK's number of the last

protected:
  int InternalCreateTimer(int number, int, unsigned long) override
  {
    this->made = number;
    EXPECT_TRUE(this->GetInitialized());
    return ++this->timers;
  }
  int InternalDestroyTimer(int) override
  {
    --this->timers;
    return 1;
  }
};
vtkStandardNewMacro(TimedInteractor);

TEST(HapticWindow, ItsFramesBeginWithTheInteractorWhicheverStartsFirst)
{
  for (const bool first : { false, true })
  {
    Frames frames;
    vtkNew<TimedInteractor> interactor;
    interactor->EnableRenderOff(); // no window is opened
    interactor->SetRenderWindow(frames.renderer->GetRenderWindow());
    ASSERT_TRUE(frames.haptic->UseMouse());
    if (first)
      interactor->Initialize();
    ASSERT_TRUE(frames.haptic->Start());
    EXPECT_EQ(interactor->timers, first ? 1 : 0);
    if (!first)
      interactor->Initialize(); // as its Start does
    EXPECT_EQ(interactor->timers, 1) << first;
    interactor->Modified();
    EXPECT_EQ(interactor->timers, 1) << first;
  }
}

TEST(HapticWindow, AnInteractorWithoutTimersIsSaid)
{
  Frames frames;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  interactor->EnableRenderOff();
  interactor->SetRenderWindow(frames.renderer->GetRenderWindow());
  interactor->Initialize();
  ASSERT_TRUE(frames.haptic->UseMouse());
  const Count warned(frames.haptic, vtkCommand::WarningEvent);
  ASSERT_TRUE(frames.haptic->Start());
  interactor->Modified();
  EXPECT_EQ(warned.times, 1);
}

// What a simulated hand means to do begins when it is asked for, not while maps are baked.
TEST(HapticWindow, NobodyReadsTheDeviceBeforeTheStart)
{
  Frames frames;
  const auto ground = BallActor(15.0), ball = BallActor(5.0, 360.0, { 0, 0, 40 });
  frames.haptic->AddTouchable(ground);
  frames.haptic->AddTool(ball);
  ASSERT_TRUE(frames.haptic->SetDevice(HandAt(At(0, 0, 40))));
  UpdateUntilReady(frames.haptic);
  EXPECT_EQ(frames.haptic->GetLoop()->GetSnapshot().ticks, 0u);
  ASSERT_TRUE(frames.haptic->Start());
  frames.haptic->Update();
  EXPECT_EQ(frames.haptic->GetLoop()->GetSnapshot().ticks, 1u);
}

/// A picture of two tools before the ball that they can touch, and a mouse.
struct Mouse : Frames
{
  Mouse()
  {
    this->window->SetOffScreenRendering(true);
    this->window->SetMultiSamples(0);
    this->renderer->GetActiveCamera()->ParallelProjectionOn();
    this->renderer->GetActiveCamera()->SetParallelScale(50.0); // half of 200 pixels: 0.5 mm each
    this->interactor->SetRenderWindow(this->window);
    this->interactor->SetInteractorStyle(nullptr); // it would keep a drag's events to itself
    for (vtkActor* actor : { this->ground.Get(), this->left.Get(), this->right.Get() })
      this->renderer->AddActor(actor);
    this->haptic->AddTouchable(this->ground);
    this->tools[0] = this->haptic->AddTool(this->left);
    this->tools[1] = this->haptic->AddTool(this->right);
    this->haptic->SetGrabReach(3.0);
    EXPECT_TRUE(this->haptic->UseMouse());
    UpdateUntilReady(this->haptic);
    EXPECT_TRUE(this->haptic->Start());
    this->haptic->Update();
    this->window->Render();
  }
  void Say(unsigned long event, const glm::dvec2& mm)
  {
    this->SayWithoutFrame(event, mm);
    this->haptic->Update();
  }
  void SayWithoutFrame(unsigned long event, const glm::dvec2& mm)
  {
    this->interactor->SetEventInformation(
      static_cast<int>(100 + 2 * mm.x), static_cast<int>(100 + 2 * mm.y));
    this->interactor->InvokeEvent(event);
  }

  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkSmartPointer<vtkActor> ground = BallActor(15.0), left = BallActor(6.0, 360.0, { -6.1, 0, 30 }),
                            right = BallActor(6.0, 360.0, { 6.1, 0, 30 });
  int tools[2];
};

TEST(HapticWindow, TheFirstPictureStillFitsTheSceneIntoTheCamera)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  window->SetInteractor(interactor);
  vtkNew<vtkHaspHapticInteractor> haptic;
  haptic->SetRenderer(renderer);
  ASSERT_TRUE(haptic->UseMouse());
  ASSERT_TRUE(haptic->Start());
  haptic->Update();
  interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  EXPECT_FALSE(renderer->IsActiveCameraCreated());
  renderer->GetActiveCamera()->SetFocalPoint(1, 2, 3);
  haptic->Update();
  haptic->Update();
  EXPECT_LT(
    glm::length(haptic->GetLoop()->GetSnapshot().device.position - glm::dvec3(1, 2, 3)), 1e-9);
}

TEST(HapticWindow, APressTakesWhatIsSeenThere)
{
  for (const int side : { 0, 1 })
  {
    Mouse mouse;
    const Count styled(mouse.interactor, vtkCommand::LeftButtonPressEvent);
    const double x = side == 0 ? -2.0 : 2.0; // a mm and a half from where they meet
    mouse.Say(vtkCommand::LeftButtonPressEvent, { x, 0 });
    EXPECT_EQ(mouse.haptic->GetHeldTool(), mouse.tools[side]);
    // Off the middle by 4.1 a ball of 6 is 4.38 high. Triangles, and the depth's steps.
    const glm::dvec3 at = mouse.haptic->GetLoop()->GetSnapshot().device.position;
    EXPECT_LT(glm::length(at - glm::dvec3(x, 0, 30 + 4.38)), 0.3) << at.x << " " << at.z;
    const double before = Pose(side == 0 ? mouse.left : mouse.right).position.x;
    mouse.Say(vtkCommand::MouseMoveEvent, { x, 0 });
    mouse.Say(vtkCommand::MouseMoveEvent, { x, 8 });
    mouse.UntilTicks(mouse.haptic->GetLoop()->GetSnapshot().ticks + 500);
    EXPECT_NEAR(Pose(side == 0 ? mouse.left : mouse.right).position.y, 8.0, 0.3);
    EXPECT_NEAR(Pose(side == 0 ? mouse.left : mouse.right).position.x, before, 0.3);
    mouse.Say(vtkCommand::LeftButtonReleaseEvent, { x, 8 });
    mouse.UntilTicks(mouse.haptic->GetLoop()->GetSnapshot().ticks + 20); // one that has seen it
    EXPECT_EQ(mouse.haptic->GetHeldTool(), -1);
    EXPECT_EQ(styled.times, 0) << "the camera stays";
  }
}

// On a busy machine many events come between two frames.
TEST(HapticWindow, APressTakesWhateverComesBeforeTheNextFrame)
{
  Mouse mouse;
  mouse.SayWithoutFrame(vtkCommand::LeftButtonPressEvent, { 2, 0 });
  mouse.SayWithoutFrame(vtkCommand::MouseMoveEvent, { 2, 0 });
  mouse.SayWithoutFrame(vtkCommand::MouseMoveEvent, { 42, 0 }); // out of reach of what was meant
  mouse.haptic->Update();
  EXPECT_EQ(mouse.haptic->GetHeldTool(), mouse.tools[1]);
  mouse.UntilTicks(mouse.haptic->GetLoop()->GetSnapshot().ticks + 500);
  mouse.window->Render();
  const Count released(mouse.haptic, vtkHaspHapticInteractor::ReleaseEvent);
  mouse.SayWithoutFrame(vtkCommand::LeftButtonReleaseEvent, { 42, 0 });
  mouse.SayWithoutFrame(vtkCommand::LeftButtonPressEvent, { -4, 0 }); // another one
  EXPECT_EQ(mouse.haptic->GetHeldTool(), mouse.tools[0]);
  EXPECT_EQ(released.times, 1);
  mouse.UntilTicks(mouse.haptic->GetLoop()->GetSnapshot().ticks + 20);
  EXPECT_EQ(mouse.haptic->GetHeldTool(), mouse.tools[0]);
  mouse.SayWithoutFrame(vtkCommand::LeftButtonReleaseEvent, { -4, 0 });
  mouse.SayWithoutFrame(vtkCommand::LeftButtonPressEvent, { 0, -40 }); // nothing: the camera's
  EXPECT_EQ(mouse.haptic->GetHeldTool(), -1);
}

// Frames cost; those in which nothing moves are not asked for, whatever could be drawn.
TEST(HapticWindow, WhereNothingMovesNoPictureIsAskedFor)
{
  Mouse mouse;
  const auto stylus = BallActor(1.0);
  mouse.haptic->SetShowForces(true);
  mouse.haptic->SetShowShell(true);
  mouse.haptic->SetPointer(stylus);
  EXPECT_TRUE(mouse.haptic->Update()) << "the pointer goes there";
  for (int frame = 0; frame < 5; ++frame)
    EXPECT_FALSE(mouse.haptic->Update());
  EXPECT_GT(mouse.haptic->GetLoop()->GetSnapshot().ticks, 5u);
  const auto other = BallActor(1.0);
  mouse.haptic->SetPointer(other);
  EXPECT_TRUE(mouse.haptic->Update());
}

TEST(HapticWindow, APressElsewhereIsTheCameras)
{
  Mouse mouse;
  const Count presses(mouse.interactor, vtkCommand::LeftButtonPressEvent),
    moves(mouse.interactor, vtkCommand::MouseMoveEvent),
    releases(mouse.interactor, vtkCommand::LeftButtonReleaseEvent);
  for (const glm::dvec2& at : { glm::dvec2(0, -12), glm::dvec2(40, 40) }) // the ground, and nothing
  {
    mouse.Say(vtkCommand::LeftButtonPressEvent, at);
    mouse.Say(vtkCommand::MouseMoveEvent, at + 5.0);
    EXPECT_EQ(mouse.haptic->GetHeldTool(), -1);
    mouse.Say(vtkCommand::LeftButtonReleaseEvent, at + 5.0);
  }
  EXPECT_EQ(presses.times, 2);
  EXPECT_EQ(moves.times, 2);
  EXPECT_EQ(releases.times, 2);
  // Nothing is in hand: wheel and all other buttons, too. In hand, all of it is the tool's.
  const Count wheel(mouse.interactor, vtkCommand::MouseWheelForwardEvent),
    middle(mouse.interactor, vtkCommand::MiddleButtonPressEvent),
    right(mouse.interactor, vtkCommand::RightButtonPressEvent),
    keys(mouse.interactor, vtkCommand::KeyPressEvent);
  const auto others = [&](const glm::dvec2& at)
  {
    mouse.Say(vtkCommand::MouseWheelForwardEvent, at);
    for (const auto event :
      { vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent,
        vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent })
      mouse.Say(event, at);
    mouse.interactor->SetKeySym("Left");
    mouse.Say(vtkCommand::KeyPressEvent, at);
    return std::array{ wheel.times, middle.times, right.times, keys.times };
  };
  EXPECT_EQ(others({ 2, 0 }), (std::array{ 1, 1, 1, 1 }));
  mouse.Say(vtkCommand::LeftButtonPressEvent, { 2, 0 });
  ASSERT_GE(mouse.haptic->GetHeldTool(), 0);
  EXPECT_EQ(others({ 2, 0 }), (std::array{ 1, 1, 1, 1 }));
  mouse.Say(vtkCommand::MouseMoveEvent, { 0, 0 });
  EXPECT_EQ(moves.times, 2);
}

// A style repeats its last step at each timer's event that it sees: the camera would turn on.
TEST(HapticWindow, ItsTimerIsNobodyElses)
{
  Frames frames;
  vtkNew<TimedInteractor> interactor;
  interactor->EnableRenderOff();
  interactor->SetRenderWindow(frames.renderer->GetRenderWindow());
  interactor->Initialize();
  ASSERT_TRUE(frames.haptic->UseMouse());
  const Count others(interactor, vtkCommand::TimerEvent); // was there before
  ASSERT_TRUE(frames.haptic->Start());
  ASSERT_EQ(interactor->timers, 1);
  frames.haptic->Update();
  const std::uint64_t ticks = frames.haptic->GetLoop()->GetSnapshot().ticks;
  int own = interactor->made, strange = own + 1;
  interactor->InvokeEvent(vtkCommand::TimerEvent, &own);
  EXPECT_EQ(others.times, 0);
  EXPECT_EQ(frames.haptic->GetLoop()->GetSnapshot().ticks, ticks + 1) << "a frame";
  interactor->InvokeEvent(vtkCommand::TimerEvent, &strange);
  EXPECT_EQ(others.times, 1);
  EXPECT_EQ(frames.haptic->GetLoop()->GetSnapshot().ticks, ticks + 1) << "another's is no frame";
}

TEST(HapticWindow, ItsFramesFollowTheRenderer)
{
  Frames frames;
  vtkNew<vtkRenderWindow> beside;
  vtkNew<vtkRenderer> renderer;
  beside->AddRenderer(renderer);
  vtkNew<TimedInteractor> before, after;
  before->SetRenderWindow(frames.window);
  after->SetRenderWindow(beside);
  for (TimedInteractor* interactor : { before.Get(), after.Get() })
  {
    interactor->EnableRenderOff();
    interactor->Initialize();
  }
  ASSERT_TRUE(frames.haptic->UseMouse());
  ASSERT_TRUE(frames.haptic->Start());
  ASSERT_EQ(after->timers, 0);
  frames.haptic->SetRenderer(renderer);
  EXPECT_EQ(after->timers, 1);
  EXPECT_EQ(before->timers, 0);
}

TEST(HapticWindow, APressInAnotherViewportIsNotThisOnes)
{
  Mouse mouse;
  mouse.haptic->SetGrabReach(1000.0);
  vtkNew<vtkRenderer> beside;
  beside->SetViewport(0.0, 0.0, 0.5, 1.0);
  beside->AddActor(mouse.ground);
  mouse.renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  mouse.window->AddRenderer(beside);
  beside->SetActiveCamera(mouse.renderer->GetActiveCamera());
  mouse.window->Render();
  const Count presses(mouse.interactor, vtkCommand::LeftButtonPressEvent);
  mouse.Say(vtkCommand::LeftButtonPressEvent, { -25, 0 }); // the ground, beside
  mouse.Say(vtkCommand::LeftButtonReleaseEvent, { -25, 0 });
  EXPECT_EQ(mouse.haptic->GetHeldTool(), -1);
  EXPECT_EQ(presses.times, 1);
  mouse.Say(vtkCommand::LeftButtonPressEvent, { 25, 0 });
  EXPECT_GE(mouse.haptic->GetHeldTool(), 0);
}

TEST(HapticWindow, TheMouseFollowsTheRenderer)
{
  Mouse mouse;
  const Count presses(mouse.interactor, vtkCommand::LeftButtonPressEvent);
  mouse.haptic->SetRenderer(nullptr);
  mouse.Say(vtkCommand::LeftButtonPressEvent, { 2, 0 });
  mouse.Say(vtkCommand::LeftButtonReleaseEvent, { 2, 0 });
  EXPECT_EQ(mouse.haptic->GetHeldTool(), -1);
  EXPECT_EQ(presses.times, 1);
  mouse.haptic->SetRenderer(mouse.renderer);
  mouse.Say(vtkCommand::LeftButtonPressEvent, { 2, 0 });
  EXPECT_EQ(mouse.haptic->GetHeldTool(), mouse.tools[1]);
  // What is held in the window before is let go.
  mouse.haptic->SetRenderer(nullptr);
  mouse.UntilTicks(mouse.haptic->GetLoop()->GetSnapshot().ticks + 20);
  EXPECT_EQ(mouse.haptic->GetHeldTool(), -1);
}

TEST(HapticWindow, APropThatIsScaledNowIsAnErrorAndNoMore)
{
  Mouse mouse;
  mouse.left->SetScale(2.0);
  const std::string said = ErrorsOf(mouse.haptic,
    [&] {
      EXPECT_NO_THROW(mouse.Say(vtkCommand::LeftButtonPressEvent, { 2, 0 }));
    });
  EXPECT_NE(said.find("scales"), std::string::npos) << said;
  EXPECT_EQ(mouse.haptic->GetHeldTool(), -1);
  mouse.ground->SetScale(2.0);
  ErrorsOf(mouse.haptic, [&] { EXPECT_NO_THROW(mouse.haptic->Remove(mouse.left)); });
}

TEST(HapticWindow, APressBeforeTheFirstPictureTakesNothing)
{
  Frames frames;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(frames.window);
  interactor->SetInteractorStyle(nullptr);
  ASSERT_TRUE(frames.haptic->UseMouse());
  ASSERT_TRUE(frames.haptic->Start());
  const Count presses(interactor, vtkCommand::LeftButtonPressEvent);
  interactor->SetEventInformation(100, 100);
  interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  EXPECT_EQ(presses.times, 1);
  EXPECT_TRUE(frames.window->GetNeverRendered());
}

// Drags of the camera all go one way, and the pointer comes back each time with no button held.
TEST(HapticWindow, HoweverFarThePointerWasCarriedAToolGoesOn)
{
  Mouse mouse;
  for (int drag = 0; drag < 120; ++drag)
  {
    mouse.Say(vtkCommand::MouseMoveEvent, { -45, -45 });
    mouse.Say(vtkCommand::MouseMoveEvent, { 45, -45 });
    mouse.Say(vtkCommand::LeftButtonPressEvent, { 45, -45 });
    mouse.Say(vtkCommand::MouseMoveEvent, { -45, -45 });
    mouse.Say(vtkCommand::LeftButtonReleaseEvent, { -45, -45 });
  }
  mouse.Say(vtkCommand::LeftButtonPressEvent, { 2, 0 });
  ASSERT_EQ(mouse.haptic->GetHeldTool(), mouse.tools[1]);
  const double before = Pose(mouse.right).position.x;
  mouse.Say(vtkCommand::MouseMoveEvent, { 2, 0 });
  mouse.Say(vtkCommand::MouseMoveEvent, { 12, 0 });
  mouse.UntilTicks(mouse.haptic->GetLoop()->GetSnapshot().ticks + 500);
  EXPECT_NEAR(Pose(mouse.right).position.x - before, 10.0, 0.3);
}

} // namespace
