#include "HapticInput.h"

#include "Devices/InputHapticDevice.h"
#include "Realtime/LoopThread.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTDxMotionEventInfo.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace hasp
{

namespace
{
constexpr unsigned long Followed[] = { vtkCommand::MouseMoveEvent, vtkCommand::LeftButtonPressEvent,
  vtkCommand::LeftButtonReleaseEvent, vtkCommand::RightButtonPressEvent,
  vtkCommand::RightButtonReleaseEvent, vtkCommand::MiddleButtonPressEvent,
  vtkCommand::MiddleButtonReleaseEvent, vtkCommand::MouseWheelForwardEvent,
  vtkCommand::MouseWheelBackwardEvent, vtkCommand::KeyPressEvent, vtkCommand::TDxMotionEvent };
constexpr unsigned long ReleaseEvents[] = { vtkCommand::LeftButtonReleaseEvent,
  vtkCommand::RightButtonReleaseEvent, vtkCommand::MiddleButtonReleaseEvent };
constexpr int Middle = 2;
constexpr double FullDeflection = 350.0; // of a SpaceMouse, per axis

/// Of a press; -1 for all else.
int PressedButton(unsigned long event)
{
  switch (event)
  {
    case vtkCommand::LeftButtonPressEvent:
      return 0;
    case vtkCommand::RightButtonPressEvent:
      return 1;
    case vtkCommand::MiddleButtonPressEvent:
      return Middle;
    default:
      return -1;
  }
}

int ReleasedButton(unsigned long event)
{
  return event == vtkCommand::LeftButtonReleaseEvent    ? 0
         : event == vtkCommand::RightButtonReleaseEvent ? 1
                                                        : Middle;
}
}

HapticInput::HapticInput()
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void* data)
    {
      auto* input = static_cast<HapticInput*>(self);
      // What is the tool's is not the camera's, too.
      if (input->Handle(event, data))
        input->Command->AbortFlagOn();
    });
  this->Releases->SetPassiveObserver(1);
  this->Releases->SetClientData(this);
  this->Releases->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<HapticInput*>(self)->Styles &= ~(1U << ReleasedButton(event)); });
}

HapticInput::~HapticInput()
{
  this->Follow(nullptr, nullptr, nullptr);
}

void HapticInput::Follow(
  vtkRenderWindowInteractor* interactor, vtkRenderer* renderer, InputHapticDevice* device)
{
  if (this->Interactor)
  {
    this->Interactor->RemoveObserver(this->Command);
    this->Interactor->RemoveObserver(this->Releases);
  }
  if (this->Device != nullptr && this->Held != 0)
    this->Device->SetButtons(0); // nobody would say so
  this->Interactor = interactor;
  this->Renderer = renderer;
  this->Device = device;
  this->Any = false;
  this->Styles = 0;
  this->Held = 0;
  if (interactor == nullptr || renderer == nullptr || device == nullptr)
    return;
  for (const unsigned long event : Followed)
    interactor->AddObserver(event, this->Command, 1.0F); // before the style
  for (const unsigned long event : ReleaseEvents)
    interactor->AddObserver(event, this->Releases);
}

void HapticInput::FollowIn(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer)
{
  this->Follow(interactor, renderer, this->Device);
}

void HapticInput::At(const glm::dvec3& tool, double scale)
{
  this->Tool = tool;
  this->Scale = scale;
}

void HapticInput::Yield(const glm::dvec3& mm, const glm::dvec3& radians)
{
  if (this->Device == nullptr)
    return;
  this->Device->MoveBy(mm);
  this->Device->TurnBy(radians);
}

double HapticInput::MmPerPixel() const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const int* size = this->Renderer->GetSize();
  const double width = std::max(1, size[0]), height = std::max(1, size[1]);
  double high = 2.0 * camera->GetParallelScale();
  if (!camera->GetParallelProjection())
  {
    glm::dvec3 eye, along;
    camera->GetPosition(&eye.x);
    camera->GetDirectionOfProjection(&along.x);
    const double depth = std::max(glm::dot(this->Tool - eye, along), 1e-3 * camera->GetDistance());
    high = 2.0 * depth * std::tan(0.5 * glm::radians(camera->GetViewAngle()));
    if (camera->GetUseHorizontalViewAngle())
      high *= height / width;
  }
  return high / height / this->Scale; // of the device
}

bool HapticInput::Clutched() const
{
  return this->Interactor->GetShiftKey() != 0;
}

