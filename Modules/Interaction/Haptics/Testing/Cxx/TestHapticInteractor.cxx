#include "vtkHaspHapticInteractor.h"

#include "HapticRenderScene.h"

#include "Devices/CoLocation.h"
#include "Devices/InputHapticDevice.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"
#include "vtkVolume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace
{

using namespace hasp;
using namespace hasp::testing;

TEST(HapticInteractor, WhatCannotBeTouchedIsRefused)
{
  vtkNew<vtkHaspHapticInteractor> haptic;
  const auto refused = [&](const std::function<void()>& call, const char* word)
  { EXPECT_NE(ErrorsOf(haptic, call).find(word), std::string::npos) << word; };
  vtkNew<vtkVolume> volume;
  refused([&] { EXPECT_FALSE(haptic->AddTouchable(volume)); }, "vtkHaspClusteredCellMapper");
  refused([&] { EXPECT_FALSE(haptic->AddTouchable(nullptr)); }, "vtkPolyDataMapper");
  const auto ball = BallActor(10.0);
  ball->SetScale(2.0);
  refused([&] { EXPECT_FALSE(haptic->AddTouchable(ball)); }, "scales");
  refused([&] { EXPECT_EQ(haptic->AddTool(ball), -1); }, "scales");
  refused([&] { EXPECT_EQ(haptic->AddTool(std::vector<vtkProp3D*>{}), -1); }, "no props");
  ball->SetScale(1.0);
  EXPECT_EQ(haptic->AddTool(ball), 0);
  refused([&] { EXPECT_EQ(haptic->AddTool(ball), -1); }, "another tool");
  refused([&] { EXPECT_FALSE(haptic->UseMouse()); }, "interactor");
  refused([&] { EXPECT_FALSE(haptic->AddTouchable(nullptr, 1.0, nullptr)); }, "image");
  vtkNew<vtkMatrix4x4> mirror;
  mirror->SetElement(0, 0, -1.0);
  refused([&] { EXPECT_FALSE(haptic->SetDeviceToWorld(mirror)); }, "mirrors");
  EXPECT_FALSE(haptic->Grab(0)) << "nothing is started";
  EXPECT_FALSE(haptic->Update());
}

TEST(HapticInteractor, NothingIsMadeUntilAToolCanTouchSomething)
{
  vtkNew<vtkHaspHapticInteractor> haptic;
  haptic->SetSpacing(0.6);
  const auto ground = BallActor(15.0), ball = BallActor(5.0);
  EXPECT_TRUE(haptic->AddTouchable(ground));
  ASSERT_TRUE(haptic->SetDevice(HandAt(At(0, 0, 30))));
  haptic->Update();
  EXPECT_EQ(haptic->GetState(), vtkHaspHapticInteractor::Idle);
  EXPECT_EQ(BytesOf(haptic.Get()), 0u);
  EXPECT_EQ(haptic->AddTool(ball), 0);
  ASSERT_TRUE(haptic->SetDevice(nullptr));
  haptic->Update();
  EXPECT_EQ(haptic->GetState(), vtkHaspHapticInteractor::Idle) << "nobody could feel it";
  EXPECT_EQ(BytesOf(haptic.Get()), 0u);
  ASSERT_TRUE(haptic->SetDevice(HandAt(At(0, 0, 30))));
  EXPECT_EQ(haptic->GetState(), vtkHaspHapticInteractor::Baking);
  const Count ready(haptic, vtkHaspHapticInteractor::ReadyEvent);
  UpdateUntilReady(haptic);
  EXPECT_EQ(haptic->GetState(), vtkHaspHapticInteractor::Ready);
  EXPECT_GT(ready.times, 0);
  EXPECT_GT(BytesOf(haptic.Get()), 0u);
  EXPECT_FALSE(haptic->GetLoop()->IsRunning()) << "nothing is in hand";
  haptic->Remove(ball);
  haptic->Update();
  EXPECT_EQ(haptic->GetState(), vtkHaspHapticInteractor::Idle);
}

TEST(HapticInteractor, WhatGoesWhileItIsBakedIsCancelled)
{
  vtkNew<vtkHaspHapticInteractor> haptic;
  const auto ground = BallActor(15.0);
  haptic->SetSpacing(0.15); // seconds of work
  haptic->AddTouchable(ground);
  {
    const auto ball = BallActor(5.0);
    haptic->AddTool(ball);
    ASSERT_TRUE(haptic->SetDevice(HandAt({})));
    haptic->Update();
    EXPECT_EQ(haptic->GetState(), vtkHaspHapticInteractor::Baking);
  } // the actor is gone
  haptic->Remove(ground);
  haptic->Update();
  EXPECT_EQ(haptic->GetState(), vtkHaspHapticInteractor::Idle);
} // and the rest with it

TEST(HapticInteractor, AnOpenSurfaceIsLeftOutWithAWord)
{
  vtkNew<vtkHaspHapticInteractor> haptic;
  haptic->SetSpacing(0.6);
  const auto open = BallActor(15.0, 90.0), ball = BallActor(5.0);
  haptic->AddTouchable(open);
  haptic->AddTool(ball);
  ASSERT_TRUE(haptic->SetDevice(HandAt({})));
  const std::string said = ErrorsOf(haptic, [&] { UpdateUntilReady(haptic); });
  EXPECT_NE(said.find("not closed"), std::string::npos) << said;
}

// The whole way: press the button, the nearest tool comes along, meets the ball, stays where it is
// let go. Held by ticks of the thread.
TEST(HapticInteractor, AToolIsTakenPressedAndLetGo)
{
  // Two balls to choose from; the hand comes down from 22 to 16, where the ball of 5 would be 4
  // deep.
  SimulatedDeviceSettings hand = HandSettings();
  hand.buttons = { { 0.0, 1 } };
  Frames frames;
  const auto ground = BallActor(15.0), far = BallActor(5.0, 360.0, { 30, 0, 0 }),
             ball = BallActor(5.0, 360.0, { 0, 0, 22 });
  frames.haptic->AddTouchable(ground);
  frames.haptic->AddTool(far);
  const int tool = frames.haptic->AddTool(ball);
  ASSERT_TRUE(frames.haptic->SetDevice(
    std::make_unique<SimulatedHapticDevice>(hand, HandIntention(At(0, 0, 22))), Settings()));
  frames.haptic->SetClutchButton(-1);
  UpdateUntilReady(frames.haptic); // the button is held already: only a press takes
  EXPECT_EQ(frames.haptic->GetHeldTool(), -1);
  auto moving = std::make_unique<SimulatedHapticDevice>(hand,
    HandIntention(At(0, 0, 22), { HoldMotion{ 0.05 }, MinimumJerkMotion{ At(0, 0, 16), 0.3 } }));
  SimulatedHapticDevice& truth = *moving;
  ASSERT_TRUE(frames.haptic->SetDevice(std::move(moving), Settings()));
  const Count grabs(frames.haptic, vtkHaspHapticInteractor::GrabEvent),
    presses(frames.haptic, vtkHaspHapticInteractor::ButtonPressEvent),
    left(frames.haptic, vtkCommand::LeftButtonPressEvent),
    contacts(frames.haptic, vtkHaspHapticInteractor::ContactEvent),
    releases(frames.haptic, vtkHaspHapticInteractor::ReleaseEvent);
  ASSERT_TRUE(frames.haptic->Start());
  frames.haptic->Update();
  EXPECT_EQ(frames.haptic->GetHeldTool(), tool);
  EXPECT_EQ(grabs.times + presses.times + left.times, 3);
  EXPECT_TRUE(frames.haptic->GetLoop()->IsRunning());
  frames.UntilTicks(1500);
  const HapticSnapshot seen = frames.haptic->GetLoop()->GetSnapshot();
  EXPECT_EQ(contacts.times, 1);
  EXPECT_GT(seen.onDevice.force.z, 0.1);
  EXPECT_NEAR(truth.Hand().Pose().position.z, 16.0, 1.5);
  // Springs of k an area where balls of R = 5 * 15 / 20 overlap by D: F = pi k R D^2. The fields
  // are off by a tenth of a spacing, meshes by 0.03 mm, each.
  const double height = ball->GetMatrix()->GetElement(2, 3);
  const double overlap =
    std::sqrt(seen.contact.force.z / (std::numbers::pi * Settings().step.contact.stiffness * 3.75));
  EXPECT_NEAR(20.0 - height, overlap, 0.1 * overlap + 0.1);
  EXPECT_NEAR(height, seen.tool.position.z, 1e-9) << "the actor is where the tool is";
  EXPECT_NEAR(far->GetMatrix()->GetElement(0, 3), 30.0, 1e-12);
  frames.haptic->Release();
  EXPECT_EQ(releases.times, 1);
  EXPECT_FALSE(frames.haptic->GetLoop()->IsRunning());
  frames.haptic->Update();
  EXPECT_EQ(ball->GetMatrix()->GetElement(2, 3), height) << "it stays";
  EXPECT_EQ(truth.Applied().force, glm::dvec3(0.0));
}

TEST(HapticInteractor, AGroupMovesAsOneAndKeepsItsMatrices)
{
  Frames frames;
  const auto ground = BallActor(15.0);
  // One stands by its position, one by a user matrix and a turned position.
  const auto one = BallActor(5.0, 360.0, { 0, 0, 40 }), other = BallActor(4.0, 360.0, { 0, 0, 0 });
  vtkNew<vtkTransform> place;
  place->Translate(12, 0, 40);
  place->RotateX(30);
  other->SetUserMatrix(place->GetMatrix());
  other->SetPosition(1, 2, 3);
  frames.haptic->AddTouchable(ground);
  const int tool = frames.haptic->AddTool(std::vector<vtkProp3D*>{ one, other });
  ASSERT_TRUE(frames.haptic->SetDevice(HandAt(At(0, 0, 40))));
  UpdateUntilReady(frames.haptic);
  ASSERT_TRUE(frames.haptic->SetDevice(HandAt(At(0, 0, 40),
    { HoldMotion{ 0.1 }, MinimumJerkMotion{ { { 10, 5, 50 }, TurnBy({ 0, 0, 0.8 }) }, 0.2 } })));
  const RigidPose oneBefore = Pose(one), otherBefore = Pose(other);
  ASSERT_TRUE(frames.haptic->Start());
  ASSERT_TRUE(frames.haptic->Grab(tool));
  frames.UntilTicks(700);
  const RigidPose between = oneBefore.Inverse() * otherBefore,
                  now = Pose(one).Inverse() * Pose(other);
  EXPECT_LT(glm::length(now.position - between.position), 1e-9);
  EXPECT_LT(
    glm::length(RotationVector(glm::conjugate(now.orientation) * between.orientation)), 1e-7);
  EXPECT_GT(glm::length(Pose(one).position - oneBefore.position), 5.0);
  EXPECT_NEAR(glm::length(RotationVector(Pose(one).orientation)), 0.8, 0.05);
  EXPECT_EQ(place->GetMatrix()->GetElement(0, 3), 12.0) << "the application's matrix is its own";
}

TEST(HapticInteractor, PropsAndWindowsMayGoWhileAToolIsInHand)
{
  Frames frames;
  const auto ground = BallActor(15.0);
  {
    const auto ball = BallActor(5.0, 360.0, { 0, 0, 40 });
    frames.haptic->AddTouchable(ground);
    const int tool = frames.haptic->AddTool(ball);
    ASSERT_TRUE(frames.haptic->SetDevice(HandAt(At(0, 0, 40))));
    UpdateUntilReady(frames.haptic);
    ASSERT_TRUE(frames.haptic->Start());
    ASSERT_TRUE(frames.haptic->Grab(tool));
  }
  frames.haptic->Update();
  EXPECT_EQ(frames.haptic->GetHeldTool(), -1);
  EXPECT_FALSE(frames.haptic->GetLoop()->IsRunning());
  const auto again = BallActor(5.0, 360.0, { 0, 0, 40 });
  const int tool = frames.haptic->AddTool(again);
  UpdateUntilReady(frames.haptic);
  ASSERT_TRUE(frames.haptic->Grab(tool));
  frames.window = nullptr;
  EXPECT_FALSE(frames.haptic->GetLoop()->IsRunning());
  frames.haptic->Update();
  EXPECT_FALSE(frames.haptic->Grab(tool));
}

// The drawn tip is where the hand's is: a device that stands turned and moved before a mirror.
TEST(HapticInteractor, TheDrawnTipMeetsTheDevicesTip)
{
  const RigidPose truth{ { 120, -40, 300 }, TurnBy({ 0.3, -1.1, 0.5 }) };
  std::vector<CoLocationPair> pairs;
  for (const glm::dvec3& p : { glm::dvec3(0), glm::dvec3(60, 0, 10), glm::dvec3(0, 50, 0),
         glm::dvec3(-30, 20, 40), glm::dvec3(10, -40, -30) })
    pairs.push_back({ p, truth.Place(p) });
  const CoLocationFit fit = FitCoLocation(pairs);
  EXPECT_LT(fit.rmsMm, 1e-9);
  Frames frames;
  frames.renderer->GetActiveCamera()->Azimuth(70); // which says nothing then
  ASSERT_TRUE(frames.haptic->SetDevice(HandAt({ { 25, 10, -15 }, TurnBy({ 0, 0, 0.4 }) })));
  vtkNew<vtkMatrix4x4> matrix;
  Set(matrix, fit.deviceToWorld);
  ASSERT_TRUE(frames.haptic->SetDeviceToWorld(matrix));
  const auto stylus = BallActor(1.0);
  frames.haptic->SetPointer(stylus);
  ASSERT_TRUE(frames.haptic->Start());
  for (int frame = 0; frame < 3; ++frame)
    frames.haptic->Update();
  // Within an encoder's counts.
  EXPECT_LT(glm::length(Pose(stylus).position - truth.Place({ 25, 10, -15 })), 0.002);
  EXPECT_LT(glm::length(RotationVector(glm::conjugate(Pose(stylus).orientation) *
                                       truth.orientation * TurnBy({ 0, 0, 0.4 }))),
    0.002);
}

/// As a window system's: timers only once it is initialised.
class TimedInteractor : public vtkGenericRenderWindowInteractor
{
public:
  static TimedInteractor* New();
  vtkTypeMacro(TimedInteractor, vtkGenericRenderWindowInteractor);
  int timers = 0;

protected:
  int InternalCreateTimer(int, int, unsigned long) override
  {
    EXPECT_TRUE(this->GetInitialized());
    return ++this->timers;
  }
};
vtkStandardNewMacro(TimedInteractor);

TEST(HapticInteractor, ItsFramesBeginWithTheInteractorWhicheverStartsFirst)
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

TEST(HapticInteractor, AnInteractorWithoutTimersIsSaid)
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
TEST(HapticInteractor, NobodyReadsTheDeviceBeforeTheStart)
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
    this->interactor->SetEventInformation(
      static_cast<int>(100 + 2 * mm.x), static_cast<int>(100 + 2 * mm.y));
    this->interactor->InvokeEvent(event);
    this->haptic->Update();
  }

  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkSmartPointer<vtkActor> ground = BallActor(15.0), left = BallActor(6.0, 360.0, { -6.1, 0, 30 }),
                            right = BallActor(6.0, 360.0, { 6.1, 0, 30 });
  int tools[2];
};

TEST(HapticInteractor, TheFirstPictureStillFitsTheSceneIntoTheCamera)
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

TEST(HapticInteractor, APressTakesWhatIsSeenThere)
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

TEST(HapticInteractor, APressElsewhereIsTheCameras)
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
  mouse.Say(vtkCommand::MouseMoveEvent, { 0, 0 });
  EXPECT_EQ(moves.times, 2) << "then it is the tool's again";
}

} // namespace
