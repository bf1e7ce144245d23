// PaintFragments [picture.png]: split a broken jaw with a brush; with a file two drags do it
#include "Studies/FractureCases.h"
#include "vtkCamera.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspSeedPainter.h"
#include "vtkHaspSegmentationSession.h"
#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

int main(int argc, char* argv[])
{
  hasp::UseHeadlessWindows();
  const hasp::FractureCase jaw = hasp::BrokenMandible({ .spacingMm = 1.0 }); // or a scan of yours
  const hasp::FracturedScan scan = hasp::BreakPhantom(jaw.geometry, jaw.settings);
  vtkNew<vtkHaspClusteredCellMapper> bone;
  bone->SetIsoValue(226.0);
  vtkNew<vtkHaspSeedPainter> painter; // keys 2 to 9: which fragment; Ctrl + Z takes a drag back
  vtkNew<vtkHaspSegmentationSession> session;
  session->SetScan(hasp::MakeImage(scan.geometry, scan.samples));
  session->SetMapper(bone);
  session->SetPainter(painter);
  vtkNew<vtkActor> actor;
  actor->SetMapper(bone);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->SetPosition(0, -1, 0); // from anterior,
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);    // superior up
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(600, 600);
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style; // a drag beside the bone turns the camera
  interactor->SetInteractorStyle(style);
  window->Render();
  painter->SetRenderer(renderer);
  painter->EnabledOn();
  if (argc < 2)
    return interactor->Start(), 0;
  for (const int fragment : { 2, 3 })
  {
    painter->SetLabel(fragment);
    interactor->SetEventInformation(fragment == 2 ? 170 : 290, 245);
    interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    interactor->SetEventInformation(fragment == 2 ? 210 : 330, 245);
    interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
    interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  }
  painter->EnabledOff(); // and its brush is gone
  session->Finish();
  window->Render();
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  return writer->GetErrorCode() != 0;
}
