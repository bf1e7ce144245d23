#include "Grid/AnalyticVolumes.h"
#include "Grid/Trilinear.h"
#include "Isosurface/RayCaster.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <random>

namespace
{

/// A grid of about `voxel` mm around the origin, rotated, with other spacing per axis, rows
/// flipped.
hasp::GridGeometry RotatedGrid(int dims, double voxel)
{
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, -2, 0.5))));
  hasp::GridGeometry g{ { dims, dims - 3, dims + 5 }, {}, voxel * glm::dvec3(1, 0.9, 1.3),
    glm::dmat3(turn[0], -turn[1], turn[2]) };
  g.origin = -(g.direction * (g.spacing * glm::dvec3(g.dims - 1) * 0.5));
  return g;
}

TEST(RayCaster, MeetsAnalyticSurfacesWithinATenthOfAVoxel)
{
  std::mt19937 random(21);
  std::normal_distribution<double> normal;
  for (const auto& shape : { hasp::AnalyticSphere({ 0.3, -0.2, 0.1 }, 20),
         hasp::AnalyticTorus({ 0, 0, 0 }, glm::normalize(glm::dvec3(1, 2, -1)), 18, 7),
         hasp::AnalyticGyroid(24) })
  {
    const hasp::GridGeometry g = RotatedGrid(60, 1.0);
    const auto samples = hasp::SampleAnalytic<float>(shape, g, 1, 0);
    const hasp::AnyGridView grid = hasp::GridView<const float>{ samples.data(), g };
    const hasp::MinMaxBlocks blocks(grid);
    const hasp::RayCaster caster(grid, blocks, 0.0);
    int hits = 0;
    for (int n = 0; n < 2000; ++n)
    {
      const glm::dvec3 target = 6.0 * glm::dvec3(normal(random), normal(random), normal(random));
      const glm::dvec3 origin =
        22.0 * glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
      const glm::dvec3 d = glm::normalize(target - origin);
      const auto hit = caster.Cast(origin, d);
      if (!hit || !hasp::LocateCell(g, g.WorldToIndex(origin)) || shape.value(origin) > 0)
        continue;
      // Distance to the true surface along the normal.
      EXPECT_LT(std::abs(shape.value(hit->position)), 0.1) << shape.name;
      if (glm::dot(glm::normalize(hit->gradient), d) < 0.3)
        continue; // grazing: along the ray the same distance grows without bound; or leaving: the
                  // origin is within rounding of the surface
      // From half a voxel before the hit: an earlier sheet that is only grazed is another matter.
      const auto truth = FirstSurface(shape, origin, d, std::max(0.0, hit->t - 0.5), hit->t + 1);
      ASSERT_TRUE(truth) << shape.name;
      EXPECT_NEAR(hit->t, *truth, 0.1 / 0.3) << shape.name;
      ++hits;
    }
    EXPECT_GT(hits, 200) << shape.name;
  }
}

TEST(RayCaster, FindsTheSameCellAsAWalkThroughEveryCell)
{
  // Truth: the nearest root over all cells, by brute force, on noise: no block structure, no walk.
  std::mt19937 random(22);
  std::uniform_int_distribution<int> sample(-100, 100);
  const hasp::GridGeometry g{ { 11, 10, 12 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples(g.Size());
  for (auto& v : samples)
    v = static_cast<std::int16_t>(sample(random));
  const hasp::GridView<const std::int16_t> view{ samples.data(), g };
  const hasp::MinMaxBlocks blocks{ hasp::AnyGridView(view) };
  const hasp::RayCaster caster(view, blocks, 0.5);
  std::uniform_real_distribution<double> any(0.0, 9.0);
  for (int n = 0; n < 300; ++n)
  {
    const glm::dvec3 origin(-3, any(random), any(random)), target(9.9, any(random), any(random));
    const glm::dvec3 d = target - origin;
    double best = 1e30;
    double valueBefore = 0;
    for (int i = 0; i <= 40000 && best > 1e29; ++i) // steps of 0.0004 voxels
    {
      const auto value = SampleTrilinear(view, origin + d * (i / 40000.0));
      if (value && valueBefore != 0 && (*value >= 0.5) != (valueBefore >= 0.5))
        best = i / 40000.0;
      valueBefore = value.value_or(0);
    }
    const auto hit = caster.Cast(origin, d, 0, 1);
    ASSERT_TRUE(hit);
    // Later than the truth never; earlier only for a double root between two of its steps.
    EXPECT_LE(hit->t, best + 1e-6);
    EXPECT_NEAR(*SampleTrilinear(view, g.WorldToIndex(hit->position)), 0.5, 1e-3);
  }
}

TEST(RayCaster, NoRaySlipsThroughAClosedSurface)
{
  std::mt19937 random(23);
  std::normal_distribution<double> normal;
  const auto shape = hasp::AnalyticSphere({ 0, 0, 0 }, 15);
  const hasp::GridGeometry g = RotatedGrid(40, 1.0);
  const auto samples = hasp::SampleAnalytic<std::int16_t>(shape, g, 100, 0);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  const hasp::MinMaxBlocks blocks(grid);
  const hasp::RayCaster caster(grid, blocks, 0.0);
  for (int n = 0; n < 20000; ++n)
  {
    const glm::dvec3 d(normal(random), normal(random), normal(random));
    ASSERT_TRUE(caster.Cast({ 0, 0, 0 }, d)) << d.x << " " << d.y << " " << d.z;
  }
}

} // namespace
