// A plate with holes and an engraved label, by the sharp contour above and Flying Edges below, on
// the same grid: edges, and what is left of them.
#include "vtkHaspCsg.h"
#include "vtkHaspSharpContour.h"
#include "vtkHaspSolidSource.h"

#include "HaspRenderTest.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

int TestPlatePicture(int argc, char* argv[])
{
  vtkNew<vtkHaspSolidSource> body, left, right, label;
  const double a[3] = { -9, 0, 0 }, b[3] = { 9, 0, 0 }, up[3] = { 0, 0, 1 };
  const double a0[3] = { -9, 0, -2 }, a1[3] = { -9, 0, 2 };
  const double b0[3] = { 9, 0, -2 }, b1[3] = { 9, 0, 2 };
  const double origin[3] = { -5.4, -1.8, 1 }, along[3] = { 1, 0, 0 }, upward[3] = { 0, 1, 0 };
  if (!body->SetToStadium(a, b, up, 4.0, 2.0) || !left->SetToCylinder(a0, a1, 1.5) ||
      !right->SetToCylinder(b0, b1, 1.5) ||
      !label->SetToText("R-27", origin, along, upward, 3.6, 0.6))
    return 1;
  vtkNew<vtkHaspCsg> plate;
  plate->SetOperationToDifference();
  for (vtkHaspSolidSource* part : { body.Get(), left.Get(), right.Get(), label.Get() })
    plate->AddInputConnection(part->GetOutputPort());

  vtkNew<vtkRenderWindow> window;
  window->SetSize(420, 400);
  window->SetMultiSamples(0);
  for (const int method : { vtkHaspSharpContour::SharpContour, vtkHaspSharpContour::FlyingEdges })
  {
    vtkNew<vtkHaspSharpContour> contour;
    contour->SetInputConnection(plate->GetOutputPort());
    contour->SetMethod(method);
    contour->SetSpacing(0.4);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(contour->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToFlat(); // an edge has no normal
    actor->GetProperty()->SetColor(0.75, 0.8, 0.85);
    vtkNew<vtkRenderer> renderer;
    const bool sharp = method == vtkHaspSharpContour::SharpContour;
    renderer->SetViewport(0.0, sharp ? 0.5 : 0.0, 1.0, sharp ? 1.0 : 0.5);
    renderer->SetBackground(0.1, 0.15, 0.2);
    renderer->AddActor(actor);
    window->AddRenderer(renderer);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(6, -34, 34);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0, 0, 1);
    camera->SetViewAngle(18);
    renderer->ResetCameraClippingRange();
  }
  window->Render();
  return hasp::CheckPicture(window, argc, argv);
}
