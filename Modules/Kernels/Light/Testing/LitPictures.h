#pragma once
// Pictures lit through a SceneLightCache, held against paths of each pixel.
#include "Light/SceneLightCache.h"
#include "Light/Testing/LightScenes.h"

#include <gtest/gtest.h>

namespace hasp::testing
{

using Kind = SceneLightRequest::Kind;

/// A ball of triangles and one of cells upon a plane of 40 mm, all of one material.
struct TwoBalls
{
  SurfaceMaterial material{ glm::vec3(0.7F, 0.6F, 0.5F) };
  glm::dvec3 meshBall{ -4, 0, 4 }, cellBall{ 5, 1, 3 };
  std::vector<LitLamp> lamps;
  std::shared_ptr<const Environment> far = Uniform(1.0);

  std::vector<LitBody> Bodies() const
  {
    const auto surface = Scattering(this->material);
    return { Body(SphereMesh({}, 4.0, 24), surface, glm::translate(glm::dmat4(1), this->meshBall)),
      Body(SphereCells({}, 3.0, 25), surface, glm::translate(glm::dmat4(1), this->cellBall)),
      Body(PlaneMesh(20.0), surface) };
  }
  LitScene Scene() const { return { this->Bodies(), this->lamps, this->far }; }
};

/// Bright above, a little brighter in the east, half as bright below.
inline std::shared_ptr<const Environment> SoftSky()
{
  return Surroundings({ 32, 16 }, [](const glm::dvec3& d) { return 0.8 + 0.4 * d.z + 0.2 * d.x; });
}

/// The same with a sun of 10 degrees.
inline std::shared_ptr<const Environment> SunnySky()
{
  const glm::dvec3 sun = glm::normalize(glm::dvec3(0.5, -0.4, 0.8));
  return Surroundings({ 128, 64 }, [&](const glm::dvec3& d)
    { return 0.5 + 0.25 * d.z + (glm::dot(d, sun) > std::cos(0.087) ? 60.0 : 0.0); });
}

inline PictureView BallsView(const glm::ivec2& size, double degrees = 0.0)
{
  const double turn = glm::radians(degrees - 60.0);
  return Camera({ 32.0 * std::cos(turn), 32.0 * std::sin(turn), 20.0 }, { 0, 0, 2 }, size, 36.0);
}

/// Of so many paths a pixel, through its centre.
inline LitPicture PathsOf(
  const LitScene& scene, const PictureView& view, int bounces, int samples, std::uint32_t seed = 77)
{
  PathTracedPicture picture;
  for (int n = 0; n < samples; ++n)
    AddPathSample(scene, view, { { bounces }, seed, false }, picture);
  LitPicture pixels(picture.sums.size());
  for (std::size_t n = 0; n < pixels.size(); ++n)
    pixels[n] = picture.Pixel(n);
  return pixels;
}

/// RMSE of linear radiance where a body is seen; they must see the same. pixel: which count.
inline double ErrorOf(
  const LitPicture& picture, const LitPicture& truth,
  const std::function<bool(std::size_t)>& counts = [](std::size_t) { return true; })
{
  EXPECT_EQ(picture.size(), truth.size());
  double sum = 0.0;
  int count = 0;
  for (std::size_t n = 0; n < truth.size(); ++n)
  {
    EXPECT_EQ(picture[n].a, truth[n].a) << n;
    if (truth[n].a == 0.0F || !counts(n))
      continue;
    const glm::dvec3 off = glm::dvec3(picture[n]) - glm::dvec3(truth[n]);
    sum += glm::dot(off, off) / 3.0;
    ++count;
  }
  EXPECT_GT(count, 0);
  return std::sqrt(sum / std::max(1, count));
}

/// The light of the last of so many pictures.
inline LitPicture LightOf(SceneLightCache& cache, const LitScene& scene, const PictureView& view,
  const SceneLightRequest& request, int frames = 1)
{
  LitPicture picture;
  for (int n = 0; n < frames; ++n)
    cache.Light(scene, view, {}, request, picture);
  return picture;
}

inline SceneLightRequest Traced(int bounces)
{
  SceneLightRequest request;
  request.paths.bounces = bounces;
  return request;
}

inline SceneLightRequest Open(double distanceMm)
{
  SceneLightRequest request;
  request.kind = Kind::AmbientOcclusion;
  request.distanceMm = distanceMm;
  return request;
}

} // namespace hasp::testing
