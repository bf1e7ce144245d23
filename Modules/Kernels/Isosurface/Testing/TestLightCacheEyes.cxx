// The light of a second eye: what it takes of the first one's, against light of its own.
#include "Grid/AnalyticVolumes.h"
#include "Isosurface/Testing/LitScene.h"

#include <algorithm>
#include <random>

namespace
{

using namespace hasp::testing;
using hasp::LightEye;

const hasp::GridGeometry Grid{ { 60, 50, 30 }, { -20, 5, 3 }, { 0.6, 0.8, 1.3 }, glm::dmat3(1) };
const glm::dvec3 Middle = Grid.IndexToWorld(glm::dvec3(Grid.dims) * 0.5);
const glm::dvec4 Sun(0.3, -0.5, 0.8, 0.0);

TracedVolume<float> Gyroid()
{
  return FieldVolume(Grid, hasp::AnalyticGyroid(13).value);
}

/// An eye beside the middle one, whose head is tilted.
hasp::PictureView Eye(double beside, const glm::dvec3& from = { 70, -60, 55 })
{
  const glm::dvec3 tilted = glm::normalize(glm::dvec3(0.7, 0.6, 0.4));
  return ViewFrom(Grid, Middle + from + beside * tilted, Middle, { 160, 140 }, 30.0);
}

struct Lit
{
  hasp::TracedPicture picture;
  hasp::PictureLight light;
};

Lit Light(hasp::LightCache& cache, const TracedVolume<float>& scene, const hasp::PictureView& view,
  hasp::PictureLightSettings settings, LightEye eye)
{
  settings.eye = eye;
  Lit lit;
  scene.tracer.TracePicture(view, lit.picture);
  cache.Light(scene.tracer, view, lit.picture, settings, lit.light);
  return lit;
}

std::size_t Hits(const Lit& lit)
{
  return lit.light.size() - static_cast<std::size_t>(std::count(lit.picture.cells.begin(),
                              lit.picture.cells.end(), hasp::TracedPicture::Nothing));
}

/// The share of the pixels with surface whose shadow is not that of a ray of their own.
double WrongShadows(const TracedVolume<float>& scene, const hasp::PictureView& view, const Lit& lit)
{
  hasp::LightCache alone;
  const Lit truth = Light(alone, scene, view, { {}, Sun }, LightEye::Alone);
  std::size_t wrong = 0;
  for (std::size_t n = 0; n < truth.light.size(); ++n)
    wrong += truth.light[n].y != lit.light[n].y;
  return double(wrong) / double(Hits(truth));
}

TEST(LightCacheEyes, TheSecondTakesTheShadowsThatBothSee)
{
  const auto scene = Gyroid();
  for (const double apart : { 0.0, 3.0, 12.0 }) // mm, from 95 mm away: none, 2 and 7 degrees
  {
    SCOPED_TRACE(apart);
    hasp::LightCache cache;
    const Lit first = Light(cache, scene, Eye(-0.5 * apart), { {}, Sun }, LightEye::First);
    EXPECT_EQ(cache.SharedPixels(), 0);
    const Lit second = Light(cache, scene, Eye(0.5 * apart), { {}, Sun }, LightEye::Second);
    EXPECT_GT(double(cache.SharedPixels()), 0.35 * double(Hits(second)));
    EXPECT_LT(double(cache.SharedPixels()), 0.95 * double(Hits(second))); // there are edges
    EXPECT_EQ(WrongShadows(scene, Eye(-0.5 * apart), first), 0.0);
    // Shadows thinner than a pixel pass between four: none between pixels of the same eye.
    EXPECT_LE(WrongShadows(scene, Eye(0.5 * apart), second), apart > 0.0 ? 0.002 : 0.0);
  }
}

TEST(LightCacheEyes, TheSecondIsAsGoodAsTheFirstAndCastsFewerRays)
{
  const auto scene = Gyroid();
  const hasp::PictureLightSettings settings{ 6.0, {} };
  const auto truth = [&](const hasp::CellHit& hit) {
    return scene.tracer.AmbientOcclusion(hit, { 64, 6.0 }, hit.number);
  };
  hasp::LightCache cache;
  std::int64_t rays[2] = {};
  double errors[2] = {};
  for (int frame = 0; frame < 6; ++frame)
    for (int eye = 0; eye < 2; ++eye)
    {
      hasp::PictureLightSettings own = settings;
      own.eye = eye == 0 ? LightEye::First : LightEye::Second;
      const auto view = Eye(4.0 * eye - 2.0, { 70, -60 + 0.5 * frame, 55 });
      const LitPicture lit = LightOf(cache, scene, view, own);
      rays[eye] += cache.Rays();
      if (frame == 5)
        errors[eye] = lit.Error(truth);
    }
  EXPECT_LT(double(rays[1]), 0.6 * double(rays[0]));
  EXPECT_LT(errors[1], 1.05 * errors[0]);
}

TEST(LightCacheEyes, TheSecondTakesNothingThatIsNotItsOwn)
{
  const auto scene = Gyroid();
  const hasp::PictureLightSettings sun{ 6.0, Sun };
  const auto second = [&](const std::function<void(hasp::LightCache&)>& between,
                        const hasp::PictureLightSettings& settings, double apart = 3.0)
  {
    hasp::LightCache cache;
    Light(cache, scene, Eye(0.0), sun, LightEye::First);
    between(cache);
    Light(cache, scene, Eye(apart), settings, LightEye::Second);
    return cache.SharedPixels();
  };
  const auto nothing = [](hasp::LightCache&) {};
  EXPECT_GT(second(nothing, sun), 0);
  EXPECT_GT(second(nothing, { 6.0, Sun + glm::dvec4(1e-7, 0, 0, 0) }), 0); // rounded
  EXPECT_EQ(second(nothing, { 6.0, glm::dvec4(0.31, -0.5, 0.8, 0) }), 0);  // another light
  EXPECT_EQ(second(nothing, { 6.0, {} }), 0);
  EXPECT_EQ(second(nothing, { {}, Sun }), 0);
  EXPECT_EQ(second(nothing, { 7.0, Sun }), 0);
  EXPECT_EQ(second([](hasp::LightCache& cache) { cache.Forget(); }, sun), 0);
  EXPECT_EQ(second(
              [](hasp::LightCache& cache) {
                cache.Forget({ 5, 5, 5 }, { 6, 6, 6 });
              },
              sun),
    0);
  const auto elsewhere = [&](hasp::LightCache& cache) // the first eye sees nothing
  {
    auto away = Eye(0.0);
    away.indexToClip[3].x += 1e4;
    Light(cache, scene, away, sun, LightEye::First);
  };
  EXPECT_EQ(second(elsewhere, sun), 0);
  // Nor of another isovalue's surface, which nobody told it of.
  const TracedVolume<float> shifted(scene.samples, Grid, 0.1);
  hasp::LightCache cache;
  Light(cache, scene, Eye(0.0), { {}, Sun }, LightEye::First);
  Light(cache, shifted, Eye(3.0), { {}, Sun }, LightEye::Second);
  EXPECT_EQ(cache.SharedPixels(), 0);
}

TEST(LightCacheEyes, TheSecondMayBeAtTheOtherSideOfTheSurface)
{
  const auto scene = Gyroid(); // seen from where it is cut open
  hasp::LightCache cache;
  Light(cache, scene, Eye(0.0, { -70, 60, -55 }), { {}, Sun }, LightEye::First);
  const Lit second = Light(cache, scene, Eye(0.0), { {}, Sun }, LightEye::Second);
  EXPECT_LE(WrongShadows(scene, Eye(0.0), second), 0.002);
}

/// Rough walls in slices of 3 mm, whose sides lie a voxel or two apart: each has its own light.
TEST(LightCacheEyes, TheSecondTakesNothingOfTheOtherSideOfAThinWall)
{
  const hasp::GridGeometry grid{ { 50, 45, 40 }, { -20, 5, 3 }, { 0.2, 0.2, 3.0 }, glm::dmat3(1) };
  const glm::dvec3 middle = grid.IndexToWorld(glm::dvec3(grid.dims) * 0.5);
  const auto wall = [&](const glm::dvec3& place)
  {
    const glm::dvec3 from = place - middle;
    return 0.9 + 0.5 * std::sin(2.0 * from.y) * std::sin(2.0 * from.z) -
           std::abs(glm::length(from) - 12.0);
  };
  const auto scene = FieldVolume(grid, wall);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  std::size_t hits = 0, wrong[2] = {};
  for (int head = 0; head < 9; ++head)
  {
    const glm::dvec3 at = middle + 80.0 * vector(), to = middle + 4.0 * vector();
    const auto left = ViewFrom(grid, at, to, { 120, 105 }),
               right = ViewFrom(grid, at + 3.0 * vector(), to, { 120, 105 });
    hasp::LightCache cache, alone;
    LitPicture pictures[2];
    for (int frame = 0; frame < 12; ++frame)
    {
      LightOf(cache, scene, left, { 6.0, {}, LightEye::First });
      pictures[0] = LightOf(cache, scene, right, { 6.0, {}, LightEye::Second });
      pictures[1] = LightOf(alone, scene, right, { 6.0, {}, LightEye::Alone });
    }
    for (std::size_t n = 0; n < pictures[0].hits.size(); ++n, ++hits)
    {
      const double truth =
        scene.tracer.AmbientOcclusion(pictures[0].hits[n], { 64, 6.0 }, std::uint32_t(n));
      for (int eye = 0; eye < 2; ++eye)
        wrong[eye] += std::abs(pictures[eye].open[n] - truth) > 0.3;
    }
  }
  EXPECT_GT(hits, 2000);
  EXPECT_LE(wrong[0], wrong[1] + hits / 500) << "of " << hits; // of these slices 1 % would be
}

TEST(LightCacheEyes, OneEyeKeepsNothingForAnother)
{
  const auto scene = Gyroid();
  const hasp::PictureLightSettings sun{ {}, Sun };
  hasp::LightCache cache;
  Light(cache, scene, Eye(0.0), sun, LightEye::Alone);
  EXPECT_EQ(cache.SharedBytes(), 0);
  Light(cache, scene, Eye(0.0), sun, LightEye::Second); // no first one
  EXPECT_EQ(cache.SharedBytes(), 0);
  EXPECT_EQ(cache.SharedPixels(), 0);
  Light(cache, scene, Eye(0.0), sun, LightEye::First);
  EXPECT_EQ(cache.SharedBytes(), 160U * 140U * 8U);
  Light(cache, scene, Eye(0.0), sun, LightEye::Alone);
  EXPECT_EQ(cache.SharedBytes(), 0);
}

} // namespace
