#pragma once
// What the pictures of drawing modes share: one isosurface, one window.
#include "Grid/AnalyticVolumes.h"
#include "HaspRenderTest.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <functional>

namespace hasp::testing
{

/// Samples around the origin, 1 mm apart.
inline GridGeometry CenteredGrid(const glm::ivec3& dims)
{
  return { dims, -0.5 * glm::dvec3(dims - 1), { 1, 1, 1 }, glm::dmat3(1) };
}

/// A point array of the values at the samples.
template <typename Array>
void AddPointArray(
  vtkImageData* image, const char* name, const std::function<double(const glm::dvec3&)>& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    double p[3];
    image->GetPoint(n, p);
    array->InsertNextTuple1(value({ p[0], p[1], p[2] }));
  }
  image->GetPointData()->AddArray(array);
}

struct PictureScene
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;

  PictureScene()
  {
    this->Renderer->SetBackground(0.1, 0.15, 0.2);
    this->Window->SetSize(400, 300);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
  }

  vtkSmartPointer<vtkHaspClusteredCellMapper> Add(
    vtkImageData* image, double isovalue, const glm::dvec3& at = { 0, 0, 0 })
  {
    auto mapper = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
    mapper->SetInputData(image);
    mapper->SetIsoValue(isovalue);
    mapper->SetRendererToRasterize(); // not what a measurement says
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(at.x, at.y, at.z);
    actor->GetProperty()->SetColor(0.9, 0.85, 0.7);
    actor->GetProperty()->SetSpecular(0.4);
    actor->GetProperty()->SetSpecularPower(30);
    this->Renderer->AddActor(actor);
    return mapper;
  }

  void Look(const glm::dvec3& eye, const glm::dvec3& at)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(at.x, at.y, at.z);
    camera->SetViewUp(0, 0, 1);
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
  }
};

} // namespace hasp::testing
