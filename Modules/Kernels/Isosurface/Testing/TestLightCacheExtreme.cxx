// Light in volumes and views at the edges of what there is.
#include "Isosurface/Testing/LitScene.h"

#include <cmath>

namespace
{

using namespace hasp::testing;

/// A floor at z = 10.3 and a wall at x = 12, in steps of the grid.
TracedVolume<float> Corner(const glm::dvec3& spacing)
{
  const hasp::GridGeometry g{ { 40, 40, 40 }, {}, spacing, glm::dmat3(1) };
  return FieldVolume(g,
    [&](const glm::dvec3& p) { return std::max(10.3 - p.z / spacing.z, 12.0 - p.x / spacing.x); });
}

TEST(LightCacheExtreme, ScaleChangesNothing)
{
  const auto lightOf = [](double scale)
  {
    const auto scene = Corner(glm::dvec3(scale));
    hasp::LightCache cache;
    LitPicture seen;
    for (int frame = 0; frame < 3; ++frame)
      seen = LightOf(cache, scene,
        ViewFrom(
          scene.view.geometry, scale * glm::dvec3(70, 25, 60), scale * glm::dvec3(20), { 64, 64 }),
        { 10.0 * scale, {} });
    return seen.open;
  };
  // Powers of two: the same digits all the way.
  const auto one = lightOf(1.0);
  ASSERT_GT(one.size(), 1000);
  EXPECT_EQ(lightOf(0x1p-30), one);
  EXPECT_EQ(lightOf(0x1p30), one);
}

TEST(LightCacheExtreme, VoxelsOf100To1AreLitWell)
{
  for (const glm::dvec3& spacing : { glm::dvec3(1, 1, 0.01), glm::dvec3(0.01, 1, 1) })
  {
    const auto scene = Corner(spacing);
    const hasp::GridGeometry& g = scene.view.geometry;
    const glm::dvec3 middle = g.IndexToWorld({ 20, 20, 10 });
    const glm::dvec3 way =
      glm::normalize(glm::dvec3(1, 0.1, 1) / spacing); // towards the large face
    hasp::LightCache cache;
    LitPicture seen;
    for (int frame = 0; frame < 8; ++frame)
      seen =
        LightOf(cache, scene, ViewFrom(g, middle + 50.0 * way, middle, { 64, 64 }), { 10.0, {} });
    ASSERT_GT(seen.hits.size(), 1000);
    const double error = seen.Error(
      [&](const hasp::CellHit& hit) {
        return scene.tracer.AmbientOcclusion(hit, { 256, 10.0 }, 1);
      });
    EXPECT_LT(error, 0.04) << "as 16 rays a pixel";
  }
}

TEST(LightCacheExtreme, ViewsFromNowhereAreLit)
{
  const auto scene = Corner(glm::dvec3(1));
  const hasp::GridGeometry& g = scene.view.geometry;
  const glm::dvec3 target(25, 20, 10.3);
  for (const double far : { 1e-3, 1.0, 1e4 })
  {
    hasp::LightCache cache;
    for (const glm::ivec2& size : { glm::ivec2(1), glm::ivec2(128, 2), glm::ivec2(32) })
    {
      const double degrees = std::min(40.0, glm::degrees(60.0 / far));
      const auto seen = LightOf(cache, scene,
        ViewFrom(g, target + far * glm::dvec3(0.1, 0, 1), target, size, degrees), { 8.0, {} });
      ASSERT_GT(seen.hits.size(), 0) << far;
      for (std::size_t n = 0; n < seen.hits.size(); ++n)
        ASSERT_TRUE(seen.open[n] >= 0.0F && seen.open[n] <= 1.0F) << far;
    }
  }
  // Nothing to light, and no pixels.
  hasp::LightCache cache;
  for (const glm::ivec2& size : { glm::ivec2(0, 5), glm::ivec2(8, 8) })
  {
    hasp::PictureView away = ViewFrom(g, { 20, 20, 100 }, { 20, 20, 200 }, { 8, 8 });
    away.size = size;
    const auto seen = LightOf(cache, scene, away, { 8.0, glm::dvec4(0, 0, 1, 0) });
    EXPECT_TRUE(seen.hits.empty());
    EXPECT_EQ(cache.Rays(), 0);
  }
}

TEST(LightCacheExtreme, NaNSamplesAndInfiniteDistancesAreLit)
{
  auto scene = Corner(glm::dvec3(1));
  for (std::size_t n = 0; n < scene.samples.size(); n += 97)
    scene.samples[n] = n % 2 ? std::nanf("") : INFINITY;
  const TracedVolume<float> holes(scene.samples, scene.view.geometry, 0.0);
  hasp::LightCache cache;
  for (int frame = 0; frame < 4; ++frame)
  {
    const auto seen = LightOf(cache, holes,
      ViewFrom(holes.view.geometry, { 80, 25, 70 }, { 20, 20, 10 }, { 64, 64 }),
      { std::numeric_limits<double>::infinity(), glm::dvec4(1, 0, 1, 0) });
    ASSERT_GT(seen.hits.size(), 1000);
    for (std::size_t n = 0; n < seen.hits.size(); ++n)
      ASSERT_TRUE(seen.open[n] >= 0.0F && seen.open[n] <= 1.0F);
  }
}

} // namespace
