// Light that adds up, against closed forms and against rays of each picture alone.
#include "Grid/AnalyticVolumes.h"
#include "Isosurface/Testing/LitScene.h"

#include <glm/gtc/constants.hpp>

#include <numeric>

namespace
{

using namespace hasp::testing;
constexpr double Pi = glm::pi<double>();

hasp::GridGeometry Grid(const glm::ivec3& dims, const glm::dvec3& spacing)
{
  return { dims, {}, spacing, glm::dmat3(1) };
}

TracedVolume<std::int16_t> Gyroid()
{
  const hasp::GridGeometry g = Cube({ 60, 50, 70 });
  return { hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(16), g, 100, 0), g, 0.5 };
}

/// From outside, `degrees` around the volume.
hasp::PictureView Around(const hasp::GridGeometry& g, double degrees, const glm::ivec2& size)
{
  const glm::dvec3 middle = g.IndexToWorld(0.5 * glm::dvec3(g.dims - 1));
  const double turn = glm::radians(degrees);
  return ViewFrom(
    g, middle + 110.0 * glm::dvec3(std::cos(turn), std::sin(turn), 0.3), middle, size);
}

TEST(LightCache, OpenPlaneIsOpenFromTheFirstFrame)
{
  for (const glm::dvec3& spacing : { glm::dvec3(1), glm::dvec3(0.4, 0.9, 2.0) })
  {
    const hasp::GridGeometry g = Grid({ 40, 40, 40 }, spacing);
    const glm::dvec3 middle = g.IndexToWorld({ 19.3, 19.6, 19.1 });
    const auto plane = FieldVolume(g, [&](const glm::dvec3& p)
      { return glm::dot(middle - p, glm::normalize(glm::dvec3(0.3, -0.2, 0.9))); });
    hasp::LightCache cache;
    for (int frame = 0; frame < 3; ++frame)
    {
      const auto seen = LightOf(cache, plane,
        ViewFrom(g, middle + glm::dvec3(frame, 0, 60), middle, { 50, 41 }), { 1e9, {} });
      ASSERT_GT(seen.hits.size(), 300);
      ASSERT_GT(cache.Rays(), 0);
      for (std::size_t n = 0; n < seen.hits.size(); ++n)
      {
        ASSERT_EQ(seen.open[n], 1.0F) << frame;
        ASSERT_EQ(seen.lit[n], 1.0F) << "no shadow was asked for";
      }
    }
  }
}

TEST(LightCache, SidesOfAThinShellDoNotMix)
{
  // A hollow ball with a wall of 1.2 voxels: its inside is dark, exactly, its outside open, and
  // both are kept around the same corners.
  const hasp::GridGeometry g = Grid({ 40, 40, 40 }, glm::dvec3(1));
  const glm::dvec3 middle = g.IndexToWorld({ 19.5, 19.5, 19.5 });
  const auto shell = FieldVolume(
    g, [&](const glm::dvec3& p) { return 0.6 - std::abs(glm::distance(p, middle) - 14.0); });
  hasp::LightCache cache;
  for (int frame = 0; frame < 8; ++frame)
  {
    const glm::dvec3 way = glm::normalize(glm::dvec3(1.0, 0.1 * frame, 0.2));
    const auto outside =
      LightOf(cache, shell, ViewFrom(g, middle + 50.0 * way, middle, { 48, 48 }), { 1e9, {} });
    const auto inside = LightOf(
      cache, shell, ViewFrom(g, middle - 4.0 * way, middle + 14.0 * way, { 48, 48 }), { 1e9, {} });
    ASSERT_GT(inside.hits.size(), 2000);
    for (const float open : inside.open)
      ASSERT_EQ(open, 0.0F) << frame;
    ASSERT_GT(outside.hits.size(), 500);
    // A ball is convex, but for trilinear patches that bulge by a hundredth of a voxel.
    for (const float open : outside.open)
      ASSERT_GT(open, 0.6F) << frame;
    EXPECT_GT(
      std::accumulate(outside.open.begin(), outside.open.end(), 0.0) / double(outside.open.size()),
      0.97);
  }
}

TEST(LightCache, FloorBesideAWallConvergesToTheClosedForm)
{
  // As CellTracerLight.WallWithinReachMatchesTheClosedForm has it. The floor is smooth, so that
  // blur takes little away and noise is seen to fall as it should.
  const hasp::GridGeometry g = Grid({ 60, 70, 60 }, glm::dvec3(0.5));
  const auto corner =
    FieldVolume(g, [](const glm::dvec3& p) { return std::max(5.0 - p.z, 6.0 - p.x); });
  const double reach = 12.0;
  const auto expected = [&](const hasp::CellHit& hit)
  {
    const double c = std::min((g.IndexToWorld(hit.Position()).x - 6.0) / reach, 1.0);
    return 1.0 - (std::acos(c) - c * std::sqrt(1 - c * c)) / Pi;
  };
  // The floor alone is in view: from above, away from the wall and from the volume's ends.
  const auto view = ViewFrom(g, { 15, 17, 28 }, { 15, 17, 5 }, { 64, 64 }, 22.0);
  hasp::LightCache cache;
  double first = 0, last = 0, x = 0, y = 0, xx = 0, xy = 0, count = 0;
  for (int frame = 1; frame <= 256; ++frame)
  {
    const auto seen = LightOf(cache, corner, view, { reach, {} });
    ASSERT_EQ(seen.hits.size(), 64 * 64);
    last = seen.Error(expected);
    if (frame == 1)
      first = last;
    if ((frame & (frame - 1)) != 0 || frame < 8) // till then the coarser lattice makes way
      continue;
    const double u = std::log(frame), v = std::log(last);
    x += u, y += v, xx += u * u, xy += u * v, ++count;
  }
  EXPECT_LT(first, 0.03) << "as 16 rays a pixel";
  EXPECT_NEAR((count * xy - x * y) / (count * xx - x * x), -0.5, 0.1);
  EXPECT_LT(last, 0.006); // 8 bits round off 0.001
}

