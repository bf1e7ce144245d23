// DrawStereo <DICOM folder, .inv3, .mha or .vti> <isovalue> <layout> <picture.png>: for two eyes
// Layouts: side-by-side, top-bottom, left, right, anaglyph, mono.
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspStereoPicture.h"
#include "vtkHaspVolumeReader.h"
#include "vtkImageData.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

int main(int argc, char* argv[])
{
  if (argc != 5)
    return 1;
  hasp::UseHeadlessWindows();
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspClusteredCellMapper> mapper; // stereo works with every mapper
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetIsoValue(std::stod(argv[2]));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->ResetCamera(); // the eyes stand beside this camera, the screen at its focal point
  vtkNew<vtkRenderWindow> window;
  window->SetSize(600, 600);
  window->AddRenderer(renderer);
  vtkNew<vtkHaspStereoPicture> stereo; // SetRig: a real screen and a tracked head instead
  stereo->SetRenderer(renderer);
  stereo->SetLayoutName(argv[3]);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(stereo->Render());
  writer->SetFileName(argv[4]);
  writer->Write();
  return reader->GetErrorCode() || writer->GetErrorCode();
}
