#include "Isosurface/RayRoot.h"
#include "RayRootTruth.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

struct Corners
{
  glm::vec4 low, high;
  std::array<double, 8> exact;
};

Corners RandomCorners(std::mt19937& random, double size)
{
  std::uniform_real_distribution<float> any(-1.0F, 1.0F);
  Corners c{};
  for (int n = 0; n < 8; ++n)
  {
    const float value = any(random) * static_cast<float>(size);
    (n < 4 ? c.low[n] : c.high[n - 4]) = value;
    c.exact[n] = value;
  }
  return c;
}

glm::vec3 RandomWallPoint(std::mt19937& random)
{
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  glm::vec3 p(unit(random), unit(random), unit(random));
  p[static_cast<int>(random() % 3)] = static_cast<float>(random() % 2);
  return p;
}

TEST(RayRoot, MatchesBruteForceOnRandomCells)
{
  std::mt19937 random(11);
  int hits = 0;
  for (int n = 0; n < 4000; ++n)
  {
    const Corners c = RandomCorners(random, 1.0);
    const glm::vec3 a = RandomWallPoint(random), b = RandomWallPoint(random);
    const auto truth = hasp::testing::BruteForceRoot(c.exact, a, b);
    if (truth.tangency < 1e-4) // roots closer than the samples of the truth, or a grazing ray
      continue;
    float s;
    const bool hit =
      hasp::glsl::HaspFirstRoot(hasp::glsl::HaspRayBernstein(c.low, c.high, a, b), s);
    ASSERT_EQ(hit, truth.first.has_value()) << "case " << n;
    if (!hit)
      continue;
    ++hits;
    // Float rounding of the cubic (some 1e-7) over its slope, which tangency >= 1e-4 keeps from
    // vanishing.
    EXPECT_NEAR(s, *truth.first, 2e-4) << "case " << n;
  }
  EXPECT_GT(hits, 1500);
}

/// All changes of side of random cubics in 2000 steps; near misses are left out.
TEST(RayRoot, LaterRootsAreAllTheOthers)
{
  std::mt19937 random(13);
  std::uniform_real_distribution<float> any(-1.0F, 1.0F);
  int found[4] = { 0, 0, 0, 0 };
  for (int n = 0; n < 4000; ++n)
  {
    const glm::dvec4 exact = glm::vec4(any(random), any(random), any(random), any(random));
    const auto f = [&](int step)
    {
      const double s = step / 2000.0, r = 1 - s;
      return r * r * (r * exact.x + 3 * s * exact.y) + s * s * (3 * r * exact.z + s * exact.w);
    };
    std::vector<double> truth;
    double nearest = std::min(std::abs(f(0)), std::abs(f(2000)));
    for (int step = 1; step <= 2000; ++step)
    {
      if ((f(step) >= 0) != (f(step - 1) >= 0))
        truth.push_back((step - 0.5) / 2000);
      if (step < 2000 && (f(step) - f(step - 1)) * (f(step + 1) - f(step)) <= 0)
        nearest = std::min(nearest, std::abs(f(step)));
    }
    if (nearest < 1e-4)
      continue;
    const glm::vec4 cubic(exact * (n % 2 ? 1.0 : 1e30)); // squares must not overflow
    float s;
    glm::vec2 later(0);
    std::vector<double> roots;
    if (hasp::glsl::HaspFirstRoot(cubic, s))
    {
      const int count = hasp::glsl::HaspLaterRoots(cubic, s, later);
      roots = { s, later.x, later.y };
      roots.resize(1 + count);
    }
    ASSERT_EQ(roots.size(), truth.size()) << "case " << n;
    ++found[truth.size()];
    for (std::size_t k = 0; k < truth.size(); ++k)
      EXPECT_NEAR(roots[k], truth[k], 5e-4) << "case " << n; // half a step; rounding as above
  }
  EXPECT_GT(found[2], 300);
  EXPECT_GT(found[3], 20);
}

TEST(RayRoot, BernsteinCoefficientsAreTheCubic)
{
  std::mt19937 random(12);
  for (int n = 0; n < 1000; ++n)
  {
    const Corners c = RandomCorners(random, 1000.0);
    const glm::vec3 a = RandomWallPoint(random), b = RandomWallPoint(random);
    const glm::vec4 cubic = hasp::glsl::HaspRayBernstein(c.low, c.high, a, b);
    for (float s : { 0.0F, 0.25F, 0.5F, 0.875F, 1.0F })
      EXPECT_NEAR(hasp::glsl::HaspBernsteinValue(cubic, s),
        hasp::TrilinearValue(
          c.exact, glm::dvec3(1 - s) * glm::dvec3(a) + double(s) * glm::dvec3(b)),
        1e-3); // float rounding of values up to 1000
  }
}

TEST(RayRoot, GradientMatchesTheDoublePrecisionOne)
{
  std::mt19937 random(13);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (int n = 0; n < 1000; ++n)
  {
    const Corners c = RandomCorners(random, 1.0);
    const glm::vec3 t(unit(random), unit(random), unit(random));
    const glm::dvec3 truth = hasp::TrilinearGradient(c.exact, t);
    EXPECT_LT(
      glm::length(glm::dvec3(hasp::glsl::HaspTrilinearGradient(c.low, c.high, t)) - truth), 2e-6);
  }
}

TEST(RayRoot, ASignChangeBetweenTheEndsIsAlwaysAHit)
{
  // No epsilon anywhere: if entry and exit differ in sign, a root is found, however wild the
  // numbers.
  std::mt19937 random(14);
  std::uniform_real_distribution<float> exponent(-20.0F, 20.0F);
  for (int n = 0; n < 20000; ++n)
  {
    glm::vec4 cubic;
    for (int i = 0; i < 4; ++i)
      cubic[i] = std::exp2(exponent(random)) * (random() % 2 ? 1.0F : -1.0F);
    float s = -1.0F;
    const bool hit = hasp::glsl::HaspFirstRoot(cubic, s);
    ASSERT_TRUE(hit || (cubic.x >= 0) == (cubic.w >= 0))
      << cubic.x << " " << cubic.y << " " << cubic.z << " " << cubic.w;
    ASSERT_TRUE(!hit || (s >= 0.0F && s <= 1.0F)) << s;
  }
}

} // namespace
