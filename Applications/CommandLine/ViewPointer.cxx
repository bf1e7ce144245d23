#include "ViewPointer.h"

#include "StereoView.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

int Scaled(double device, int pixels)
{
  constexpr double rounding = 1e-6; // two pixels for one: their middles lie on borders
  return static_cast<int>(std::floor(0.5 * (device + 1.0) * pixels + rounding));
}

/// 1 for a button that goes down, -1 for one that comes up.
int Pressed(unsigned long event)
{
  switch (event)
  {
    case vtkCommand::LeftButtonPressEvent:
    case vtkCommand::MiddleButtonPressEvent:
    case vtkCommand::RightButtonPressEvent:
      return 1;
    case vtkCommand::LeftButtonReleaseEvent:
    case vtkCommand::MiddleButtonReleaseEvent:
    case vtkCommand::RightButtonReleaseEvent:
      return -1;
    default:
      return 0;
  }
}

} // namespace

ViewPointer::ViewPointer(vtkRenderWindowInteractor* interactor, const StereoView* eyes,
  const std::function<void()>& before)
  : Interactor(interactor),
    Eyes(eyes),
    Before(before)
{
  if (!eyes)
    return;
  this->First->SetClientData(this);
  this->First->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<ViewPointer*>(self)->Map(event); });
  this->First->PassiveObserverOn(); // called before all others, and while one has the focus
  for (const auto event : { vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
         vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent,
         vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent,
         vtkCommand::MouseMoveEvent, vtkCommand::MouseWheelForwardEvent,
         vtkCommand::MouseWheelBackwardEvent, vtkCommand::EnterEvent, vtkCommand::LeaveEvent })
    interactor->AddObserver(event, this->First);
}

ViewPointer::~ViewPointer()
{
  this->Interactor->RemoveObserver(this->First);
}

std::array<int, 2> ViewPointer::WindowPixel() const
{
  const int* at = this->Interactor->GetEventPosition();
  const Pixel here{ at[0], at[1] };
  // Some systems' keys bring a position with them, others leave the mouse's.
  return here == this->InView ? this->InWindow : here;
}

void ViewPointer::Map(unsigned long event)
{
  const bool held = this->Buttons > 0;
  this->Buttons = std::max(0, this->Buttons + Pressed(event));
  const int* at = this->Interactor->GetEventPosition();
  this->InWindow = { at[0], at[1] };
  const int* size = this->Interactor->GetRenderWindow()->GetSize();
  const Pixel last = this->InView;
  auto to = this->Eyes->PositionInView(at[0], at[1]);
  if (!held && to)
    this->RightEye = to->rightEye;
  if (held && (!to || (to->eyesApart && to->rightEye != this->RightEye)))
    to = this->Eyes->PositionInEye(this->RightEye, at[0], at[1]);
  if (to)
    this->InView = { Scaled(to->x, size[0]), Scaled(to->y, size[1]) };
  else if (!held) // beside what is seen
    this->InView = this->InWindow;
  this->Before();
  this->Interactor->SetEventPosition(this->InView[0], this->InView[1]);
  if (last[0] >= 0) // which VTK took from the window's pixel
    this->Interactor->SetLastEventPosition(last[0], last[1]);
}

} // namespace hasp
