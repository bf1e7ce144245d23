#include "View/SceneStyle.h"

#include "vtkObjectFactory.h"

namespace hasp
{

vtkStandardNewMacro(SceneStyle);

void SceneStyle::OnLeftButtonDown()
{
  if (!this->isSecondPress())
    this->Superclass::OnLeftButtonDown();
}

void SceneStyle::OnMiddleButtonDown()
{
  if (!this->isSecondPress())
    this->Superclass::OnMiddleButtonDown();
}

void SceneStyle::OnRightButtonDown()
{
  if (!this->isSecondPress())
    this->Superclass::OnRightButtonDown();
}

} // namespace hasp
