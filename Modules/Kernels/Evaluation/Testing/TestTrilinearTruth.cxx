#include "Evaluation/TrilinearTruth.h"
#include "Grid/Trilinear.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

struct Volume
{
  hasp::GridGeometry geometry;
  std::vector<float> samples;
  hasp::AnyGridView View() const
  {
    return hasp::GridView<const float>{ this->samples.data(), this->geometry };
  }
};

Volume Random(const hasp::GridGeometry& geometry, int seed)
{
  Volume volume{ geometry, std::vector<float>(geometry.Size()) };
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> any(-1, 1);
  for (float& sample : volume.samples)
    sample = any(random);
  return volume;
}

/// x + 10 y + 100 z of the index: trilinear interpolation gives a plane back exactly.
Volume Plane(const hasp::GridGeometry& geometry)
{
  Volume volume{ geometry, {} };
  for (int k = 0; k < geometry.dims.z; ++k)
    for (int j = 0; j < geometry.dims.y; ++j)
      for (int i = 0; i < geometry.dims.x; ++i)
        volume.samples.push_back(float(i + 10 * j + 100 * k));
  return volume;
}

hasp::GridGeometry Grid(const glm::ivec3& dims)
{
  return { dims, glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
}

TEST(TrilinearTruth, WhatIsNoRayMeetsNothing)
{
  const Volume v = Plane(Grid({ 4, 4, 4 }));
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(FirstTrilinearHit(v.View(), 100, { 1, 1, -1 }, { 0, 0, 0 }));
  EXPECT_FALSE(FirstTrilinearHit(v.View(), 100, { 1, nan, -1 }, { 0, 0, 1 }));
  EXPECT_FALSE(FirstTrilinearHit(v.View(), 100, { 1, 1, -1 }, { 0, 0, infinity }));
  EXPECT_FALSE(FirstTrilinearHit(v.View(), 100, { 1, 1, 5 }, { 0, 0, 1 })) << "behind the start";
  EXPECT_FALSE(FirstTrilinearHit(v.View(), 100, { -1, 1, 1 }, { 0, 0, 1 })) << "beside the volume";
  EXPECT_FALSE(FirstTrilinearHit(Plane(Grid({ 4, 1, 4 })).View(), 50, { 0, 0, 0 }, { 1, 0, 1 }));
}

TEST(TrilinearTruth, PlaneIsTheClosedForm)
{
  const glm::dmat3 turned(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, 2, 3))));
  const hasp::GridGeometry g{ { 9, 8, 7 }, { 3, -4, 5 }, { 0.3, 0.5, 2.0 }, turned };
  const Volume v = Plane(g);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  for (int n = 0; n < 200; ++n)
  {
    const glm::dvec3 inside =
      glm::dvec3(any(random), any(random), any(random)) * glm::dvec3(8, 7, 6);
    const double isovalue = inside.x + 10 * inside.y + 100 * inside.z;
    const glm::dvec3 target = g.IndexToWorld(inside);
    const glm::dvec3 d(any(random) - 0.5, any(random) - 0.5, any(random) - 0.5);
    const auto hit = FirstTrilinearHit(v.View(), isovalue, target - 1e3 * d, d);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 1e3, 1e-9);
    EXPECT_LT(glm::length(hit->position - target), 1e-9);
    EXPECT_LT(glm::length(hit->gradient - g.GradientToWorld({ 1, 10, 100 })), 1e-9);
  }
}

/// The same question by brute force: 20,000 steps through the volume.
TEST(TrilinearTruth, NoiseAgreesWithSmallSteps)
{
  const Volume v = Random(Grid({ 6, 6, 6 }), 4);
  const hasp::GridView<const float> view{ v.samples.data(), v.geometry };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 5);
  int hits = 0;
  for (int n = 0; n < 60; ++n)
  {
    const glm::dvec3 a(any(random), any(random), 0), b(any(random), any(random), 5);
    const auto value = [&](int step)
    { return *SampleTrilinear(view, glm::mix(a, b, step / 20000.0)) - 0.3; };
    int first = 1;
    while (first <= 20000 && (value(first) >= 0) == (value(0) >= 0))
      ++first;
    const auto hit = FirstTrilinearHit(v.View(), 0.3, a, b - a);
    ASSERT_EQ(hit.has_value(), first <= 20000) << n;
    hits += hit.has_value();
    EXPECT_NEAR(hit ? hit->t : 0, hit ? first / 20000.0 : 0, 1.0 / 20000) << n;
  }
  EXPECT_GT(hits, 30);
}

