#include "WindowTextures.h"

#include "vtkActor.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkVolume.h"

#include <string>

void ReleaseTextures(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  for (vtkTexture* texture :
    { renderer->GetBackgroundTexture(), renderer->GetEnvironmentTexture() })
    if (texture)
      texture->ReleaseGraphicsResources(window);
  vtkCollectionSimpleIterator at;
  renderer->GetViewProps()->InitTraversal(at);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(at))
  {
    if (auto* actor = vtkActor::SafeDownCast(prop))
    {
      if (vtkTexture* texture = actor->GetTexture())
        texture->ReleaseGraphicsResources(window);
      for (const auto& [name, texture] : actor->GetProperty()->GetAllTextures())
        texture->ReleaseGraphicsResources(window);
    }
    else if (!vtkVolume::SafeDownCast(prop))
      prop->ReleaseGraphicsResources(window);
  }
}
