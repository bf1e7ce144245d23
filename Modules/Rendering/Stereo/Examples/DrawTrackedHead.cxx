// DrawTrackedHead <scan> <isovalue> <x> <.png>: a screen of 300 mm, x mm beside its middle
#include "StereoWindow.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspStereoWindows.h"
#include "vtkHaspVolumeReader.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"
int main(int argc, char* argv[])
{
  if (argc != 5)
    return 1;
  hasp::UseHeadlessWindows();
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetIsoValue(std::stod(argv[2]));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> scene; // what its camera sees stands on the screen
  scene->AddActor(actor);
  scene->ResetCamera();
  vtkNew<vtkRenderWindow> window; // more windows of the same room: AddWindow again
  vtkNew<vtkHaspStereoWindows> windows;
  windows->SetRenderer(scene);
  windows->AddWindow(window, { {}, hasp::StereoScreen{ {}, { 1, 0, 0 }, { 0, 1, 0 }, 300, 300 } });
  windows->SetHead({ { std::stod(argv[3]), 0, 600 } }); // a tracker's, once a frame
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(argv[4]);
  return !windows->Render() || (writer->Write(), writer->GetErrorCode()) || reader->GetErrorCode();
}
