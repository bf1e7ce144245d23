#pragma once
// Cells and polydata in one picture, and the same picture on the CPU: all that the ray of a pixel
// meets, sorted and blended.
#include "Evaluation/SortedLayers.h"
#include "Evaluation/TrilinearTruth.h"
#include "Grid/AnalyticVolumes.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hasp::testing
{

/// How far a picture is from the truth, in 1/255 of a channel.
struct LayerError
{
  static constexpr double Allowed = 2.0;
  double largest = 0.0, rms = 0.0;
  int wrong = 0;          ///< pixels of which a channel is farther off than is allowed
  int compared = 0;       ///< pixels
  int deep = 0;           ///< of these, such that show 4 layers and more
  int silhouettes = 0;    ///< pixels beside these that are as wrong, and left out
  std::size_t layers = 0; ///< most in a pixel

  double SilhouetteShare() const
  {
    return double(this->silhouettes) / (this->compared + this->silhouettes);
  }
};

class LayerScene
{
public:
  using Ray = std::pair<glm::dvec3, glm::dvec3>; ///< origin, unit direction
  using Meet = std::function<void(const Ray&, std::vector<Layer>&)>;

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;

  LayerScene(int width, int height)
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Background({ 51 / 255.0, 102 / 255.0, 204 / 255.0 }); // as 8 bits have it
    this->Renderer->UseDepthPeelingOn();
    this->Renderer->SetMaximumNumberOfPeels(20);
    this->Renderer->SetOcclusionRatio(0.0);
    this->Look({ 40, -90, 35 }, { 0, 0, 0 }, 40, 180);
  }

  void Background(const glm::dvec3& color)
  {
    this->Behind = color;
    this->Renderer->SetBackground(color.x, color.y, color.z);
  }

  /// From now on what is added is diffuse, in white light from a direction; without, colours are
  /// shown as they are.
  void LightFrom(const glm::dvec3& direction)
  {
    this->TowardsLight = glm::normalize(direction);
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(direction.x, direction.y, direction.z);
    light->SetFocalPoint(0, 0, 0);
    this->Renderer->RemoveAllLights();
    this->Renderer->AddLight(light);
  }

  void Look(const glm::dvec3& eye, const glm::dvec3& at, double nearest, double farthest)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(at.x, at.y, at.z);
    camera->SetViewUp(0.1, 0.2, 1);
    camera->SetViewAngle(30);
    camera->SetClippingRange(nearest, farthest);
  }

  /// meet: tells all layers of the surface that a ray meets.
  vtkActor* Add(vtkMapper* mapper, const glm::dvec3& color, double opacity, const Meet& meet)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(color.x, color.y, color.z);
    actor->GetProperty()->SetOpacity(opacity);
    actor->GetProperty()->SetAmbient(0);
    actor->GetProperty()->SetLighting(this->TowardsLight.has_value());
    this->Renderer->AddActor(actor);
    this->Surfaces.push_back(meet);
    return actor;
  }

  /// The isosurface of an image. own: the colour of a hit whose label has one, RGBA.
  template <typename Mapper = vtkHaspClusteredCellMapper>
  vtkSmartPointer<Mapper> AddCells(vtkImageData* image, double isovalue, const glm::dvec3& color,
    double opacity, const std::function<glm::dvec4(const TrilinearHit&)>& own = {})
  {
    auto mapper = vtkSmartPointer<Mapper>::New();
    mapper->SetInputData(image);
    mapper->SetIsoValue(isovalue);
    const int number = int(this->Surfaces.size());
    this->Add(mapper, color, opacity,
      [=, this, keep = vtkSmartPointer<vtkImageData>(image)](
        const Ray& ray, std::vector<Layer>& layers)
      {
        for (const TrilinearHit& hit :
          AllTrilinearHits(ViewImage(keep), isovalue, ray.first, ray.second))
        {
          const glm::dvec4 rgba = own ? own(hit) : glm::dvec4(color, 1.0);
          layers.push_back(
            { hit.t, this->Shaded(glm::dvec3(rgba), hit.gradient, ray), rgba.a * opacity, number });
        }
      });
    return mapper;
  }

  template <typename Mapper = vtkHaspClusteredCellMapper>
  vtkSmartPointer<Mapper> AddBody(
    const AnalyticVolume& shape, const glm::dvec3& color, double opacity)
  {
    const GridGeometry grid{ { 44, 44, 44 }, glm::dvec3(-25.8), glm::dvec3(1.2), glm::dmat3(1) };
    return this->AddCells<Mapper>(
      MakeImage(grid, SampleAnalytic<std::int16_t>(shape, grid, 100, 0)), 0.0, color, opacity);
  }

  /// A parallelogram from a corner along two edges.
  void AddPlane(const glm::dvec3& corner, const glm::dvec3& edge1, const glm::dvec3& edge2,
    const glm::dvec3& color, double opacity)
  {
    const glm::dvec3 end1 = corner + edge1, end2 = corner + edge2;
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(corner.x, corner.y, corner.z);
    plane->SetPoint1(end1.x, end1.y, end1.z);
    plane->SetPoint2(end2.x, end2.y, end2.z);
    this->AddMesh(plane->GetOutputPort(), color, opacity,
      [=](const Ray& ray, const auto& met)
      {
        const glm::dvec3 at = Solve(ray, corner, edge1, edge2); // t, and along the edges
        if (at.x >= 0 && at.y >= 0 && at.y <= 1 && at.z >= 0 && at.z <= 1)
          met(at.x, glm::cross(edge1, edge2));
      });
  }

  /// The triangles of a mesh, each asked by itself; they have no normals of their own.
  void AddTriangles(vtkPolyData* mesh, const glm::dvec3& color, double opacity)
  {
    std::vector<std::array<glm::dvec3, 3>> corners;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      mesh->GetCellPoints(cell, count, points);
      auto& triangle = corners.emplace_back();
      for (int n = 0; n < 3; ++n)
        mesh->GetPoint(points[n], glm::value_ptr(triangle[n]));
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    this->AddMeshMapper(mapper, color, opacity,
      [corners](const Ray& ray, const auto& met)
      {
        for (const auto& c : corners)
        {
          const glm::dvec3 at = Solve(ray, c[0], c[1] - c[0], c[2] - c[0]);
          if (at.x >= 0 && at.y >= 0 && at.z >= 0 && at.y + at.z <= 1)
            met(at.x, glm::cross(c[1] - c[0], c[2] - c[0]));
        }
      });
  }

  /// Draws, and holds every pixel against the truth. One that is wrong is left out if it lies on a
  /// silhouette: rays a fiftieth of a pixel to its sides do not meet what its middle meets, so that
  /// the rounding of OpenGL (1/256 pixel for polygons) decides what it shows.
  LayerError Compare()
  {
    this->Window->Render();
    const int* size = this->Window->GetSize();
    this->Size = { size[0], size[1] };
    vtkMatrix4x4* clip = this->Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      this->Renderer->GetTiledAspectRatio(), -1, 1);
    this->ClipToWorld = glm::inverse(glm::transpose(glm::dmat4(glm::make_mat4(clip->GetData()))));
    vtkNew<vtkUnsignedCharArray> shown;
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, shown);
    LayerError error;
    double squares = 0.0;
    for (int pixel = 0; pixel < size[0] * size[1]; ++pixel)
    {
      const glm::dvec2 at(pixel % size[0] + 0.5, pixel / size[0] + 0.5);
      const std::vector<Layer> truth = this->LayersAt(at);
      const glm::dvec3 owed = 255.0 * BlendLayers(truth, this->Behind);
      double off = 0.0;
      for (int c = 0; c < 3; ++c)
        off = std::max(off, std::abs(shown->GetValue(3 * pixel + c) - owed[c]));
      if (off > LayerError::Allowed && this->IsOnSilhouette(at, truth))
      {
        ++error.silhouettes;
        continue;
      }
      squares += off * off;
      error.largest = std::max(error.largest, off);
      error.wrong += off > LayerError::Allowed;
      error.deep += truth.size() >= 4;
      error.layers = std::max(error.layers, truth.size());
      ++error.compared;
    }
    error.rms = std::sqrt(squares / std::max(1, error.compared));
    return error;
  }

