// PaintFragments [picture.png]: paint a fragment on a skull; with a file one drag is made and drawn
#include "Grid/Phantom.h"
#include "LabelPalette.h"
#include "Planning/SegmentationRecipe.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspSeedPainter.h"
#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkUnsignedShortArray.h"
#include "vtkWindowToImageFilter.h"
#include <glm/geometric.hpp>

/// What the brush touches becomes the fragment. A random walker would be asked here, with the
/// pieces.
struct PaintVoxels : vtkCommand
{
  static PaintVoxels* New() { return new PaintVoxels; }
  void Execute(vtkObject* painter, unsigned long, void*) override
  {
    for (const auto& stroke : static_cast<vtkHaspSeedPainter*>(painter)->GetPieces())
      for (const glm::dvec3& point : stroke.points)
      {
        const glm::dvec3 at = grid.WorldToIndex(point), reach = stroke.radiusMm / grid.spacing;
        const glm::ivec3 low = glm::max(at - reach, 0.0);
        const glm::ivec3 high = glm::min(at + reach, glm::dvec3(grid.dims - 1));
        for (glm::ivec3 v = low; v.z <= high.z; ++v.z)
          for (v.y = low.y; v.y <= high.y; ++v.y)
            for (v.x = low.x; v.x <= high.x; ++v.x)
              if (glm::distance(grid.IndexToWorld(v), point) <= stroke.radiusMm)
                labels->SetValue((v.z * grid.dims.y + v.y) * grid.dims.x + v.x, stroke.label);
        const int box[6] = { low.x, high.x, low.y, high.y, low.z, high.z };
        bone->MarkModified(box);
      }
  }
  const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(1.5)); // world LPS, mm
  vtkNew<vtkUnsignedShortArray> labels;                               // a fragment a voxel
  vtkNew<vtkHaspClusteredCellMapper> bone;
};

int main(int argc, char* argv[])
{
  hasp::UseHeadlessWindows();
  vtkNew<PaintVoxels> paint;
  paint->labels->SetName("Fragments");
  paint->labels->SetNumberOfValues(static_cast<vtkIdType>(paint->grid.Size()));
  paint->labels->Fill(0);
  const auto ct = hasp::MakeImage(paint->grid, hasp::SamplePhantom(paint->grid, { .edgeMm = 3.0 }));
  ct->GetPointData()->AddArray(paint->labels);
  paint->bone->SetInputData(ct);
  paint->bone->SetIsoValue(226.0);
  paint->bone->SetLabelArrayName("Fragments");
  const glm::dvec3 colour = hasp::PaletteColour(2);
  paint->bone->SetLabelColor(2, colour.x, colour.y, colour.z);
  vtkNew<vtkActor> actor;
  actor->SetMapper(paint->bone);
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

  vtkNew<vtkHaspSeedPainter> painter;
  painter->SetRenderer(renderer);
  painter->SetRadiusMm(4.0); // Shift and the wheel change it
  painter->AddObserver(vtkHaspSeedPainter::StrokeStartedEvent, paint);
  painter->AddObserver(vtkHaspSeedPainter::StrokeChangedEvent, paint);
  painter->EnabledOn();
  if (argc < 2)
    return interactor->Start(), 0;
  interactor->SetEventInformation(280, 420);
  interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  interactor->SetEventInformation(380, 420);
  interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  painter->EnabledOff(); // and its brush is gone
  window->Render();
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  return writer->GetErrorCode() != 0;
}
