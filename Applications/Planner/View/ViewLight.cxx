#include "View/ViewLight.h"

#include "View/SceneView.h"

#if HASP_WITH_LIGHT
#include "vtkHaspLightPass.h"

#include "vtkRenderer.h"
#endif

namespace hasp
{

namespace
{

constexpr int BetterMs = 100;      // between frames of paths
constexpr int DarkeningFrames = 8; // of a view at rest: openness of some hundred samples

} // namespace

#if HASP_WITH_LIGHT

struct ViewLight::Pass
{
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
  this->Better.stop();
  if (this->Made)
    this->Made->frames = 0;
  if (mode == Plain)
  {
    this->Of.Renderer()->SetPass(nullptr);
    this->Made.reset();
  }
  else if (!this->Made)
  {
    this->Made = std::make_unique<Pass>();
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
  const bool rests = !this->Of.IsMoving();
  this->Made->frames = rests ? this->Made->frames + 1 : 0;
  this->Made->pass->SetMode(this->Chosen == AmbientOcclusion ? vtkHaspLightPass::AmbientOcclusion
                            : rests                          ? vtkHaspLightPass::PathTraced
                                                             : vtkHaspLightPass::Traced);
}

bool ViewLight::Finish()
{
  if (!this->Made)
    return false;
  if (this->Of.IsMoving())
  {
    this->Better.start(BetterMs); // till it rests
    return false;
  }
  if (this->Chosen == AmbientOcclusion)
    return this->Made->frames < DarkeningFrames;
  if (this->Made->pass->IsRefining())
    this->Better.start(BetterMs);
  return false;
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

ViewLight::ViewLight(SceneView& view) : Of(view)
{
  this->Better.setSingleShot(true);
  QObject::connect(&this->Better, &QTimer::timeout, this, [this] { this->Of.Draw(); });
}

ViewLight::~ViewLight()
{
  this->SetMode(Plain);
}

} // namespace hasp
