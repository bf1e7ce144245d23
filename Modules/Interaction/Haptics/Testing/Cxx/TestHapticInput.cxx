// A window's events as a device: read in virtual time, so that each step is there at once.
#include "HapticInput.h"

#include "HapticRenderScene.h"

#include "Devices/InputHapticDevice.h"
#include "Realtime/LoopThread.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkTDxMotionEventInfo.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr int Side = 200;          // of the window, pixels
constexpr double Distance = 100.0; // of the eye from the origin, where the tool is
constexpr double StepTolerance = 1e-9;

/// A window that looks along -z, and a device that its events move.
struct Window
{
  Window()
  {
    this->window->SetSize(Side, Side);
    this->window->AddRenderer(this->renderer);
    this->window->SetInteractor(this->interactor);
    this->interactor->EnableRenderOff();
    this->interactor->SetInteractorStyle(nullptr); // those that are in the way say so
    this->renderer->GetActiveCamera()->SetPosition(0, 0, Distance);
    this->input.Follow(this->interactor, this->renderer, &this->device);
    this->input.At(glm::dvec3(0.0), 1.0);
    this->Read();
  }
  ~Window() { this->input.Follow(nullptr, nullptr, nullptr); }

  /// An event, with the pointer there.
  void Say(unsigned long event, const char* keys = "", const char* symbol = nullptr)
  {
    const std::string held = keys;
    this->interactor->SetEventInformation(this->at[0], this->at[1],
      held.find('c') != std::string::npos, held.find('s') != std::string::npos, 0, 0, symbol);
    this->interactor->InvokeEvent(event);
  }
  void MoveTo(int x, int y, const char* keys = "")
  {
    this->at[0] = x;
    this->at[1] = y;
    this->Say(vtkCommand::MouseMoveEvent, keys);
  }
  void Rates(double x, double angle, const char* keys = "")
  {
    vtkTDxMotionEventInfo said{ x, 0.0, 0.0, angle, 0.0, 1.0, 0.0 };
    this->interactor->SetShiftKey(std::string(keys).find('s') != std::string::npos);
    this->interactor->InvokeEvent(vtkCommand::TDxMotionEvent, &said);
  }
  /// A tick later.
  DeviceSample Read(int ticks = 1)
  {
    DeviceSample sample;
    for (int n = 0; n < ticks; ++n)
      this->device.Read(this->nowNs += 1'000'000, sample);
    return sample;
  }
  glm::dvec3 Place() { return this->Read().pose.position; }

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  InputHapticDevice device{ { .workspaceMm = glm::dvec3(1e4), .followS = 0.0 } };
  HapticInput input;
  int at[2] = { 100, 100 };
  std::int64_t nowNs = MonotonicClock().NowNs(); ///< rates are said on that clock
};

/// Of the screen, where the tool is: the view angle's tangent over half of the window.
double PixelMm(double angleDeg, double depth)
{
  return 2.0 * depth * std::tan(0.5 * angleDeg * std::numbers::pi / 180.0) / Side;
}

TEST(HapticInput, ADragFollowsThePointerAtTheToolsDepth)
{
  Window w;
  w.MoveTo(100, 100); // it comes in: that is no step
  EXPECT_EQ(w.Place(), glm::dvec3(0.0));
  w.MoveTo(130, 90);
  const double mm = PixelMm(w.renderer->GetActiveCamera()->GetViewAngle(), Distance);
  EXPECT_LT(glm::length(w.Place() - mm * glm::dvec3(30, -10, 0)), StepTolerance);
  // Half as far away a pixel is half as much; of a device that moves twice as far, a quarter.
  const glm::dvec3 before = w.Place();
  w.input.At({ 0, 0, 0.5 * Distance }, 2.0);
  w.MoveTo(140, 90);
  EXPECT_LT(glm::length(w.Place() - before - glm::dvec3(0.25 * 10 * mm, 0, 0)), StepTolerance);
  w.renderer->GetActiveCamera()->ParallelProjectionOn();
  w.renderer->GetActiveCamera()->SetParallelScale(50.0); // half of the window's height, mm
  w.input.At(glm::dvec3(0.0), 1.0);
  const glm::dvec3 there = w.Place();
  w.MoveTo(140, 110);
  EXPECT_LT(glm::length(w.Place() - there - glm::dvec3(0, 20 * 100.0 / Side, 0)), StepTolerance);
}

