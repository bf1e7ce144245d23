// A guide on the phantom's bone: its mesh above, its preview below, drawn as clustered cells
// straight from the field.
#include "Grid/Phantom.h"
#include "Planning/GuideRecipe.h"
#include "vtkHaspClusteredCellFilter.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspVolumeView.h"

#include "HaspRenderTest.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

namespace
{

/// As Data/phantom-guide.json.
hasp::GuideRecipe AroundTheDefect()
{
  const glm::dvec3 up(-0.627308, -0.590306, 0.507961);
  hasp::GuideRecipe r;
  r.landmarks = { { -25.115, -79.091, 27.06 }, { -13.883, -77.033, 41.07 },
    { -18.694, -66.761, 52.904 }, { -25.072, -51.917, 63.136 }, { -31.092, -36.753, 68.582 },
    { -45.221, -30.32, 58.907 } };
  r.withdrawal = up;
  r.thicknessMm = 3.0;
  r.wallMm = 2.5;
  r.slots = { { { -22.011, -59.732, 58.369 }, { -0.707123, 0.15847, -0.689104 }, 1.0, 20, 20,
    10 } };
  r.holes = { { { -19.427, -78.352, 34.94 }, up, 2.0, 20, 6 },
    { { -37.992, -34.276, 64.379 }, up, 2.0, 20, 6 } };
  r.labels = { { "R1", { -29.6, -40.6, 66.9 }, { 0.329, -0.858, -0.395 }, 5, 1, false } };
  return r;
}

vtkSmartPointer<vtkActor> CellsOf(vtkImageData* image, double isovalue, const double color[3])
{
  vtkNew<vtkHaspClusteredCellFilter> cells;
  cells->SetInputData(image);
  cells->SetIsoValue(isovalue);
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputConnection(cells->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}
} // namespace

int TestGuidePicture(int argc, char* argv[])
{
  const hasp::GridGeometry grid{ { 90, 116, 104 }, { -70, -98, -8 }, glm::dvec3(0.9),
    glm::dmat3(1) };
  const auto ct = hasp::MakeImage(grid, hasp::SamplePhantom(grid));
  vtkNew<vtkHaspGuideFilter> guide;
  guide->SetInputData(ct);
  guide->SetRecipe(AroundTheDefect());
  guide->Update();
  const auto preview = guide->MakePreview();
  if (!preview || guide->GetOutput()->GetNumberOfPolys() == 0)
    return 1;

  const double bone[3] = { 0.9, 0.86, 0.75 }, plastic[3] = { 0.3, 0.65, 0.75 };
  vtkNew<vtkRenderWindow> window;
  window->SetSize(440, 720);
  window->SetMultiSamples(0);
  for (const bool above : { true, false })
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(0.0, above ? 0.5 : 0.0, 1.0, above ? 1.0 : 0.5);
    renderer->SetBackground(0.1, 0.15, 0.2);
    renderer->AddActor(CellsOf(ct, 226, bone));
    if (above)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(guide->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetInterpolationToFlat(); // an edge has no normal
      actor->GetProperty()->SetColor(plastic[0], plastic[1], plastic[2]);
      renderer->AddActor(actor);
    }
    else
      renderer->AddActor(CellsOf(preview, 0.0, plastic));
    window->AddRenderer(renderer);
    vtkCamera* camera = renderer->GetActiveCamera();
    const glm::dvec3 middle(-26, -58, 48), from = middle + 190.0 * AroundTheDefect().withdrawal;
    camera->SetPosition(from.x, from.y, from.z);
    camera->SetFocalPoint(middle.x, middle.y, middle.z);
    camera->SetViewUp(0, 0, 1);
    camera->SetViewAngle(26);
    renderer->ResetCameraClippingRange();
  }
  window->Render();
  return hasp::CheckPicture(window, argc, argv);
}