private:
  /// origin + t * direction = corner + u * edge1 + v * edge2; not finite where they are parallel.
  static glm::dvec3 Solve(
    const Ray& ray, const glm::dvec3& corner, const glm::dvec3& edge1, const glm::dvec3& edge2)
  {
    return glm::inverse(glm::dmat3(-ray.second, edge1, edge2)) * (ray.first - corner);
  }

  template <typename Find>
  void AddMesh(vtkAlgorithmOutput* mesh, const glm::dvec3& color, double opacity, const Find& find)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(mesh);
    this->AddMeshMapper(mapper, color, opacity, find);
  }

  template <typename Find>
  void AddMeshMapper(vtkMapper* mapper, const glm::dvec3& color, double opacity, const Find& find)
  {
    const int number = int(this->Surfaces.size());
    vtkActor* actor = this->Add(mapper, color, opacity,
      [=, this](const Ray& ray, std::vector<Layer>& layers)
      {
        find(ray,
          [&](double t, const glm::dvec3& normal) {
            layers.push_back({ t, this->Shaded(color, normal, ray), opacity, number });
          });
      });
    actor->GetProperty()->SetInterpolationToFlat();
  }

  glm::dvec3 Shaded(const glm::dvec3& color, const glm::dvec3& normal, const Ray& ray) const
  {
    if (!this->TowardsLight)
      return color;
    const glm::dvec3 unit = glm::normalize(normal);
    const double facing = glm::dot(unit, *this->TowardsLight);
    return color * std::max(0.0, glm::dot(unit, ray.second) > 0 ? -facing : facing);
  }

  /// pixels: from the lower left corner
  std::vector<Layer> LayersAt(const glm::dvec2& pixels) const
  {
    const auto world = [&](double z)
    {
      const glm::dvec2 device = 2.0 * pixels / glm::dvec2(this->Size) - 1.0;
      const glm::dvec4 p = this->ClipToWorld * glm::dvec4(device, z, 1.0);
      return glm::dvec3(p) / p.w;
    };
    const glm::dvec3 from = world(-1);
    const Ray ray{ from, glm::normalize(world(1) - from) };
    std::vector<Layer> layers;
    for (const Meet& meet : this->Surfaces)
      meet(ray, layers);
    return SortLayers(layers);
  }

  bool IsOnSilhouette(const glm::dvec2& at, const std::vector<Layer>& middle) const
  {
    for (const double x : { -0.02, 0.02 })
      for (const double y : { -0.02, 0.02 })
        if (!SameSurfaces(middle, this->LayersAt(at + glm::dvec2(x, y))))
          return true;
    return false;
  }

  std::optional<glm::dvec3> TowardsLight;
  std::vector<Meet> Surfaces;
  glm::dvec3 Behind{};
  glm::ivec2 Size{};
  glm::dmat4 ClipToWorld{ 1.0 };
};

} // namespace hasp::testing
