// DrawPointShell <surface.stl> <picture.png>: its points as discs
#include "vtkActor.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspPointShellMapper.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataNormals.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSTLReader.h"
#include "vtkWindowToImageFilter.h"

int main(int argc, char* argv[])
{
  if (argc != 3)
    return 1;
  hasp::UseHeadlessWindows(); // before the first window
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkPolyDataNormals> points; // or SetPointShell, or SetDiscs each frame
  points->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkHaspPointShellMapper> mapper;
  mapper->SetInputConnection(points->GetOutputPort());
  vtkNew<vtkActor> shell;
  shell->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(shell);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(600, 600);
  window->AddRenderer(renderer);
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return reader->GetErrorCode() || writer->GetErrorCode();
}
