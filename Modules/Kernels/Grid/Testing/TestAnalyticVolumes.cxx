#include "Grid/AnalyticVolumes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <random>

namespace
{

TEST(AnalyticVolumes, FirstSurfaceOfASphereIsTheClosedForm)
{
  const glm::dvec3 center(1, 2, 3), origin(40, -3, 8);
  const double radius = 10;
  const auto sphere = hasp::AnalyticSphere(center, radius);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> spread(-12, 12);
  int hits = 0;
  for (int n = 0; n < 500; ++n)
  {
    const glm::dvec3 target = center + glm::dvec3(spread(random), spread(random), spread(random));
    const glm::dvec3 d = glm::normalize(target - origin), m = origin - center;
    const double b = glm::dot(m, d), D = b * b - glm::dot(m, m) + radius * radius;
    const auto t = FirstSurface(sphere, origin, d, 0, 100);
    if (std::abs(D) < 1e-3)
      continue; // grazing: inside for less than the least step
    ASSERT_EQ(t.has_value(), D > 0);
    hits += D > 0;
    EXPECT_NEAR(t.value_or(0.0), t ? -b - std::sqrt(D) : 0.0, 1e-8);
  }
  EXPECT_GT(hits, 100);
}

TEST(AnalyticVolumes, LipschitzBoundHolds)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> any(-50, 50), small(-1, 1);
  for (const auto& v : { hasp::AnalyticSphere({ 1, 2, 3 }, 10),
         hasp::AnalyticTorus({ 0, 0, 0 }, glm::normalize(glm::dvec3(1, 2, 2)), 20, 6),
         hasp::AnalyticGyroid(17), hasp::AnalyticTrabecular(40, 2, 9) })
    for (int n = 0; n < 20000; ++n)
    {
      const glm::dvec3 a(any(random), any(random), any(random));
      const glm::dvec3 b = a + glm::dvec3(small(random), small(random), small(random));
      ASSERT_LE(std::abs(v.value(a) - v.value(b)), v.lipschitz * glm::length(a - b) + 1e-12)
        << v.name;
    }
}

TEST(AnalyticVolumes, TrabecularBoneIsAShellWithAQuarterOfStruts)
{
  EXPECT_THROW(hasp::AnalyticTrabecular(10, 10, 3), std::invalid_argument);
  EXPECT_THROW(hasp::AnalyticTrabecular(10, 0, 3), std::invalid_argument);
  EXPECT_THROW(hasp::AnalyticTrabecular(10, 1, 0), std::invalid_argument);
  const auto bone = hasp::AnalyticTrabecular(30, 2, 6);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> any(-16, 16), depth(0, 2);
  int solid = 0;
  constexpr int count = 20000;
  for (int n = 0; n < count; ++n)
  {
    const glm::dvec3 p(any(random), any(random), any(random)); // inside the shell: |p| < 28
    solid += bone.value(p) > 0;
    const glm::dvec3 outward = glm::normalize(p);
    EXPECT_GE(bone.value((30 - depth(random)) * outward), 0);
    EXPECT_NEAR(bone.value((30.0 + depth(random)) * outward), 0, 2.0); // minus the distance
    EXPECT_LT(bone.value(30.001 * outward), 0);
  }
  EXPECT_NEAR(double(solid) / count, 0.25, 0.03); // of the network; 0.003 a standard deviation
}

TEST(AnalyticVolumes, IntegersAreRoundedAndSaturated)
{
  const hasp::GridGeometry g{ { 3, 1, 1 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  const hasp::AnalyticVolume x{ "x", [](const glm::dvec3& p) { return p.x; }, 1 };
  EXPECT_EQ(hasp::SampleAnalytic<std::uint8_t>(x, g, 300, -0.6),
    (std::vector<std::uint8_t>{ 0, 255, 255 }));
  EXPECT_EQ(
    hasp::SampleAnalytic<std::int16_t>(x, g, 1.6, -1), (std::vector<std::int16_t>{ -1, 1, 2 }));
}

} // namespace
