// Forces about a plate; the longest is cut at the cap.
#include "vtkHaspForceArrows.h"

#include "HaspRenderTest.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

int TestForceArrows(int argc, char* argv[])
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.15, 0.2);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(300, 240);
  window->SetMultiSamples(0);
  window->AddRenderer(renderer);

  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(-20, -15, 0);
  plate->SetPoint1(20, -15, 0);
  plate->SetPoint2(-20, 15, 0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plate->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);

  vtkNew<vtkHaspForceArrows> arrows;
  arrows->GetProperty()->SetColor(0.9, 0.3, 0.2);
  arrows->SetMmPerNewton(8.0);
  arrows->SetMaximumMm(24.0);
  arrows->SetArrows({ { { -20, -15, 0 }, { 0, 0, 1 } }, { { 20, -15, 0 }, { 0.5, 0, 2 } },
    { { 0, 15, 0 }, { -1, 0, 100 } }, { { 20, 15, 0 }, { 1.5, 0.5, 0 } } });
  renderer->AddActor(arrows);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(30, -90, 50);
  camera->SetFocalPoint(0, 0, 6);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCameraClippingRange();
  window->Render();
  return hasp::CheckPicture(window, argc, argv);
}