TEST(HapticInput, TheWheelAndKeysAreSteps)
{
  Window w;
  const double step = w.input.wheelMm;
  const auto moves = [&](unsigned long event, const char* symbol, const glm::dvec3& by)
  {
    const glm::dvec3 before = w.Place();
    w.Say(event, "", symbol);
    EXPECT_LT(glm::length(w.Place() - before - step * by), StepTolerance) << (symbol ? symbol : "");
  };
  moves(vtkCommand::MouseWheelForwardEvent, nullptr, { 0, 0, -1 }); // away from the viewer
  moves(vtkCommand::MouseWheelBackwardEvent, nullptr, { 0, 0, 1 });
  moves(vtkCommand::KeyPressEvent, "Left", { -1, 0, 0 });
  moves(vtkCommand::KeyPressEvent, "Right", { 1, 0, 0 });
  moves(vtkCommand::KeyPressEvent, "Up", { 0, 1, 0 });
  moves(vtkCommand::KeyPressEvent, "Down", { 0, -1, 0 });
  moves(vtkCommand::KeyPressEvent, "Prior", { 0, 0, -1 });
  moves(vtkCommand::KeyPressEvent, "Next", { 0, 0, 1 });
  moves(vtkCommand::KeyPressEvent, "q", { 0, 0, 0 });
}

TEST(HapticInput, AMiddleDragTurnsAboutTheScreensAxes)
{
  Window w;
  w.MoveTo(100, 100);
  w.Say(vtkCommand::MiddleButtonPressEvent);
  w.MoveTo(120, 100); // to the right: about the axis that points up
  DeviceSample seen = w.Read();
  EXPECT_LT(glm::length(RotationVector(seen.pose.orientation) -
                        glm::dvec3(0, 20 * w.input.turnRadPerPixel, 0)),
    StepTolerance);
  EXPECT_EQ(seen.pose.position, glm::dvec3(0.0));
  w.Say(vtkCommand::MiddleButtonReleaseEvent);
  w.MoveTo(130, 100);
  EXPECT_GT(w.Place().x, 0.0);
}

TEST(HapticInput, ASixAxisDevicesDeflectionIsARate)
{
  Window w;
  w.Rates(350.0, 0.0); // all the way to the right: 60 mm/s
  w.Read();
  const glm::dvec3 before = w.Place();
  EXPECT_NEAR(w.Read(20).pose.position.x - before.x, 20 * 0.001 * w.input.rateMmPerS, 1e-6);
  w.Rates(0.0, 175.0); // half of a turn about up
  const glm::dquat turned = w.Read().pose.orientation;
  EXPECT_LT(glm::length(RotationVector(w.Read(20).pose.orientation * glm::conjugate(turned)) -
                        glm::dvec3(0, 20 * 0.001 * 0.5 * w.input.rateRadPerS, 0)),
    1e-6);
  w.Rates(350.0, 175.0, "s"); // the clutch
  const RigidPose held = w.Read().pose;
  EXPECT_EQ(w.Read(20).pose.position, held.position);
  // Let go without a word: after a tenth of a second it does not run on.
  w.Rates(350.0, 0.0);
  w.nowNs += 200'000'000;
  const glm::dvec3 stale = w.Place();
  EXPECT_EQ(w.Place(), stale);
}

// However far the pointer is carried meanwhile, and whenever a tick looks: not a micrometre.
TEST(HapticInput, UnderShiftTheToolStaysAndGoesOnFromThere)
{
  Window w;
  w.MoveTo(100, 100);
  w.MoveTo(110, 100);
  const glm::dvec3 held = w.Place();
  for (int x = 110; x >= 10; x -= 5)
  {
    w.MoveTo(x, 100 + x / 2, "s");
    EXPECT_EQ(w.Place(), held);
  }
  w.Say(vtkCommand::MouseWheelForwardEvent, "s");
  w.Say(vtkCommand::KeyPressEvent, "s", "Right");
  EXPECT_EQ(w.Place(), held);
  w.MoveTo(12, 105); // Shift is let go: a step of two pixels, not of a hundred
  const double mm = PixelMm(w.renderer->GetActiveCamera()->GetViewAngle(), Distance);
  EXPECT_LT(glm::length(w.Place() - held - glm::dvec3(2 * mm, 0, 0)), StepTolerance);
}

