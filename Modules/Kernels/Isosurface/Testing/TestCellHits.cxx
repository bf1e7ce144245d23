// Lines against the active cells alone, held to the ray caster, which walks the volume.
#include "Grid/AnalyticVolumes.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellHits.h"
#include "Isosurface/RayCaster.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace
{

struct Gyroid
{
  hasp::GridGeometry geometry{ { 40, 33, 45 }, { -11, 4, 2 }, { 0.5, 0.7, 1.1 }, glm::dmat3(1) };
  std::vector<float> samples =
    hasp::SampleAnalytic<float>(hasp::AnalyticGyroid(12), geometry, 100, 0);
  hasp::AnyGridView grid = hasp::GridView<const float>{ samples.data(), geometry };
  hasp::MinMaxBlocks blocks{ grid };
  hasp::ClusteredCells cells = ExtractActiveCells(grid, blocks, 0);
};

TEST(CellHits, TheFirstIsTheRayCasters)
{
  const Gyroid g;
  const hasp::RayCaster caster(g.grid, g.blocks, 0);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-0.3, 1.3);
  int hits = 0;
  for (int n = 0; n < 400; ++n)
  {
    const auto point = [&]
    { return glm::dvec3(u(random), u(random), u(random)) * glm::dvec3(g.geometry.dims - 1); };
    const glm::dvec3 from = point(), to = point();
    const glm::dvec3 a = g.geometry.IndexToWorld(from), b = g.geometry.IndexToWorld(to);
    const auto truth = caster.Cast(a, b - a, 0.0, 1.0);
    const auto hit = FirstHit(g.cells, from, to);
    ASSERT_EQ(hit.has_value(), truth.has_value()) << n;
    if (!hit)
      continue;
    ++hits;
    // Both solve in float inside the cell: a millionth of a cell's chord, here up to 1.4 mm.
    EXPECT_LT(glm::distance(g.geometry.IndexToWorld(hit->index), truth->position), 1e-5);
    EXPECT_NEAR(hit->t, truth->t, 1e-5);
    EXPECT_GT(glm::dot(glm::normalize(g.geometry.GradientToWorld(hit->gradient)),
                glm::normalize(truth->gradient)),
      0.9999);
    const auto same = HitCell(g.cells, hit->cell, from, to);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->t, hit->t);
  }
  EXPECT_GT(hits, 200);
}

TEST(CellHits, CellsThatDoNotCountAreNotThere)
{
  const Gyroid g;
  const glm::dvec3 from(20, 16, -1), to(20.5, 16.5, 46);
  const auto first = FirstHit(g.cells, from, to);
  ASSERT_TRUE(first);
  const auto second = FirstHit(g.cells, from, to, [&](std::size_t n) { return n != first->cell; });
  ASSERT_TRUE(second);
  EXPECT_GT(second->t, first->t);
  EXPECT_FALSE(FirstHit(g.cells, from, to, [](std::size_t) { return false; }));
}

TEST(CellHits, WhatIsNoLineOrNoCellMeetsNothing)
{
  const Gyroid g;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { nan, infinity, -infinity })
  {
    EXPECT_FALSE(FirstHit(g.cells, { bad, 1, 1 }, { 3, 3, 3 }));
    EXPECT_FALSE(FirstHit(g.cells, { 1, 1, 1 }, { 3, bad, 3 }));
    EXPECT_FALSE(HitCell(g.cells, 0, { bad, 1, 1 }, { 3, 3, 3 }));
  }
  EXPECT_FALSE(FirstHit(g.cells, { -5, -5, -5 }, { -5, -5, -5 }));
  EXPECT_FALSE(HitCell(g.cells, g.cells.Count(), { -1, -1, -1 }, { 50, 50, 50 }));
  EXPECT_FALSE(hasp::FirstHit({}, { -1, -1, -1 }, { 50, 50, 50 }));
}

} // namespace
