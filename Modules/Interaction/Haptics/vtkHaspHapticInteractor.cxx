#include "vtkHaspHapticInteractor.h"

#include "HapticChain.h"
#include "HapticInteractorInternals.h"
#include "PropPose.h"

#include "Devices/InputHapticDevice.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkProp3D.h"
#include "vtkRenderWindow.h"

#include <exception>
#include <stdexcept>
#include <utility>

vtkStandardNewMacro(vtkHaspHapticInteractor);

namespace
{
constexpr unsigned long FrameMs = 16;

/// For devices without motors: no hand has to be kept stable, so contact is as firm as fidelity
/// wants it (`hasp report reduction`, reduction.fidelity.soft).
hasp::HapticChainSettings WithoutMotors()
{
  hasp::HapticChainSettings settings;
  settings.step.contact.stiffness = 0.5F;
  return settings;
}
}

vtkHaspHapticInteractor::vtkHaspHapticInteractor() : Self(std::make_unique<Internals>())
{
  this->Self->timer->SetClientData(this);
  this->Self->timer->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void* data)
    {
      auto* haptic = static_cast<vtkHaspHapticInteractor*>(self);
      if (event == vtkCommand::ModifiedEvent)
        haptic->BeginTimer();
      else if (data != nullptr && *static_cast<int*>(data) == haptic->Self->timerId)
      {
        // A style takes any timer for its own, and repeats the last step of a drag.
        haptic->Self->timer->AbortFlagOn();
        haptic->Frame();
      }
    });
}

vtkHaspHapticInteractor::~vtkHaspHapticInteractor()
{
  this->Self->EndTimer();
  this->Self->input.Follow(nullptr, nullptr, nullptr);
}

void vtkHaspHapticInteractor::Frame()
{
  if (this->Update() && this->Self->interactor)
    this->Self->interactor->Render();
}

bool vtkHaspHapticInteractor::AddTouchable(vtkProp3D* prop)
{
  try
  {
    this->Self->props.AddTouchable(prop);
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "This prop cannot be touched: " << error.what());
    return false;
  }
}

bool vtkHaspHapticInteractor::AddTouchable(
  vtkImageData* image, double isovalue, vtkMatrix4x4* imageToWorld)
{
  try
  {
    this->Self->props.AddTouchable(
      image, isovalue, imageToWorld != nullptr ? hasp::PoseOf(imageToWorld) : hasp::RigidPose{});
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "This image cannot be touched: " << error.what());
    return false;
  }
}

int vtkHaspHapticInteractor::AddTool(vtkProp3D* prop)
{
  return this->AddTool(std::vector<vtkProp3D*>{ prop });
}

int vtkHaspHapticInteractor::AddTool(const std::vector<vtkProp3D*>& group)
{
  try
  {
    return this->Self->props.AddTool(group);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "These props cannot be taken in hand: " << error.what());
    return -1;
  }
}

void vtkHaspHapticInteractor::Remove(vtkProp3D* prop)
{
  this->Self->props.Remove(prop);
  try
  {
    this->FollowProps();
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "What is left cannot be touched: " << error.what());
    this->Release();
  }
}

void vtkHaspHapticInteractor::SetRenderer(vtkRenderer* renderer)
{
  Internals& self = *this->Self;
  self.renderer = renderer;
  self.drawing.SetRenderer(renderer);
  vtkRenderWindow* window = renderer != nullptr ? renderer->GetRenderWindow() : nullptr;
  self.loop->SetRenderWindow(window);
  self.input.FollowIn(window != nullptr ? window->GetInteractor() : nullptr, renderer);
  if (self.loop->GetStarted())
    this->StartTimer();
  this->Modified();
}

bool vtkHaspHapticInteractor::SetDevice(std::unique_ptr<hasp::HapticDevice> device)
{
  return this->SetDevice(std::move(device), {});
}

bool vtkHaspHapticInteractor::SetDevice(
  std::unique_ptr<hasp::HapticDevice> device, const hasp::HapticChainSettings& settings)
{
  Internals& self = *this->Self;
  this->Release();
  self.input.Follow(nullptr, nullptr, nullptr);
  self.buttons = 0;
  self.yieldedAt = 0;
  self.placed = false;
  if (std::exchange(self.stands, false))
    this->CameraRelative = true;
  if (!self.loop->SetDevice(std::move(device), settings))
    return false;
  this->Scale = settings.workspace.scale;
  return true;
}

bool vtkHaspHapticInteractor::UseMouse()
{
  Internals& self = *this->Self;
  vtkRenderWindow* window = self.renderer ? self.renderer->GetRenderWindow() : nullptr;
  if (window == nullptr || window->GetInteractor() == nullptr)
  {
    vtkErrorMacro(<< "A mouse is read from a window's interactor; give the window one, then call "
                     "SetRenderer and UseMouse");
    return false;
  }
  auto device = std::make_unique<hasp::InputHapticDevice>(
    hasp::InputDeviceSettings{ .workspaceMm = glm::dvec3(1e4) }); // the screen is its end
  hasp::InputHapticDevice* feed = device.get();
  if (!this->SetDevice(std::move(device), WithoutMotors()))
    return false;
  self.input.takes = [this, feed](int button, int x, int y)
  {
    const bool grabs = button >= 0 && button == this->GrabButton;
    if (grabs) // what no frame has seen let go since its last press goes first
      this->FollowButtons(this->Self->buttons & ~(1U << button));
    if (this->Self->grab.Tool() >= 0)
      return true;
    if (!grabs || !this->PointAt(x, y))
      return false;
    feed->MoveTo({}); // whatever way it has gone, its workspace does not end
    return true;
  };
  // Not at the next frame: until then the pointer goes on, and props may become others.
  self.input.pressed = [this] { this->Frame(); };
  self.input.Follow(window->GetInteractor(), self.renderer, feed);
  return true;
}

