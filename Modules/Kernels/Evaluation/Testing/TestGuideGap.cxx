#include "Evaluation/GuideGap.h"
#include "Grid/AnalyticVolumes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// A patch of the sphere of radius r around 0 about the z axis, facing the centre (or away).
hasp::TriangleMesh Patch(double r, bool facingCenter)
{
  constexpr int N = 24;
  hasp::TriangleMesh mesh;
  for (int j = 0; j <= N; ++j)
    for (int i = 0; i <= N; ++i)
      mesh.points.push_back(r * glm::normalize(glm::dvec3(i - N / 2, j - N / 2, 2.0 * N)));
  for (unsigned j = 0; j < N; ++j)
    for (unsigned i = 0; i < N; ++i)
    {
      const unsigned a = j * (N + 1) + i, b = a + 1, c = a + N + 1, d = c + 1;
      mesh.triangles.emplace_back(facingCenter ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c));
      mesh.triangles.emplace_back(facingCenter ? glm::uvec3(b, c, d) : glm::uvec3(b, d, c));
    }
  return mesh;
}

struct Bone
{
  hasp::GridGeometry grid{ { 40, 40, 20 }, { -20, -20, 30 }, glm::dvec3(1), glm::dmat3(1) };
  std::vector<float> samples =
    hasp::SampleAnalytic<float>(hasp::AnalyticSphere({}, 40), grid, 1, 0);
  hasp::GridView<const float> ct{ samples.data(), grid };
};

TEST(GuideGap, FindsTheGapOfASphericalWall)
{
  const Bone bone;
  hasp::GuideGapSettings s;
  s.isovalue = 0;
  s.gapMm = 0.5;
  const auto mesh = Patch(40.5, true);
  const auto gap = hasp::MeasureGuideGap(bone.ct, mesh, s);
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * glm::length(glm::cross(
                    mesh.points[t.y] - mesh.points[t.x], mesh.points[t.z] - mesh.points[t.x]));
  EXPECT_NEAR(gap.innerWallMm2, area, 1e-9);
  EXPECT_EQ(gap.share, 1.0);
  EXPECT_EQ(gap.closer, 0.0);
  // The trilinear sphere lies up to 0.006 inside, triangle centres up to 0.003 inside theirs.
  EXPECT_NEAR(gap.p5, 0.5, 0.01);
  EXPECT_NEAR(gap.p95, 0.5, 0.01);
  EXPECT_LE(gap.least, gap.p5);
  EXPECT_LE(gap.p95, gap.most);
}

TEST(GuideGap, WallsThatAreWrongShow)
{
  const Bone bone;
  hasp::GuideGapSettings s;
  s.isovalue = 0;
  s.gapMm = 0.5;
  auto gap = hasp::MeasureGuideGap(bone.ct, Patch(40.9, true), s);
  EXPECT_EQ(gap.share, 0.0);
  EXPECT_EQ(gap.closer, 0.0);
  gap = hasp::MeasureGuideGap(bone.ct, Patch(39.8, true), s); // inside the bone
  EXPECT_EQ(gap.share, 0.0);
  EXPECT_EQ(gap.closer, 1.0);
  EXPECT_NEAR(gap.p50, -0.2, 0.01);
  gap = hasp::MeasureGuideGap(bone.ct, Patch(40.5, false), s); // an outer wall
  EXPECT_EQ(gap.innerWallMm2, 0.0);
  EXPECT_NEAR(gap.leastAnywhere, 0.5, 0.02);
  gap = hasp::MeasureGuideGap(bone.ct, Patch(44, true), s); // far off
  EXPECT_EQ(gap.innerWallMm2, 0.0);
}

TEST(GuideGap, SettingsOutOfRangeThrow)
{
  const Bone bone;
  hasp::GuideGapSettings s;
  s.nearMm = s.gapMm;
  EXPECT_THROW(hasp::MeasureGuideGap(bone.ct, {}, s), std::invalid_argument);
  s = {};
  s.gapMm = std::nan("");
  EXPECT_THROW(hasp::MeasureGuideGap(bone.ct, {}, s), std::invalid_argument);
  const hasp::TriangleMesh broken{ { { 0, 0, 0 } }, { { 0, 0, 1000000 } } };
  EXPECT_THROW(hasp::MeasureGuideGap(bone.ct, broken, {}), std::invalid_argument);
}

} // namespace
