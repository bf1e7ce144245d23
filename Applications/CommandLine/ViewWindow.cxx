#include "ViewWindow.h"

#include "Failure.h"
#include "Files.h"
#include "PictureFile.h"
#include "StereoView.h"
#include "SurfaceScene.h"
#include "ViewFrames.h"
#include "ViewKeys.h"
#include "ViewOverlay.h"
#include "ViewPointer.h"
#include "ViewStyle.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

namespace hasp
{
struct ViewWindow::Parts
{
  SurfaceScene& scene;
  vtkRenderWindow* window;
  vtkRenderWindowInteractor* interactor;
  ViewSettings settings;
  ViewOverlay overlay;
  ViewPointer pointer;
  vtkNew<ViewStyle> style;

  std::string answer; ///< to the last key
  ResourceList resources;
  bool closed = false;
  ViewFrames frames;
  std::vector<std::pair<vtkObject*, unsigned long>> observed;

  Parts(SurfaceScene& scene_, vtkRenderWindow* window_, vtkRenderWindowInteractor* interactor_,
    const ViewSettings& settings_)
    : scene(scene_),
      window(window_),
      interactor(interactor_),
      settings(settings_),
      overlay(scene_.Renderer(), interactor_, settings_),
      pointer(interactor_, settings_.eyes, [this] { this->overlay.PlaceSlider(); }),
      frames(scene_, window_, interactor_, settings_.eyes,
        { [this] { this->overlay.SetText(this->Text()); }, [this] { this->Close(); },
          settings_.sayWarning })
  {
    this->style->SetDefaultRenderer(this->scene.Renderer());
    this->interactor->SetInteractorStyle(this->style);
    if (this->settings.eyes)
      this->Observe(this->interactor, vtkCommand::MouseMoveEvent, &Parts::Point);
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
    std::snprintf(text, sizeof text, "%.1f ms a frame, %s%s", this->frames.Milliseconds(),
      this->scene.DrewBy().c_str(), this->frames.Refines() ? ", refining" : "");
    std::string lines = this->overlay.IsoValueText(this->settings.isoValue) + ", " + text;
    if (this->settings.eyes && !this->settings.eyes->Text().empty())
      lines.append("\n").append(this->settings.eyes->Text());
    if (!this->answer.empty())
      lines.append("\n").append(this->answer);
    return lines;
  }
  /// The pointer is the head, unless it drags something.
  void Point()
  {
    const int* size = this->window->GetSize();
    const int* at = this->interactor->GetEventPosition();
    if (this->style->GetState() == VTKIS_NONE)
      this->settings.eyes->PointAt(2.0 * at[0] / size[0] - 1.0, 2.0 * at[1] / size[1] - 1.0);
  }
  void List(ResourceList& list) const
  {
    this->scene.ListResources(list);
    if (this->settings.eyes)
      this->settings.eyes->ListResources(list);
    else
      list.push_back({ "second eye", 0, 0.0, "no --stereo was given" });
  }
  void Close()
  {
    if (this->closed)
      return;
    this->closed = true;
    this->List(this->resources); // closing frees them
    this->frames.Stop();
    this->interactor->TerminateApp();
    if (this->settings.closed)
      this->settings.closed();
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
    {
      PlaceCamera(this->scene.Renderer(), this->settings.camera);
      if (this->settings.eyes)
        this->settings.eyes->CameraPlaced();
    }
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
    const auto at = this->pointer.WindowPixel();
    this->answer = PickText(this->scene, at[0], at[1], this->settings.eyes);
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
    if (const std::string& error = this->frames.Error(); !error.empty())
      throw Failure(ExitCode::CannotDraw, "cannot draw: " + error);
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
  self.frames.Draw();
  self.RequireDrawn();
  self.interactor->Start();
  self.RequireDrawn();
}

vtkSmartPointer<vtkImageData> ViewWindow::DrawComplete()
{
  Parts& self = *this->Self;
  self.frames.DrawComplete();
  self.RequireDrawn();
  return WindowPicture(self.window);
}

ResourceList ViewWindow::Resources() const
{
  ResourceList list = this->Self->resources;
  if (!this->Self->closed)
    this->Self->List(list);
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
  return this->Self->frames.WaitsForTimer();
}

vtkSliderWidget* ViewWindow::Slider() const
{
  return this->Self->overlay.Slider();
}

} // namespace hasp