bool vtkHaspHapticInteractor::Start()
{
  Internals& self = *this->Self;
  if (vtkRenderWindow* window = self.renderer ? self.renderer->GetRenderWindow() : nullptr)
    self.loop->SetRenderWindow(window); // which the renderer may have been given since
  if (!self.loop->Start())
    return false;
  this->SendControl();
  this->StartTimer();
  return true;
}

void vtkHaspHapticInteractor::StartTimer()
{
  Internals& self = *this->Self;
  vtkRenderWindow* window = self.renderer ? self.renderer->GetRenderWindow() : nullptr;
  self.EndTimer();
  if (window == nullptr || window->GetInteractor() == nullptr)
    return;
  self.interactor = window->GetInteractor();
  self.interactor->AddObserver(vtkCommand::TimerEvent, self.timer, 1.0F); // before the style
  // Interactors give timers only once they are initialised, which their Start does: that enables
  // them, and says so.
  self.interactor->AddObserver(vtkCommand::ModifiedEvent, self.timer);
  this->BeginTimer();
}

void vtkHaspHapticInteractor::BeginTimer()
{
  Internals& self = *this->Self;
  if (self.timerId != 0 || !self.interactor || !self.interactor->GetInitialized())
    return;
  self.timerId = self.interactor->CreateRepeatingTimer(FrameMs);
  if (self.timerId != 0)
    return;
  self.EndTimer();
  vtkWarningMacro(<< "Nobody asks for frames: this interactor has no timers. Without a display, or "
                     "with a loop of its own, call Update once a frame");
}

void vtkHaspHapticInteractor::Stop()
{
  this->Release();
  this->Self->EndTimer();
  this->Self->loop->Stop();
}

bool vtkHaspHapticInteractor::Grab(int tool)
{
  Internals& self = *this->Self;
  if (tool < 0 || !self.loop->GetStarted())
    return false;
  this->Release();
  try
  {
    if (!self.grab.Take(tool, self.props, self.loop))
      return false;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "This tool is not taken in hand: " << error.what());
    return false;
  }
  this->InvokeEvent(GrabEvent, &tool);
  return true;
}

void vtkHaspHapticInteractor::Release()
{
  int tool = this->Self->grab.Tool();
  if (tool < 0)
    return;
  this->Self->grab.Drop(this->Self->loop);
  this->InvokeEvent(ReleaseEvent, &tool);
}

int vtkHaspHapticInteractor::GetHeldTool() const
{
  return this->Self->grab.Tool();
}

int vtkHaspHapticInteractor::GetState() const
{
  const Internals& self = *this->Self;
  if (self.loop->GetProfile() == nullptr || !self.props.Wanted())
    return Idle;
  return self.props.Complete() ? Ready : Baking;
}

double vtkHaspHapticInteractor::GetProgress() const
{
  return this->Self->props.Progress();
}

vtkHaspHapticLoop* vtkHaspHapticInteractor::GetLoop()
{
  return this->Self->loop;
}

bool vtkHaspHapticInteractor::SetDeviceToWorld(vtkMatrix4x4* matrix)
{
  try
  {
    Internals& self = *this->Self;
    hasp::HapticControl control = self.loop->GetControl();
    control.place = hasp::PoseOf(matrix);
    if (self.loop->GetProfile() == nullptr)
      throw std::invalid_argument("there is none; call SetDevice before SetDeviceToWorld");
    control.axes = control.place.orientation;
    control.scale = this->Scale = 1.0;
    ++control.placed;
    self.stands = std::exchange(this->CameraRelative, false) || self.stands;
    self.placed = true;
    self.loop->SetControl(control);
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "The device stays where it stood: " << error.what());
    return false;
  }
}

void vtkHaspHapticInteractor::ListResources(hasp::ResourceList& resources) const
{
  this->Self->props.ListResources(resources);
  this->Self->loop->ListResources(resources);
}

// What is set and got as it is.
void vtkHaspHapticInteractor::SetSpacing(double mm)
{
  this->Self->props.spacingMm = mm;
}
double vtkHaspHapticInteractor::GetSpacing() const
{
  return this->Self->props.spacingMm;
}
void vtkHaspHapticInteractor::SetDynamicShells(bool on)
{
  this->Self->props.dynamicShells = on;
}
bool vtkHaspHapticInteractor::GetDynamicShells() const
{
  return this->Self->props.dynamicShells;
}
void vtkHaspHapticInteractor::SetShowForces(bool on)
{
  this->Self->drawing.forces = on;
}
bool vtkHaspHapticInteractor::GetShowForces() const
{
  return this->Self->drawing.forces;
}
void vtkHaspHapticInteractor::SetShowShell(bool on)
{
  this->Self->drawing.shell = on;
}
bool vtkHaspHapticInteractor::GetShowShell() const
{
  return this->Self->drawing.shell;
}
void vtkHaspHapticInteractor::SetPointer(vtkProp3D* prop)
{
  this->Self->drawing.SetPointer(prop);
}

void vtkHaspHapticInteractor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "State: " << this->GetState() << "\n";
  os << indent << "HeldTool: " << this->GetHeldTool() << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  this->Self->loop->PrintSelf(os, indent.GetNextIndent());
}
