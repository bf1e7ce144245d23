#include "ViewWindow.h"

#include "Failure.h"
#include "Files.h"
#include "PictureFile.h"
#include "SurfaceScene.h"
#include "ViewOverlay.h"
#include "VtkMessages.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

namespace hasp
{
namespace
{

constexpr int MostFrames = 2000; // a picture is refined for, where its noise never ends
constexpr int TimerMs = 1;

/// The keys are ours, and so is the timer: by VTK's default any timer turns the camera on while a
/// button is down.
class Trackball : public vtkInteractorStyleTrackballCamera
{
public:
  static Trackball* New();
  vtkTypeMacro(Trackball, vtkInteractorStyleTrackballCamera);
  void OnChar() override {}
  void OnTimer() override {}
};
vtkStandardNewMacro(Trackball);

/// Hundredths of the isovalue's range that a key steps, 0 for other keys.
int StepOf(const std::string& key)
{
  if (key == "Right" || key == "Up" || key == "plus" || key == "equal" || key == "KP_Add")
    return 1;
  if (key == "Left" || key == "Down" || key == "minus" || key == "KP_Subtract")
    return -1;
  return key == "Prior" ? 10 : key == "Next" ? -10 : 0; // Page Up, Page Down
}

/// A picture's name that is not taken.
std::string FreeName()
{
  int n = 1;
  while (std::filesystem::exists("hasp-view-" + std::to_string(n) + ".png"))
    ++n;
  return "hasp-view-" + std::to_string(n) + ".png";
}

} // namespace

struct ViewWindow::Parts
{
  SurfaceScene& scene;
  vtkRenderWindow* window;
  vtkRenderWindowInteractor* interactor;
  ViewSettings settings;
  ViewOverlay overlay;
  vtkNew<Trackball> style;

  std::string answer;  ///< to the last key
  std::string failure; ///< why nothing can be drawn any more
  ResourceList resources;
  bool closed = false;
  std::chrono::steady_clock::time_point frameStart;
  double frameMs = 0.0;
  bool refines = false, ticking = false;
  int timer = 0, spentTimer = 0; ///< of the interactor; 0: none

