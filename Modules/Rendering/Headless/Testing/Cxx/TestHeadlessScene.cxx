// An opaque ball half behind a translucent one, a bar through both: VTK's opaque and translucent
// passes, depth and shading without a display.
#include "HaspRenderTest.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

namespace
{

vtkNew<vtkActor> MakeActor(vtkAlgorithm* source, double red, double green, double blue)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  actor->GetProperty()->SetSpecular(0.4);
  actor->GetProperty()->SetSpecularPower(30);
  return actor;
}

vtkNew<vtkSphereSource> MakeBall(double x, double z, double radius)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(x, 0, z);
  ball->SetRadius(radius);
  ball->SetThetaResolution(60);
  ball->SetPhiResolution(40);
  return ball;
}

} // namespace

int TestHeadlessScene(int argc, char* argv[])
{
  const vtkNew<vtkSphereSource> farBall = MakeBall(-0.5, -1, 1);
  const vtkNew<vtkSphereSource> nearBall = MakeBall(0.6, 1, 0.8);
  vtkNew<vtkCubeSource> bar;
  bar->SetXLength(4);
  bar->SetYLength(0.3);
  bar->SetZLength(0.3);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.15, 0.2);
  renderer->AddActor(MakeActor(farBall, 0.9, 0.85, 0.7));
  renderer->AddActor(MakeActor(bar, 0.8, 0.3, 0.3));
  const vtkNew<vtkActor> glass = MakeActor(nearBall, 0.4, 0.6, 0.9);
  glass->GetProperty()->SetOpacity(0.5);
  renderer->AddActor(glass);

  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 200);
  window->AddRenderer(renderer);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Azimuth(20);
  renderer->GetActiveCamera()->Elevation(15);
  renderer->GetActiveCamera()->Zoom(2);
  renderer->ResetCameraClippingRange();
  window->Render();
  return hasp::CheckPicture(window, argc, argv);
}
