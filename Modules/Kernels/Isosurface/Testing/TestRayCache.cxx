#include "Isosurface/RayCache.h"

#include "Grid/AnalyticVolumes.h"
#include "Isosurface/ActiveCells.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <stdexcept>

namespace
{

constexpr int Side = hasp::MinMaxBlocks::Side;

/// Bone in a box, and a camera that goes round it.
class RayCache : public ::testing::Test
{
protected:
  explicit RayCache(const glm::ivec3& dims = { 70, 61, 55 })
    : Geometry{ dims, { 3, 4, 5 }, { 0.7, 0.9, 1.1 }, glm::dmat3(1) },
      Samples(hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(20), this->Geometry, 100, 0)),
      Grid(hasp::GridView<const std::int16_t>{ this->Samples.data(), this->Geometry }),
      Blocks(this->Grid)
  {
  }

  hasp::PictureView View(double angle, double distance = 160) const
  {
    const glm::dvec3 middle = 0.5 * glm::dvec3(this->Geometry.dims);
    const glm::dvec3 eye = middle + distance * glm::dvec3(std::sin(angle), -std::cos(angle), 0.2);
    return { glm::perspective(0.5, 1.0, 1.0, 1000.0) *
               glm::lookAt(eye, middle, glm::dvec3(0, 0, 1)),
      { 160, 160 }, {} };
  }
  hasp::RayCache::Frame Sample(hasp::RayCache& cache, const hasp::PictureView& view, int rays = 16)
  {
    const hasp::SampledEye eye{ view, {}, 0 };
    return cache.Sample({ &eye, 1 }, {}, rays);
  }

  /// Every cluster of level 0 is the one that a whole extraction has there, bit for bit.
  void ExpectClustersOfTheWhole(hasp::RayCache& cache, double isovalue)
  {
    const auto some = cache.Cells(0);
    const hasp::ClusteredCells all =
      ExtractActiveCells(this->Grid, hasp::MinMaxBlocks(this->Grid), isovalue);
    EXPECT_EQ(some->isovalue, all.isovalue);
    EXPECT_GT(some->clusters.size(), 20U);
    std::size_t next = 0, cells = 0;
    for (const hasp::CellCluster& cluster : some->clusters)
    {
      while (next < all.clusters.size() && all.clusters[next].place != cluster.place)
        ++next;
      ASSERT_LT(next, all.clusters.size()) << "not in the whole, or not in raster order";
      const hasp::CellCluster& other = all.clusters[next];
      ASSERT_EQ(cluster.active, other.active);
      ASSERT_EQ(cluster.cornersBefore, other.cornersBefore);
      ASSERT_EQ(cluster.firstCell, cells);
      cells += cluster.CellCount();
      const std::size_t words = (cluster.CornerCount() * cluster.Width() + 31) / 32;
      ASSERT_TRUE(std::equal(some->corners.begin() + cluster.firstWord,
        some->corners.begin() + cluster.firstWord + std::ptrdiff_t(words),
        all.corners.begin() + other.firstWord));
    }
    EXPECT_EQ(some->Count(), cells);
  }

  /// Of the pixels' rays, isovalue 7, level 0: how many meet the surface, and a cell that is not
  /// there.
  void CountMissing(hasp::RayCache& cache, const hasp::PictureView& view, int& met, int& missing)
  {
    const auto cells = cache.Cells(0);
    const hasp::RayCaster caster(this->Grid, this->Blocks, 7.0);
    const hasp::PictureRays rays(view);
    for (int y = 0; y < view.size.y; ++y)
      for (int x = 0; x < view.size.x; ++x)
      {
        hasp::CellRay ray;
        ASSERT_TRUE(rays.Of({ x + 0.5, y + 0.5 }, ray));
        const auto hit = caster.CastInIndex(ray.origin, ray.direction, ray.tMin, ray.tMax);
        met += hit.has_value();
        missing += hit && !cells->Find(hit->cell);
      }
  }
  /// No block is there twice, none in the place of a coarser one or under another's key, which
  /// gives the raster order.
  static void ExpectPlacesOnce(hasp::RayCache& cache)
  {
    std::set<std::array<int, 4>> blocks;
    const auto key = [](const hasp::CellCluster& cluster, int level, int at)
    {
      const glm::ivec3 block = cluster.Origin() / 8 >> (at - level);
      return std::array{ at, block.x, block.y, block.z };
    };
    for (int level = cache.Levels() - 1; level >= 0; --level)
    {
      std::array last{ -1, -1, -1 };
      for (const hasp::CellCluster& cluster : cache.Cells(level)->clusters)
      {
        const glm::ivec3 o = cluster.Origin();
        const std::array now{ o.z, o.y, o.x };
        ASSERT_LT(last, now);
        last = now;
        for (int coarser = level + 1; coarser < cache.Levels(); ++coarser)
          ASSERT_FALSE(blocks.count(key(cluster, level, coarser))) << level << " in " << coarser;
        ASSERT_TRUE(blocks.insert(key(cluster, level, level)).second);
      }
    }
    EXPECT_EQ(blocks.size(), cache.Live());
  }

