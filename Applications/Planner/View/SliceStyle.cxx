#include "View/SliceStyle.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"

namespace hasp
{

vtkStandardNewMacro(SliceStyle);

void SliceStyle::Tell(SliceMouse::What what, SliceMouse::Button button)
{
  if (this->tell)
    this->tell({ what, button, this->Interactor->GetShiftKey() != 0 });
}

} // namespace hasp
