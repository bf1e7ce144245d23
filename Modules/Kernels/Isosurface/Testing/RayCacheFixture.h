#pragma once
// Bone in a box, a camera that goes round it, and what a cache must hold of it.
#include "Grid/AnalyticVolumes.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/RayCache.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace hasp::testing
{

/// Bone in a box, and a camera that goes round it.
class RayCacheScene : public ::testing::Test
{
protected:
  explicit RayCacheScene(const glm::ivec3& dims = { 70, 61, 55 })
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

} // namespace hasp::testing