  hasp::GridGeometry Geometry;
  std::vector<std::int16_t> Samples;
  hasp::AnyGridView Grid;
  hasp::MinMaxBlocks Blocks;
};

TEST_F(RayCache, HoldsClustersOfTheWholeSurface)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  for (int f = 0; f < 10; ++f)
    Sample(cache, View(0.1 * f));
  ExpectClustersOfTheWhole(cache, 7.0);
}

/// After some frames no pixel's ray meets a block that is not there.
TEST_F(RayCache, BecomesCompleteForAViewAtRest)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  const hasp::PictureView view = View(0.3);
  for (int f = 0; f < 400; ++f)
    Sample(cache, view);
  EXPECT_EQ(Sample(cache, view).added, 0);
  int met = 0, missing = 0;
  CountMissing(cache, view, met, missing);
  EXPECT_GT(met, 5000);
  EXPECT_LE(missing, met / 1000); // blocks of which a corner of a pixel shows
}

TEST_F(RayCache, HoldsEachBlockOnce)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  for (int f = 0; f < 30; ++f)
    Sample(cache, View(0.2 * f), 4);
  ExpectPlacesOnce(cache);
}

TEST_F(RayCache, FollowsTheIsovalueAtOnce)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  for (int f = 0; f < 10; ++f)
    Sample(cache, View(0));
  for (const double isovalue : { 8.0, -31.5, 60.0, 7.0 })
  {
    cache.SetIsovalue(isovalue);
    ExpectClustersOfTheWhole(cache, isovalue);
    Sample(cache, View(0));
    ExpectClustersOfTheWhole(cache, isovalue);
  }
  cache.SetIsovalue(5000);
  EXPECT_EQ(cache.Live(), 0U);
  EXPECT_EQ(cache.Cells(0)->Count(), 0U);
}

TEST_F(RayCache, FollowsAnEdit)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  for (int f = 0; f < 20; ++f)
    Sample(cache, View(0));
  const glm::ivec3 low(20, 0, 20), high(45, 20, 40);
  const hasp::GridView<std::int16_t> edited{ Samples.data(), Geometry };
  for (int k = low.z; k <= high.z; ++k)
    for (int j = low.y; j <= high.y; ++j)
      for (int i = low.x; i <= high.x; ++i)
        edited(i, j, k) = static_cast<std::int16_t>(-edited(i, j, k) / 2);
  Blocks.Update(Grid, low, high);
  cache.MarkModified(low, high);
  ExpectClustersOfTheWhole(cache, 7.0);
}

/// What nobody has marked is found by upkeep, in a round; a share is one of what is still there, so
/// a round in which half of the clusters go takes up to twice as many frames.
TEST_F(RayCache, ChecksItselfInTurns)
{
  hasp::RayCacheSettings settings;
  settings.upkeepShare = 8;
  hasp::RayCache cache(Grid, Blocks, 7.0, settings);
  for (int f = 0; f < 20; ++f)
    Sample(cache, View(0));
  for (std::int16_t& sample : Samples)
    sample = static_cast<std::int16_t>(sample / 2);
  Blocks = hasp::MinMaxBlocks(Grid);
  std::int64_t checked = 0;
  for (int f = 0; f < 16; ++f)
    checked += Sample(cache, View(0), 0).checked;
  EXPECT_GE(checked, std::int64_t(cache.Live()));
  ExpectClustersOfTheWhole(cache, 7.0);
}

/// A ring far too small for what is seen: what is there is no more than fits, and right.
TEST_F(RayCache, StaysWithinItsMemory)
{
  for (const bool words : { false, true })
  {
    hasp::RayCacheSettings settings;
    (words ? settings.words : settings.clusters) = words ? 3000 : 60;
    hasp::RayCache cache(Grid, Blocks, 7.0, settings);
    std::size_t mostWords = 0, mostClusters = 0;
    for (int f = 0; f < 100; ++f)
    {
      Sample(cache, View(0.15 * f), 4);
      mostClusters = std::max(mostClusters, cache.Live());
      mostWords = std::max(mostWords, cache.Cells(0)->corners.size() - hasp::PaddingWords);
    }
    EXPECT_LE(mostClusters, settings.clusters);
    EXPECT_LE(mostWords, settings.words);
    // Nor does it leave room unused, but for what does not fit before the end.
    EXPECT_GT(words ? mostWords : mostClusters, words ? 2700U : 58U);
    ExpectClustersOfTheWhole(cache, 7.0);
  }
}

/// A ring that cannot hold what is seen is full, not refining; until the view changes.
TEST_F(RayCache, SaysThatItIsFull)
{
  hasp::RayCacheSettings settings;
  settings.clusters = 60;
  hasp::RayCache cache(Grid, Blocks, 7.0, settings);
  for (const double angle : { 0.0, 3.1 })
  {
    const auto first = Sample(cache, View(angle));
    EXPECT_GT(first.added, 60);
    EXPECT_TRUE(first.Refining());
    for (int f = 0; f < 10; ++f)
      Sample(cache, View(angle));
    for (int f = 0; f < 50; ++f)
    {
      const auto frame = Sample(cache, View(angle));
      EXPECT_GT(frame.added, 20);
      EXPECT_FALSE(frame.Refining()) << frame.added << " added, " << frame.dropped << " dropped";
    }
  }
}

