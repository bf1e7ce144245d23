#include "LayerPicture.h"

#include "Evaluation/TrilinearTruth.h"
#include "Grid/AnalyticVolumes.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkImageData.h"
#include "vtkLightsPass.h"
#include "vtkMatrix4x4.h"
#include "vtkOpaquePass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double Opacity = 0.5;
const glm::dvec3 Background(51 / 255.0, 102 / 255.0, 204 / 255.0); // as 8 bits have it

vtkSmartPointer<vtkRenderPass> PlainPass()
{
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkRenderPassCollection> passes;
  for (vtkRenderPass* pass : { static_cast<vtkRenderPass*>(lights),
         static_cast<vtkRenderPass*>(opaque), static_cast<vtkRenderPass*>(translucent) })
    passes->AddItem(pass);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

} // namespace

LayerPicture::LayerPicture(int layers) : Plain(PlainPass())
{
  if (layers < 4 || layers > 12 || layers % 2 != 0)
    throw std::invalid_argument(
      std::to_string(layers) + " layers: choose an even number from 4 to 12");
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(Width, Height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(Background.x, Background.y, Background.z);
  this->Renderer->SetOcclusionRatio(0.0);
  this->Renderer->SetMaximumNumberOfPeels(layers);
  constexpr glm::dvec3 colors[] = { { 1, 0.8, 0.6 }, { 0.2, 0.8, 0.6 }, { 0.9, 0.9, 0.1 },
    { 0.8, 0.2, 0.9 }, { 0.1, 0.3, 0.3 } };
  for (int ball = 0; ball < layers / 2 - 1; ++ball)
    this->AddBall(22.0 - 4.0 * ball, colors[ball]);
  this->AddPlane({ -30, -5, -30 }, { 60, 5, 0 }, { 0, 3, 60 }, { 1, 0, 0 });
  this->AddPlane({ -30, 4, -30 }, { 60, -5, 0 }, { 0, 3, 60 }, { 0, 0, 1 });
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(40, -90, 35);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0.1, 0.2, 1);
  camera->SetViewAngle(30);
  camera->SetClippingRange(40, 180);
}

void LayerPicture::Add(vtkMapper* mapper, const glm::dvec3& color,
  const std::function<std::vector<double>(const Ray&)>& meet)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.x, color.y, color.z);
  actor->GetProperty()->SetOpacity(Opacity);
  actor->GetProperty()->SetAmbient(0);
  actor->GetProperty()->LightingOff();
  this->Renderer->AddActor(actor);
  const int number = static_cast<int>(this->Surfaces.size());
  this->Surfaces.push_back(
    [=](const Ray& ray, std::vector<Layer>& layers)
    {
      for (const double t : meet(ray))
        layers.push_back({ t, color, Opacity, number });
    });
}

void LayerPicture::AddBall(double radius, const glm::dvec3& color)
{
  const GridGeometry grid{ glm::ivec3(24), glm::dvec3(-25.3), glm::dvec3(2.2), glm::dmat3(1) };
  const auto image = MakeImage(
    grid, SampleAnalytic<std::int16_t>(AnalyticSphere({ 0, 0, 0 }, radius), grid, 100, 0));
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetIsoValue(0);
  this->Add(mapper, color,
    [image](const Ray& ray)
    {
      std::vector<double> met;
      for (const TrilinearHit& hit : AllTrilinearHits(ViewImage(image), 0.0, ray.first, ray.second))
        met.push_back(hit.t);
      return met;
    });
}

void LayerPicture::AddPlane(const glm::dvec3& corner, const glm::dvec3& edge1,
  const glm::dvec3& edge2, const glm::dvec3& color)
{
  const glm::dvec3 end1 = corner + edge1, end2 = corner + edge2;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(corner.x, corner.y, corner.z);
  plane->SetPoint1(end1.x, end1.y, end1.z);
  plane->SetPoint2(end2.x, end2.y, end2.z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  this->Add(mapper, color,
    [=](const Ray& ray) -> std::vector<double>
    {
      // origin + t * direction = corner + u * edge1 + v * edge2
      const glm::dvec3 at =
        glm::inverse(glm::dmat3(-ray.second, edge1, edge2)) * (ray.first - corner);
      const bool met = at.x >= 0 && at.y >= 0 && at.y <= 1 && at.z >= 0 && at.z <= 1;
      return met ? std::vector{ at.x } : std::vector<double>();
    });
}

Timing LayerPicture::Draw(LayerOrder order)
{
  this->Renderer->SetUseDepthPeeling(order == LayerOrder::Peeled);
  this->Renderer->SetPass(order == LayerOrder::Unsorted ? this->Plain.Get() : nullptr);
  return TimeOf(
    [&]
    {
      this->Window->Render();
      this->Window->WaitForCompletion();
    });
}

std::vector<Layer> LayerPicture::LayersAt(const glm::dvec2& pixels) const
{
  const auto world = [&](double z)
  {
    const glm::dvec2 device = 2.0 * pixels / glm::dvec2(Width, Height) - 1.0;
    const glm::dvec4 p = this->ClipToWorld * glm::dvec4(device, z, 1.0);
    return glm::dvec3(p) / p.w;
  };
  const glm::dvec3 from = world(-1);
  const Ray ray{ from, glm::normalize(world(1) - from) };
  std::vector<Layer> layers;
  for (const auto& meet : this->Surfaces)
    meet(ray, layers);
  return SortLayers(layers);
}

void LayerPicture::FindTruth()
{
  vtkMatrix4x4* clip = this->Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    this->Renderer->GetTiledAspectRatio(), -1, 1);
  this->ClipToWorld = glm::inverse(glm::transpose(glm::dmat4(glm::make_mat4(clip->GetData()))));
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    const glm::dvec2 middle(pixel % Width + 0.5, pixel / Width + 0.5);
    const std::vector<Layer> layers = this->LayersAt(middle);
    bool counts = true;
    for (const double x : { -0.02, 0.02 })
      for (const double y : { -0.02, 0.02 })
        counts = counts && SameSurfaces(layers, this->LayersAt(middle + glm::dvec2(x, y)));
    this->Truth.push_back({ 255.0 * BlendLayers(layers, Background), counts });
  }
}

LayerPicture::Error LayerPicture::FindError()
{
  if (this->Truth.empty())
    this->FindTruth();
  vtkNew<vtkUnsignedCharArray> shown;
  this->Window->GetPixelData(0, 0, Width - 1, Height - 1, 0, shown);
  Error error;
  double squares = 0.0;
  int counted = 0;
  for (std::size_t pixel = 0; pixel < this->Truth.size(); ++pixel)
    for (int c = 0; c < 3 && this->Truth[pixel].counts; ++c, ++counted)
    {
      const double off =
        std::abs(shown->GetValue(3 * vtkIdType(pixel) + c) - this->Truth[pixel].color[c]);
      error.largest = std::max(error.largest, off);
      squares += off * off;
    }
  error.rms = std::sqrt(squares / std::max(1, counted));
  return error;
}

} // namespace hasp
