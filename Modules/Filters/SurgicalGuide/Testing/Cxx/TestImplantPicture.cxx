// A perforated implant in the phantom's skull: flush with the outer table, even clearance around
// it.
#include "Grid/Phantom.h"
#include "Planning/ImplantRecipe.h"
#include "vtkHaspImplantFilter.h"
#include "vtkHaspVolumeView.h"

#include "HaspRenderTest.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cmath>

namespace
{
hasp::ImplantRecipe AroundTheHole(const hasp::PhantomSettings& settings)
{
  const hasp::PhantomDefect hole = hasp::DefectOf(settings);
  hasp::ImplantRecipe recipe;
  for (int n = 0; n < 12; ++n)
  {
    const double angle = n * 6.283185307179586 / 12;
    recipe.outline.push_back(hasp::PhantomOuterTable(
      settings, hole.center + (0.6 * hole.lengthMm + 7) * std::cos(angle) * hole.along +
                  (0.6 * hole.widthMm + 7) * std::sin(angle) * hole.across - settings.center));
  }
  recipe.clearanceMm = 1.0; // to be seen
  recipe.holeDiameterMm = 2.5;
  recipe.holePitchMm = 9.0;
  return recipe;
}

void Add(vtkRenderer* renderer, vtkAlgorithmOutput* surface, double r, double g, double b)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(surface);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  renderer->AddActor(actor);
}
} // namespace

int TestImplantPicture(int argc, char* argv[])
{
  hasp::PhantomSettings settings;
  settings.blurMm = glm::dvec3(0.5);
  const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(1.25), settings);
  const auto image = hasp::MakeImage(grid, hasp::SamplePhantom(grid, settings));
  vtkNew<vtkHaspImplantFilter> implant;
  implant->SetInputData(image);
  implant->SetRecipe(AroundTheHole(settings));
  vtkNew<vtkFlyingEdges3D> bone;
  bone->SetInputData(image);
  bone->SetValue(0, 226);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.12, 0.16);
  Add(renderer, bone->GetOutputPort(), 0.85, 0.8, 0.68);
  Add(renderer, implant->GetOutputPort(), 0.35, 0.6, 0.8);
  const hasp::PhantomDefect hole = hasp::DefectOf(settings);
  const glm::dvec3 from = hole.center + 200.0 * glm::normalize(hole.outward + 0.35 * hole.across);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(from.x, from.y, from.z);
  camera->SetFocalPoint(hole.center.x, hole.center.y, hole.center.z);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(24);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(420, 380);
  window->SetMultiSamples(0);
  window->AddRenderer(renderer);
  window->Render();
  return hasp::CheckPicture(window, argc, argv);
}