TEST(HapticInput, WithCtrlTheCameraHasTheMouse)
{
  Window w;
  // As a style listens: behind us.
  const Count moves(w.interactor, vtkCommand::MouseMoveEvent),
    presses(w.interactor, vtkCommand::LeftButtonPressEvent),
    releases(w.interactor, vtkCommand::LeftButtonReleaseEvent);
  w.MoveTo(100, 100);
  w.Say(vtkCommand::LeftButtonPressEvent);
  EXPECT_EQ(w.Read().buttons, 1u);
  EXPECT_EQ(moves.times + presses.times, 0) << "what is the tool's is not the camera's, too";
  const glm::dvec3 held = w.Place();
  w.MoveTo(150, 150, "c");
  EXPECT_EQ(w.Place(), held);
  EXPECT_EQ(moves.times, 1);
  // Who had the press has the release, whatever Ctrl does in between.
  w.Say(vtkCommand::LeftButtonReleaseEvent, "c");
  EXPECT_EQ(w.Read().buttons, 0u);
  EXPECT_EQ(releases.times, 0);
  w.Say(vtkCommand::LeftButtonPressEvent, "c");
  w.Say(vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(presses.times, 1);
  EXPECT_EQ(releases.times, 1);
  EXPECT_EQ(w.Read().buttons, 0u);
  w.MoveTo(50, 60); // put down again: no step
  EXPECT_EQ(w.Place(), held);
}

TEST(HapticInput, ButtonsAreZeroAndOneAndEndWithFollowing)
{
  Window w;
  w.Say(vtkCommand::LeftButtonPressEvent);
  w.Say(vtkCommand::RightButtonPressEvent);
  EXPECT_EQ(w.Read().buttons, 3u);
  w.Say(vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(w.Read().buttons, 2u);
  w.input.Follow(nullptr, nullptr, nullptr);
  w.Say(vtkCommand::MouseWheelForwardEvent);
  EXPECT_EQ(w.Place(), glm::dvec3(0.0));
}

// The whole way: the axes are the camera's, so right is the viewer's right.
TEST(HapticInput, TheMouseMovesATouchersPointAlongTheScreen)
{
  Frames frames;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  frames.window->SetInteractor(interactor);
  frames.renderer->GetActiveCamera()->Azimuth(90.0); // from +x: right is -z
  ASSERT_TRUE(frames.haptic->UseMouse());
  ASSERT_TRUE(frames.haptic->Start());
  frames.haptic->Update();
  const auto point = [&] { return frames.haptic->GetLoop()->GetSnapshot().device.position; };
  const glm::dvec3 start = point();
  for (const int x : { 100, 110 })
  {
    interactor->SetEventInformation(x, 100);
    interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  }
  const double mm = 10.0 * PixelMm(frames.renderer->GetActiveCamera()->GetViewAngle(), Distance);
  // Followed within 15 ms, by the clock: frames until it is there.
  for (int frame = 0; frame < 1'000'000 && glm::length(point() - start) < 0.9995 * mm; ++frame)
    frames.haptic->Update();
  EXPECT_LT(glm::length(point() - start - glm::dvec3(0, 0, -mm)), 0.001 * mm);
}

TEST(HapticInput, APressThatIsNotTakenIsTheStylesUntilItsRelease)
{
  Window w;
  bool take = false;
  std::array<int, 3> asked{};
  w.input.takes = [&](int button, int x, int y)
  {
    asked = { button, x, y };
    return take;
  };
  const Count moves(w.interactor, vtkCommand::MouseMoveEvent),
    presses(w.interactor, vtkCommand::RightButtonPressEvent),
    releases(w.interactor, vtkCommand::RightButtonReleaseEvent);
  const auto drag = [&](const char* keys = "")
  {
    w.MoveTo(80, 90);
    w.Say(vtkCommand::RightButtonPressEvent, keys);
    const DeviceSample held = w.Read();
    w.MoveTo(120, 90);
    const glm::dvec3 moved = w.Place() - held.pose.position;
    w.Say(vtkCommand::RightButtonReleaseEvent);
    EXPECT_EQ(w.Read().buttons, 0u);
    return std::pair(held.buttons, moved.x > 0.0);
  };
  EXPECT_EQ(drag(), std::pair(0u, false));
  EXPECT_EQ(asked, (std::array<int, 3>{ 1, 80, 90 }));
  EXPECT_EQ(presses.times + moves.times + releases.times, 4) << "and the move that went before";
  take = true;
  EXPECT_EQ(drag(), std::pair(2u, true)) << "the next press is asked for anew";
  EXPECT_EQ(presses.times + moves.times + releases.times, 4);
  take = false;
  EXPECT_EQ(drag("s"), std::pair(0u, false)) << "with Shift as well";
  EXPECT_EQ(presses.times + moves.times + releases.times, 8);
}

// Who had a button's press has its drag, too: a style that zooms goes on zooming, and ends.
TEST(HapticInput, TheStylesDragIsItsOwnUntilItsLastRelease)
{
  Window w;
  const Count moves(w.interactor, vtkCommand::MouseMoveEvent),
    releases(w.interactor, vtkCommand::RightButtonReleaseEvent);
  w.MoveTo(100, 100);
  w.Say(vtkCommand::RightButtonPressEvent, "c");
  w.MoveTo(120, 100); // Ctrl is let go
  EXPECT_EQ(w.Place(), glm::dvec3(0.0));
  EXPECT_EQ(moves.times, 1);
  w.Say(vtkCommand::LeftButtonPressEvent); // another one meanwhile, let go last
  w.Say(vtkCommand::RightButtonReleaseEvent);
  w.MoveTo(140, 100);
  EXPECT_EQ(w.Place(), glm::dvec3(0.0));
  EXPECT_EQ(moves.times, 2);
  w.Say(vtkCommand::LeftButtonReleaseEvent);
  w.MoveTo(150, 100); // put down again
  w.MoveTo(160, 100);
  EXPECT_GT(w.Place().x, 0.0);
  EXPECT_EQ(moves.times, 2);
  EXPECT_EQ(releases.times, 1);
}

// VTK's styles keep a drag's events to themselves, its release among them.
TEST(HapticInput, AfterEachDragOfVtksOwnStyleTheNextPressIsAskedForAgain)
{
  Window w;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  w.interactor->SetInteractorStyle(style);
  w.interactor->Enable();
  bool take = false;
  w.input.takes = [&](int, int, int) { return take; };
  constexpr std::pair<unsigned long, unsigned long> Buttons[] = {
    { vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent },
    { vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent },
    { vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent }
  };
  for (const auto& [press, release] : Buttons)
  {
    take = false;
    w.MoveTo(100, 100);
    w.Say(press);
    ASSERT_NE(style->GetState(), VTKIS_NONE) << "the camera's";
    w.MoveTo(110, 100);
    w.Say(release);
    EXPECT_EQ(style->GetState(), VTKIS_NONE);
    take = true;
    w.Say(vtkCommand::LeftButtonPressEvent);
    EXPECT_EQ(w.Read().buttons, 1u) << press;
    EXPECT_EQ(style->GetState(), VTKIS_NONE);
    w.Say(vtkCommand::LeftButtonReleaseEvent);
    EXPECT_EQ(w.Read().buttons, 0u) << press;
  }
}

// A release that no window saw: whose the next press is, his is its release.
TEST(HapticInput, ASecondPressWithoutAReleaseIsAskedForAnew)
{
  Window w;
  bool take = true;
  w.input.takes = [&](int, int, int) { return take; };
  const Count presses(w.interactor, vtkCommand::LeftButtonPressEvent),
    releases(w.interactor, vtkCommand::LeftButtonReleaseEvent);
  w.Say(vtkCommand::LeftButtonPressEvent);
  EXPECT_EQ(w.Read().buttons, 1u);
  take = false;
  w.Say(vtkCommand::LeftButtonPressEvent);
  EXPECT_EQ(w.Read().buttons, 0u);
  w.Say(vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(presses.times, 1);
  EXPECT_EQ(releases.times, 1) << "or the camera turns for ever";
}

TEST(HapticInput, APixelIsAsLargeWhicheverAngleTheCameraIsGiven)
{
  Window w;
  w.window->SetSize(Side, Side / 2);
  w.renderer->GetActiveCamera()->UseHorizontalViewAngleOn();
  w.MoveTo(100, 50);
  w.MoveTo(110, 50);
  const double mm = PixelMm(w.renderer->GetActiveCamera()->GetViewAngle(), Distance);
  EXPECT_LT(glm::length(w.Place() - glm::dvec3(10 * mm, 0, 0)), StepTolerance);
}

} // namespace
