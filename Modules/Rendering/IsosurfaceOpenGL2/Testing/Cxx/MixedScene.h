#pragma once
// An isosurface among other actors: opaque behind and through it, translucent before and behind it,
// a clipped second one with specular light, and a third that is translucent itself.
#include "Grid/AnalyticVolumes.h"
#include "HaspRenderTest.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <type_traits>

namespace hasp::testing
{

inline vtkSmartPointer<vtkActor> MakeActor(
  vtkMapper* mapper, double r, double g, double b, double opacity)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

/// configure(mapper) says how it is drawn.
template <typename Mapper, typename Configure>
vtkSmartPointer<vtkActor> Isosurface(
  const AnalyticVolume& shape, double opacity, const Configure& configure)
{
  const GridGeometry geometry{ { 50, 50, 50 }, glm::dvec3(-24.5), { 1, 1, 1 }, glm::dmat3(1) };
  vtkNew<Mapper> mapper;
  mapper->SetInputData(MakeImage(geometry, SampleAnalytic<std::int16_t>(shape, geometry, 100, 0)));
  mapper->SetIsoValue(0);
  configure(mapper.GetPointer());
  return MakeActor(mapper, 0.9, 0.85, 0.7, opacity);
}

inline vtkSmartPointer<vtkActor> Plane(double y, double r, double g, double b, double opacity)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-15, y, -35);
  plane->SetPoint1(35, y, -35);
  plane->SetPoint2(-15, y, 5);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  return MakeActor(mapper, r, g, b, opacity);
}

/// Draws the scene and compares it with the baseline. A mapper that is not for clustered cells
/// draws the opaque ones. frames: until it is complete.
template <typename Mapper = vtkHaspClusteredCellMapper, typename Configure>
int CheckMixedScene(int argc, char* argv[], const Configure& configure, int frames = 1)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.15, 0.2);
  renderer->AddActor(Isosurface<Mapper>(AnalyticSphere({ 0, 0, 0 }, 20), 1.0, configure));
  renderer->AddActor(Plane(-30, 1, 0.2, 0.2, 0.4)); // before
  renderer->AddActor(Plane(30, 0.2, 0.4, 1, 0.5));  // behind

  vtkNew<vtkConeSource> cone; // through
  cone->SetHeight(70);
  cone->SetRadius(8);
  cone->SetResolution(60);
  vtkNew<vtkPolyDataMapper> coneMapper;
  coneMapper->SetInputConnection(cone->GetOutputPort());
  renderer->AddActor(MakeActor(coneMapper, 0.3, 0.7, 0.4, 1.0));

  auto cut = Isosurface<Mapper>(AnalyticTorus({ 0, 0, 0 }, { 0, 1, 0 }, 15, 7), 1.0, configure);
  cut->SetPosition(-45, 0, 25);
  cut->GetProperty()->SetSpecular(0.5);
  cut->GetProperty()->SetSpecularPower(30);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(-45, 0, 25);
  plane->SetNormal(1, 1, 0.3);
  cut->GetMapper()->AddClippingPlane(plane);
  renderer->AddActor(cut);

  auto ghost = Isosurface<vtkHaspClusteredCellMapper>(AnalyticGyroid(25), 0.5,
    [&](auto* mapper)
    {
      if constexpr (std::is_same_v<Mapper, vtkHaspClusteredCellMapper>)
        configure(mapper);
    });
  ghost->SetPosition(40, 20, 30);
  ghost->SetScale(0.8);
  renderer->AddActor(ghost);

  renderer->GetActiveCamera()->SetPosition(20, -180, 60);
  renderer->GetActiveCamera()->SetFocalPoint(0, 0, 8);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetSize(480, 360);
  window->SetMultiSamples(0);
  window->AddRenderer(renderer);
  for (int frame = 0; frame < frames; ++frame)
    window->Render();
  return CheckPicture(window, argc, argv);
}

} // namespace hasp::testing
