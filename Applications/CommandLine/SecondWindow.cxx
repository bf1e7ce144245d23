#include "SecondWindow.h"

#include "vtkCommand.h"

namespace hasp
{

SecondWindow::SecondWindow(vtkRenderWindowInteractor* main, std::array<int, 2> size,
  const std::optional<std::array<int, 2>>& at)
  : Main(main)
{
  this->Shown->SetWindowName("hasp view, right eye");
  this->Shown->SetSize(size[0], size[1]);
  if (at)
  {
    this->Shown->BordersOff();
    this->Shown->SetPosition((*at)[0], (*at)[1]);
  }
  this->Own->SetInteractorStyle(nullptr);
  this->Own->SetRenderWindow(this->Shown);
  this->Own->EnableRenderOff(); // the main window's frame draws both
  for (const unsigned long event :
    { vtkCommand::RenderEvent, vtkCommand::ExitEvent, vtkCommand::KeyPressEvent })
    this->Own->AddObserver(event, this, &SecondWindow::Pass);
  this->Own->Initialize(); // VTK 9.1 crashes at the end where the window opened the display
}

SecondWindow::~SecondWindow()
{
  this->Own->RemoveAllObservers();
}

void SecondWindow::Pass(vtkObject*, unsigned long event, void*)
{
  if (event == vtkCommand::KeyPressEvent)
    this->Main->SetKeySym(this->Own->GetKeySym());
  this->Main->InvokeEvent(event);
}

} // namespace hasp
