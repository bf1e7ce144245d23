// Every instruction set of this machine against one number at a time.
#include "Distance/ElementLanes.h"
#include "Testing/AnalyticCoverage.h"

#include <gtest/gtest.h>

namespace
{

using hasp::ElementLanes;
using Elements = std::vector<hasp::SurfaceElements::Element>;

void ExpectAlike(const Elements& a, const Elements& b, const char* what)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t n = 0; n < a.size(); ++n)
    for (int c = 0; c < 3; ++c)
    {
      // Fused additions differ in the last bits; edges, where a choice may fall the other way,
      // there are none of.
      ASSERT_NEAR(a[n].point[c], b[n].point[c], 2e-4) << what << " " << n;
      ASSERT_NEAR(a[n].normal[c], b[n].normal[c], 2e-4) << what << " " << n;
    }
}

TEST(ElementLanes, AllGiveWhatOneNumberAtATimeGives)
{
  // 37 voxels a row: no multiple of any width. The sphere is cut by the grid's border.
  const hasp::GridGeometry grid{ { 37, 35, 33 }, glm::dvec3(-18, -17, -16), { 1, 1, 1.25 },
    glm::dmat3(1) };
  const auto coverage = hasp::AnalyticCoverage(hasp::AnalyticSphere({ 6.3, 0, 0.2 }, 14.3), grid);
  const hasp::SurfaceElements surface = hasp::ExtractSurfaceElements(grid, coverage);
  const std::size_t count = surface.elements.size();
  ASSERT_GT(count, 1000U);
  const auto all = hasp::AllElementLanes();
  const ElementLanes& one = all.back();
  const auto made = [&](auto make)
  {
    Elements to(count);
    make(surface, coverage.data(), 0, count, to.data());
    return to;
  };
  for (const ElementLanes& lanes : all)
  {
    ExpectAlike(made(lanes.planes), made(one.planes), lanes.name);
    ExpectAlike(made(lanes.isoPlanes), made(one.isoPlanes), lanes.name);
    ExpectAlike(made(lanes.polish), made(one.polish), lanes.name);
    ExpectAlike(made(lanes.refine), made(one.refine), lanes.name);
    Elements to(count);
    const auto a = lanes.gradients(surface, coverage.data(), 0, count, to.data());
    const auto b = one.gradients(surface, coverage.data(), 0, count, to.data());
    EXPECT_EQ(a.partial, b.partial) << lanes.name;
    EXPECT_EQ(a.blurred, b.blurred) << lanes.name;
    EXPECT_EQ(a.stray, b.stray) << lanes.name;
  }
}

TEST(ElementLanes, TheNearestWithinABrickIsThatOfBruteForce)
{
  hasp::SurfaceElements surface;
  surface.sides = { 1.0F, 1.5F, 1.25F };
  constexpr int S = ElementLanes::Side, R = ElementLanes::Reach, N = S + 2 * R;
  ElementLanes::Bits bits{};
  unsigned state = 7;
  for (auto& slice : bits.row)
    for (std::uint32_t& row : slice)
      for (int x = 0; x < N; ++x)
        row |= std::uint32_t((state = state * 1664525U + 1013904223U) >> 24 == 0) << x;
  const float most = 4.87F;
  for (const ElementLanes& lanes : hasp::AllElementLanes())
  {
    std::vector<std::int32_t> list(S * S * S + ElementLanes::Padding);
    const int count = lanes.listNear(surface, bits, most, list.data());
    int listed = 0;
    for (int v = 0; v < S * S * S; ++v)
    {
      const glm::ivec3 p(v % S, v / S % S, v / (S * S));
      float least = 1e30F;
      for (int d = 0; d < 11 * 11 * 11; ++d)
      {
        const glm::ivec3 step(d % 11 - R, d / 11 % 11 - R, d / 121 - R), q = p + step + R;
        if (bits.row[q.z][q.y] >> q.x & 1)
          least = std::min(least, glm::length(glm::vec3(step) * surface.sides));
      }
      if (least > most)
        continue;
      ASSERT_LT(listed, count) << lanes.name;
      const std::int32_t found = list[listed++];
      ASSERT_EQ(found & 4095, p.x | p.y << 4 | p.z << 8) << lanes.name;
      const glm::ivec3 step((found >> 12 & 15) - R, (found >> 16 & 15) - R, (found >> 20 & 15) - R);
      ASSERT_NEAR(glm::length(glm::vec3(step) * surface.sides), least, 1e-5F) << lanes.name;
    }
    EXPECT_EQ(listed, count) << lanes.name;
    EXPECT_GT(count, 1000) << lanes.name;
  }
}

} // namespace
