#include "ViewWindow.h"

#include "Failure.h"
#include "Files.h"
#include "FrameTimer.h"
#include "PictureFile.h"
#include "SurfaceScene.h"
#include "ViewKeys.h"
#include "ViewOverlay.h"
#include "ViewStyle.h"
#include "VtkMessages.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>
#include <vector>

namespace hasp
{
namespace
{

constexpr int MostFrames = 2000; // a picture is refined for, where its noise never ends

} // namespace

struct ViewWindow::Parts
{
  SurfaceScene& scene;
  vtkRenderWindow* window;
  vtkRenderWindowInteractor* interactor;
  ViewSettings settings;
  ViewOverlay overlay;
  vtkNew<ViewStyle> style;

  std::string answer;  ///< to the last key
  std::string failure; ///< why nothing can be drawn any more
  ResourceList resources;
  bool closed = false;
  std::chrono::steady_clock::time_point frameStart;
  double frameMs = 0.0;
  bool refines = false, ticking = false;
  FrameTimer timer;
  std::vector<std::pair<vtkObject*, unsigned long>> observed;

  Parts(SurfaceScene& scene_, vtkRenderWindow* window_, vtkRenderWindowInteractor* interactor_,
    const ViewSettings& settings_)
    : scene(scene_),
      window(window_),
      interactor(interactor_),
      settings(settings_),
      overlay(scene_.Renderer(), interactor_, settings_),
      timer(interactor_, [this] { this->Tick(); })
  {
    this->style->SetDefaultRenderer(this->scene.Renderer());
    this->interactor->SetInteractorStyle(this->style);
    this->Observe(this->window, vtkCommand::StartEvent, &Parts::FrameStarts);
    this->Observe(this->window, vtkCommand::EndEvent, &Parts::FrameEnds);
    this->Observe(this->interactor, vtkCommand::KeyPressEvent, &Parts::Key);
    this->Observe(this->interactor, vtkCommand::ExitEvent, &Parts::Close);
    if (vtkSliderWidget* slider = this->overlay.Slider())
      this->Observe(slider, vtkCommand::InteractionEvent, &Parts::Slid);
  }
  ~Parts()
  {
    this->interactor->EnableRenderOff(); // hiding the slider would draw another frame
    for (const auto& [object, tag] : this->observed)
      object->RemoveObserver(tag);
  }
  void Observe(vtkObject* object, unsigned long event, void (Parts::*method)())
  {
    this->observed.emplace_back(object, object->AddObserver(event, this, method));
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
    if (this->refines)
      this->timer.Start();
  }
  void Tick()
  {
    if (this->closed || !this->refines)
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
    if (const int step = IsoValueStep(key); step != 0 && this->settings.range)
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
    this->answer = PickText(this->scene, at[0], at[1]);
  }
  void Save()
  {
    const std::string name = FreeName("hasp-view", ".png");
    try
    {
      RequireWritable(name, { ".png" });
      WriteFile(name, PngFile(WindowPicture(this->window)));
      this->answer = "saved " + name;
    }
    catch (const Failure& failed)
    {
      this->answer = failed.what();
    }
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

ViewWindow::~ViewWindow() = default;

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
  return WindowPicture(self.window);
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
  return this->Self->timer.Runs();
}

vtkSliderWidget* ViewWindow::Slider() const
{
  return this->Self->overlay.Slider();
}

} // namespace hasp