TEST(TrilinearTruth, RaysInFacesEdgesAndCornersLoseNothing)
{
  const Volume v = Plane(Grid({ 5, 5, 5 }));
  for (const glm::dvec3 start :
    { glm::dvec3(2, 2, -3), glm::dvec3(0, 0, -3), glm::dvec3(4, 4, -3) })
  {
    const double isovalue = start.x + 10 * start.y + 250;
    const auto hit = FirstTrilinearHit(v.View(), isovalue, start, { 0, 0, 1 });
    ASSERT_TRUE(hit);
    EXPECT_DOUBLE_EQ(hit->t, 5.5);
  }
  const auto corners = FirstTrilinearHit(v.View(), 222, { -1, -1, -1 }, { 1, 1, 1 });
  ASSERT_TRUE(corners); // the surface goes through the corner the ray goes through
  EXPECT_DOUBLE_EQ(corners->t, 3.0);
  const auto leaving = FirstTrilinearHit(v.View(), 222, { 4, 4, 4 }, { -1, -1, -1 });
  ASSERT_TRUE(leaving) << "it starts inside";
  EXPECT_NEAR(leaving->t, 2.0, 1e-15);
}

/// One cell; along its diagonal the polynomial is 32 (s - 1/4)(s - 1/2)(s - 3/4).
Volume ThreeRoots()
{
  Volume v{ Grid({ 2, 2, 2 }), std::vector<float>(8) };
  for (int n = 0; n < 8; ++n)
  {
    constexpr float bernstein[] = { -3.0F, 13.0F / 3.0F, -13.0F / 3.0F, 3.0F };
    v.samples[n] = bernstein[(n & 1) + (n >> 1 & 1) + (n >> 2)];
  }
  return v;
}

TEST(TrilinearTruth, ThreeRootsInACellGiveTheFirst)
{
  const Volume v = ThreeRoots();
  const auto hit = FirstTrilinearHit(v.View(), 0.0, { -1, -1, -1 }, { 1, 1, 1 });
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 1.25, 1e-6); // the corners' thirds are rounded to float
}

TEST(TrilinearTruth, AllRootsOfACellAreFound)
{
  const Volume v = ThreeRoots();
  const auto hits = AllTrilinearHits(v.View(), 0.0, { -1, -1, -1 }, { 1, 1, 1 });
  ASSERT_EQ(hits.size(), 3U);
  for (int n = 0; n < 3; ++n)
    EXPECT_NEAR(hits[n].t, 1.25 + 0.25 * n, 1e-6); // rounded corners, as above
}

/// By brute force: every change of side in 20,000 steps through noise. Two changes within a step
/// are for the truth alone to see, so neither may be missing, and pairs may be more.
TEST(TrilinearTruth, AllHitsAgreeWithSmallSteps)
{
  const Volume v = Random(Grid({ 6, 6, 6 }), 6);
  const hasp::GridView<const float> view{ v.samples.data(), v.geometry };
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 5);
  std::size_t found = 0, stepped = 0;
  for (int n = 0; n < 60; ++n)
  {
    const glm::dvec3 a(any(random), any(random), 0), b(any(random), any(random), 5);
    const auto hits = AllTrilinearHits(v.View(), 0.1, a, b - a);
    const auto inside = [&](int step)
    { return *SampleTrilinear(view, glm::mix(a, b, step / 20000.0)) >= 0.1; };
    std::vector<double> changes;
    for (int step = 1; step <= 20000; ++step)
      if (inside(step) != inside(step - 1))
        changes.push_back(step / 20000.0);
    ASSERT_EQ(hits.size() % 2, changes.size() % 2) << n;
    for (const double change : changes)
    {
      const auto at = std::lower_bound(hits.begin(), hits.end(), change - 1.0 / 20000,
        [](const hasp::TrilinearHit& hit, double t) { return hit.t < t; });
      ASSERT_TRUE(at != hits.end() && at->t <= change) << n << " " << change;
    }
    found += hits.size();
    stepped += changes.size();
  }
  EXPECT_GT(stepped, 80U);
  EXPECT_LE(found, stepped + 2);
}

TEST(TrilinearTruth, CellsWithoutAPolynomialAreEmpty)
{
  Volume v = Plane(Grid({ 5, 5, 5 }));
  v.samples[(2 * 5 + 2) * 5 + 2] = std::nanf("");
  EXPECT_FALSE(FirstTrilinearHit(v.View(), 150 + 16.5, { 1.5, 1.5, -1 }, { 0, 0, 1 }));
  v.samples[(2 * 5 + 2) * 5 + 2] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(FirstTrilinearHit(v.View(), 150 + 16.5, { 1.5, 1.5, -1 }, { 0, 0, 1 }));
  EXPECT_TRUE(FirstTrilinearHit(v.View(), 150 + 16.5, { 0.5, 1.5, -1 }, { 0, 0, 1 }));
}

TEST(TrilinearTruth, FarEyesKeepTheRoot)
{
  const Volume v = Plane(Grid({ 5, 5, 5 }));
  const glm::dvec3 d = glm::normalize(glm::dvec3(1, 2, 3)), target(1.25, 1.5, 2.5);
  const auto hit = FirstTrilinearHit(v.View(), 1.25 + 15 + 250, target - 1e6 * d, d);
  ASSERT_TRUE(hit);
  EXPECT_LT(glm::length(hit->position - target), 1e-9); // doubles of 1e6
}

} // namespace
