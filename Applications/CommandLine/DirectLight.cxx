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
#include <array>
#include <span>

namespace hasp
{
namespace
{
constexpr std::size_t Packet = 16; // hits that CellTracer::Sees takes at once
}

struct DirectLight::Internals
{
  explicit Internals(const IsosurfaceView& seen)
    : view(seen),
      grid(ViewImage(seen.image)),
      tracer(std::make_shared<const ClusteredCells>(
        ExtractActiveCells(grid, MinMaxBlocks(grid), seen.isovalue)))
  {
  }
  /// Some pixels that met something, at most 16.
  void Shade(
    std::span<const std::size_t> pixels, const DirectLightSettings& settings, std::uint32_t number);
  CellHit HitOf(std::size_t pixel) const;

  const IsosurfaceView& view;
  AnyGridView grid;
  CellTracer tracer;
  TracedPicture traced;
  PictureTruth picture;
};

/// What the pixel shows; fromInside is left out.
CellHit DirectLight::Internals::HitOf(std::size_t pixel) const
{
  CellHit hit{};
  hit.number = this->traced.cells[pixel];
  hit.cell = this->traced.corners[pixel];
  hit.local = this->traced.places[pixel];
  hit.gradient = glm::vec3(this->traced.gradients[pixel]);
  return hit;
}

void DirectLight::Internals::Shade(
  std::span<const std::size_t> pixels, const DirectLightSettings& settings, std::uint32_t number)
{
  const GridGeometry& geometry = this->tracer.Cells().geometry;
  std::array<CellHit, Packet> hits;
  std::array<double, Packet> facing;
  for (std::size_t n = 0; n < pixels.size(); ++n)
  {
    CellHit& hit = hits[n] = this->HitOf(pixels[n]);
    const glm::dvec3 toEye =
      glm::make_vec3(this->view.camera->GetPosition()) - geometry.IndexToWorld(hit.Position());
    const glm::dvec3 gradient = geometry.GradientToWorld(glm::dvec3(hit.gradient));
    hit.fromInside = glm::dot(gradient, toEye) > 0.0;
    facing[n] = DiffuseShade(gradient, toEye, settings.towardsLight);
  }
  const std::uint32_t seen =
    this->tracer.Sees(std::span(hits).first(pixels.size()), glm::dvec4(settings.towardsLight, 0.0));
  for (std::size_t n = 0; n < pixels.size(); ++n)
  {
    const bool lit = facing[n] > 0.0 && (seen >> n & 1U) != 0;
    const float open = this->tracer.AmbientOcclusion(hits[n],
      { settings.rays, settings.darkeningMm }, std::uint32_t(pixels[n]) + 1'000'003U * number);
    this->picture.pixels[pixels[n]] = glm::vec3(
      open * float(RaycachingScene::Ambient + (lit ? RaycachingScene::Diffuse * facing[n] : 0.0)));
  }
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
      std::array<std::size_t, Packet> pixels;
      std::size_t count = 0;
      for (auto n = std::size_t(first); n < std::size_t(last); ++n)
      {
        if (in.traced.cells[n] != TracedPicture::Nothing)
          pixels[count++] = n;
        if (count == Packet || n + 1 == std::size_t(last))
        {
          in.Shade(std::span(pixels).first(count), settings, number);
          count = 0;
        }
      }
    });
}

const PictureTruth& DirectLight::Picture() const
{
  return this->Inside->picture;
}

} // namespace hasp
