// Pictures by paths: AddPathSample.
#include "Grid/ParallelFor.h"
#include "Isosurface/EvenPoints.h"
#include "Light/PathTracer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr int TileSide = 16; // pixels: some milliseconds at most, so a cancel is answered soon

/// One sample of a tile's pixels, apart from the picture until all tiles have theirs.
struct Sampled
{
  std::vector<glm::vec3> radiance;
  std::vector<std::uint8_t> covered;
};

struct Sampling
{
  const LitScene& scene;
  const PathTracer<SobolSequence>& tracer;
  const PictureRays& rays;
  const PathPictureSettings& settings;
  glm::ivec2 size;
  std::uint32_t number; ///< of the sample
};

std::int64_t SamplePixel(const Sampling& of, std::size_t pixel, Sampled& sampled)
{
  const glm::dvec2 lower(
    double(pixel % std::size_t(of.size.x)), double(pixel / std::size_t(of.size.x)));
  SobolSequence points(
    HashOf(static_cast<std::uint32_t>(pixel) ^ HashOf(of.settings.seed)), of.number);
  const glm::dvec2 within = of.settings.smoothEdges ? points.Next() : glm::dvec2(0.5);
  CellRay ray;
  if (!of.rays.Of(lower + within, ray))
    return 0;
  const glm::dvec3 direction = glm::normalize(ray.direction);
  const double length = glm::length(ray.direction);
  const auto hit = of.scene.Trace(ray.origin, direction, ray.tMin * length, ray.tMax * length);
  if (!hit)
    return 1;
  const PathSample sample = of.tracer.Radiance(*hit, -direction, points);
  sampled.radiance[pixel] = sample.radiance;
  sampled.covered[pixel] = 1;
  return 1 + sample.rays;
}

} // namespace

glm::vec4 PathTracedPicture::Pixel(std::size_t n) const
{
  const double share = this->samples > 0 ? 1.0 / this->samples : 0.0;
  return { glm::vec3(this->sums[n] * share), this->covered[n] * static_cast<float>(share) };
}

std::size_t PathTracedPicture::Bytes() const
{
  return this->sums.size() * sizeof(this->sums[0]) + this->covered.size() * sizeof(float);
}

bool AddPathSample(const LitScene& scene, const PictureView& view,
  const PathPictureSettings& settings, PathTracedPicture& picture, const std::atomic<bool>* cancel)
{
  if (view.size.x < 0 || view.size.y < 0)
    throw std::invalid_argument("AddPathSample: a picture of " + std::to_string(view.size.x) +
                                " x " + std::to_string(view.size.y) + " pixels");
  const PathTracer<SobolSequence> tracer(scene, settings.paths);
  const PictureRays rays(view);
  const std::size_t pixels = std::size_t(view.size.x) * std::size_t(view.size.y);
  if (picture.size != view.size)
  {
    picture = {};
    picture.size = view.size;
    picture.sums.assign(pixels, glm::dvec3(0.0));
    picture.covered.assign(pixels, 0.0F);
  }
  Sampled sampled{ std::vector<glm::vec3>(pixels, glm::vec3(0.0F)),
    std::vector<std::uint8_t>(pixels, 0) };
  const Sampling of{ scene, tracer, rays, settings, view.size,
    static_cast<std::uint32_t>(picture.samples) };
  const glm::i64vec2 tiles = (view.size + TileSide - 1) / TileSide;
  std::atomic<std::int64_t> cast = 0, left = tiles.x * tiles.y;
  const auto stopped = [&] { return cancel && cancel->load(std::memory_order_relaxed); };
  ParallelFor(0, tiles.x * tiles.y, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      std::int64_t mine = 0;
      for (std::int64_t tile = first; tile < last && !stopped(); ++tile)
      {
        --left;
        const glm::ivec2 from = TileSide * glm::ivec2(tile % tiles.x, tile / tiles.x);
        const glm::ivec2 to = glm::min(from + TileSide, view.size);
        for (int y = from.y; y < to.y; ++y)
          for (int x = from.x; x < to.x; ++x)
            mine += SamplePixel(of, std::size_t(y) * view.size.x + x, sampled);
      }
      cast += mine;
    });
  picture.rays += cast;
  if (left > 0) // who cancels may have taken it back meanwhile, so it is not asked
    return false;
  for (std::size_t n = 0; n < pixels; ++n)
  {
    picture.sums[n] += glm::dvec3(sampled.radiance[n]);
    picture.covered[n] += sampled.covered[n];
  }
  ++picture.samples;
  return true;
}

} // namespace hasp
