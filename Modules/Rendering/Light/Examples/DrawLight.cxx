// DrawLight <volume> <isovalue> <picture.png> [environment.hdr]: bone and a part under one light
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspLightPass.h"
#include "vtkHaspVolumeReader.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

#include <string>

int main(int argc, char* argv[])
{
  if (argc != 4 && argc != 5)
    return 1;
  hasp::UseHeadlessWindows();
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspClusteredCellMapper> boneMapper;
  boneMapper->SetInputConnection(reader->GetOutputPort());
  boneMapper->SetIsoValue(std::stod(argv[2]));
  vtkNew<vtkActor> bone;
  bone->SetMapper(boneMapper);
  bone->GetProperty()->SetColor(0.93, 0.87, 0.76);
  double box[6];
  boneMapper->GetBounds(box);
  vtkNew<vtkSphereSource> sphere; // a part of titanium, before the face
  sphere->SetCenter(0.5 * (box[0] + box[1]), box[2], box[4] + 0.4 * (box[5] - box[4]));
  sphere->SetRadius(0.12 * (box[1] - box[0]));
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> partMapper;
  partMapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> part;
  part->SetMapper(partMapper);
  part->GetProperty()->SetInterpolationToPBR();
  part->GetProperty()->SetMetallic(1.0);
  part->GetProperty()->SetRoughness(0.3);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(bone);
  renderer->AddActor(part);
  // Patients stand along z and look along -y: the middle of a map is before the face.
  renderer->SetEnvironmentUp(0, 0, 1);
  renderer->SetEnvironmentRight(0, -1, 0);
  vtkNew<vtkHaspLightPass> light;
  light->SetModeToPathTraced();
  light->SetSamplesPerPixel(64);
  if (argc == 5)
    light->SetEnvironmentFileName(argv[4]); // else daylight
  light->WaitForSamplesOn(); // a window draws frames while light->IsRefining() instead
  renderer->SetPass(light);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(600, 600);
  window->SetMultiSamples(0);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->GetActiveCamera()->SetPosition(0, -1, 0);
  renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0);
  renderer->ResetCamera();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argv[3]);
  writer->Write();
  const bool lit = light->GetSamples() == light->GetSamplesPerPixel(); // else it said why
  return !lit || reader->GetErrorCode() || writer->GetErrorCode();
}
