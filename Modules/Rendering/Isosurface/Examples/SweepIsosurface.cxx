// SweepIsosurface <volume> <isovalue> <picture.png>: another isovalue in each frame, up to this one
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspRayCachingMapper.h"
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
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspRayCachingMapper> mapper; // draws each isovalue in the cheaper of its ways
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetFrameBudget(30.0); // milliseconds for rays: a slider that is dragged stays smooth
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(600, 600);
  window->AddRenderer(renderer);
  for (int frame = 0; frame <= 20 || mapper->IsRefining(); ++frame) // until nothing new is found
  {
    mapper->SetIsoValue(std::stod(argv[2]) - 10.0 * std::max(0, 20 - frame));
    window->Render();
  }
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->SetFileName(argv[3]);
  writer->Write();
  return reader->GetErrorCode() || writer->GetErrorCode();
}