  Parts(SurfaceScene& scene_, vtkRenderWindow* window_, vtkRenderWindowInteractor* interactor_,
    const ViewSettings& settings_)
    : scene(scene_),
      window(window_),
      interactor(interactor_),
      settings(settings_),
      overlay(scene_.Renderer(), interactor_, settings_)
  {
    this->style->SetDefaultRenderer(this->scene.Renderer());
    this->interactor->SetInteractorStyle(this->style);
    this->window->AddObserver(vtkCommand::StartEvent, this, &Parts::FrameStarts);
    this->window->AddObserver(vtkCommand::EndEvent, this, &Parts::FrameEnds);
    this->interactor->AddObserver(vtkCommand::TimerEvent, this, &Parts::Tick);
    this->interactor->AddObserver(vtkCommand::KeyPressEvent, this, &Parts::Key);
    this->interactor->AddObserver(vtkCommand::ExitEvent, this, &Parts::Close);
    if (vtkSliderWidget* slider = this->overlay.Slider())
      slider->AddObserver(vtkCommand::InteractionEvent, this, &Parts::Slid);
  }
  std::string Text() const
  {
    char text[200];
    std::snprintf(text, sizeof text, "%.1f ms a frame, %s%s", this->frameMs,
      this->scene.DrewBy().c_str(), this->refines ? ", refining" : "");
    return this->overlay.IsoValueText(this->settings.isoValue) + ", " + text +
           (this->answer.empty() ? "" : "\n" + this->answer);
  }
  void FrameStarts()
  {
    this->overlay.SetText(this->Text());
    this->frameStart = std::chrono::steady_clock::now();
  }
  void FrameEnds()
  {
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - this->frameStart;
    this->frameMs = spent.count();
    if (this->failure.empty())
      this->failure = TakeVtkError();
    if (!this->failure.empty())
      return this->Close();
    if (!this->ticking) // camera, isovalue or window: what was complete is no more
      this->scene.Restart();
    this->refines = this->scene.WantsFrame(MostFrames);
    if (this->refines && this->timer == 0 && this->interactor->GetInitialized())
      this->timer = this->interactor->CreateOneShotTimer(TimerMs);
  }
  /// A chain of timers for one shot: VTK 9.1's X interactor writes to a repeating one after its
  /// event, so that it could not be stopped there.
  void Tick(vtkObject*, unsigned long, void* id)
  {
    if (this->closed || !id || *static_cast<int*>(id) != this->timer)
      return;
    if (this->spentTimer)
      this->interactor->DestroyTimer(this->spentTimer); // else it is remembered
    this->spentTimer = std::exchange(this->timer, 0);
    if (!this->refines)
      return;
    this->ticking = true;
    this->window->Render();
    this->ticking = false;
  }
  void Close()
  {
    if (this->closed)
      return;
    this->closed = true;
    this->scene.ListResources(this->resources); // closing frees them
    this->interactor->EnableRenderOff();        // or what comes now would open the window again
    this->interactor->TerminateApp();
  }
  void SetIsoValue(double value)
  {
    if (!this->settings.range)
      return;
    const auto& [least, most] = *this->settings.range;
    this->settings.isoValue = std::clamp(value, least, most);
    this->answer.clear();
    this->scene.SetIsoValue(this->settings.isoValue);
  }
  void Slid() { this->SetIsoValue(this->overlay.SliderValue()); } // the slider then renders
  void Key()
  {
    const char* sym = this->interactor->GetKeySym();
    const std::string key = sym ? sym : "";
    if (key == "q" || key == "Q" || key == "Escape")
      return this->Close();
    if (const int step = StepOf(key); step != 0 && this->settings.range)
    {
      const auto& [least, most] = *this->settings.range;
      this->SetIsoValue(this->settings.isoValue + step * (most - least) / 100.0);
      this->overlay.SetSliderValue(this->settings.isoValue);
    }
    else if (key == "r" || key == "R")
      PlaceCamera(this->scene.Renderer(), this->settings.camera);
    else if (key == "p" || key == "P")
      this->Pick();
    else if (key == "s" || key == "S")
      this->Save();
    else
      return;
    this->interactor->Render();
  }
  void Pick()
  {
    const int* at = this->interactor->GetEventPosition();
    vtkRenderer* renderer = this->scene.Renderer();
    const auto world = [&](double depth)
    {
      renderer->SetDisplayPoint(at[0], at[1], depth);
      renderer->DisplayToWorld();
      const double* p = renderer->GetWorldPoint();
      return WorldPoint{ p[0] / p[3], p[1] / p[3], p[2] / p[3] };
    };
    const auto point = this->scene.Pick(world(0.0), world(1.0));
    char text[100] = "no surface there";
    if (point)
      std::snprintf(text, sizeof text, "picked %.2f, %.2f, %.2f mm (LPS)", (*point)[0], (*point)[1],
        (*point)[2]);
    this->answer = text;
  }
  void Save()
  {
    const std::string name = FreeName();
    try
    {
      RequireWritable(name, { ".png" });
      WriteFile(name, PngFile(this->Picture()));
      this->answer = "saved " + name;
    }
    catch (const Failure& failed)
    {
      this->answer = failed.what();
    }
  }
  vtkSmartPointer<vtkImageData> Picture() const
  {
    vtkNew<vtkWindowToImageFilter> read;
    read->SetInput(this->window);
    read->SetInputBufferTypeToRGB();
    read->ReadFrontBufferOff();
    read->ShouldRerenderOff();
    read->Update();
    return read->GetOutput();
  }
  void RequireDrawn() const
  {
    if (!this->failure.empty())
      throw Failure(ExitCode::CannotDraw, "cannot draw: " + this->failure);
  }
};

ViewWindow::ViewWindow(SurfaceScene& scene, vtkRenderWindow* window,
  vtkRenderWindowInteractor* interactor, const ViewSettings& settings)
  : Self(std::make_unique<Parts>(scene, window, interactor, settings))
{
}

ViewWindow::~ViewWindow()
{
  Parts& self = *this->Self;
  self.interactor->EnableRenderOff();
  self.window->RemoveAllObservers();
}

void ViewWindow::Run()
{
  Parts& self = *this->Self;
  self.interactor->Initialize();
  self.window->Render();
  self.RequireDrawn();
  self.interactor->Start();
  self.RequireDrawn();
}

vtkSmartPointer<vtkImageData> ViewWindow::DrawComplete()
{
  Parts& self = *this->Self;
  self.window->Render();
  self.ticking = true;
  while (self.refines && !self.closed)
    self.window->Render();
  self.RequireDrawn();
  self.window->Render(); // with the text of the last frame
  self.ticking = false;
  self.RequireDrawn();
  return self.Picture();
}

ResourceList ViewWindow::Resources() const
{
  ResourceList list = this->Self->resources;
  if (!this->Self->closed)
    this->Self->scene.ListResources(list);
  return list;
}

double ViewWindow::IsoValue() const
{
  return this->Self->settings.isoValue;
}

std::string ViewWindow::Text() const
{
  return this->Self->Text();
}

bool ViewWindow::WaitsForTimer() const
{
  return this->Self->timer != 0;
}

vtkSliderWidget* ViewWindow::Slider() const
{
  return this->Self->overlay.Slider();
}

std::string ViewKeys()
{
  return "Mouse: left turns, middle (or Shift and left) pans, right and wheel zoom; drag the "
         "slider\n"
         "Keys:\n"
         "  Right Up + / Left Down -   raise / lower the isovalue by 1% of its range\n"
         "  Page Up / Page Down        by 10%\n"
         "  p   where the pointer's surface is, mm LPS     r   back to the first view\n"
         "  s   save the window as hasp-view-1.png (-2, ...) in the current folder\n"
         "  q Esc   quit\n";
}

} // namespace hasp