void HapticInput::Move()
{
  const std::array<int, 2> now{ this->Interactor->GetEventPosition()[0],
    this->Interactor->GetEventPosition()[1] };
  const glm::dvec3 pixels(now[0] - this->Before[0], now[1] - this->Before[1], 0.0);
  this->Before = now;
  if (!std::exchange(this->Any, true) || this->Clutched())
    return; // where it came in, or is put back
  if ((this->Held >> Middle & 1U) != 0)
    this->Device->TurnBy(this->turnRadPerPixel * glm::dvec3(-pixels.y, pixels.x, 0.0));
  else
    this->Device->MoveBy(this->MmPerPixel() * pixels);
}

bool HapticInput::Key()
{
  const std::string key =
    this->Interactor->GetKeySym() != nullptr ? this->Interactor->GetKeySym() : "";
  const glm::dvec3 step = key == "Left"    ? glm::dvec3(-1, 0, 0)
                          : key == "Right" ? glm::dvec3(1, 0, 0)
                          : key == "Up"    ? glm::dvec3(0, 1, 0)
                          : key == "Down"  ? glm::dvec3(0, -1, 0)
                          : key == "Prior" ? glm::dvec3(0, 0, -1)
                          : key == "Next"  ? glm::dvec3(0, 0, 1)
                                           : glm::dvec3(0.0);
  if (step == glm::dvec3(0.0) || !this->Takes(-1))
    return false;
  if (!this->Clutched())
    this->Device->MoveBy(this->wheelMm * step);
  return true;
}

bool HapticInput::Takes(int button) const
{
  const int* at = this->Interactor->GetEventPosition();
  return !this->takes || this->takes(button, at[0], at[1]);
}

/// Buttons 0 and 1 are the device's, the middle one turns.
bool HapticInput::Press(int button)
{
  const bool taken = this->Takes(button == Middle ? -1 : button);
  this->Give(button, taken);
  if (taken && this->pressed)
    this->pressed();
  return taken;
}

/// From its press on; also where the release of the press before was lost.
void HapticInput::Give(int button, bool device)
{
  const std::uint32_t bit = 1U << button;
  (device ? this->Held : this->Styles) |= bit;
  (device ? this->Styles : this->Held) &= ~bit;
  this->Device->SetButtons(this->Held & ~(1U << Middle));
}

bool HapticInput::Release(int button)
{
  const std::uint32_t bit = 1U << button;
  if ((this->Held & bit) == 0)
    return false; // the style had the press
  this->Held &= ~bit;
  this->Device->SetButtons(this->Held & ~(1U << Middle));
  return true;
}

void HapticInput::Rates(const vtkTDxMotionEventInfo& said)
{
  const double free = this->Clutched() ? 0.0 : 1.0 / FullDeflection;
  const glm::dvec3 move(said.X, said.Y, said.Z), axis(said.AxisX, said.AxisY, said.AxisZ);
  this->Device->SetRates(move * (this->rateMmPerS * free),
    axis * (said.Angle * this->rateRadPerS * free), MonotonicClock().NowNs());
}

bool HapticInput::Step(unsigned long event)
{
  switch (event)
  {
    case vtkCommand::MouseMoveEvent:
      this->Move();
      return this->Takes(-1);
    case vtkCommand::LeftButtonPressEvent:
    case vtkCommand::RightButtonPressEvent:
    case vtkCommand::MiddleButtonPressEvent:
      return this->Press(PressedButton(event));
    case vtkCommand::MouseWheelForwardEvent:
    case vtkCommand::MouseWheelBackwardEvent:
      if (!this->Takes(-1))
        return false;
      if (!this->Clutched())
        this->Device->MoveBy(
          { 0, 0, event == vtkCommand::MouseWheelForwardEvent ? -this->wheelMm : this->wheelMm });
      return true;
    case vtkCommand::KeyPressEvent:
      return this->Key();
    default:
      return false;
  }
}

bool HapticInput::Handle(unsigned long event, void* data)
{
  if (this->Device == nullptr || !this->Renderer || !this->Renderer->IsActiveCameraCreated())
    return false; // before the first picture there is nothing to point at
  switch (event)
  {
    case vtkCommand::TDxMotionEvent:
      if (!this->Takes(-1))
        return false;
      this->Rates(*static_cast<const vtkTDxMotionEventInfo*>(data));
      return true;
    case vtkCommand::LeftButtonReleaseEvent:
    case vtkCommand::RightButtonReleaseEvent:
    case vtkCommand::MiddleButtonReleaseEvent:
      return this->Release(ReleasedButton(event));
    default:
      break;
  }
  if (!this->Interactor->GetControlKey() && this->Styles == 0)
    return this->Step(event);
  if (const int button = PressedButton(event); button >= 0)
    this->Give(button, false);
  this->Any = false; // the pointer stays where it is, as a mouse that is lifted
  return false;
}

} // namespace hasp
