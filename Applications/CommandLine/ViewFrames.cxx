#include "ViewFrames.h"

#include "Devices/HeadPose.h"
#include "StereoView.h"
#include "SurfaceScene.h"
#include "VtkMessages.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

namespace hasp
{
namespace
{

constexpr int MostFrames = 2000; // a picture is refined for, where its noise never ends
constexpr int TrackerMs = 8;     // from one look at a head tracker to the next

} // namespace

ViewFrames::ViewFrames(SurfaceScene& scene, vtkRenderWindow* window,
  vtkRenderWindowInteractor* interactor, StereoView* eyes, Hooks hooks)
  : Scene(scene),
    Window(window),
    Interactor(interactor),
    Eyes(eyes),
    Call(std::move(hooks)),
    Timer(interactor, [this] { this->Tick(); })
{
  if (this->Eyes) // each eye's frame is one of the window's, which must not draw on its own
  {
    this->Interactor->EnableRenderOff();
    this->Observe(this->Interactor, vtkCommand::RenderEvent, &ViewFrames::Draw);
  }
  else
  {
    this->Observe(this->Window, vtkCommand::StartEvent, &ViewFrames::Begin);
    this->Observe(this->Window, vtkCommand::EndEvent, &ViewFrames::End);
  }
}

ViewFrames::~ViewFrames()
{
  for (const auto& [object, tag] : this->Observed)
    object->RemoveObserver(tag);
}

void ViewFrames::Observe(vtkObject* object, unsigned long event, void (ViewFrames::*method)())
{
  this->Observed.emplace_back(object, object->AddObserver(event, this, method));
}

bool ViewFrames::Tracked() const
{
  return this->Eyes && this->Eyes->IsTracked();
}

void ViewFrames::Draw()
{
  if (this->Stopped)
    return;
  if (!this->Eyes)
    return this->Window->Render(); // which begins and ends
  this->Begin();
  this->Eyes->Draw(SteadySeconds());
  this->End();
}

void ViewFrames::DrawComplete()
{
  this->Scene.SetWaitForPaths(true); // frames meanwhile would take cores from them
  this->Draw();
  this->Ticking = true;
  while (this->Refining && !this->Stopped)
    this->Draw();
  this->Draw();
  this->Ticking = false;
  this->Scene.SetWaitForPaths(false);
}

void ViewFrames::Stop()
{
  this->Stopped = true;
  this->Interactor->EnableRenderOff(); // or what comes now would open the window again
}

void ViewFrames::Begin()
{
  this->Call.begins();
  this->Start = std::chrono::steady_clock::now();
}

void ViewFrames::End()
{
  const std::chrono::duration<double, std::milli> spent =
    std::chrono::steady_clock::now() - this->Start;
  this->FrameMs = spent.count();
  if (this->Complaint.empty())
    this->Complaint = TakeVtkError();
  if (!this->Complaint.empty())
    return this->Call.failed();
  if (!this->Ticking) // camera, isovalue, head or window: what was complete is no more
    this->Scene.Restart();
  const bool refined = this->Refining;
  this->Refining = this->Scene.WantsFrame(MostFrames);
  this->SaysOld = refined && !this->Refining;
  this->Wait();
}

/// For the next frame, if there may be one.
void ViewFrames::Wait()
{
  if (this->Refining)
    this->Timer.Start(this->Scene.NextFrameMs());
  else if (this->SaysOld)
    this->Timer.Start();
  else if (this->Tracked())
    this->Timer.Start(TrackerMs);
}

void ViewFrames::Tick()
{
  if (this->Stopped)
    return;
  const bool moved = this->Tracked() && this->Eyes->HeadMoved(SteadySeconds());
  if (this->Tracked())
    for (const std::string& warning : this->Eyes->TakeWarnings())
      this->Call.warns(warning);
  this->Ticking = !moved; // a head that moves makes another picture
  if (moved || this->Refining || this->SaysOld)
    this->Draw();
  else
    this->Wait();
  this->Ticking = false;
}

} // namespace hasp
