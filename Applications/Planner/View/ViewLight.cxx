#include "View/ViewLight.h"

#include "View/SceneView.h"

#if HASP_WITH_LIGHT
#include "vtkHaspLightPass.h"

#include "vtkCommand.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#endif

namespace hasp
{

#if HASP_WITH_LIGHT

namespace
{

constexpr int BetterMs = 100;      // between frames of paths
constexpr int DarkeningFrames = 8; // of a view at rest: openness of some hundred samples
constexpr int StillFrames = 64;    // by which the pass refines openness, for the share done

} // namespace

struct ViewLight::Pass
{
  explicit Pass(SceneView& view) : of(view)
  {
    this->pass->AddObserver(vtkCommand::ProgressEvent, this, &Pass::Tell);
  }
  ~Pass()
  {
    // Parts of VTK's passes need the window to free what they have on the GPU.
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->of.renderWindow());
    window->PushContext();
    this->pass->ReleaseGraphicsResources(window);
    window->PopContext();
  }
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  /// While the pass waits for samples.
  void Tell(vtkObject*, unsigned long, void* share)
  {
    if (!this->of.Report(*static_cast<double*>(share)))
      this->pass->WaitForSamplesOff();
  }

  SceneView& of;
  vtkNew<vtkHaspLightPass> pass;
  int frames = 0; ///< at rest
};

bool ViewLight::IsThere()
{
  return true;
}

void ViewLight::SetMode(Mode mode)
{
  if (mode == this->Chosen)
    return;
  this->Chosen = mode;
  if (this->Made)
    this->Made->frames = 0;
  if (mode == Plain)
  {
    this->Of.Renderer()->SetPass(nullptr);
    this->Made.reset();
  }
  else if (!this->Made)
  {
    this->Made = std::make_unique<Pass>(this->Of);
    this->Made->pass->ShadowsOff(); // the view's two lamps go with the viewer
    // Patients stand along z and look along -y: daylight comes from before the face.
    this->Of.Renderer()->SetEnvironmentUp(0, 0, 1);
    this->Of.Renderer()->SetEnvironmentRight(0, -1, 0);
    this->Of.Renderer()->SetPass(this->Made->pass);
  }
  this->Of.Draw();
}

void ViewLight::Prepare()
{
  if (!this->Made)
    return;
  const bool complete = this->Of.IsCompleting(), rests = complete || !this->Of.IsMoving();
  this->Made->frames = rests ? this->Made->frames + 1 : 0;
  this->Made->pass->SetWaitForSamples(complete);
  this->Made->pass->SetMode(this->Chosen == AmbientOcclusion ? vtkHaspLightPass::AmbientOcclusion
                            : rests                          ? vtkHaspLightPass::PathTraced
                                                             : vtkHaspLightPass::Traced);
}

bool ViewLight::Finish()
{
  if (!this->Made)
    return false;
  if (this->Of.IsCompleting())
    return this->Complete();
  if (this->Of.IsMoving())
  {
    this->Of.DrawIn(BetterMs); // till it rests
    return false;
  }
  if (this->Chosen == AmbientOcclusion)
    return this->Made->frames < DarkeningFrames;
  if (this->Made->pass->IsRefining())
    this->Of.DrawIn(BetterMs);
  return false;
}

/// Also with all paths, for the pass shows what it keeps on surfaces beside them.
bool ViewLight::Complete()
{
  const Pass& made = *this->Made;
  if (made.frames >= DarkeningFrames && !made.pass->IsRefining())
    return false;
  const bool awaited = this->Of.Report(
    this->Chosen == Traced ? double(made.pass->GetSamples()) / made.pass->GetSamplesPerPixel()
                           : std::min(1.0, double(made.frames) / StillFrames));
  if (!awaited)
    this->Of.DrawIn(BetterMs); // better as ever
  return awaited;
}

void ViewLight::ListResources(ResourceList& list) const
{
  if (this->Made)
    this->Made->pass->ListResources(list);
  else
    list.push_back({ "light", 0, 0.0, "plain: as the mappers shade" });
}

#else

struct ViewLight::Pass
{
};

bool ViewLight::IsThere()
{
  return false;
}

void ViewLight::SetMode(Mode) {}

void ViewLight::Prepare() {}

bool ViewLight::Finish()
{
  return false;
}

void ViewLight::ListResources(ResourceList& list) const
{
  list.push_back({ "light", 0, 0.0, "plain: this build is without Embree" });
}

#endif

ViewLight::ViewLight(SceneView& view) : Of(view) {}

ViewLight::~ViewLight()
{
  this->SetMode(Plain);
}

} // namespace hasp
