// What is forgotten and when, and that memory stays as it is.
#include "Grid/AnalyticVolumes.h"
#include "Isosurface/Testing/LitScene.h"

namespace
{

using namespace hasp::testing;

const hasp::GridGeometry Grid{ { 40, 40, 40 }, {}, glm::dvec3(1), glm::dmat3(1) };

TracedVolume<float> Bumps(double isovalue = 0.0)
{
  const hasp::AnalyticVolume gyroid = hasp::AnalyticGyroid(12);
  auto scene = FieldVolume(Grid, gyroid.value);
  return { std::move(scene.samples), Grid, isovalue };
}

/// A camera that moves: a view that stays casts more. So little that nothing else changes.
double Step(int frame)
{
  return 1e-4 * frame;
}

/// Rays a hit in a frame of a camera so many mm aside.
template <typename T>
double Rays(
  hasp::LightCache& cache, const TracedVolume<T>& scene, double distance = 8.0, double aside = 0.0)
{
  const auto view = ViewFrom(Grid, { 100, 60 + aside, 50 }, { 20, 20, 20 }, { 64, 64 });
  const auto seen = LightOf(cache, scene, view, { distance, {} });
  EXPECT_GT(seen.hits.size(), 1000);
  return double(cache.Rays()) / double(seen.hits.size());
}

TEST(LightCacheChanges, IsovalueAndDistanceForgetAll)
{
  const auto bumps = Bumps(), others = Bumps(0.1);
  hasp::LightCache cache;
  const auto settle = [&](const auto& scene, double distance)
  {
    for (int frame = 1; frame <= 12; ++frame)
      Rays(cache, scene, distance, Step(frame));
    return Rays(cache, scene, distance, Step(13));
  };
  EXPECT_NEAR(Rays(cache, bumps), 3.0, 0.01); // what nothing is known of
  EXPECT_LT(settle(bumps, 8.0), 0.5);
  EXPECT_NEAR(Rays(cache, others), 3.0, 0.01);
  EXPECT_LT(settle(others, 8.0), 0.5);
  EXPECT_NEAR(Rays(cache, others, 9.0), 3.0, 0.01);
  EXPECT_LT(settle(others, 9.0), 0.5);
  cache.Forget();
  EXPECT_NEAR(Rays(cache, others, 9.0), 3.0, 0.01);
}

TEST(LightCacheChanges, AViewThatStaysGoesOnTillItIsSettled)
{
  const auto bumps = Bumps();
  const double eyes[2] = { 0.0, Step(1) };
  for (const int count : { 1, 2 })
  {
    hasp::LightCache cache;
    for (int frame = 0; frame < 20; ++frame)
      EXPECT_NEAR(Rays(cache, bumps, 8.0, eyes[frame % count]), 3.0, 0.01);
    EXPECT_LT(Rays(cache, bumps, 8.0, Step(2)), 0.5) << "it moves again";
    EXPECT_NEAR(Rays(cache, bumps, 8.0, Step(2)), 3.0, 0.01);
    cache.Forget(glm::ivec3(0), glm::ivec3(1));
    EXPECT_LT(Rays(cache, bumps, 8.0, Step(2)), 0.5) << "it is being edited";
  }
  hasp::LightCache cache;
  double rays = 3.0;
  for (int frame = 0; frame < 300; ++frame)
    rays = Rays(cache, bumps);
  EXPECT_LT(rays, 1.0) << "but for places at the rim, which few pixels share";
}

TEST(LightCacheChanges, AnEditForgetsWhatItReachesAndNoMore)
{
  // A pillar rises on a floor: afterwards the light is as if it had always stood there.
  const auto floor = [](const glm::dvec3& p) { return 10.3 - p.z; };
  const auto pillar = [&](const glm::dvec3& p)
  {
    return std::max(
      floor(p), std::min({ 2.0 - std::abs(p.x - 12), 2.0 - std::abs(p.y - 20), 20.0 - p.z }));
  };
  const auto before = FieldVolume(Grid, floor), after = FieldVolume(Grid, pillar);
  const double reach = 5.0;
  const auto view = [](int frame) {
    return ViewFrom(Grid, { 20, 19 + Step(frame), 120 }, { 20, 20, 10 }, { 64, 64 }, 14.0);
  };
  hasp::LightCache cache, all, fresh;
  for (int frame = 0; frame < 30; ++frame)
  {
    LightOf(cache, before, view(frame), { reach, {} });
    LightOf(all, before, view(frame), { reach, {} });
  }
  cache.Forget({ 9, 17, 10 }, { 15, 23, 21 });
  hasp::LightCache* const caches[] = { &cache, &fresh, &all };
  double errors[3];
  std::int64_t rays[3];
  for (int n = 0; n < 3; ++n)
  {
    auto seen = LightOf(*caches[n], after, view(30), { reach, {} });
    rays[n] = caches[n]->Rays();
    for (int frame = 31; frame < 51; ++frame)
      seen = LightOf(*caches[n], after, view(frame), { reach, {} });
    errors[n] = seen.Error(
      [&](const hasp::CellHit& hit) {
        return after.tracer.AmbientOcclusion(hit, { 64, reach }, 1);
      });
  }
  EXPECT_LT(errors[0], 1.1 * errors[1]);
  EXPECT_GT(errors[2], 1.3 * errors[1]) << "had it not been told, this test would see it";
  EXPECT_LT(rays[0], rays[1] / 2) << "what lies farther away is still known";
  EXPECT_GT(rays[0], 2 * rays[2]);
}

TEST(LightCacheChanges, MemoryStaysAsItIsOverTenThousandFrames)
{
  // The smallest table for a walk that sees far more than fits: the oldest goes, and where nothing
  // fits rays of the pixel alone give the light. In a closed hall all of it is dark, exactly.
  const glm::dvec3 middle(19.5);
  const auto hall =
    FieldVolume(Grid, [&](const glm::dvec3& p) { return glm::distance(p, middle) - 15.0; });
  hasp::LightCache cache(hasp::LightCacheSettings{ 64 });
  EXPECT_EQ(cache.Bytes(), 0);
  hasp::TracedPicture picture;
  hasp::PictureLight light;
  for (int frame = 0; frame < 10'000; ++frame)
  {
    const double turn = 0.37 * frame;
    const auto view = ViewFrom(Grid, middle + glm::dvec3(9 * std::sin(0.01 * frame), 0, 0),
      middle + 14.0 * glm::dvec3(std::cos(turn), std::sin(turn), std::sin(0.1 * frame)), { 6, 6 },
      60);
    hall.tracer.TracePicture(view, picture);
    cache.Light(hall.tracer, view, picture, { 1e9, {} }, light);
    ASSERT_EQ(cache.Bytes(), 64 * 524);
    for (const auto& pixel : light)
      ASSERT_EQ(pixel.x, 0) << frame;
  }
}

TEST(LightCacheChanges, TooSmallATableIsSlowerNotWrong)
{
  const auto bumps = Bumps();
  const auto view = ViewFrom(Grid, { 100, 60, 50 }, { 20, 20, 20 }, { 96, 96 });
  double errors[2];
  int n = 0;
  for (const std::size_t blocks : { 64, 32'768 })
  {
    hasp::LightCache cache(hasp::LightCacheSettings{ blocks });
    LitPicture seen;
    for (int frame = 0; frame < 6; ++frame)
      seen = LightOf(cache, bumps, view, { 8.0, {} });
    errors[n++] = seen.Error(
      [&](const hasp::CellHit& hit) {
        return bumps.tracer.AmbientOcclusion(hit, { 64, 8.0 }, 1);
      });
  }
  EXPECT_LT(errors[1], 0.09) << "as four rays a pixel";
  EXPECT_LT(errors[0], 0.3) << "as three rays a pixel";
  EXPECT_GT(errors[0], errors[1]);
}

} // namespace
