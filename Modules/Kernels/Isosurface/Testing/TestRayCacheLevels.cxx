// Volumes of more than a window of blocks, which have several levels.
#include "Isosurface/RayCache.h"

#include "Isosurface/Testing/RayCacheFixture.h"

#include <cmath>
#include <limits>
#include <memory>

namespace
{

/// Longer than a window: far away, cells are twice as long, and are those of the volume that has
/// every other sample.
class LongRayCache : public hasp::testing::RayCacheScene
{
protected:
  LongRayCache() : RayCacheScene({ 1030, 20, 24 }) {}
};

TEST_F(LongRayCache, HasCoarserCellsFarAway)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  ASSERT_EQ(cache.Levels(), 3);
  const glm::dvec3 eye(-20, 10, 12);
  const hasp::PictureView view{ glm::perspective(0.3, 1.0, 1.0, 3000.0) *
                                  glm::lookAt(eye, glm::dvec3(500, 10, 12), glm::dvec3(0, 0, 1)),
    { 64, 64 }, { { -1, 0, 0, 1030 }, { 1, 0, 0, -700 } } }; // what lies in front is cut away
  for (int f = 0; f < 30; ++f)
    Sample(cache, view);
  const auto coarse = cache.Cells(1);
  ASSERT_GT(coarse->clusters.size(), 5U);
  EXPECT_EQ(coarse->geometry.dims, glm::ivec3(515, 10, 12));
  EXPECT_EQ(coarse->geometry.spacing, 2.0 * Geometry.spacing);

  std::vector<std::int16_t> every;
  const hasp::GridView<const std::int16_t> fine{ Samples.data(), Geometry };
  for (int k = 0; k < 24; k += 2)
    for (int j = 0; j < 20; j += 2)
      for (int i = 0; i < 1030; i += 2)
        every.push_back(fine(i, j, k));
  const hasp::AnyGridView second =
    hasp::GridView<const std::int16_t>{ every.data(), coarse->geometry };
  const auto all = ExtractActiveCells(second, hasp::MinMaxBlocks(second), 7.0);
  for (std::size_t n = 0; n < coarse->Count(); ++n)
  {
    const auto same = all.Find(coarse->Cell(n));
    ASSERT_TRUE(same);
    ASSERT_EQ(coarse->Corners(n), all.Corners(*same));
  }
}

/// What is drawn of a cache: along a ray the first root in a cell that it holds.
class DrawnCache
{
public:
  /// samples: of the volume, as the cache has them.
  DrawnCache(hasp::RayCache& cache, const hasp::GridView<const std::int16_t>& samples)
  {
    for (int l = 0; l < cache.Levels(); ++l)
      Levels.push_back(std::make_unique<Level>(cache.Cells(l), samples, 1 << l));
  }
  /// In the ray's lengths; infinity where it meets nothing.
  double Depth(const hasp::CellRay& ray) const
  {
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t l = 0; l < Levels.size(); ++l)
    {
      const double scale = 1.0 / double(1 << l), step = 1e-3 / glm::length(ray.direction);
      double from = ray.tMin;
      while (const auto hit = Levels[l]->Caster.CastInIndex(
               scale * ray.origin, scale * ray.direction, from, ray.tMax))
      {
        if (Levels[l]->Cells->Find(hit->cell))
        {
          depth = std::min(depth, hit->t);
          break;
        }
        from = hit->t + step; // past a root in a cell that is not there
      }
    }
    return depth;
  }

private:
  struct Level
  {
    Level(std::shared_ptr<const hasp::ClusteredCells> cells,
      const hasp::GridView<const std::int16_t>& samples, int stride)
      : Cells(std::move(cells)),
        Every(EachOf(samples, Cells->geometry.dims, stride)),
        Grid(hasp::GridView<const std::int16_t>{ Every.data(), Cells->geometry }),
        Blocks(Grid),
        Caster(Grid, Blocks, Cells->isovalue)
    {
    }
    static std::vector<std::int16_t> EachOf(
      const hasp::GridView<const std::int16_t>& samples, const glm::ivec3& dims, int stride)
    {
      std::vector<std::int16_t> every;
      for (int k = 0; k < dims.z; ++k)
        for (int j = 0; j < dims.y; ++j)
          for (int i = 0; i < dims.x; ++i)
            every.push_back(samples(i * stride, j * stride, k * stride));
      return every;
    }
    std::shared_ptr<const hasp::ClusteredCells> Cells;
    std::vector<std::int16_t> Every;
    hasp::AnyGridView Grid;
    hasp::MinMaxBlocks Blocks;
    hasp::RayCaster Caster;
  };
  std::vector<std::unique_ptr<Level>> Levels;
};

