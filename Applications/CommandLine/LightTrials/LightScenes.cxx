#include "LightScenes.h"

#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ActiveCells.h"
#include "Light/SkyModel.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

std::shared_ptr<const CellTracer> CellsOf(const AnyGridView& grid, double isovalue)
{
  return std::make_shared<const CellTracer>(
    std::make_shared<const ClusteredCells>(ExtractActiveCells(grid, MinMaxBlocks(grid), isovalue)));
}

std::shared_ptr<const CellTracer> CellsOf(
  const AnalyticVolume& shape, int n, double halfMm, const glm::dvec3& spacingScale)
{
  GridGeometry grid{ glm::ivec3(n), glm::dvec3(-halfMm), glm::dvec3(2.0 * halfMm / (n - 1)),
    glm::dmat3(1) };
  const std::vector<float> samples = SampleAnalytic<float>(shape, grid, 1.0, 0.0);
  grid.origin *= spacingScale;
  grid.spacing *= spacingScale;
  return CellsOf(GridView<const float>{ samples.data(), grid }, 0.0);
}

LitBody BodyOf(std::shared_ptr<const CellTracer> cells, const SurfaceMaterial& material)
{
  return { std::move(cells), nullptr, glm::dmat4(1.0),
    std::make_shared<const SurfaceScattering>(material) };
}

LitBody BodyOf(TriangleMesh mesh, const SurfaceMaterial& material)
{
  return { nullptr, std::make_shared<const TriangleTracer>(LitMesh{ std::move(mesh), {}, {} }),
    glm::dmat4(1.0), std::make_shared<const SurfaceScattering>(material) };
}

TriangleMesh SquareMesh(double halfMm)
{
  const double h = halfMm;
  return { { { -h, -h, 0 }, { h, -h, 0 }, { h, h, 0 }, { -h, h, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } } };
}

std::shared_ptr<const Environment> Daylight()
{
  return std::make_shared<const Environment>(MakeSky({}));
}

std::shared_ptr<const Environment> UniformLight(float radiance)
{
  return std::make_shared<const Environment>(Environment::Uniform(glm::vec3(radiance)));
}

PictureView OrbitView(const LitScene& scene, double degrees, int side)
{
  const glm::dvec3 middle = 0.5 * (scene.Bounds().low + scene.Bounds().high);
  const double far = 1.75 * scene.Bounds().Size(), turn = glm::radians(degrees);
  const glm::dvec3 eye =
    middle + far * glm::normalize(glm::dvec3(std::sin(turn), -std::cos(turn), 0.25));
  return { glm::perspective(glm::radians(30.0), 1.0, 0.4 * far, 2.0 * far) *
             glm::lookAt(eye, middle, glm::dvec3(0, 0, 1)),
    { side, side }, {} };
}

std::vector<SeenHit> SeenHits(const LitScene& scene, const PictureView& view, std::size_t most)
{
  const PictureRays rays(view);
  std::vector<SeenHit> hits;
  for (int y = 0; y < view.size.y; ++y)
    for (int x = 0; x < view.size.x; ++x)
    {
      CellRay ray;
      if (!rays.Of(glm::dvec2(x, y) + 0.5, ray))
        continue;
      const glm::dvec3 direction = glm::normalize(ray.direction);
      if (const auto hit = scene.Trace(ray.origin, direction))
        hits.push_back({ *hit, -direction });
    }
  if (hits.size() <= most)
    return hits;
  std::vector<SeenHit> some;
  for (std::size_t n = 0; n < most; ++n)
    some.push_back(hits[n * hits.size() / most]);
  return some;
}

LightPixels PixelsOf(const PathTracedPicture& picture)
{
  LightPixels pixels(picture.sums.size());
  for (std::size_t n = 0; n < pixels.size(); ++n)
    pixels[n] = picture.Pixel(n);
  return pixels;
}

PathTracedPicture TracePaths(
  const LitScene& scene, const PictureView& view, int bounces, int samples, std::uint32_t seed)
{
  PathTracedPicture picture;
  for (int n = 0; n < samples; ++n)
    AddPathSample(scene, view, { { bounces }, seed, false }, picture);
  return picture;
}

double RmsError(const LightPixels& pixels, const LightPixels& truth)
{
  double sum = 0.0;
  int count = 0;
  for (std::size_t n = 0; n < truth.size(); ++n)
    if (truth[n].a > 0.0F)
    {
      const glm::dvec3 off = glm::dvec3(pixels[n]) - glm::dvec3(truth[n]);
      sum += glm::dot(off, off) / 3.0;
      ++count;
    }
  return std::sqrt(sum / std::max(1, count));
}

double MeanRadiance(const LightPixels& pixels)
{
  double sum = 0.0;
  int count = 0;
  for (const glm::vec4& pixel : pixels)
    if (pixel.a > 0.0F)
    {
      sum += (double(pixel.r) + pixel.g + pixel.b) / 3.0;
      ++count;
    }
  return sum / std::max(1, count);
}

std::uint32_t SeedOf(std::uint64_t seed, std::size_t place)
{
  return static_cast<std::uint32_t>(MixedBits(MixedBits(seed) + place) >> 32U);
}

std::vector<glm::dvec3> MeansOf(
  const std::vector<SeenHit>& hits, int samples, const SampleHit& sample)
{
  std::vector<glm::dvec3> means(hits.size(), glm::dvec3(0.0));
  ParallelFor(0, std::int64_t(hits.size()), 8,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        for (int k = 0; k < samples; ++k)
          means[n] += glm::dvec3(
            sample(hits[n], static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(k)));
        means[n] /= double(samples);
      }
    });
  return means;
}

} // namespace hasp
