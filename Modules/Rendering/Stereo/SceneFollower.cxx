#include "SceneFollower.h"

#include "vtkLightCollection.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkTexture.h"

#include <vector>

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
  std::vector<vtkProp*> gone;
  vtkCollectionSimpleIterator at;
  this->Own->GetViewProps()->InitTraversal(at);
  while (vtkProp* prop = this->Own->GetViewProps()->GetNextProp(at))
    if (!scene->HasViewProp(prop))
      gone.push_back(prop);
  for (vtkProp* prop : gone)
    this->Own->RemoveViewProp(prop);
  scene->GetViewProps()->InitTraversal(at);
  while (vtkProp* prop = scene->GetViewProps()->GetNextProp(at))
    this->Own->AddViewProp(prop); // nothing if it is there already

  if (scene->GetLights()->GetNumberOfItems() > 0 && this->Own->GetLights() != scene->GetLights())
    this->Own->SetLightCollection(scene->GetLights());
  this->Own->SetAutomaticLightCreation(scene->GetAutomaticLightCreation());
  this->Own->SetTwoSidedLighting(scene->GetTwoSidedLighting());
  this->Own->SetAmbient(scene->GetAmbient());
  this->Own->SetBackground(scene->GetBackground());
  this->Own->SetBackground2(scene->GetBackground2());
  this->Own->SetBackgroundAlpha(scene->GetBackgroundAlpha());
  this->Own->SetGradientBackground(scene->GetGradientBackground());
  this->Own->SetBackgroundTexture(scene->GetBackgroundTexture());
  this->Own->SetTexturedBackground(scene->GetTexturedBackground());
  this->Own->SetUseDepthPeeling(scene->GetUseDepthPeeling());
  this->Own->SetMaximumNumberOfPeels(scene->GetMaximumNumberOfPeels());
  this->Own->SetOcclusionRatio(scene->GetOcclusionRatio());
  this->Own->SetUseFXAA(scene->GetUseFXAA());
  this->Own->SetUseShadows(scene->GetUseShadows());
  this->Own->SetUseHiddenLineRemoval(scene->GetUseHiddenLineRemoval());
  this->Own->SetEnvironmentTexture(scene->GetEnvironmentTexture());
  this->Own->SetUseImageBasedLighting(scene->GetUseImageBasedLighting());
  this->Own->SetNearClippingPlaneTolerance(scene->GetNearClippingPlaneTolerance());
  this->Own->SetClippingRangeExpansion(scene->GetClippingRangeExpansion());
  this->Own->SetActiveCamera(scene->GetActiveCamera());
}
