#pragma once
// A window, a renderer with a light pass, and bodies of both kinds in it.
#include "Grid/AnalyticVolumes.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspLightPass.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <glm/vec3.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp::testing
{

inline vtkSmartPointer<vtkImageData> BallImage(double radius, double spacing = 1.0)
{
  const int dims = 2 * static_cast<int>(std::ceil(radius / spacing)) + 7;
  GridGeometry g{ glm::ivec3(dims), glm::dvec3(-0.5 * spacing * (dims - 1)), glm::dvec3(spacing),
    glm::dmat3(1) };
  const AnalyticVolume ball = AnalyticSphere({ 0, 0, 0 }, radius);
  return MakeImage(g, SampleAnalytic<float>(ball, g, 1.0, 0.0));
}

struct LightTestScene
{
  struct Headless
  {
    Headless() { hasp::UseHeadlessWindows(); }
  } Before; ///< any window is made
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkHaspLightPass> Pass;
  int Width, Height;

  explicit LightTestScene(int width = 120, int height = 90) : Width(width), Height(height)
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.1, 0.15, 0.2);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetEnvironmentUp(0, 0, 1);
    this->Renderer->SetEnvironmentRight(0, -1, 0);
    this->Renderer->SetPass(this->Pass);
  }

  vtkSmartPointer<vtkActor> Add(vtkMapper* mapper, const glm::dvec3& at, double grey = 1.0)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->SetPosition(at.x, at.y, at.z);
    actor->GetProperty()->SetColor(grey, grey, grey);
    this->Renderer->AddActor(actor);
    return actor;
  }
  vtkSmartPointer<vtkActor> AddCellBall(
    double radius, const glm::dvec3& at, double grey = 1.0, double spacing = 1.0)
  {
    vtkNew<vtkHaspClusteredCellMapper> mapper;
    mapper->SetInputData(BallImage(radius, spacing));
    mapper->SetIsoValue(0.0);
    mapper->SetRendererToTrace();
    return this->Add(mapper, at, grey);
  }
  vtkSmartPointer<vtkActor> AddMeshBall(double radius, const glm::dvec3& at, double grey = 1.0)
  {
    vtkNew<vtkSphereSource> source;
    source->SetRadius(radius);
    source->SetThetaResolution(160);
    source->SetPhiResolution(80);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    return this->Add(mapper, at, grey);
  }
  vtkSmartPointer<vtkActor> AddFloor(double side, double z, double grey = 1.0)
  {
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(-side, -side, z);
    source->SetPoint1(side, -side, z);
    source->SetPoint2(-side, side, z);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    return this->Add(mapper, { 0, 0, 0 }, grey);
  }
  vtkSmartPointer<vtkLight> AddLamp(const glm::dvec3& from)
  {
    auto lamp = vtkSmartPointer<vtkLight>::New();
    lamp->SetLightTypeToSceneLight();
    lamp->SetPosition(from.x, from.y, from.z);
    lamp->SetFocalPoint(0, 0, 0);
    this->Renderer->AddLight(lamp);
    return lamp;
  }
  void Look(const glm::dvec3& eye, const glm::dvec3& at = glm::dvec3(0.0))
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(at.x, at.y, at.z);
    camera->SetViewUp(0, std::abs(eye.z) > 5.0 * std::hypot(eye.x, eye.y) ? 1 : 0, 1);
    this->Renderer->ResetCameraClippingRange();
  }
  vtkSmartPointer<vtkUnsignedCharArray> Draw(int frames = 1)
  {
    for (int n = 0; n < frames; ++n)
      this->Window->Render();
    auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Window->GetRGBACharPixelData(0, 0, this->Width - 1, this->Height - 1, 1, pixels);
    return pixels;
  }
  /// Where a place of the world is in the picture.
  glm::ivec2 PixelOf(const glm::dvec3& place)
  {
    this->Renderer->SetWorldPoint(place.x, place.y, place.z, 1.0);
    this->Renderer->WorldToDisplay();
    const double* p = this->Renderer->GetDisplayPoint();
    return { static_cast<int>(p[0]), static_cast<int>(p[1]) };
  }
  int Grey(vtkUnsignedCharArray* pixels, const glm::dvec3& place)
  {
    const glm::ivec2 at = this->PixelOf(place);
    return pixels->GetTypedComponent(at.y * this->Width + at.x, 1);
  }
  ResourceUse Resource(const std::string& name) const
  {
    ResourceList list;
    this->Pass->ListResources(list);
    for (const ResourceUse& use : list)
      if (use.resource == name)
        return use;
    throw std::invalid_argument("no resource " + name);
  }
};

/// Root mean square difference of two pictures, of 255.
inline double Difference(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  double sum = 0.0;
  for (vtkIdType n = 0; n < a->GetNumberOfValues(); ++n)
    sum += std::pow(double(a->GetValue(n)) - double(b->GetValue(n)), 2);
  return std::sqrt(sum / double(a->GetNumberOfValues()));
}

} // namespace hasp::testing
