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
    { vtkCommand::RenderEvent, vtkCommand::ExitEvent, vtkCommand::KeyPressEvent,
      vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
      vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent,
      vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent,
      vtkCommand::MouseMoveEvent, vtkCommand::MouseWheelForwardEvent,
      vtkCommand::MouseWheelBackwardEvent, vtkCommand::EnterEvent, vtkCommand::LeaveEvent })
    this->Own->AddObserver(event, this, &SecondWindow::Pass);
  this->Own->Initialize(); // VTK 9.1 crashes at the end where the window opened the display
}

SecondWindow::~SecondWindow()
{
  this->Own->RemoveAllObservers();
}

void SecondWindow::Pass(vtkObject*, unsigned long event, void*)
{
  if (event == vtkCommand::RenderEvent || event == vtkCommand::ExitEvent)
  {
    this->Main->InvokeEvent(event);
    return;
  }
  const int* at = this->Own->GetEventPosition();
  this->Main->SetEventInformation(at[0], at[1], this->Own->GetControlKey(),
    this->Own->GetShiftKey(), this->Own->GetKeyCode(), this->Own->GetRepeatCount(),
    this->Own->GetKeySym());
  if (this->Here)
    this->Here(true);
  this->Main->InvokeEvent(event);
  if (this->Here)
    this->Here(false);
}

} // namespace hasp
