#include "SceneFollower.h"

#include "vtkFXAAOptions.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <unordered_set>
#include <vector>

namespace
{

std::vector<vtkProp*> PropsOf(vtkRenderer* renderer)
{
  std::vector<vtkProp*> props;
  vtkCollectionSimpleIterator at;
  renderer->GetViewProps()->InitTraversal(at);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(at))
    props.push_back(prop);
  return props;
}

void FollowEnvironment(vtkOpenGLRenderer* own, vtkOpenGLRenderer* scene)
{
  own->SetUseImageBasedLighting(scene->GetUseImageBasedLighting());
  own->SetUseSphericalHarmonics(scene->GetUseSphericalHarmonics());
  own->SetEnvironmentUp(scene->GetEnvironmentUp());
  own->SetEnvironmentRight(scene->GetEnvironmentRight());
  own->SetUserLightTransform(scene->GetUserLightTransform());
  own->SetEnvironmentTexture(
    scene->GetEnvironmentTexture(), scene->GetEnvMapIrradiance()->GetConvertToLinear());
}

} // namespace

SceneFollower::SceneFollower(vtkRenderWindow* window)
{
  window->AddRenderer(this->Own);
}

SceneFollower::~SceneFollower()
{
  if (vtkRenderWindow* window = this->Own->GetRenderWindow())
    window->RemoveRenderer(this->Own);
}

void SceneFollower::Follow(vtkRenderer* scene)
{
  this->FollowProps(scene);
  if (scene->GetLights()->GetNumberOfItems() > 0 && this->Own->GetLights() != scene->GetLights())
    this->Own->SetLightCollection(scene->GetLights());
  this->FollowLook(scene);
  if (auto* own = vtkOpenGLRenderer::SafeDownCast(this->Own))
    if (auto* other = vtkOpenGLRenderer::SafeDownCast(scene))
      FollowEnvironment(own, other);
  this->Own->SetActiveCamera(scene->GetActiveCamera());
}

/// What is drawn later lies on top, so the order is followed too. Of many props, a few come and go.
void SceneFollower::FollowProps(vtkRenderer* scene)
{
  const std::vector<vtkProp*> wanted = PropsOf(scene), shown = PropsOf(this->Own);
  if (wanted == shown)
    return;
  const std::unordered_set<vtkProp*> now(wanted.begin(), wanted.end());
  const std::unordered_set<vtkProp*> before(shown.begin(), shown.end());
  for (vtkProp* prop : shown)
    if (!now.contains(prop))
      this->Own->RemoveViewProp(prop);
  for (vtkProp* prop : wanted)
    if (!before.contains(prop))
      this->Own->AddViewProp(prop);
  vtkPropCollection* order = this->Own->GetViewProps(); // the renderer stays their consumer
  order->RemoveAllItems();
  for (vtkProp* prop : wanted)
    order->AddItem(prop);
}

void SceneFollower::FollowLook(vtkRenderer* scene)
{
  this->Own->SetDraw(scene->GetDraw());
  this->Own->SetAutomaticLightCreation(scene->GetAutomaticLightCreation());
  this->Own->SetLightFollowCamera(scene->GetLightFollowCamera());
  this->Own->SetTwoSidedLighting(scene->GetTwoSidedLighting());
  this->Own->SetAmbient(scene->GetAmbient());
  this->Own->SetBackground(scene->GetBackground());
  this->Own->SetBackground2(scene->GetBackground2());
  this->Own->SetBackgroundAlpha(scene->GetBackgroundAlpha());
  this->Own->SetGradientBackground(scene->GetGradientBackground());
  this->Own->SetBackgroundTexture(scene->GetBackgroundTexture());
  this->Own->SetTexturedBackground(scene->GetTexturedBackground());
  this->Own->SetUseDepthPeeling(scene->GetUseDepthPeeling());
  this->Own->SetUseDepthPeelingForVolumes(scene->GetUseDepthPeelingForVolumes());
  this->Own->SetMaximumNumberOfPeels(scene->GetMaximumNumberOfPeels());
  this->Own->SetOcclusionRatio(scene->GetOcclusionRatio());
  this->Own->SetUseSSAO(scene->GetUseSSAO());
  this->Own->SetSSAORadius(scene->GetSSAORadius());
  this->Own->SetSSAOBias(scene->GetSSAOBias());
  this->Own->SetSSAOKernelSize(scene->GetSSAOKernelSize());
  this->Own->SetSSAOBlur(scene->GetSSAOBlur());
  this->Own->SetUseFXAA(scene->GetUseFXAA());
  this->Own->SetFXAAOptions(scene->GetFXAAOptions());
  this->Own->SetUseShadows(scene->GetUseShadows());
  this->Own->SetUseHiddenLineRemoval(scene->GetUseHiddenLineRemoval());
  this->Own->SetNearClippingPlaneTolerance(scene->GetNearClippingPlaneTolerance());
  this->Own->SetClippingRangeExpansion(scene->GetClippingRangeExpansion());
}
