// PressBalls: a window with two balls; drag the small one with the left button, and press
#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <iostream>

vtkSmartPointer<vtkActor> Ball(double radiusMm, double x)
{
  vtkNew<vtkSphereSource> sphere; // or a vtkHaspClusteredCellMapper: an isosurface
  sphere->SetRadius(radiusMm);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(x, 0.0, 0.0);
  return actor;
}

int main()
{
  if (hasp::UseHeadlessWindows()) // else VTK's windows end the program without a word
  {
    std::cerr << "This program needs a display\n";
    return 1;
  }
  const auto ground = Ball(30.0, 0.0), fragment = Ball(12.0, 50.0);
  fragment->GetProperty()->SetColor(0.9, 0.8, 0.5);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(ground);
  renderer->AddActor(fragment);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  vtkNew<vtkInteractorStyleTrackballCamera> style; // a drag beside the tools turns the camera
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(style);

  vtkNew<vtkHaspHapticInteractor> haptic;
  haptic->SetRenderer(renderer);    // its window has an interactor
  haptic->AddTouchable(ground);     // an actor: vtkHaspClusteredCellMapper, or a closed surface
  haptic->AddTool(fragment);        // in hand while the left button is held
  haptic->SetShowForces(true);      // arrows
  vtkNew<vtkCallbackCommand> ready; // until then a press turns the camera
  ready->SetCallback([](vtkObject*, unsigned long, void*, void*)
    { std::cout << "Ready: drag the small ball onto the large one\n"
                << std::flush; });
  haptic->AddObserver(vtkHaspHapticInteractor::ReadyEvent, ready);
  if (!haptic->UseMouse() || !haptic->Start()) // or SetDevice
    return 1;
  interactor->Start();
}
