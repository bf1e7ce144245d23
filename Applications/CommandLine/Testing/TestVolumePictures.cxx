// The phantom without a surface of its own, a ball behind its teeth: the brightest values from the
// front, and bone and skin from the front and the left.
#include "VolumeLook.h"

#include "Grid/Phantom.h"
#include "HaspRenderTest.h"
#include "vtkHaspVolumeFile.h"
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
#include "vtkVolume.h"

namespace
{

void AddView(vtkRenderWindow* window, int column, vtkVolume* volume, double x, double y)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(25, -70, -35);
  ball->SetRadius(18);
  ball->SetThetaResolution(60);
  ball->SetPhiResolution(60);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.35, 0.70, 0.90);
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(column / 3.0, 0, (column + 1) / 3.0, 1);
  renderer->SetBackground(0.10, 0.11, 0.13);
  renderer->AddVolume(volume);
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->SetPosition(x, y, 0.2);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  window->AddRenderer(renderer);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.35);
}

} // namespace

int TestVolumePictures(int argc, char* argv[])
{
  using namespace hasp;
  const GridGeometry grid = PhantomGrid(glm::dvec3(1.5));
  const auto image = MakeImage(grid, SamplePhantom(grid));
  Passport passport;
  passport.hounsfield = true;
  passport.minimum = image->GetScalarRange()[0];
  passport.maximum = image->GetScalarRange()[1];
  const VolumeLook look = UsualLook(passport);
  const std::array<double, 3> bone{ 0.93, 0.87, 0.76 };
  vtkNew<vtkRenderWindow> window;
  window->SetSize(960, 320);
  window->SetMultiSamples(0);
  AddView(window, 0, MakeBrightest(image, look.window), 0.1, -1);
  AddView(window, 1, MakeTranslucent(image, 226, look, bone), 0.1, -1);
  AddView(window, 2, MakeTranslucent(image, 226, look, bone), 1, -0.3);
  window->Render();
  return CheckPicture(window, argc, argv);
}
