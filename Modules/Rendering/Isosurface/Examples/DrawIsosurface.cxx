// DrawIsosurface <DICOM folder, .inv3, .mha or .vti> <isovalue> <picture.png>: a scan from the
// front
#include "vtkCamera.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspVolumeReader.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

int main(int argc, char* argv[])
{
  if (argc != 4)
    return 1;
  hasp::UseHeadlessWindows(); // before the first window; changes nothing where DISPLAY is set
  vtkNew<vtkHaspVolumeReader> reader; // whatever the file: patient LPS, millimetres
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspClusteredCellMapper> mapper; // in place of a contour filter and vtkPolyDataMapper
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetIsoValue(std::stod(argv[2]));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->SetPosition(0, -1, 0); // from anterior,
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);    // superior up
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(600, 600);
  window->AddRenderer(renderer);
  vtkNew<vtkWindowToImageFilter> pixels; // or a vtkRenderWindowInteractor, to turn it by hand
  pixels->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->SetFileName(argv[3]);
  writer->Write();
  return reader->GetErrorCode() || writer->GetErrorCode();
}
