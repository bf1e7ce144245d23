#include "vtkHaspHapticLoop.h"

#include "HapticRenderScene.h"

#include "Realtime/LoopThread.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <string>

namespace
{

using namespace hasp;
using namespace hasp::testing;

/// Frames until `done`, at most so many ticks of the thread: counted, not timed.
void FramesUntil(
  vtkHaspHapticLoop* loop, std::uint64_t mostTicks, const std::function<bool()>& done)
{
  do
    loop->Update();
  while (!done() && loop->IsRunning() && loop->GetSnapshot().ticks < mostTicks);
}

TEST(HapticLoop, WhatLacksADeviceIsRefused)
{
  vtkNew<vtkHaspHapticLoop> loop;
  EXPECT_NE(
    ErrorsOf(loop, [&] { EXPECT_FALSE(loop->Start()); }).find("SetDevice"), std::string::npos);
  EXPECT_NE(ErrorsOf(loop, [&] { EXPECT_EQ(loop->SetScene(Tip(), Ball()), 0u); }).find("SetDevice"),
    std::string::npos);
  HapticChainSettings wrong;
  wrong.workspace.scale = 0.0;
  EXPECT_NE(ErrorsOf(loop, [&] { EXPECT_FALSE(loop->SetDevice(HandAt({}), wrong)); }).find("scale"),
    std::string::npos);
  EXPECT_EQ(loop->GetDevice(), nullptr);
  loop->Update(); // nothing happens
  EXPECT_EQ(loop->GetSnapshot().ticks, 0u);
  EXPECT_TRUE(loop->SetDevice(HandAt({})));
  EXPECT_NE(ErrorsOf(loop,
              [&] {
                EXPECT_EQ(loop->SetScene({ { nullptr, {} } }, Ball()), 0u);
              }),
    "");
  LoopSettings tooFast;
  tooFast.periodNs = 1;
  loop->SetLoopSettings(tooFast);
  EXPECT_TRUE(loop->Start()) << "nothing can be touched: no thread is asked for";
  EXPECT_NE(ErrorsOf(loop, [&] { EXPECT_EQ(loop->SetScene(Tip(), Ball()), 0u); }).find("periodNs"),
    std::string::npos);
  EXPECT_FALSE(loop->IsRunning());
  HapticControl control;
  control.contact.stiffness = std::nanf("");
  EXPECT_NE(ErrorsOf(loop, [&] { EXPECT_FALSE(loop->SetControl(control)); }).find("stiffness"),
    std::string::npos);
  EXPECT_GT(loop->GetControl().contact.stiffness, 0.0F);
}

TEST(HapticLoop, AThreadTicksAsItsStepDoesOrNotAtAll)
{
  vtkNew<vtkHaspHapticLoop> loop;
  HapticChainSettings settings;
  settings.step.tickS = 0.002;
  ASSERT_TRUE(loop->SetDevice(HandAt(At(0, 0, 30)), settings));
  ASSERT_GT(loop->SetScene(Tip(), Ball()), 0u);
  EXPECT_NE(
    ErrorsOf(loop, [&] { EXPECT_FALSE(loop->Start()); }).find("tickS 0.002 s"), std::string::npos);
  EXPECT_FALSE(loop->IsRunning());
  LoopSettings slower;
  slower.periodNs = 2'000'000;
  loop->SetLoopSettings(slower);
  EXPECT_TRUE(loop->Start());
  EXPECT_TRUE(loop->IsRunning());
}

TEST(HapticLoop, NoThreadUntilATouchIsPossible)
{
  vtkNew<vtkHaspHapticLoop> loop;
  EXPECT_EQ(BytesOf(loop.Get()), 0u);
  ASSERT_TRUE(loop->SetDevice(HandAt(At(1, 2, 30))));
  ASSERT_TRUE(loop->Start());
  EXPECT_FALSE(loop->IsRunning());
  loop->SetScene(Tip(), {});
  EXPECT_FALSE(loop->IsRunning());
  loop->SetScene({}, Ball());
  EXPECT_FALSE(loop->IsRunning());
  EXPECT_EQ(BytesOf(loop.Get()), 0u);
  // The device is known all the same, once a frame.
  loop->Update();
  EXPECT_EQ(loop->GetSnapshot().ticks, 1u);
  EXPECT_NEAR(loop->GetSnapshot().device.position.z, 30.0, 0.01);
  const std::uint64_t scene = loop->SetScene(Tip(), Ball());
  EXPECT_GT(scene, 0u);
  EXPECT_TRUE(loop->IsRunning());
  EXPECT_GT(BytesOf(loop.Get()), 0u);
  FramesUntil(loop, 10'000, [&] { return loop->GetSnapshot().scene == scene; });
  EXPECT_EQ(loop->GetSnapshot().scene, scene);
  loop->SetScene({}, Ball()); // the tool is put down
  EXPECT_FALSE(loop->IsRunning());
  EXPECT_EQ(BytesOf(loop.Get()), 0u);
}

// A simulated device on a real thread: held by numbers of ticks, not by the clock.
TEST(HapticLoop, ABallIsPressedOnTheThread)
{
  vtkNew<vtkHaspHapticLoop> loop;
  ASSERT_TRUE(loop->SetDevice(HandAt(At(0, 0, BallRadius - 5)), Settings()));
  ASSERT_TRUE(loop->Start());
  const RigidPose start = At(0, 0, BallRadius + 2);
  ASSERT_GT(loop->SetScene(Tip(), Ball(), &start), 0u);
  FramesUntil(loop, 1500, [] { return false; });
  const HapticSnapshot seen = loop->GetSnapshot();
  ASSERT_GE(seen.ticks, 1500u);
  const Pressed expected =
    PressedBall(5.0, SpringFor(TouchProfile(), Settings().step.coupling.spring, 1.0, 1.0, 0.001),
      Settings().step.contact.stiffness);
  // As in virtual time (TestHapticChain), and what a late tick leaves of the hand's way back.
  EXPECT_NEAR(seen.onDevice.force.z, expected.forceN, 0.05 * expected.forceN);
  EXPECT_NEAR(-seen.deepestMm, expected.depthMm, 0.05 * expected.depthMm);
  EXPECT_GE(loop->GetRates().ticks, 1500u);
  loop->Stop();
  EXPECT_FALSE(loop->IsRunning());
  EXPECT_EQ(
    static_cast<SimulatedHapticDevice*>(loop->GetDevice())->Applied().force, glm::dvec3(0.0));
  loop->Update();
  EXPECT_EQ(loop->GetSnapshot().onDevice.force, glm::dvec3(0.0));
}

// The hand is below the plate, the tool is taken above it: it is held there, whatever is said and
// drawn before the thread starts. (The device is read by frames once it was started.)
TEST(HapticLoop, AToolTakenBeforeStartIsTakenThere)
{
  const RigidPose start = At(0, 0, 8);
  HapticControl placed;
  placed.placed = 1;
  using Loop = vtkHaspHapticLoop;
  const std::function<void(Loop*)> before[] = { [](Loop*) {}, [](Loop* loop) { loop->Update(); },
    [](Loop* loop) { loop->SetScene(Tip(), Plate()); },
    [](Loop* loop)
    {
      loop->Update();
      loop->SetScene(Tip(), Plate());
    },
    [&](Loop* loop)
    {
      loop->Update();
      loop->SetControl(placed);
    } };
  for (std::size_t n = 0; n < std::size(before); ++n)
  {
    vtkNew<vtkHaspHapticLoop> loop;
    ASSERT_TRUE(loop->SetDevice(HandAt(At(0, 0, -8)), Firm()));
    ASSERT_TRUE(loop->Start());
    loop->Update();
    loop->Stop();
    ASSERT_GT(loop->SetScene(Tip(), Plate(), &start), 0u);
    before[n](loop);
    ASSERT_TRUE(loop->Start());
    FramesUntil(loop, 50, [] { return false; });
    EXPECT_NEAR(loop->GetSnapshot().tool.position.z, PlateTop, 1.0) << n;
    EXPECT_EQ(loop->GetSnapshot().contacts, 1u) << n;
  }
}

TEST(HapticLoop, AToolThatIsPutDownWaitsForNoStart)
{
  vtkNew<vtkHaspHapticLoop> loop;
  const RigidPose start = At(0, 0, 8);
  ASSERT_TRUE(loop->SetDevice(HandAt(At(0, 0, -8)), Firm()));
  ASSERT_GT(loop->SetScene(Tip(), Plate(), &start), 0u);
  ASSERT_GT(loop->SetScene({}, {}), 0u);
  ASSERT_GT(loop->SetScene(Tip(), Plate()), 0u);
  ASSERT_TRUE(loop->Start());
  FramesUntil(loop, 50, [] { return false; });
  EXPECT_LT(loop->GetSnapshot().tool.position.z, -PlateTop);
  loop->Stop();
  RigidPose none = start;
  none.position.x = std::nan("");
  EXPECT_NE(
    ErrorsOf(loop, [&] { EXPECT_EQ(loop->SetScene(Tip(), Plate(), &none), 0u); }).find("pose"),
    std::string::npos);
}

TEST(HapticLoop, ANewDeviceIsToldNothingOfTheOneBefore)
{
  vtkNew<vtkHaspHapticLoop> loop;
  const RigidPose start = At(0, 0, 8);
  ASSERT_TRUE(loop->SetDevice(HandAt(At(2, 0, 0)), Settings()));
  HapticControl control;
  control.place = At(100, 0, 0);
  control.placed = 7;
  control.attract = true;
  control.isovalues[0] = 3.0;
  ASSERT_TRUE(loop->SetControl(control));
  ASSERT_TRUE(loop->Start());
  loop->Update();
  EXPECT_NEAR(loop->GetSnapshot().device.position.x, 102.0, 0.01);
  loop->Stop();
  ASSERT_GT(loop->SetScene(Tip(), Plate(), &start), 0u);
  HapticChainSettings settings = Firm();
  settings.workspace.scale = 2.0;
  ASSERT_TRUE(loop->SetDevice(HandAt(At(2, 0, -4)), settings));
  EXPECT_EQ(loop->GetControl().placed, 0u);
  EXPECT_EQ(loop->GetControl().scale, 2.0);
  EXPECT_FALSE(loop->GetControl().attract);
  EXPECT_TRUE(std::isnan(loop->GetControl().isovalues[0]));
  ASSERT_GT(loop->SetScene(Tip(), Plate()), 0u);
  ASSERT_TRUE(loop->Start());
  FramesUntil(loop, 50, [] { return false; });
  EXPECT_NEAR(loop->GetSnapshot().device.position.x, 4.0, 0.01);
  // Nor of the tool that was taken with it, above the plate.
  EXPECT_LT(loop->GetSnapshot().tool.position.z, -PlateTop);
}

/// Says when it is gone, and what force it was left with.
struct Watched : SimulatedHapticDevice
{
  using SimulatedHapticDevice::SimulatedHapticDevice;
  ~Watched() override
  {
    ++Gone;
    LastForce = glm::length(this->Applied().force);
  }
  static inline std::atomic<int> Gone{ 0 };
  static inline std::atomic<double> LastForce{ 0.0 };
};
std::unique_ptr<Watched> WatchedHand()
{
  return std::make_unique<Watched>(HandSettings(), HandIntention(At(0, 0, BallRadius - 5)));
}

TEST(HapticLoop, ItEndsWithoutForceWhereverItEnds)
{
  const auto pressed = [](vtkHaspHapticLoop* loop)
  {
    ASSERT_TRUE(loop->SetDevice(WatchedHand(), Settings()));
    ASSERT_TRUE(loop->Start());
    ASSERT_GT(loop->SetScene(Tip(), Ball()), 0u);
    FramesUntil(loop, 10'000, [&] { return loop->GetSnapshot().onDevice.force.z > 0.1; });
    ASSERT_GT(loop->GetSnapshot().onDevice.force.z, 0.1);
  };
  Watched::Gone = 0;
  {
    vtkNew<vtkHaspHapticLoop> loop;
    pressed(loop);
    if (HasFatalFailure())
      return;
  } // deleted while it runs
  EXPECT_EQ(Watched::Gone, 1);
  EXPECT_EQ(Watched::LastForce, 0.0);
  vtkNew<vtkHaspHapticLoop> loop;
  pressed(loop);
  EXPECT_TRUE(loop->SetDevice(nullptr)); // unset while it runs
  EXPECT_EQ(Watched::Gone, 2);
  EXPECT_EQ(Watched::LastForce, 0.0);
  EXPECT_FALSE(loop->IsRunning());
  EXPECT_TRUE(loop->GetStarted()) << "the next device ticks as soon as it has a scene";
  EXPECT_TRUE(loop->SetDevice(HandAt(At(0, 0, 30))));
  EXPECT_FALSE(loop->IsRunning());
  EXPECT_GT(loop->SetScene(Tip(), Ball()), 0u);
  EXPECT_TRUE(loop->IsRunning());
  HapticChainSettings wrong;
  wrong.workspace.scale = 0.0;
  ErrorsOf(loop, [&] { EXPECT_FALSE(loop->SetDevice(HandAt({}), wrong)); });
  EXPECT_EQ(loop->GetDevice(), nullptr) << "nor is the one before there";
}

TEST(HapticLoop, ItStopsWhenTheWindowOrItsInteractorGoes)
{
  vtkNew<vtkHaspHapticLoop> loop;
  ASSERT_TRUE(loop->SetDevice(HandAt(At(0, 0, 30))));
  const auto run = [&]
  {
    ASSERT_TRUE(loop->Start());
    ASSERT_GT(loop->SetScene(Tip(), Ball()), 0u);
    ASSERT_TRUE(loop->IsRunning());
  };
  {
    vtkNew<vtkRenderWindow> window;
    loop->SetRenderWindow(window);
    run();
  }
  EXPECT_FALSE(loop->IsRunning());
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  window->SetInteractor(interactor);
  loop->SetRenderWindow(window);
  run();
  interactor->InvokeEvent(vtkCommand::ExitEvent);
  EXPECT_FALSE(loop->IsRunning());
  EXPECT_FALSE(loop->GetStarted());
  // An interactor that comes later.
  vtkNew<vtkRenderWindow> early;
  loop->SetRenderWindow(early);
  vtkNew<vtkGenericRenderWindowInteractor> late;
  early->SetInteractor(late);
  run();
  late->InvokeEvent(vtkCommand::ExitEvent);
  EXPECT_FALSE(loop->IsRunning());
  // Another window: the one before is let go of.
  vtkNew<vtkRenderWindow> other;
  loop->SetRenderWindow(other);
  run();
  interactor->InvokeEvent(vtkCommand::ExitEvent);
  EXPECT_TRUE(loop->IsRunning());
}

/// As a window system's: its loop ends when it is told to.
class EndingInteractor : public vtkGenericRenderWindowInteractor
{
public:
  static EndingInteractor* New();
  vtkTypeMacro(EndingInteractor, vtkGenericRenderWindowInteractor);
  void TerminateApp() override
  {
    this->Done = true;
    ++this->ended;
  }
  int ended = 0;
};
vtkStandardNewMacro(EndingInteractor);

// A key or the window's cross, as without haptics; an application that listens decides itself.
TEST(HapticLoop, AnInteractorEndsAsItDoesWithoutHaptics)
{
  enum Application
  {
    Silent,
    Refuses,
    Ends
  };
  for (const Application application : { Silent, Refuses, Ends })
  {
    vtkNew<vtkRenderWindow> window;
    vtkNew<EndingInteractor> interactor;
    window->SetInteractor(interactor);
    vtkNew<vtkHaspHapticLoop> loop;
    loop->SetRenderWindow(window);
    ASSERT_TRUE(loop->SetDevice(HandAt(At(0, 0, 30))));
    ASSERT_TRUE(loop->Start());
    ASSERT_GT(loop->SetScene(Tip(), Ball()), 0u);
    vtkNew<vtkCallbackCommand> listens;
    listens->SetClientData(interactor);
    if (application == Ends)
      listens->SetCallback([](vtkObject*, unsigned long, void* it, void*)
        { static_cast<EndingInteractor*>(it)->TerminateApp(); });
    if (application != Silent)
      interactor->AddObserver(vtkCommand::ExitEvent, listens);
    for (int again = 0; again < 2; ++again)
    {
      interactor->ExitCallback();
      EXPECT_EQ(interactor->GetDone(), application != Refuses) << application;
      EXPECT_EQ(interactor->ended, application == Refuses ? 0 : again + 1) << application;
      EXPECT_EQ(loop->IsRunning(), application == Refuses) << application;
    }
  }
}

// Two hands at one window: neither is an application that refuses.
TEST(HapticLoop, TwoLoopsOfAWindowEndWithIt)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<EndingInteractor> interactor;
  window->SetInteractor(interactor);
  vtkNew<vtkHaspHapticLoop> one, other;
  for (vtkHaspHapticLoop* loop : { one.Get(), other.Get() })
  {
    loop->SetRenderWindow(window);
    ASSERT_TRUE(loop->SetDevice(HandAt(At(0, 0, 30))));
    ASSERT_TRUE(loop->Start());
    ASSERT_GT(loop->SetScene(Tip(), Ball()), 0u);
  }
  interactor->ExitCallback();
  EXPECT_EQ(interactor->ended, 1);
  EXPECT_FALSE(one->IsRunning());
  EXPECT_FALSE(other->IsRunning());
}

TEST(HapticLoop, DiscsAreAskedForAndAnswered)
{
  vtkNew<vtkHaspHapticLoop> loop;
  EXPECT_EQ(loop->AskForDiscs(10), nullptr);
  ASSERT_TRUE(loop->SetDevice(HandAt(At(0, 0, 30))));
  EXPECT_EQ(loop->AskForDiscs(10), nullptr) << "the next tick answers";
  ASSERT_TRUE(loop->Start());
  loop->Update();
  const HapticDiscRequest* discs = loop->AskForDiscs(10);
  ASSERT_NE(discs, nullptr);
  EXPECT_EQ(discs->count, 0u) << "there is no dynamic shell";
}

} // namespace
