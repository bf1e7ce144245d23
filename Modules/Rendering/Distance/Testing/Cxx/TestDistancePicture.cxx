// A ball that is pushed into another: blue where it is inside, red where it stands off, 3 mm.
#include "vtkHaspDistanceColours.h"
#include "vtkHaspSurfaceDistance.h"

#include "HaspRenderTest.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkSphereSource.h"

int TestDistancePicture(int argc, char* argv[])
{
  vtkNew<vtkSphereSource> ball, other;
  for (vtkSphereSource* sphere : { ball.Get(), other.Get() })
  {
    sphere->SetRadius(20.0);
    sphere->SetThetaResolution(160);
    sphere->SetPhiResolution(120);
  }
  vtkNew<vtkMatrix4x4> pose;
  pose->SetElement(0, 3, 3.0);
  vtkNew<vtkHaspSurfaceDistance> distance;
  distance->SetInputConnection(ball->GetOutputPort());
  distance->SetReferenceConnection(other->GetOutputPort());
  distance->SetSurfaceToReference(pose);
  distance->SetSpacing(0.5);
  const auto colours = hasp::MakeDistanceColours({ 3.0 });
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(distance->GetOutputPort());
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn(); // fixed, whatever the data
  mapper->InterpolateScalarsBeforeMappingOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetUserMatrix(pose);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.15, 0.2);
  renderer->AddActor(actor);
  renderer->AddActor2D(hasp::MakeDistanceScale(colours));
  vtkNew<vtkRenderWindow> window;
  window->SetSize(420, 320);
  window->SetMultiSamples(0);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(3, -120, 0);
  renderer->GetActiveCamera()->SetFocalPoint(7, 0, 0);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->ResetCameraClippingRange();
  window->Render();
  return hasp::CheckPicture(window, argc, argv);
}
