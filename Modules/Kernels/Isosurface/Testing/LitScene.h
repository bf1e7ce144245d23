#pragma once
// Volumes of a field, seen by a camera and lit through a LightCache.
#include "Isosurface/LightCache.h"
#include "Isosurface/Testing/TracedVolume.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>

namespace hasp::testing
{

/// A float volume of a field given at world positions, > 0 inside.
inline TracedVolume<float> FieldVolume(
  const GridGeometry& g, const std::function<double(const glm::dvec3&)>& field)
{
  std::vector<float> samples;
  samples.reserve(g.Size());
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        samples.push_back(static_cast<float>(field(g.IndexToWorld({ i, j, k }))));
  return { std::move(samples), g, 0.0 };
}

/// A camera in world coordinates; the geometry must not be rotated.
inline PictureView ViewFrom(const GridGeometry& g, const glm::dvec3& eye, const glm::dvec3& to,
  const glm::ivec2& size, double degrees = 40.0)
{
  const double far = glm::distance(eye, to);
  const glm::dvec3 up =
    std::abs(to.z - eye.z) > 0.9 * far ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  return { glm::perspective(
             glm::radians(degrees), double(size.x) / size.y, 1e-3 * far, 10.0 * far) *
             glm::lookAt(eye, to, up) * glm::translate(glm::dmat4(1.0), g.origin) *
             glm::scale(glm::dmat4(1.0), g.spacing),
    size, {} };
}

struct LitPicture
{
  std::vector<CellHit> hits; ///< of the pixels that met something, by tracing them alone
  std::vector<float> open, lit;

  /// RMSE of open against rays of each pixel alone.
  template <typename Truth>
  double Error(const Truth& truth) const
  {
    double sum = 0.0;
    for (std::size_t n = 0; n < this->hits.size(); ++n)
      sum += std::pow(this->open[n] - truth(this->hits[n]), 2);
    return std::sqrt(sum / double(this->hits.size()));
  }
};

template <typename T>
LitPicture LightOf(LightCache& cache, const TracedVolume<T>& scene, const PictureView& view,
  const PictureLightSettings& settings)
{
  TracedPicture picture;
  scene.tracer.TracePicture(view, picture);
  PictureLight light;
  cache.Light(scene.tracer, view, picture, settings, light);
  const PictureRays rays(view);
  LitPicture result;
  EXPECT_EQ(light.size(), picture.cells.size());
  for (std::size_t pixel = 0; pixel < light.size(); ++pixel)
  {
    CellRay ray;
    rays.Of(glm::dvec2(pixel % view.size.x, pixel / view.size.x) + 0.5, ray);
    const auto hit = scene.tracer.Trace(ray);
    if (!hit)
      continue;
    result.hits.push_back(*hit);
    result.open.push_back(light[pixel].x / 255.0F);
    result.lit.push_back(light[pixel].y / 255.0F);
  }
  return result;
}

} // namespace hasp::testing