TEST(LightCache, BeatsSixteenRaysAPixelWhereTheCameraMoves)
{
  const auto gyroid = Gyroid();
  const double distance = 10;
  hasp::LightCache cache;
  for (int frame = 1; frame <= 8; ++frame)
  {
    const auto seen =
      LightOf(cache, gyroid, Around(gyroid.view.geometry, frame, { 96, 96 }), { distance, {} });
    if (frame < 8)
      continue;
    double cached = 0.0, direct = 0.0;
    for (std::size_t n = 0; n < seen.hits.size(); n += 9)
    {
      const auto rays = [&](int count, unsigned seed) {
        return gyroid.tracer.AmbientOcclusion(seen.hits[n], { count, distance }, seed);
      };
      const float truth = rays(1024, 999);
      cached += std::pow(seen.open[n] - truth, 2);
      direct += std::pow(rays(16, static_cast<unsigned>(n)) - truth, 2);
    }
    EXPECT_LT(cached, direct);
    EXPECT_LT(cache.Rays(), std::int64_t(seen.hits.size()));
  }
}

TEST(LightCache, ShadowsAreThoseOfTheTracer)
{
  const auto gyroid = Gyroid();
  const hasp::GridGeometry& g = gyroid.view.geometry;
  const glm::dvec3 lamp = g.IndexToWorld({ 80, 20, 60 });
  hasp::LightCache cache;
  const auto view = Around(g, 20, { 80, 70 });
  const auto far = LightOf(cache, gyroid, view, { {}, glm::dvec4(1, 0.3, 0.5, 0) });
  const auto near = LightOf(cache, gyroid, view, { {}, glm::dvec4(lamp, 1) });
  EXPECT_EQ(cache.Rays(), 0) << "ambient occlusion was not asked for";
  int lit = 0, shaded = 0;
  ASSERT_GT(far.hits.size(), 1000);
  for (std::size_t n = 0; n < far.hits.size(); ++n)
  {
    ASSERT_EQ(far.lit[n], gyroid.tracer.Light(far.hits[n], { { 1, 0.3, 0.5 } }));
    const glm::dvec3 to = lamp - g.IndexToWorld(far.hits[n].Position());
    ASSERT_EQ(near.lit[n], gyroid.tracer.Light(far.hits[n], { to, 0.0, 1, glm::length(to) }));
    ASSERT_EQ(near.open[n], 1.0F);
    ++(near.lit[n] > 0.5F ? lit : shaded);
  }
  EXPECT_GT(lit, 100);
  EXPECT_GT(shaded, 100);
}

TEST(LightCache, RangesAreChecked)
{
  using Settings = hasp::LightCacheSettings;
  EXPECT_THROW(hasp::LightCache(Settings{ 1000, 2.0, 0.25 }), std::invalid_argument);
  EXPECT_THROW(hasp::LightCache(Settings{ 32, 2.0, 0.25 }), std::invalid_argument);
  EXPECT_THROW(hasp::LightCache(Settings{ 64, 0.0, 0.25 }), std::invalid_argument);
  EXPECT_THROW(hasp::LightCache(Settings{ 64, 2.0, 0.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::LightCache(Settings{ 64, NAN, 0.5 }), std::invalid_argument);
  const auto gyroid = Gyroid();
  const auto view = Around(gyroid.view.geometry, 0, { 8, 8 });
  hasp::TracedPicture picture;
  gyroid.tracer.TracePicture(view, picture);
  hasp::LightCache cache(Settings{ 64 });
  hasp::PictureLight light;
  const auto ask = [&](const hasp::PictureLightSettings& settings)
  { cache.Light(gyroid.tracer, view, picture, settings, light); };
  EXPECT_THROW(ask({ 0.0, {} }), std::invalid_argument);
  EXPECT_THROW(ask({ NAN, {} }), std::invalid_argument);
  EXPECT_THROW(ask({ {}, glm::dvec4(0) }), std::invalid_argument);
  EXPECT_THROW(ask({ {}, glm::dvec4(0, NAN, 1, 0) }), std::invalid_argument);
  picture.size.x = 7;
  EXPECT_THROW(ask({ 5.0, {} }), std::invalid_argument);
}

} // namespace
