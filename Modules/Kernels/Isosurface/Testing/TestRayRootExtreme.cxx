// Cells and rays at the edge of what float can say.
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/RayCaster.h"
#include "Isosurface/RayRoot.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace
{

using hasp::glsl::HaspFirstRoot;

TEST(RayRootExtreme, AllEqualToTheIsovalueIsInsideEverywhereAndHasNoSurface)
{
  float s;
  EXPECT_FALSE(HaspFirstRoot(glm::vec4(0.0F), s));
  EXPECT_FALSE(HaspFirstRoot(glm::vec4(-0.0F), s)); // minus zero is inside as zero is
  EXPECT_TRUE(HaspFirstRoot(glm::vec4(-1.0F, -1.0F, -1.0F, 0.0F), s));
  EXPECT_FLOAT_EQ(s, 1.0F);
}

TEST(RayRootExtreme, ASaddleWithADoubleRootNeverLeavesTheSegment)
{
  float s;
  // (2s-1)^2 touches zero; raised or lowered by one part in 1e6 it has none or two roots.
  EXPECT_FALSE(HaspFirstRoot(glm::vec4(1.0F, -1.0F / 3, -1.0F / 3, 1.0F) + 1e-6F, s));
  EXPECT_TRUE(HaspFirstRoot(glm::vec4(1.0F, -1.0F / 3, -1.0F / 3, 1.0F) - 1e-6F, s));
  EXPECT_NEAR(s, 0.5, 1e-3);
}

TEST(RayRootExtreme, TinyAndHugeValues)
{
  float s;
  for (float size : { 1e-30F, 1e-10F, 1.0F, 1e10F, 1e30F })
  {
    ASSERT_TRUE(HaspFirstRoot(glm::vec4(-1.0F, -1.0F / 3, 1.0F / 3, 1.0F) * size, s)) << size;
    EXPECT_NEAR(s, 0.5, 1e-6) << size;
  }
}

TEST(RayRootExtreme, NotANumberIsNoSurface)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  float s;
  EXPECT_FALSE(HaspFirstRoot(glm::vec4(nan), s));
}

TEST(RayRootExtreme, InfiniteCornersAreNoSurfaceEither)
{
  const float infinity = std::numeric_limits<float>::infinity();
  const hasp::GridGeometry g{ { 2, 2, 2 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  for (const float bad : { infinity, -infinity })
    for (int corner = 0; corner < 8; ++corner)
    {
      std::vector<float> samples{ -1, 1, -1, 1, -1, 1, -1, 1 };
      samples[corner] = bad;
      const hasp::AnyGridView grid = hasp::GridView<const float>{ samples.data(), g };
      const hasp::MinMaxBlocks blocks(grid);
      const hasp::RayCaster caster(grid, blocks, 0.0);
      EXPECT_FALSE(caster.Cast({ -1, 0.3, 0.4 }, { 1, 0, 0 })) << bad << " at " << corner;
      EXPECT_FALSE(caster.Cast({ -1, -0.5, 0.1 }, { 1, 0.7, 0.4 })) << bad << " at " << corner;
    }
}

/// A slab of 8 x 8 x 8 samples with value 10 (k - 3.5) along z, spacing 0.3 x 0.3 x 3 mm.
struct Ramp
{
  hasp::GridGeometry geometry{ { 8, 8, 8 }, {}, { 0.3, 0.3, 3.0 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples;
  Ramp()
  {
    for (int n = 0; n < 512; ++n)
      samples.push_back(static_cast<std::int16_t>(10 * (n / 64) - 35));
  }
  hasp::AnyGridView View() const
  {
    return hasp::GridView<const std::int16_t>{ samples.data(), geometry };
  }
};

TEST(RayRootExtreme, AxisParallelFaceEdgeAndCornerRaysHitExactly)
{
  const Ramp ramp;
  const hasp::MinMaxBlocks blocks(ramp.View());
  const hasp::RayCaster caster(ramp.View(), blocks, 0.0);
  for (double i : { 0.0, 0.5, 1.0, 7.0 }) // through cells, along faces, along edges, on the border
    for (double j : { 0.0, 1.0, 3.5, 7.0 })
    {
      const glm::dvec3 start = ramp.geometry.IndexToWorld({ i, j, -15 });
      const auto hit = caster.Cast(start, { 0, 0, 1 });
      ASSERT_TRUE(hit) << i << " " << j;
      EXPECT_NEAR(hit->position.z, 3.5 * 3.0, 1e-5);
      EXPECT_NEAR(hit->gradient.z, 10.0 / 3.0, 1e-5);
    }
  const glm::dvec3 diagonal =
    ramp.geometry.IndexToWorld({ 7, 7, 7 }); // through corners of cells all the way
  const auto hit = caster.Cast(-diagonal, diagonal);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 1.5, 1e-6);
  EXPECT_FALSE(caster.Cast({ 1, 1, 9 }, { 1, 0, 0 })); // parallel to the surface, below it
}

TEST(RayRootExtreme, TheOriginMayBeInsideOrAMillionVoxelsAway)
{
  const Ramp ramp;
  const hasp::MinMaxBlocks blocks(ramp.View());
  const hasp::RayCaster caster(ramp.View(), blocks, 0.0);
  const auto fromInside = caster.Cast({ 1, 1, 20 }, { 0, 0, -2 });
  ASSERT_TRUE(fromInside);
  EXPECT_NEAR(fromInside->t, (20 - 10.5) / 2, 1e-6);
  const glm::dvec3 far = glm::normalize(glm::dvec3(1, 2, -2)) * 1e6;
  const auto hit = caster.Cast(glm::dvec3(1, 1, 10.5) + far, -far);
  ASSERT_TRUE(hit);
  EXPECT_LT(glm::length(hit->position - glm::dvec3(1, 1, 10.5)), 1e-5);
}

TEST(RayRootExtreme, FullRangeOfInt16)
{
  Ramp ramp;
  for (int n = 0; n < 512; ++n)
    ramp.samples[n] = n / 64 < 4 ? std::numeric_limits<std::int16_t>::min()
                                 : std::numeric_limits<std::int16_t>::max();
  const hasp::MinMaxBlocks blocks(ramp.View());
  const auto hit = hasp::RayCaster(ramp.View(), blocks, -0.5).Cast({ 1, 1, -5 }, { 0, 0, 1 });
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->position.z, 3.5 * 3, 1e-5);
}

TEST(RayRootExtreme, RaysThatAreNoRaysHitNothing)
{
  const Ramp ramp;
  const hasp::MinMaxBlocks blocks(ramp.View());
  const hasp::RayCaster caster(ramp.View(), blocks, 0.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(caster.Cast({ 1, 1, 1 }, { 0, 0, 0 }));
  EXPECT_FALSE(caster.Cast({ nan, 1, 1 }, { 0, 0, 1 }));
  EXPECT_FALSE(caster.Cast({ 1, 1, 1 }, { 0, nan, 1 }));
}

} // namespace