class WalkRayCache : public hasp::testing::RayCacheScene
{
protected:
  WalkRayCache() : RayCacheScene({ 600, 40, 44 }) {}
  hasp::PictureView Look(const glm::dvec3& eye, const glm::dvec3& at) const
  {
    return { glm::perspective(0.5, 1.0, 1.0, 5000.0) * glm::lookAt(eye, at, glm::dvec3(0, 0.1, 1)),
      { 80, 80 }, {} };
  }
  /// Rays at the pixels' centres, of the exact surface and of what is drawn. from: what lies before
  /// it is wanted coarser.
  void ExpectExact(hasp::RayCache& cache, const hasp::PictureView& view, int from = 0)
  {
    const hasp::GridView<const std::int16_t> samples{ Samples.data(), Geometry };
    const DrawnCache drawn(cache, samples);
    const hasp::RayCaster exact(Grid, Blocks, 7.0);
    const hasp::PictureRays rays(view);
    int met = 0, missed = 0, invented = 0;
    for (int y = 0; y < view.size.y; ++y)
      for (int x = 0; x < view.size.x; ++x)
      {
        hasp::CellRay ray;
        ASSERT_TRUE(rays.Of({ x + 0.5, y + 0.5 }, ray));
        const auto hit = exact.CastInIndex(ray.origin, ray.direction, ray.tMin, ray.tMax);
        if (hit && hit->cell.x < from)
          continue;
        const double truth = hit ? hit->t : std::numeric_limits<double>::infinity();
        const double depth = drawn.Depth(ray), length = glm::length(ray.direction);
        met += hit.has_value();
        // The same cells, roots and arithmetic: what differs is another cell.
        invented += depth < truth - 1e-3 / length;
        missed += depth > truth + 1e-3 / length;
      }
    EXPECT_GT(met, 1500);
    EXPECT_EQ(invented, 0);
    EXPECT_LE(missed, met / 500); // blocks of which a corner of a pixel shows
  }
  /// Pixels where something is drawn.
  std::size_t Covered(hasp::RayCache& cache, const hasp::PictureView& view)
  {
    const DrawnCache drawn(cache, { Samples.data(), Geometry });
    const hasp::PictureRays rays(view);
    std::size_t covered = 0;
    for (int y = 0; y < view.size.y; ++y)
      for (int x = 0; x < view.size.x; ++x)
      {
        hasp::CellRay ray;
        covered += rays.Of({ x + 0.5, y + 0.5 }, ray) && std::isfinite(drawn.Depth(ray));
      }
    return covered;
  }
};

/// A walk over places that want several levels, and back: where fine cells are wanted nothing else
/// is drawn.
TEST_F(WalkRayCache, DrawsTheExactSurfaceAfterAWalkOverLevels)
{
  const glm::dvec3 middle(300, 20, 22);
  const hasp::PictureView along = Look({ -30, 20, 22 }, middle),
                          end = Look({ 690, 60, 60 }, { 560, 20, 22 }),
                          far = Look({ 300, -700, 22 }, middle),
                          near = Look({ 300, -90, 30 }, middle);
  hasp::RayCache cache(Grid, Blocks, 7.0);
  ASSERT_EQ(cache.Levels(), 2);
  const auto rest = [&](const hasp::PictureView& view, int frames)
  {
    for (int f = 0; f < frames; ++f)
      Sample(cache, view);
    ExpectPlacesOnce(cache);
  };
  rest(far, 20);
  EXPECT_GT(cache.Cells(1)->Count(), 100U);
  rest(near, 60);
  ExpectExact(cache, near);
  rest(along, 20);
  rest(end, 60);
  ExpectExact(cache, end, 400);
  rest(far, 20);
  rest(near, 60);
  ExpectExact(cache, near);
  EXPECT_EQ(Sample(cache, near).added, 0);
}

/// The same place, wanted coarse and fine in each frame.
TEST_F(WalkRayCache, ComesToRestWithViewersNearAndFar)
{
  const hasp::PictureView far = Look({ 300, -700, 22 }, { 300, 20, 22 }),
                          near = Look({ 300, -90, 30 }, { 300, 20, 22 });
  const hasp::SampledEye eyes[] = { { far, {}, 0 }, { near, {}, 1 } };
  hasp::RayCache cache(Grid, Blocks, 7.0);
  std::int64_t added = 0;
  for (int f = 0; f < 400; ++f)
  {
    const std::int64_t now = cache.Sample(eyes, {}, 16).added;
    added += f < 380 ? 0 : now;
  }
  EXPECT_LE(added, 2); // a block of which a corner of a pixel shows is found late
  EXPECT_GT(cache.Cells(1)->Count(), 100U);
  ExpectPlacesOnce(cache);
  ExpectExact(cache, near);
}

