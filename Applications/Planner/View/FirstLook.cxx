#include "View/FirstLook.h"

#include "View/SceneCamera.h"
#include "View/SceneLayers.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

namespace hasp
{

FirstLook::Look FirstLook::LookOf(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  Look look{};
  camera->GetPosition(look.data());
  camera->GetFocalPoint(look.data() + 3);
  camera->GetViewUp(look.data() + 6);
  look[9] = camera->GetParallelScale();
  return look;
}

void FirstLook::Begin(bool awaitsFragments)
{
  this->Seen = Nothing;
  this->AwaitsFragments = awaitsFragments;
}

void FirstLook::Follow(vtkRenderer* renderer, const SceneLayers& layers)
{
  const auto put = [&](const vtkBoundingBox& box)
  {
    LookFromSide(renderer, box, 'A');
    this->Put = LookOf(renderer);
  };
  const vtkBoundingBox bone = layers.BoneBounds(), all = layers.Bounds();
  const auto now = bone.IsValid() ? Bone : all.IsValid() ? Something : Nothing;
  if (now > this->Seen)
    put(all);
  this->Seen = now > this->Seen ? now : this->Seen;
  if (!this->AwaitsFragments || !layers.fragments.AreThere())
    return;
  this->AwaitsFragments = false;
  if (this->Put == LookOf(renderer))
    put(bone);
}

} // namespace hasp
