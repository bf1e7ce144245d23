#pragma once
// One window, one renderer, one isosurface; and what its depth buffer says, pixel by pixel.
#include "Grid/AnalyticVolumes.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp::testing
{

/// About `dims`^3 samples around the origin: rotated, another spacing per axis, rows flipped.
inline GridGeometry ObliqueGrid(int dims, const glm::dvec3& spacing)
{
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, -2, 0.5))));
  GridGeometry g{ { dims, dims - 3, dims + 5 }, {}, spacing,
    glm::dmat3(turn[0], -turn[1], turn[2]) };
  g.origin = -(g.direction * (g.spacing * glm::dvec3(g.dims - 1) * 0.5));
  return g;
}

class CellTestScene
{
public:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkSmartPointer<vtkHaspClusteredCellMapper> Mapper;

  CellTestScene(int width, int height)
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Mapper = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
    this->Mapper->SetIsoValue(0.0);         // most volumes here are signed distances
    this->Mapper->SetRendererToRasterize(); // not what a measurement says
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
  }

  void Look(const glm::dvec3& eye, const glm::dvec3& at, double nearest, double farthest)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(at.x, at.y, at.z);
    camera->SetViewUp(0.1, 0.2, 1);
    camera->SetClippingRange(nearest, farthest);
  }

  /// From now on the actor shows VTK's own mesh of the mapper's image and isovalue.
  void ShowMesh()
  {
    vtkNew<vtkFlyingEdges3D> mesh;
    mesh->SetInputData(this->Mapper->GetImage());
    mesh->SetValue(0, this->Mapper->GetIsoValue());
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(mesh->GetOutputPort());
    mapper->ScalarVisibilityOff();
    this->Actor->SetMapper(mapper);
  }

  /// Draws, and keeps depth and matrix for Point and Ray.
  void Draw()
  {
    this->Window->Render();
    const int* size = this->Window->GetSize();
    this->Width = size[0];
    this->Height = size[1];
    this->Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, this->Depth);
    vtkMatrix4x4* clip = this->Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      this->Renderer->GetTiledAspectRatio(), -1, 1);
    this->ClipToWorld = glm::inverse(glm::transpose(glm::dmat4(glm::make_mat4(clip->GetData()))));
  }

  /// What the depth buffer shows in a pixel; nothing at the background.
  std::optional<glm::dvec3> Point(int x, int y) const
  {
    const float depth = this->Depth->GetValue(y * this->Width + x);
    if (depth >= 1.0F)
      return std::nullopt;
    return this->Unproject(x, y, 2.0 * depth - 1.0);
  }

  /// Origin on the near plane, unit direction.
  std::pair<glm::dvec3, glm::dvec3> Ray(int x, int y) const
  {
    const glm::dvec3 from = this->Unproject(x, y, -1.0);
    return { from, glm::normalize(this->Unproject(x, y, 1.0) - from) };
  }

private:
  glm::dvec3 Unproject(int x, int y, double z) const
  {
    const glm::dvec4 p = this->ClipToWorld * glm::dvec4(2.0 * (x + 0.5) / this->Width - 1.0,
                                               2.0 * (y + 0.5) / this->Height - 1.0, z, 1);
    return glm::dvec3(p) / p.w;
  }

  int Width = 0, Height = 0;
  vtkNew<vtkFloatArray> Depth;
  glm::dmat4 ClipToWorld{ 1.0 };
};

/// What the mapper says of one of its resources.
inline ResourceUse FindResource(vtkHaspClusteredCellMapper* mapper, const std::string& name)
{
  ResourceList list;
  mapper->ListResources(list);
  for (const ResourceUse& use : list)
    if (use.resource == name)
      return use;
  throw std::invalid_argument("no resource " + name);
}

} // namespace hasp::testing
