#include "DrawnEye.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

class DrawnEye::Observer : public vtkCommand
{
public:
  static Observer* New() { return new Observer; }
  void Execute(vtkObject* renderer, unsigned long, void*) override
  {
    static_cast<vtkRenderer*>(renderer)->GetActiveCamera()->SetLeftEye(this->Left);
  }
  bool Left = true;
};

DrawnEye::DrawnEye(vtkRenderer* renderer, bool left) : Renderer(renderer)
{
  vtkNew<Observer> observer;
  observer->Left = left;
  this->Tag = renderer->AddObserver(vtkCommand::StartEvent, observer);
}

DrawnEye::~DrawnEye()
{
  if (!this->Renderer)
    return;
  this->Renderer->RemoveObserver(this->Tag);
  this->Renderer->GetActiveCamera()->SetLeftEye(true);
}
