// Above, the phantom's resected jaw with two segments of its fibula, the vessel and the skin that
// come with them; below, the mitre guide on the fibula that leads the saw.
#include "MitreGuide.h"
#include "TransplantBuilder.h"
#include "TransplantFixture.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspTransplantFilter.h"
#include "vtkHaspVolumeView.h"

#include "HaspRenderTest.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"

#include <initializer_list>

namespace
{

struct View
{
  vtkNew<vtkRenderer> renderer;

  View(double bottom, double top, const glm::dvec3& from, const glm::dvec3& at,
    const glm::dvec3& up, double angle)
  {
    this->renderer->SetViewport(0.0, bottom, 1.0, top);
    this->renderer->SetBackground(0.1, 0.15, 0.2);
    vtkCamera* camera = this->renderer->GetActiveCamera();
    camera->SetPosition(from.x, from.y, from.z);
    camera->SetFocalPoint(at.x, at.y, at.z);
    camera->SetViewUp(up.x, up.y, up.z);
    camera->SetViewAngle(angle);
  }
  void Add(vtkAlgorithmOutput* mesh, const glm::dvec3& colour, bool flat = true)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(mesh);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    if (flat)
      actor->GetProperty()->SetInterpolationToFlat(); // an edge has no normal
    actor->GetProperty()->SetColor(colour.x, colour.y, colour.z);
    this->renderer->AddActor(actor);
  }
};

} // namespace

int TestFibulaPicture(int argc, char* argv[])
{
  using namespace transplanttest;
  const cuttest::BoneScan jaw = Scan({ 155, 110, 60 }, { -78, -92, -125 }, glm::dvec3(1.0)),
                          leg = ScanOfLeg(glm::dvec3(0.9));
  hasp::TransplantRecipe recipe = Recipe();
  recipe.resection.spacingMm = 0.8;
  vtkNew<vtkHaspTransplantFilter> transplant;
  transplant->SetInputData(0, hasp::MakeImage(jaw.grid, jaw.samples));
  transplant->SetInputData(1, hasp::MakeImage(leg.grid, leg.samples));
  transplant->SetRecipe(recipe);
  transplant->Update();
  vtkNew<vtkHaspGuideFilter> guide;
  guide->SetInputData(hasp::MakeImage(leg.grid, leg.samples));
  guide->SetRecipe(
    hasp::MakeMitreGuideRecipe(transplant->GetResult().plan, leg.View(), 226.0, recipe.guide)
      .recipe);
  vtkNew<vtkFlyingEdges3D> bone;
  bone->SetInputData(hasp::MakeImage(leg.grid, leg.samples));
  bone->SetValue(0, 226.0);
  vtkNew<vtkTubeFilter> lines;
  lines->SetInputConnection(transplant->GetOutputPort(3));
  lines->SetRadius(0.9);
  lines->SetNumberOfSides(12);

  View above(0.45, 1.0, { -120, -240, -190 }, { 0, -52, -92 }, { 0, 0, 1 }, 22);
  above.Add(transplant->GetOutputPort(2), { 0.9, 0.86, 0.75 });
  above.Add(transplant->GetOutputPort(0), { 0.45, 0.7, 0.9 });
  above.Add(lines->GetOutputPort(), { 0.8, 0.2, 0.2 }, false);
  const glm::dvec3 lateral = recipe.donor.lateral;
  View below(0.0, 0.45, glm::dvec3(150, 0, -55) + 300.0 * lateral + glm::dvec3(-60, -130, 90),
    { 153, -5, -62 }, { 0, -0.6, 0.8 }, 20);
  below.Add(bone->GetOutputPort(), { 0.9, 0.86, 0.75 }, false);
  below.Add(guide->GetOutputPort(), { 0.75, 0.8, 0.85 });

  vtkNew<vtkRenderWindow> window;
  window->SetSize(640, 800);
  window->SetMultiSamples(0);
  for (View* view : { &above, &below })
  {
    window->AddRenderer(view->renderer);
    view->renderer->ResetCameraClippingRange();
  }
  window->Render();
  return hasp::CheckPicture(window, argc, argv);
}
