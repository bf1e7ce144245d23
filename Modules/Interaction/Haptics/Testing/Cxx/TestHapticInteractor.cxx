#include "vtkHaspHapticInteractor.h"

#include "HapticDrawing.h"
#include "HapticExchange.h"
#include "HapticRenderScene.h"

#include "vtkGenericRenderWindowInteractor.h"
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
  EXPECT_NE(said.find("prop 1 in the order of adding"), std::string::npos) << said;
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
  Frames frames;
  frames.renderer->GetActiveCamera()->Azimuth(70); // which says nothing then
  ASSERT_TRUE(frames.haptic->SetDevice(HandAt({ { 25, 10, -15 }, TurnBy({ 0, 0, 0.4 }) })));
  vtkNew<vtkMatrix4x4> matrix;
  Set(matrix, truth); // as FitCoLocation finds it, where there are fits
  ASSERT_TRUE(frames.haptic->SetDeviceToWorld(matrix));
  const auto stylus = BallActor(1.0);
  frames.haptic->SetPointer(stylus);
  ASSERT_TRUE(frames.haptic->Start());
  frames.UntilTicks(3); // the loop's thread may start late
  // Within an encoder's counts.
  EXPECT_LT(glm::length(Pose(stylus).position - truth.Place({ 25, 10, -15 })), 0.002);
  EXPECT_LT(glm::length(RotationVector(glm::conjugate(Pose(stylus).orientation) *
                                       truth.orientation * TurnBy({ 0, 0, 0.4 }))),
    0.002);
}

// After the end a device is read, but nothing is felt: a tool would go through all.
TEST(HapticInteractor, WhatIsInHandAtTheEndStaysThere)
{
  Frames frames;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  frames.haptic->SetRenderer(nullptr);
  frames.window->SetInteractor(interactor);
  vtkNew<vtkRenderer> renderer;
  frames.haptic->SetRenderer(renderer); // which has no window yet
  frames.window->AddRenderer(renderer);
  const auto ground = BallActor(15.0), ball = BallActor(5.0, 360.0, { 0, 0, 40 });
  frames.haptic->AddTouchable(ground);
  const int tool = frames.haptic->AddTool(ball);
  const auto hand = [] {
    return HandAt(At(0, 0, 40), { HoldMotion{ 0.05 }, MinimumJerkMotion{ At(0, 0, -40), 2.0 } });
  };
  ASSERT_TRUE(frames.haptic->SetDevice(hand()));
  UpdateUntilReady(frames.haptic);
  ASSERT_TRUE(frames.haptic->Start());
  ASSERT_TRUE(frames.haptic->Grab(tool));
  frames.UntilTicks(100);
  const Count releases(frames.haptic, vtkHaspHapticInteractor::ReleaseEvent);
  interactor->InvokeEvent(vtkCommand::ExitEvent);
  EXPECT_FALSE(frames.haptic->GetLoop()->IsRunning());
  frames.haptic->Update();
  EXPECT_EQ(frames.haptic->GetHeldTool(), -1);
  EXPECT_EQ(releases.times, 1);
}

TEST(HapticInteractor, ADroppedToolIsSaidToBeReleased)
{
  Frames frames;
  const auto ground = BallActor(15.0), ball = BallActor(5.0, 360.0, { 0, 0, 40 });
  frames.haptic->AddTouchable(ground);
  const int tool = frames.haptic->AddTool(ball);
  ASSERT_TRUE(frames.haptic->SetDevice(HandAt(At(0, 0, 40))));
  UpdateUntilReady(frames.haptic);
  ASSERT_TRUE(frames.haptic->Start());
  ASSERT_TRUE(frames.haptic->Grab(tool));
  const Count releases(frames.haptic, vtkHaspHapticInteractor::ReleaseEvent);
  ground->SetScale(2.0);
  EXPECT_NE(
    ErrorsOf(frames.haptic, [&] { frames.haptic->Update(); }).find("scales"), std::string::npos);
  EXPECT_EQ(frames.haptic->GetHeldTool(), -1);
  EXPECT_EQ(releases.times, 1);
}

// Images stand in the list without a prop: none is not one of them.
TEST(HapticInteractor, NoPropIsNoneThatIsThere)
{
  vtkNew<vtkHaspHapticInteractor> haptic;
  haptic->SetSpacing(1.0);
  ASSERT_TRUE(haptic->AddTouchable(GreyBall(), -8.0, nullptr));
  EXPECT_NE(ErrorsOf(haptic, [&] { EXPECT_FALSE(haptic->AddTouchable(nullptr)); }), "");
  EXPECT_NE(ErrorsOf(haptic, [&] { EXPECT_EQ(haptic->AddTool(nullptr), -1); }), "");
  haptic->Remove(nullptr);
  const auto ball = BallActor(5.0);
  EXPECT_GE(haptic->AddTool(ball), 0);
  ASSERT_TRUE(haptic->SetDevice(HandAt({})));
  EXPECT_EQ(haptic->GetState(), vtkHaspHapticInteractor::Baking) << "the image is still there";
}

TEST(HapticInteractor, WhatIsNoLongerDrawnIsAnotherPicture)
{
  vtkNew<vtkRenderer> renderer;
  HapticDrawing drawing;
  drawing.SetRenderer(renderer);
  drawing.forces = true;
  HapticSnapshot seen;
  const auto update = [&](const glm::dvec3& force)
  {
    ++seen.ticks;
    seen.contact.force = force;
    return drawing.Update(seen, nullptr);
  };
  EXPECT_TRUE(update({ 0, 0, 1 }));
  EXPECT_FALSE(update({ 0, 0, 1 }));
  drawing.forces = false;
  EXPECT_TRUE(update({ 0, 0, 1 })) << "the arrow is gone";
  EXPECT_FALSE(update({ 0, 0, 1 }));
  drawing.forces = true;
  EXPECT_TRUE(update({ 0, 0, 1 })) << "and there again, of the same force";
  EXPECT_TRUE(update({ 0, 0, 0 }));
  drawing.forces = false;
  EXPECT_FALSE(update({ 0, 0, 0 })) << "there was none to be seen";
}

} // namespace
