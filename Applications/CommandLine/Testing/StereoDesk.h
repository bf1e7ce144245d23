#pragma once
#include "StereoView.h"
#include "ViewDesk.h"

#include "vtkMath.h"

#include <glm/vec3.hpp>

#include <functional>
#include <utility>

namespace hasp::testing
{

/// A tracker that a test moves by hand.
class HandHeld : public HeadPoseSource
{
public:
  HeadPose pose;
  std::vector<std::string> warnings;

  bool silent = false;

  std::optional<TimedHeadPose> Latest(double nowS) override
  {
    if (!this->silent)
      this->Newest = { nowS, this->pose };
    return this->Newest;
  }
  const char* Name() const noexcept override { return "a hand"; }
  std::vector<std::string> TakeWarnings() override { return std::exchange(this->warnings, {}); }

private:
  TimedHeadPose Newest;
};

/// A ball of 20 mm in the middle of a screen of 400 x 300 mm.
struct StereoDesk
{
  bool headless = UseHeadlessWindows();
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindow> right; ///< of dual-window
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  int frames = 0; ///< of the window: one an eye
  int timers = 0; ///< that wait
  int lastTimer = 0;
  Session session;
  SceneOptions options;
  StereoChoices choices;
  HandHeld* hand = nullptr;
  std::vector<std::string> said;
  std::unique_ptr<SurfaceScene> scene;
  std::unique_ptr<StereoView> eyes;
  std::unique_ptr<ViewWindow> view;

  explicit StereoDesk(
    const std::string& layout, std::unique_ptr<HeadPoseSource> source = nullptr,
    const std::function<void(StereoChoices&)>& change = [](StereoChoices&) {},
    const std::string& mapper = "cells")
  {
    this->session.quiet = true;
    this->options.isoValue = 80.0;
    this->options.drawing.mapper = mapper;
    this->options.drawing.interactive = true;
    this->choices.layout = layout;
    this->choices.screen = "400x300";
    if (layout != "mono")
      this->choices.eyeSeparationMm = 60.0;
    change(this->choices);
    const auto size = WindowPixels(MakeStereoWindow(this->choices), { 200, 150 }, true);
    this->options.camera.aspect = EyeAspect(MakeStereoWindow(this->choices), { 200, 150 });
    this->window->SetOffScreenRendering(true);
    this->window->SetSize(size[0], size[1]);
    this->window->AddRenderer(this->renderer);
    this->right->SetOffScreenRendering(true);
    this->right->SetSize(size[0], size[1]);
    this->interactor->SetRenderWindow(this->window);
    this->interactor->AddObserver(vtkCommand::CreateTimerEvent, this, &StereoDesk::Timer);
    this->window->AddObserver(vtkCommand::StartEvent, this, &StereoDesk::Frame);
    this->scene =
      std::make_unique<SurfaceScene>(this->renderer, Ball(), this->options, this->session);
    std::unique_ptr<HeadTracker> tracker;
    this->hand = dynamic_cast<HandHeld*>(source.get());
    if (source)
    {
      HeadTrackerSettings settings;
      settings.horizonS = 0.0;
      settings.predict = false;
      tracker = std::make_unique<HeadTracker>(std::move(source), settings);
    }
    this->eyes = std::make_unique<StereoView>(
      this->renderer, this->window, this->choices, std::move(tracker), this->right);
    ViewSettings view;
    view.eyes = this->eyes.get();
    view.range = { 40.0, 100.0 };
    view.isoValue = 80.0;
    view.sayWarning = [this](const std::string& text) { this->said.push_back(text); };
    this->view = std::make_unique<ViewWindow>(*this->scene, this->window, this->interactor, view);
    this->interactor->Initialize();
    this->interactor->Render();
  }
  void Timer()
  {
    this->lastTimer = this->interactor->GetTimerEventId();
    this->interactor->SetTimerEventPlatformId(this->lastTimer);
    ++this->timers;
  }
  void Frame() { ++this->frames; }
  /// Fires what waits; false if nothing does.
  bool Fire()
  {
    if (!this->view->WaitsForTimer())
      return false;
    int id = this->lastTimer;
    this->interactor->InvokeEvent(vtkCommand::TimerEvent, &id);
    return true;
  }
  void Mouse(int x, int y, unsigned long event)
  {
    this->interactor->SetEventInformation(x, y, 0, 0, 0);
    this->interactor->InvokeEvent(event);
  }
  /// Millimetres of the world in one of the room: the screen is as high as the view.
  double Scale() const
  {
    vtkCamera* camera = this->renderer->GetActiveCamera();
    return 2.0 * camera->GetDistance() * std::tan(camera->GetViewAngle() * M_PI / 360.0) / 300.0;
  }
  /// From the middle of the screen, in the room's millimetres: right, up, towards the viewer.
  glm::dvec3 InRoom(const WorldPoint& p) const
  {
    vtkCamera* camera = this->renderer->GetActiveCamera();
    double focus[3], normal[3], up[3], right[3];
    camera->GetFocalPoint(focus);
    camera->GetViewPlaneNormal(normal);
    camera->OrthogonalizeViewUp();
    camera->GetViewUp(up);
    vtkMath::Cross(up, normal, right);
    const double from[3] = { p[0] - focus[0], p[1] - focus[1], p[2] - focus[2] };
    return glm::dvec3(
             vtkMath::Dot(from, right), vtkMath::Dot(from, up), vtkMath::Dot(from, normal)) /
           this->Scale();
  }
};

} // namespace hasp::testing
