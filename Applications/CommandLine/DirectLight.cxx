#include "DirectLight.h"

#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellTracer.h"
#include "RaycachingScene.h"
#include "vtkHaspVolumeView.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace hasp
{

struct DirectLight::Internals
{
  explicit Internals(const IsosurfaceView& seen)
    : view(seen),
      grid(ViewImage(seen.image)),
      tracer(std::make_shared<const ClusteredCells>(
        ExtractActiveCells(grid, MinMaxBlocks(grid), seen.isovalue)))
  {
  }
  /// Of pixel n, which met something.
  float Shade(std::size_t n, const DirectLightSettings& settings, std::uint32_t number) const;

  const IsosurfaceView& view;
  AnyGridView grid;
  CellTracer tracer;
  TracedPicture traced;
  PictureTruth picture;
};

float DirectLight::Internals::Shade(
  std::size_t n, const DirectLightSettings& settings, std::uint32_t number) const
{
  const ClusteredCells& cells = this->tracer.Cells();
  CellHit hit{};
  hit.number = this->traced.cells[n];
  hit.cell = cells.CellIn(cells.ClusterOf(hit.number), hit.number);
  hit.local = glm::vec3(this->traced.places[n]);
  hit.gradient = glm::vec3(this->traced.gradients[n]);
  const glm::dvec3 toEye =
    glm::make_vec3(this->view.camera->GetPosition()) - cells.geometry.IndexToWorld(hit.Position());
  const glm::dvec3 gradient = cells.geometry.GradientToWorld(glm::dvec3(hit.gradient));
  hit.fromInside = glm::dot(gradient, toEye) > 0.0;
  const double facing = DiffuseShade(gradient, toEye, settings.towardsLight);
  const bool lit = facing > 0.0 && this->tracer.Light(hit, { settings.towardsLight }) > 0.0F;
  const float open = this->tracer.AmbientOcclusion(
    hit, { settings.rays, settings.darkeningMm }, std::uint32_t(n) + 1'000'003U * number);
  return open * float(RaycachingScene::Ambient + (lit ? RaycachingScene::Diffuse * facing : 0.0));
}

DirectLight::DirectLight(const IsosurfaceView& view) : Inside(std::make_unique<Internals>(view)) {}
DirectLight::~DirectLight() = default;

void DirectLight::Draw(const DirectLightSettings& settings, std::uint32_t number)
{
  Internals& in = *this->Inside;
  in.tracer.TracePicture(IndexView(in.view, in.grid), in.traced);
  const std::size_t size = in.traced.cells.size();
  in.picture.pixels.assign(size, glm::vec3(0.0F));
  in.picture.surface.assign(size, false);
  for (std::size_t n = 0; n < size; ++n)
    in.picture.surface[n] = in.traced.cells[n] != TracedPicture::Nothing;
  ParallelFor(0, std::int64_t(size), 512,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto n = std::size_t(first); n < std::size_t(last); ++n)
        if (in.traced.cells[n] != TracedPicture::Nothing)
          in.picture.pixels[n] = glm::vec3(in.Shade(n, settings, number));
    });
}

const PictureTruth& DirectLight::Picture() const
{
  return this->Inside->picture;
}

} // namespace hasp
