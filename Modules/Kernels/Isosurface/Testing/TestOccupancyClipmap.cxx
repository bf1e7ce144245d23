#include "Isosurface/OccupancyClipmap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

namespace
{

TEST(OccupancyClipmap, HasAsManyLevelsAsTheVolumeNeeds)
{
  EXPECT_EQ(hasp::OccupancyClipmap({ 1, 1, 1 }).Levels(), 1);
  EXPECT_EQ(hasp::OccupancyClipmap({ 512, 512, 512 }).Levels(), 1);
  EXPECT_EQ(hasp::OccupancyClipmap({ 513, 8, 8 }).Levels(), 2);
  EXPECT_EQ(hasp::OccupancyClipmap({ 2047, 2047, 2047 }).Levels(), 3);
  EXPECT_LE(hasp::OccupancyClipmap({ 65536, 65536, 65536 }).Bytes(), 16U << 20);
}

TEST(OccupancyClipmap, ShowsTheWholeVolumeAtTheLastLevel)
{
  const glm::ivec3 cells(1500, 100, 3000);
  hasp::OccupancyClipmap map(cells);
  const int last = map.Levels() - 1;
  for (const double at : { 0.0, 750.0, 1e9, -1e9, std::numeric_limits<double>::quiet_NaN() })
  {
    map.Follow(glm::dvec3(at));
    EXPECT_TRUE(map.InWindow({ { 0, 0, 0 }, last })) << at;
    EXPECT_TRUE(map.InWindow({ (cells - 1) / (8 << last), last })) << at;
  }
}

TEST(OccupancyClipmap, KeepsTheViewerInAllWindows)
{
  const glm::ivec3 cells(3000, 700, 5000);
  hasp::OccupancyClipmap map(cells);
  std::mt19937 random(3);
  for (int n = 0; n < 1000; ++n)
  {
    glm::dvec3 viewer;
    for (int a = 0; a < 3; ++a)
      viewer[a] = std::uniform_real_distribution<>(0, cells[a] - 1e-6)(random);
    map.Follow(viewer);
    for (int level = 0; level < map.Levels(); ++level)
      EXPECT_TRUE(map.InWindow({ glm::ivec3(viewer) / (8 << level), level })) << level;
  }
}

/// Wherever a viewer walks: a block's place is in all coarser windows, and with a block all of its
/// place is there. Along an axis; the others are alike.
TEST(OccupancyClipmap, NestsItsWindowsAtBoundsOfCoarserBlocks)
{
  for (const int cells : { 513, 1030, 4099, 9001 })
  {
    hasp::OccupancyClipmap map({ 8, cells, 8 });
    std::mt19937 random(11);
    double viewer = 0.0;
    for (int n = 0; n < 500; ++n)
    {
      viewer += std::uniform_real_distribution<>(-1.0, 1.0)(random) * (n % 50 ? 70 : cells);
      map.Follow({ 4, viewer, 4 });
      for (int level = 0; level + 1 < map.Levels(); ++level)
        for (int b = 0; b * (8 << level) < cells; ++b)
        {
          if (!map.InWindow({ { 0, b, 0 }, level }))
            continue;
          ASSERT_TRUE(map.InWindow({ { 0, b / 2, 0 }, level + 1 })) << viewer;
          ASSERT_TRUE(map.InWindow({ { 0, b ^ 1, 0 }, level }) || (b ^ 1) * (8 << level) >= cells)
            << viewer;
        }
    }
  }
}

/// Two blocks of one window never share an address, wherever the window is.
TEST(OccupancyClipmap, RemembersEveryBlockOfItsWindows)
{
  const glm::ivec3 cells(1000, 60, 900);
  hasp::OccupancyClipmap map(cells);
  for (const glm::dvec3& viewer : { glm::dvec3(0), glm::dvec3(777, 30, 444), glm::dvec3(1000) })
  {
    map.Follow(viewer);
    std::uint32_t number = 0;
    const auto each = [&](const auto& f)
    {
      for (int level = 0; level < map.Levels(); ++level)
        for (int z = 0; z <= cells.z / (8 << level); ++z)
          for (int y = 0; y <= cells.y / (8 << level); ++y)
            for (int x = 0; x <= cells.x / (8 << level); ++x)
              if (map.InWindow({ { x, y, z }, level }))
                f(hasp::BlockKey{ { x, y, z }, level });
    };
    each([&](const hasp::BlockKey& key) { map.Set(key, number++); });
    const std::uint32_t blocks = number;
    EXPECT_GT(blocks, 10000U);
    number = 0;
    each([&](const hasp::BlockKey& key) { EXPECT_EQ(map.Get(key), number++); });
  }
}

TEST(OccupancyClipmap, RemembersWhenABlockWasDropped)
{
  hasp::OccupancyClipmap map({ 100, 100, 100 });
  const hasp::BlockKey key{ { 3, 4, 5 }, 0 };
  constexpr std::uint32_t never = 0x7FFFFFFF;
  EXPECT_EQ(map.DroppedAgo(key, 10), never);
  map.Set(key, 7);
  EXPECT_EQ(map.DroppedAgo(key, 10), never);
  for (const std::uint32_t now : { 12U, 0x7FFFFFFEU }) // the clock turns
  {
    map.Drop(key, now);
    EXPECT_EQ(map.Get(key), hasp::OccupancyClipmap::Empty);
    EXPECT_EQ(map.DroppedAgo(key, now), 0U);
    EXPECT_EQ(map.DroppedAgo(key, now + 5), 5U);
  }
  map.Set(key, hasp::OccupancyClipmap::Empty);
  EXPECT_EQ(map.DroppedAgo(key, 20), never);
}

/// Against a plain set, while blocks of all levels come and go.
TEST(OccupancyClipmap, KnowsTheFinerBlocksOfAPlace)
{
  const glm::ivec3 cells(2100, 70, 9);
  hasp::OccupancyClipmap map(cells);
  ASSERT_EQ(map.Levels(), 4);
  map.Follow({ 1500, 30, 4 });
  std::map<std::uint32_t, hasp::BlockKey> there;
  std::mt19937 random(7);
  for (std::uint32_t n = 0; n < 3000; ++n)
  {
    const int level = int(random() % 4);
    const glm::ivec3 cell(1500 + random() % 200, random() % 70, random() % 9);
    const auto key = hasp::BlockKey::Of(cell, level);
    if (const std::uint32_t number = map.Get(key); number != hasp::OccupancyClipmap::Empty)
    {
      map.Set(key, n % 3 ? hasp::OccupancyClipmap::Empty : n);
      there.erase(number);
      if (n % 3 == 0)
        there[n] = key;
    }
    else
    {
      map.Set(key, n);
      there[n] = key;
    }
    const auto asked = hasp::BlockKey::Of(cell, int(random() % 4));
    std::vector<std::uint32_t> expected, finer = map.FinerIn(asked);
    for (const auto& [number, block] : there)
      if (block.level < asked.level && block.At(asked.level) == asked)
        expected.push_back(number);
    std::sort(finer.begin(), finer.end());
    ASSERT_EQ(finer, expected);
    ASSERT_EQ(map.HasFiner(asked), !expected.empty());
  }
}

TEST(OccupancyClipmap, MovesOnlyWhenTheViewerHasGoneFar)
{
  hasp::OccupancyClipmap map({ 4000, 4000, 4000 });
  map.Follow({ 2000, 2000, 2000 });
  int moves = 0;
  for (int n = 0; n < 256; ++n) // a quarter of the finest window's half
    moves += map.Follow({ 2000.0 + n, 2000, 2000 });
  EXPECT_GE(moves, 1);
  EXPECT_LE(moves, 256 / 64 + 2); // every eighth of 512 cells, and once a coarser level
}

/// Two eyes, or one that goes to and fro, wherever they are.
TEST(OccupancyClipmap, StaysWhileTheViewerGoesToAndFro)
{
  hasp::OccupancyClipmap map({ 4000, 4000, 4000 });
  for (int x = 0; x < 4000; ++x)
  {
    map.Follow({ double(x), 2000, 2000 });
    for (int n = 0; n < 2; ++n)
      EXPECT_FALSE(map.Follow({ x - 60.0, 2000, 2000 }) || map.Follow({ double(x), 2000, 2000 }))
        << x;
  }
}

} // namespace
