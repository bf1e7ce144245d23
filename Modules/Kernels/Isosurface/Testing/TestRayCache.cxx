#include "Isosurface/RayCache.h"

#include "Isosurface/Testing/RayCacheFixture.h"

#include <limits>
#include <random>
#include <stdexcept>

namespace
{

using RayCache = hasp::testing::RayCacheScene;

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
