#include "Isosurface/RaySampler.h"

#include "Grid/AnalyticVolumes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

namespace
{

/// A ball in front of a camera that looks along y.
class RaySampler : public ::testing::Test
{
protected:
  RaySampler()
    : Samples(hasp::SampleAnalytic<float>(
        hasp::AnalyticSphere({ 20, 20, 20 }, 12), this->Geometry, 1, 0)),
      Grid(hasp::GridView<const float>{ this->Samples.data(), this->Geometry }),
      Blocks(this->Grid),
      Caster(this->Grid, this->Blocks, 0.0)
  {
    const glm::dvec3 eye(20, -60, 20);
    this->Eye.view.indexToClip = glm::perspective(0.6, 1.5, 1.0, 500.0) *
                                 glm::lookAt(eye, glm::dvec3(20), glm::dvec3(0, 0, 1));
    this->Eye.view.size = { 150, 100 };
  }
  int Tiles() const { return 10 * 7; }

  hasp::GridGeometry Geometry{ { 41, 41, 41 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<float> Samples;
  hasp::AnyGridView Grid;
  hasp::MinMaxBlocks Blocks;
  hasp::RayCaster Caster;
  hasp::SampledEye Eye;
  hasp::RaySampler Sampler;
};

TEST_F(RaySampler, CastsAFixedNumberOfRaysATileAndEye)
{
  EXPECT_EQ(Sampler.Sample(Caster, {}, {}, 8).rays, 0);
  EXPECT_EQ(Sampler.Sample(Caster, { &Eye, 1 }, {}, 0).rays, 0);
  EXPECT_EQ(Sampler.Sample(Caster, { &Eye, 1 }, {}, 5).rays, 5 * Tiles());
  const hasp::SampledEye both[] = { Eye, { Eye.view, {}, 1 } };
  EXPECT_EQ(Sampler.Sample(Caster, both, {}, 5).rays, 10 * Tiles());
  EXPECT_EQ(Sampler.Sample(Caster, { &Eye, 1 }, { &Eye.view, 1 }, 8).rays, 10 * Tiles());
}

TEST_F(RaySampler, MeetsCellsOfTheSurface)
{
  const auto frame = Sampler.Sample(Caster, { &Eye, 1 }, {}, 16);
  ASSERT_GT(frame.hits.size(), 100U);
  for (const hasp::SampledHit& hit : frame.hits)
  {
    // A cell's middle is at most half its diagonal from the surface, which chords cut a little.
    const double distance = glm::length(glm::dvec3(hit.cell) + 0.5 - 20.0) - 12.0;
    EXPECT_LT(std::abs(distance), 1.0);
    // 100 pixels over 2 tan(0.3) at a distance of 68 to 80 voxels, seen from the front.
    EXPECT_NEAR(hit.pixelsAVoxel, 100 / (2 * std::tan(0.3) * (hit.cell.y + 60.5)), 0.05);
    EXPECT_FALSE(hit.inHole);
  }
}

/// A wall that fills a picture of one tile, a pixel to some voxels.
class WallSampler : public RaySampler
{
protected:
  WallSampler()
  {
    for (std::size_t n = 0; n < this->Samples.size(); ++n)
      this->Samples[n] = float(n / 41 % 41) - 20.5F;
    this->Blocks = hasp::MinMaxBlocks(this->Grid);
    this->Eye.view.indexToClip =
      glm::ortho(0.0, 40.0, 0.0, 40.0, -100.0, 100.0) *
      glm::lookAt(glm::dvec3(0, -50, 0), glm::dvec3(0), glm::dvec3(0, 0, 1));
    this->Eye.view.size = { 16, 16 };
  }
  std::vector<hasp::SampledHit> Hits(hasp::RaySampler& sampler, int rays)
  {
    return sampler.Sample(this->Caster, { &this->Eye, 1 }, {}, rays).hits;
  }
};

/// The share of a tile's rays in each quarter of it goes to a quarter, as 1 / n, which chance would
/// not reach: for random points the difference falls as 1 / sqrt(n).
TEST_F(WallSampler, SpreadsRaysEvenly)
{
  std::map<std::pair<bool, bool>, int> quarters;
  constexpr int frames = 64, rays = 16;
  for (int f = 0; f < frames; ++f)
    for (const hasp::SampledHit& hit : Hits(Sampler, rays))
      ++quarters[{ hit.cell.x >= 20, hit.cell.z >= 20 }];
  ASSERT_EQ(quarters.size(), 4U);
  for (const auto& [quarter, count] : quarters)
    EXPECT_NEAR(count, frames * rays / 4, 8); // chance: 14 is one standard deviation
}

/// However many rays each frame has, and whatever other eyes do.
TEST_F(WallSampler, GoesOnFromFrameToFrame)
{
  hasp::RaySampler even, odd;
  std::vector<glm::ivec3> some, others;
  for (int f = 0; f < 8; ++f)
    for (const hasp::SampledHit& hit : Hits(even, 8))
      some.push_back(hit.cell);
  const hasp::SampledEye other{ Eye.view, {}, 7 };
  for (const int rays : { 5, 11, 1, 0, 30, 2, 15 })
  {
    for (const hasp::SampledHit& hit : Hits(odd, rays))
      others.push_back(hit.cell);
    odd.Sample(Caster, { &other, 1 }, {}, 3);
  }
  EXPECT_EQ(some.size(), 64U);
  EXPECT_EQ(some, others);
}

/// One ray a tile, and a hole in it where there is nothing to find.
TEST_F(WallSampler, CastsASingleRayElsewhereToo)
{
  std::vector<float> depth(16 * 16, 0.5F);
  depth[0] = 1.0F;
  Eye.depth = depth;
  int aimed = 0, spread = 0;
  for (int f = 0; f < 100; ++f)
    for (const hasp::SampledHit& hit : Hits(Sampler, 1))
      ++(hit.inHole ? aimed : spread);
  EXPECT_EQ(aimed, 50);
  EXPECT_EQ(spread, 50);
}

TEST_F(RaySampler, AimsHalfOfTheRaysAtHoles)
{
  std::vector<float> depth(150 * 100, 0.5F);
  const int hole = 50 * 150 + 75; // in the middle of the ball
  depth[hole] = 1.0F;
  Eye.depth = depth;
  const auto frame = Sampler.Sample(Caster, { &Eye, 1 }, {}, 16);
  const auto aimed = std::count_if(
    frame.hits.begin(), frame.hits.end(), [](const hasp::SampledHit& hit) { return hit.inHole; });
  EXPECT_EQ(aimed, 8);
  EXPECT_EQ(frame.rays, 16 * Tiles());
}

TEST_F(RaySampler, GivesUpHolesWhereRaysMeetNothing)
{
  const std::vector<float> depth(150 * 100, 1.0F); // all of it, though the ball is small
  Eye.depth = depth;
  std::size_t first = 0, last = 0;
  for (int f = 0; f < 8; ++f)
  {
    const auto frame = Sampler.Sample(Caster, { &Eye, 1 }, {}, 16);
    ASSERT_EQ(frame.rays, 16 * Tiles());
    last = std::count_if(
      frame.hits.begin(), frame.hits.end(), [](const hasp::SampledHit& hit) { return hit.inHole; });
    first = f == 0 ? last : first;
  }
  EXPECT_GT(first, 50U);
  EXPECT_GT(last, first / 2); // tiles of the ball go on
  EXPECT_LE(last, first);
}

/// Another eye may get the number of one that has gone.
TEST_F(RaySampler, ForgetsAnEyeThatHasGone)
{
  const auto aimed = [&](hasp::RaySampler& sampler)
  {
    const auto hits = sampler.Sample(Caster, { &Eye, 1 }, {}, 16).hits;
    return std::count_if(
      hits.begin(), hits.end(), [](const hasp::SampledHit& hit) { return hit.inHole; });
  };
  const std::vector<float> depth(150 * 100, 1.0F);
  Eye.depth = depth;
  hasp::RaySampler fresh;
  const auto first = aimed(fresh);
  const glm::dmat4 ball = Eye.view.indexToClip;
  Eye.view.indexToClip = glm::translate(ball, glm::dvec3(500, 0, 0)); // nothing to find
  for (int f = 0; f < 8; ++f)
    EXPECT_EQ(aimed(Sampler), 0);
  Eye.view.indexToClip = ball;
  hasp::RaySampler early = Sampler;
  EXPECT_LT(aimed(early), first / 2);
  const hasp::SampledEye other{ { ball, { 16, 16 }, {} }, {}, 1 };
  for (int f = 0; f < 256; ++f)
    Sampler.Sample(Caster, { &other, 1 }, {}, 1);
  EXPECT_EQ(aimed(Sampler), first);
}

/// What a picture shows is what rays through its pixels' middles meet, once each.
TEST_F(RaySampler, ARayAPixelMeetsAllThatAPictureShows)
{
  const hasp::PictureRays rays(Eye.view);
  std::multiset<std::tuple<int, int, int>> shown;
  for (int pixel = 0; pixel < 150 * 100; ++pixel)
  {
    hasp::CellRay ray;
    ASSERT_TRUE(rays.Of(glm::dvec2(pixel % 150, pixel / 150) + 0.5, ray));
    if (const auto hit = Caster.CastInIndex(ray.origin, ray.direction, ray.tMin, ray.tMax))
      shown.insert({ hit->cell.x, hit->cell.y, hit->cell.z });
  }
  ASSERT_GT(shown.size(), 1000U);
  for (int frame = 0; frame < 3; ++frame)
  {
    const auto sampled = Sampler.Sample(Caster, { &Eye, 1 }, {}, hasp::RaySampler::TilePixels);
    EXPECT_EQ(sampled.rays, 256 * Tiles()) << "tiles at the border have more than their pixels";
    std::multiset<std::tuple<int, int, int>> met;
    for (const hasp::SampledHit& hit : sampled.hits)
      met.insert({ hit.cell.x, hit.cell.y, hit.cell.z });
    EXPECT_TRUE(std::includes(met.begin(), met.end(), shown.begin(), shown.end()));
  }
}

TEST_F(RaySampler, ARayAPixelSaysWhichWasAHole)
{
  std::vector<float> depth(150 * 100, 0.5F);
  depth[50 * 150 + 75] = depth[51 * 150 + 75] = 1.0F;
  Eye.depth = depth;
  const auto hits = Sampler.Sample(Caster, { &Eye, 1 }, {}, hasp::RaySampler::TilePixels).hits;
  EXPECT_EQ(
    std::count_if(hits.begin(), hits.end(), [](const hasp::SampledHit& hit) { return hit.inHole; }),
    2);
}

TEST_F(RaySampler, StopsAtClippingPlanes)
{
  Eye.view.planes = { { 0, 1, 0, -20 } }; // the far half alone
  const auto frame = Sampler.Sample(Caster, { &Eye, 1 }, {}, 16);
  ASSERT_GT(frame.hits.size(), 50U);
  for (const hasp::SampledHit& hit : frame.hits)
    EXPECT_GE(hit.cell.y, 20);
}

TEST_F(RaySampler, RefusesADepthOfAnotherSize)
{
  const std::vector<float> depth(10, 1.0F);
  Eye.depth = depth;
  EXPECT_THROW(Sampler.Sample(Caster, { &Eye, 1 }, {}, 1), std::invalid_argument);
  Eye.depth = {};
  Eye.view.indexToClip = glm::dmat4(0.0);
  EXPECT_THROW(Sampler.Sample(Caster, { &Eye, 1 }, {}, 1), std::invalid_argument);
}

TEST_F(RaySampler, TakesAPictureWithoutPixels)
{
  Eye.view.size = { 0, 0 };
  EXPECT_EQ(Sampler.Sample(Caster, { &Eye, 1 }, {}, 8).rays, 0);
}

} // namespace
