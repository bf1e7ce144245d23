// A head's skin over opaque bone, with a translucent part of polydata in the hole of the skull and
// the ghost of the bone turned aside, by depth peeling.
#include "Grid/Phantom.h"
#include "HaspRenderTest.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

namespace
{

vtkActor* Add(vtkRenderer* renderer, vtkMapper* mapper, const glm::dvec3& color, double opacity)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.x, color.y, color.z);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkHaspClusteredCellMapper> Cells(vtkImageData* image, double isovalue)
{
  auto mapper = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
  mapper->SetInputData(image);
  mapper->SetIsoValue(isovalue);
  mapper->SetRendererToRasterize(); // not what a measurement says
  return mapper;
}

} // namespace

int TestTranslucentHead(int argc, char* argv[])
{
  hasp::PhantomSettings settings;
  settings.blurMm = glm::dvec3(0.8);
  const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(2), settings);
  const auto image = hasp::MakeImage(grid, hasp::SamplePhantom(grid, settings));
  const hasp::PhantomDefect hole = hasp::DefectOf(settings);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.12, 0.16);
  renderer->UseDepthPeelingOn();
  renderer->SetMaximumNumberOfPeels(12);
  renderer->SetOcclusionRatio(0.0);
  const auto bone = Cells(image, 226);
  Add(renderer, bone, { 0.9, 0.85, 0.7 }, 1.0);
  Add(renderer, Cells(image, -400), { 0.9, 0.65, 0.55 }, 0.3);
  vtkActor* ghost = Add(renderer, bone, { 0.3, 0.8, 0.4 }, 0.25);
  ghost->RotateZ(25);
  ghost->AddPosition(0, 0, 25);
  vtkNew<vtkSphereSource> part;
  part->SetCenter(hole.center.x, hole.center.y, hole.center.z);
  part->SetRadius(0.6 * hole.lengthMm);
  part->SetThetaResolution(60);
  part->SetPhiResolution(40);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(part->GetOutputPort());
  Add(renderer, mapper, { 0.2, 0.5, 0.9 }, 0.5);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(-330, -420, 190);
  camera->SetFocalPoint(0, 0, 5);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(26);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(400, 400);
  window->SetMultiSamples(0);
  window->AddRenderer(renderer);
  window->Render();
  return hasp::CheckPicture(window, argc, argv);
}
