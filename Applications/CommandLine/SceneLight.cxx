#include "SceneLight.h"

#include "Failure.h"
#include "SurfaceActors.h"

#if HASP_WITH_LIGHT
#include "Files.h"
#include "Light/RadianceFile.h"
#include "vtkHaspLightPass.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#endif

namespace hasp
{

bool SharesLight(const LightChoices& light, const SurfaceDrawing& drawing, std::size_t surfaces)
{
  return light.pathSamples ||
         (drawing.Lit() && drawing.mapper == "cells" && surfaces > 0 && !light.eyesApart);
}

#if HASP_WITH_LIGHT

struct SceneLight::Parts
{
  vtkRenderer* renderer;
  vtkNew<vtkHaspLightPass> pass;
  vtkNew<vtkCallbackCommand> samples;
  std::function<void(double)> progress;
};

SceneLight::SceneLight(
  vtkRenderer* renderer, const LightChoices& light, const SurfaceDrawing& drawing)
  : Self(std::make_unique<Parts>())
{
  Parts& self = *this->Self;
  self.renderer = renderer;
  if (light.pathSamples)
  {
    self.pass->SetModeToPathTraced();
    self.pass->SetSamplesPerPixel(*light.pathSamples);
    self.pass->SetBounces(light.bounces);
    self.pass->SetLampsInPaths(drawing.shadows);
    self.pass->SetWaitForSamples(!drawing.interactive);
    self.pass->SetTemporalAccumulation(drawing.interactive);
    if (!light.environment.empty())
    {
      try
      {
        ReadRadianceFile(
          light.environment); // what is wrong with it is said before anything is drawn
      }
      catch (const std::exception& e)
      {
        throw Failure(ExitCode::BadInput, e.what());
      }
      self.pass->SetEnvironmentFileName(light.environment.c_str());
    }
    // Patients stand along z and look along -y: the map's centre is before the face.
    renderer->SetEnvironmentUp(0, 0, 1);
    renderer->SetEnvironmentRight(0, -1, 0);
  }
  else
  {
    self.pass->SetMode(
      drawing.ambientOcclusionMm ? vtkHaspLightPass::AmbientOcclusion : vtkHaspLightPass::Lamps);
    if (drawing.ambientOcclusionMm)
      self.pass->SetAmbientOcclusionDistance(*drawing.ambientOcclusionMm);
    self.pass->SetShadows(drawing.shadows);
  }
  self.samples->SetClientData(&self);
  self.samples->SetCallback(
    [](vtkObject*, unsigned long, void* parts, void* share)
    {
      if (const auto& progress = static_cast<Parts*>(parts)->progress)
        progress(*static_cast<double*>(share));
    });
  self.pass->AddObserver(vtkCommand::ProgressEvent, self.samples);
  renderer->SetPass(self.pass);
}

SceneLight::~SceneLight()
{
  Parts& self = *this->Self;
  self.renderer->SetPass(nullptr); // which leaves the GPU's part of it to the pass
  if (vtkRenderWindow* window = self.renderer->GetRenderWindow())
  {
    window->MakeCurrent();
    self.pass->ReleaseGraphicsResources(window);
  }
}

bool SceneLight::Refining() const
{
  // Openness is refined by the scene's frames.
  return this->Self->pass->GetMode() == vtkHaspLightPass::PathTraced &&
         this->Self->pass->IsRefining();
}

void SceneLight::SetWaitForSamples(bool wait)
{
  this->Self->pass->SetWaitForSamples(wait);
}

void SceneLight::SetProgress(std::function<void(double share)> progress)
{
  this->Self->progress = std::move(progress);
}

void SceneLight::ListResources(ResourceList& list) const
{
  this->Self->pass->ListResources(list);
}

#else

struct SceneLight::Parts
{
};

SceneLight::SceneLight(vtkRenderer*, const LightChoices&, const SurfaceDrawing&)
{
  throw Failure(ExitCode::CannotDraw,
    "light of surfaces on each other takes traced rays: this build of Hasp was made without "
    "Embree; "
    "configure it with HASP_ENABLE_EMBREE=ON (Debian: libembree-dev)");
}

SceneLight::~SceneLight() = default;

bool SceneLight::Refining() const
{
  return false;
}

void SceneLight::SetWaitForSamples(bool) {}

void SceneLight::SetProgress(std::function<void(double share)>) {}

void SceneLight::ListResources(ResourceList&) const {}

#endif

} // namespace hasp
