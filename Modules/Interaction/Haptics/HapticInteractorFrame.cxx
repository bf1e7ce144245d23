// A frame of vtkHaspHapticInteractor: the newest tick on props, what RENDER wants to HAPTIC.
#include "HapticExchange.h"
#include "HapticInteractorInternals.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr float DefaultAttraction = 0.01F; // N/mm^2, where Snap-to-fit is on and none was said
constexpr double YieldTicks =
  100.0; // in which a hand that lets itself be pulled goes 63 % of the way

/// Device x is the camera's right, y its up, z towards the viewer.
glm::dquat CameraAxes(vtkCamera* camera)
{
  glm::dvec3 along, up;
  camera->GetDirectionOfProjection(&along.x);
  camera->GetViewUp(&up.x);
  const glm::dvec3 right = glm::normalize(glm::cross(along, up));
  return glm::normalize(glm::quat_cast(glm::dmat3(right, glm::cross(right, along), -along)));
}
}

bool vtkHaspHapticInteractor::Update()
{
  Internals& self = *this->Self;
  if (self.loop->GetProfile() == nullptr)
    return false;
  self.loop->Update();
  if (!self.loop->GetStarted())
    this->Release(); // the window has ended it: nothing would be felt
  bool moved = false;
  try
  {
    this->FollowProps();
    this->SendControl();
    this->FollowButtons(self.loop->GetSnapshot().buttons);
    moved = self.grab.Follow(self.loop);
    this->YieldToSnap();
    self.faulty = false;
  }
  catch (const std::exception& error)
  {
    if (!std::exchange(self.faulty, true))
      vtkErrorMacro(<< "What was in hand is let go: " << error.what());
    this->Release();
  }
  const hasp::HapticDiscRequest* discs =
    self.drawing.shell ? self.loop->AskForDiscs(self.drawing.mostDiscs) : nullptr;
  moved = self.drawing.Update(self.loop->GetSnapshot(), discs) || moved;
  this->FollowContact();
  return moved;
}

void vtkHaspHapticInteractor::FollowProps()
{
  Internals& self = *this->Self;
  std::vector<std::string> faults;
  self.props.Update(faults);
  for (const std::string& fault : faults)
    vtkErrorMacro(<< "Left out of haptics: " << fault);
  if (self.grab.Tool() >= 0 && !self.props.ToolReady(self.grab.Tool()))
    this->Release();
  self.grab.Refresh(self.props, self.loop);
  if (std::exchange(self.wasBaking, self.props.Baking()) && !self.props.Baking())
    this->InvokeEvent(ReadyEvent);
}

void vtkHaspHapticInteractor::SendControl()
{
  Internals& self = *this->Self;
  hasp::HapticControl control = self.loop->GetControl();
  // Asking for a camera makes one, and then the first picture does not fit the scene into it.
  if (this->CameraRelative && self.renderer && self.renderer->IsActiveCameraCreated())
  {
    vtkCamera* camera = self.renderer->GetActiveCamera();
    control.axes = CameraAxes(camera);
    if (!std::exchange(self.placed, true))
    {
      control.place.orientation = control.axes;
      camera->GetFocalPoint(&control.place.position.x);
      ++control.placed;
    }
  }
  control.scale = this->Scale;
  control.clutch = this->ClutchButton >= 0 ? 1U << this->ClutchButton : 0U;
  control.attract = this->SnapToFit;
  if (this->SnapToFit && control.contact.attraction == 0.0F)
    control.contact.attraction = DefaultAttraction;
  control.isovalues = self.props.Isovalues(self.grab.Tool());
  self.loop->SetControl(control);
  const hasp::HapticSnapshot& seen = self.loop->GetSnapshot();
  self.input.At(seen.tool.position, this->Scale);
}

/// A press of the mouse that may take something: the middle of the device's workspace goes to what
/// is seen there, if a tool is within reach of it. False: it is nothing of haptics.
bool vtkHaspHapticInteractor::PointAt(int x, int y)
{
  Internals& self = *this->Self;
  vtkRenderWindow* window = self.renderer ? self.renderer->GetRenderWindow() : nullptr;
  if (!self.loop->GetStarted() || window == nullptr || window->GetNeverRendered() ||
      !self.renderer->IsInViewport(x, y))
    return false;
  const double depth = self.renderer->GetZ(x, y);
  if (!(depth < 1.0))
    return false;
  self.renderer->SetDisplayPoint(x, y, depth);
  self.renderer->DisplayToWorld();
  glm::dvec4 seen;
  self.renderer->GetWorldPoint(&seen.x);
  const glm::dvec3 point = glm::dvec3(seen) / seen.w;
  try
  {
    if (self.props.Nearest(point, this->GrabReach) < 0)
      return false;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "Nothing is taken in hand: " << error.what());
    return false;
  }
  hasp::HapticControl control = self.loop->GetControl();
  control.place = { point, control.axes };
  ++control.placed;
  self.placed = true;
  return self.loop->SetControl(control);
}

void vtkHaspHapticInteractor::FollowButtons(std::uint32_t now)
{
  Internals& self = *this->Self;
  const std::uint32_t before = std::exchange(self.buttons, now);
  static constexpr unsigned long As[3][2] = { { vtkCommand::LeftButtonReleaseEvent,
                                                vtkCommand::LeftButtonPressEvent },
    { vtkCommand::RightButtonReleaseEvent, vtkCommand::RightButtonPressEvent },
    { vtkCommand::MiddleButtonReleaseEvent, vtkCommand::MiddleButtonPressEvent } };
  const std::uint32_t changed = now ^ before;
  for (int button = 0; button < 32 && changed >> button != 0; ++button)
  {
    if ((changed >> button & 1U) == 0)
      continue;
    const bool held = (now >> button & 1U) != 0;
    if (button == this->GrabButton && held)
      this->Grab(self.props.Nearest(self.loop->GetSnapshot().device.position, this->GrabReach));
    else if (button == this->GrabButton)
      this->Release();
    int number = button; // an observer may write to what it is handed
    this->InvokeEvent(held ? ButtonPressEvent : ButtonReleaseEvent, &number);
    if (button < 3)
      this->InvokeEvent(As[button][held ? 1 : 0], &number);
  }
}

void vtkHaspHapticInteractor::FollowContact()
{
  Internals& self = *this->Self;
  const bool now = self.grab.Tool() >= 0 && self.loop->GetSnapshot().contacts > 0;
  if (std::exchange(self.touching, now) != now)
    this->InvokeEvent(now ? ContactEvent : FreeEvent);
}

/// Where nobody's hand feels the pull the device's point would hold against it: it goes along, as a
/// hand does that lets itself be pulled in.
void vtkHaspHapticInteractor::YieldToSnap()
{
  Internals& self = *this->Self;
  const hasp::HapticSnapshot& seen = self.loop->GetSnapshot();
  const std::uint64_t before = std::exchange(self.yieldedAt, seen.ticks);
  if (!this->SnapToFit || self.grab.Tool() < 0 || seen.ticks <= before ||
      !(seen.attractedAreaMm2 > 0.0))
    return;
  const double share = 1.0 - std::exp(-double(seen.ticks - before) / YieldTicks);
  const glm::dquat toDevice = glm::inverse(self.loop->GetControl().axes);
  const glm::dquat turn = seen.tool.orientation * glm::inverse(seen.device.orientation);
  self.input.Yield(toDevice * ((seen.tool.position - seen.device.position) * share / this->Scale),
    toDevice * (hasp::RotationVector(turn) * share));
}