/// A viewer that comes near meets finer cells, and no holes where a coarse block has gone.
TEST_F(WalkRayCache, LeavesNoHoleWhereABlockIsTakenApart)
{
  const hasp::PictureView far = Look({ 300, -700, 22 }, { 300, 20, 22 }),
                          near = Look({ 300, -90, 30 }, { 300, 20, 22 });
  hasp::RayCache cache(Grid, Blocks, 7.0);
  for (int f = 0; f < 60; ++f)
    Sample(cache, far, 64);
  const std::size_t before = Covered(cache, near), coarse = cache.Cells(1)->clusters.size();
  Sample(cache, near, 1);
  ASSERT_LT(cache.Cells(1)->clusters.size(), coarse - 5);
  ASSERT_GT(cache.Cells(0)->clusters.size(), 20U);
  // Silhouettes of coarse cells are a little larger, or smaller.
  EXPECT_GT(Covered(cache, near), before * 99 / 100);
}

/// Fine blocks of a viewer who has gone away give way when the ring has not room for all.
TEST_F(WalkRayCache, BecomesCoarseAgainWhenMemoryIsShort)
{
  const hasp::PictureView far = Look({ 300, -700, 22 }, { 300, 20, 22 });
  hasp::RayCacheSettings settings;
  settings.clusters = 200;
  hasp::RayCache cache(Grid, Blocks, 7.0, settings);
  for (int x = 150; x <= 450; x += 5)
    Sample(cache, Look({ x, -90, 30 }, { x, 20, 22 }));
  ASSERT_EQ(cache.Live(), 200U);
  EXPECT_GT(cache.Cells(0)->clusters.size(), 100U);
  for (int f = 0; f < 120; ++f)
    Sample(cache, far);
  EXPECT_EQ(cache.Cells(0)->Count(), 0U);
  EXPECT_GT(cache.Cells(1)->clusters.size(), 120U);
  ExpectPlacesOnce(cache);
}

/// Rays through gaps between levels find the coarse block there; finer ones take its place.
TEST_F(LongRayCache, MendsHolesWithFinerCells)
{
  hasp::RayCacheSettings settings;
  settings.pixelsACell = 4;
  hasp::RayCache cache(Grid, Blocks, 7.0, settings);
  const hasp::PictureView view = View(0, 700);
  const std::vector<float> nothing(160 * 160, 1.0F);
  const hasp::SampledEye eye{ view, nothing, 0 };
  cache.Sample({ &eye, 1 }, {}, 16);
  EXPECT_EQ(cache.Cells(0)->Count(), 0U);
  for (int f = 0; f < 4; ++f)
    cache.Sample({ &eye, 1 }, {}, 16);
  EXPECT_GT(cache.Cells(0)->Count(), 0U);
  ExpectPlacesOnce(cache);
}

/// Two viewers at the ends of a volume that no window of fine blocks can hold.
class TwoEndsRayCache : public hasp::testing::RayCacheScene
{
protected:
  TwoEndsRayCache() : RayCacheScene({ 1200, 20, 24 }) {}
  hasp::SampledEye Eye(int number) const
  {
    const glm::dvec3 middle(600, 10, 12), eye(number == 0 ? -30 : 1230, 14, 15);
    return { { glm::perspective(0.4, 1.0, 1.0, 2000.0) *
                 glm::lookAt(eye, middle, glm::dvec3(0, 0, 1)),
               { 64, 64 }, {} },
      {}, number };
  }
};

TEST_F(TwoEndsRayCache, ComesToRestWithTwoEyesFarApart)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  const hasp::SampledEye eyes[] = { Eye(0), Eye(1) };
  std::int64_t added = 0, early = 0;
  for (int f = 0; f < 400; ++f)
    for (const hasp::SampledEye& eye : eyes) // each renderer draws, and samples, for itself
      (f < 380 ? early : added) += cache.Sample({ &eye, 1 }, {}, 16).added;
  EXPECT_GT(early, 50);
  EXPECT_LE(added, 2); // a block of which a corner of a pixel shows is found late
}

TEST_F(TwoEndsRayCache, FollowsTheNextEyeOnceTheFirstHasGone)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  const hasp::SampledEye eyes[] = { Eye(0), Eye(1) };
  for (int f = 0; f < 20; ++f)
    cache.Sample(eyes, {}, 16);
  ASSERT_GT(cache.Cells(0)->Count(), 0U);
  for (const hasp::CellCluster& cluster : cache.Cells(0)->clusters)
    EXPECT_LT(cluster.Origin().x, 512);
  for (int f = 0; f < 80; ++f)
    cache.Sample({ &eyes[1], 1 }, {}, 16);
  ASSERT_GT(cache.Cells(0)->Count(), 0U);
  for (const hasp::CellCluster& cluster : cache.Cells(0)->clusters)
    EXPECT_GT(cluster.Origin().x, 1200 - 520);
}

} // namespace
