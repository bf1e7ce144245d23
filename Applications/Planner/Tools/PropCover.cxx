#include "Tools/PropCover.h"

#include "View/FrameView.h"

#include "vtkProp.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace hasp
{

void PropCover::Set(const std::vector<vtkProp*>& props)
{
  vtkRenderer* renderer = this->In.Renderer();
  for (const vtkWeakPointer<vtkProp>& prop : this->Covered)
    if (prop && std::find(props.begin(), props.end(), prop) == props.end())
      renderer->AddViewProp(prop);
  this->Covered.assign(props.begin(), props.end());
  for (vtkProp* prop : props)
    if (renderer->HasViewProp(prop))
    {
      renderer->GetRenderWindow()->MakeCurrent(); // what it has on the graphics card goes
      renderer->RemoveViewProp(prop);
    }
  this->In.Draw();
}

} // namespace hasp