TEST_F(RayCache, RefinesAsLongAsItFinds)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  for (int f = 0; f < 20; ++f)
  {
    const auto frame = Sample(cache, View(0.1 * f));
    EXPECT_EQ(frame.dropped, 0);
    EXPECT_EQ(frame.Refining(), frame.added > 0);
  }
}

/// What an eye at rest sees stays while another goes round and fills the ring: whether records are
/// short, or words.
TEST_F(RayCache, KeepsWhatWasSeenLately)
{
  for (const bool words : { false, true })
  {
    hasp::RayCacheSettings settings;
    (words ? settings.words : settings.clusters) = words ? 15'000 : 200;
    hasp::RayCache cache(Grid, Blocks, 7.0, settings);
    const auto zoomed = [&](double angle)
    {
      hasp::PictureView part = View(angle);
      part.indexToClip = glm::scale(glm::dmat4(1), glm::dvec3(3, 3, 1)) * part.indexToClip;
      return part;
    };
    const hasp::PictureView part = zoomed(0);
    for (int f = 0; f < 40; ++f)
      Sample(cache, part);
    int met = 0, missing = 0;
    for (int f = 0; f < 300; ++f)
    {
      const hasp::SampledEye eyes[] = { { part, {}, 0 }, { zoomed(0.02 * f), {}, 1 } };
      cache.Sample(eyes, {}, 1);
      if (f % 20 == 19)
        CountMissing(cache, part, met, missing);
    }
    EXPECT_GT(met, 5000);
    // What no ray has met in 64 frames, as it shows a corner of a pixel, may go.
    EXPECT_LE(missing, met / 4000) << (words ? "words" : "records") << " are short";
  }
}

/// A full ring whose clusters change: one that upkeep makes anew may take the place of another that
/// it is about to make anew.
TEST_F(RayCache, KeepsClustersApartWhileTheRingTurns)
{
  hasp::RayCacheSettings settings;
  settings.clusters = 60;
  settings.upkeepShare = 1;
  hasp::RayCache cache(Grid, Blocks, 7.0, settings);
  std::mt19937 random(1);
  for (int f = 0; f < 100; ++f)
  {
    if (f % 3 == 2)
    {
      for (std::int16_t& sample : Samples)
        sample = static_cast<std::int16_t>(sample + int(random() % 5) - 2);
      Blocks = hasp::MinMaxBlocks(Grid);
    }
    Sample(cache, View(0.05 * f), 2);
    ASSERT_NO_FATAL_FAILURE(ExpectPlacesOnce(cache)) << f;
  }
  cache.MarkModified({ 0, 0, 0 }, Geometry.dims - 1);
  ExpectClustersOfTheWhole(cache, 7.0);
}

TEST_F(RayCache, GivesTheSamePointerWhileNothingChanges)
{
  hasp::RayCache cache(Grid, Blocks, 7.0);
  Sample(cache, View(0));
  const auto before = cache.Cells(0);
  EXPECT_EQ(cache.Cells(0), before);
  Sample(cache, View(0), 0);
  EXPECT_EQ(cache.Cells(0), before);
  cache.SetIsovalue(9);
  EXPECT_NE(cache.Cells(0), before);
}

/// Longer than a window: far away, cells are twice as long, and are those of the volume that has
/// every other sample.
class LongRayCache : public RayCache
{
protected:
  LongRayCache() : RayCache({ 1030, 20, 24 }) {}
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

class WalkRayCache : public RayCache
{
protected:
  WalkRayCache() : RayCache({ 600, 40, 44 }) {}
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
class TwoEndsRayCache : public RayCache
{
protected:
  TwoEndsRayCache() : RayCache({ 1200, 20, 24 }) {}
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

TEST_F(RayCache, RefusesWhatItCannotUse)
{
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(hasp::RayCache(Grid, Blocks, infinite), std::invalid_argument);
  hasp::RayCache cache(Grid, Blocks, 7.0);
  EXPECT_THROW(cache.SetIsovalue(infinite), std::invalid_argument);
  hasp::RayCacheSettings settings;
  settings.pixelsACell = 0;
  EXPECT_THROW(hasp::RayCache(Grid, Blocks, 7.0, settings), std::invalid_argument);
  settings = {};
  settings.upkeepShare = 0;
  EXPECT_THROW(hasp::RayCache(Grid, Blocks, 7.0, settings), std::invalid_argument);
  settings = {};
  settings.clusters = 0;
  EXPECT_THROW(hasp::RayCache(Grid, Blocks, 7.0, settings), std::invalid_argument);
  hasp::GridGeometry other = Geometry;
  other.dims = { 9, 9, 9 };
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ Samples.data(), other };
  EXPECT_THROW(hasp::RayCache(grid, Blocks, 7.0), std::invalid_argument);
}

} // namespace
