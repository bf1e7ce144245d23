// The demo's plate with its screws on the phantom's jaw: from outside, and without bone from
// inside.
#include "Grid/Phantom.h"
#include "vtkHaspPlateFilter.h"
#include "vtkHaspVolumeView.h"

#include "HaspRenderTest.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkLineSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"

namespace
{

void Add(vtkRenderer* renderer, vtkAlgorithm* part, double r, double g, double b)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(part->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat(); // an edge has no normal
  actor->GetProperty()->SetColor(r, g, b);
  renderer->AddActor(actor);
}

/// A rod along a screw's axis, from and to mm below the plate's outer face.
void AddRod(vtkRenderer* renderer, const double* screw, double from, double to, double radius)
{
  vtkNew<vtkLineSource> line;
  const glm::dvec3 outer(screw[0], screw[1], screw[2]), axis(screw[3], screw[4], screw[5]);
  line->SetPoint1(&(outer - from * axis)[0]);
  line->SetPoint2(&(outer - to * axis)[0]);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(line->GetOutputPort());
  tube->SetRadius(radius);
  tube->SetNumberOfSides(48);
  tube->CappingOn();
  Add(renderer, tube, 0.85, 0.65, 0.25);
}

void Look(vtkRenderer* renderer, const glm::dvec3& from, double angle)
{
  renderer->SetBackground(0.1, 0.15, 0.2);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(-26, -67, -95);
  camera->SetPosition(from.x, from.y, from.z);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(angle);
  renderer->ResetCameraClippingRange();
}

} // namespace

int TestBonePlateOnBone(int argc, char* argv[])
{
  hasp::GridGeometry grid;
  grid.origin = { -70, -100, -115 };
  grid.dims = { 141, 100, 60 };
  const auto scan = hasp::MakeImage(grid, hasp::SamplePhantom(grid));
  vtkNew<vtkHaspPlateFilter> plate;
  plate->SetInputData(scan);
  if (!plate->ReadRecipe(HASP_TEST_RECIPE))
    return 1;
  plate->Update();
  vtkNew<vtkFlyingEdges3D> bone;
  bone->SetInputData(scan);
  bone->SetValue(0, 226);

  vtkNew<vtkRenderWindow> window;
  window->SetSize(640, 560);
  window->SetMultiSamples(0);
  vtkNew<vtkRenderer> outside, inside;
  outside->SetViewport(0.0, 0.4, 1.0, 1.0);
  inside->SetViewport(0.0, 0.0, 1.0, 0.4);
  Add(outside, bone, 0.9, 0.85, 0.7);
  vtkDataArray* screws = plate->GetOutput()->GetFieldData()->GetArray("ScrewAxes");
  for (vtkRenderer* renderer : { outside.Get(), inside.Get() })
  {
    Add(renderer, plate, 0.75, 0.8, 0.85);
    window->AddRenderer(renderer);
    for (vtkIdType n = 0; screws && n < screws->GetNumberOfTuples(); ++n)
    {
      AddRod(renderer, screws->GetTuple(n), 0.2, 0.8, 1.7);
      AddRod(renderer, screws->GetTuple(n), 0.2, 10.7, 1.15);
    }
  }
  Look(outside, { -130, -150, -60 }, 15);
  Look(inside, { 50, -10, -85 }, 13);
  window->Render();
  return hasp::CheckPicture(window, argc, argv);
}
