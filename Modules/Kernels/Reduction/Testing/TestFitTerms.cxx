#include "BrokenBlock.h"

#include <gtest/gtest.h>

namespace
{
struct Scene
{
  std::vector<hasp::PlacedBody> moved;
  hasp::FitScene standing;

  Scene()
  {
    const BrokenBlock block{ .wave = 0.4 }; // all of it looks at the other face
    this->moved = { block.Half(true) };
    this->moved[0].bodyInWorld =
      Moved(this->moved[0].bodyInWorld, { 0.2, -0.1, 0.1 }, { 1, 1, 0 }, 0.7);
    this->standing.partners = { block.Half(false) };
  }
  hasp::FitSums At(const glm::dvec3& shift, const glm::dvec3& turn, const hasp::FitLaw& law) const
  {
    std::vector<hasp::PlacedBody> bodies = this->moved;
    const glm::dvec3 origin = bodies[0].bodyInWorld.position;
    bodies[0].bodyInWorld = { origin + shift,
      hasp::TurnBy(turn) * bodies[0].bodyInWorld.orientation };
    return hasp::SumFit(bodies, origin, this->standing, law, 4096);
  }
};
} // namespace

TEST(FitTerms, PullAgainstTheEnergysGradient)
{
  const Scene scene;
  hasp::FitLaw law;
  law.captureMm = 0.5;
  law.continuity = 0.0; // its normals turn with the body: the next test
  const hasp::FitSums sums = scene.At({}, {}, law);
  std::vector<hasp::FitResidual> residuals;
  hasp::SumFit(
    scene.moved, scene.moved[0].bodyInWorld.position, scene.standing, law, 4096, &residuals);
  for (int k = 0; k < 6; ++k)
  {
    const double step = k < 3 ? 1e-3 : 1e-4;
    glm::dvec3 way(0.0);
    way[k % 3] = step;
    const glm::dvec3 none(0.0);
    const double up = scene.At(k < 3 ? way : none, k < 3 ? none : way, law).energy;
    const double down = scene.At(k < 3 ? -way : none, k < 3 ? none : -way, law).energy;
    double sizes = 0.0; // of what nearly balances
    for (const hasp::FitResidual& r : residuals)
      sizes += std::abs(r.weight * r.mm * r.slope[k]);
    // Distances on a grid do not rise by 1 a mm everywhere, and at the rim what looks at what
    // changes.
    EXPECT_NEAR(sums.pull[k], -(up - down) / (2.0 * step), 0.05 * sizes) << k;
  }
}

TEST(FitTerms, AllBodiesTogetherAreTheirSum)
{
  const Scene scene;
  hasp::FitScene twice = scene.standing;
  twice.partners.push_back(twice.partners[0]);
  const glm::dvec3 origin = scene.moved[0].bodyInWorld.position;
  const hasp::FitSums one = hasp::SumFit(scene.moved, origin, scene.standing, {}, 4096);
  const hasp::FitSums two = hasp::SumFit(scene.moved, origin, twice, {}, 4096);
  EXPECT_NEAR(two.energy, 2.0 * one.energy, 1e-9 * std::abs(one.energy));
  EXPECT_NEAR(two.facesMm2, 2.0 * one.facesMm2, 1e-9 * one.facesMm2);
  EXPECT_EQ(two.deepestMm, one.deepestMm);
  for (std::size_t n = 0; n < one.matrix.size(); ++n)
    EXPECT_NEAR(two.matrix[n], 2.0 * one.matrix[n], 1e-6 * std::abs(one.matrix[0]) * 225.0);
}

TEST(FitTerms, ResidualsAreWhatTheSumsAreOf)
{
  const Scene scene;
  std::vector<hasp::FitResidual> residuals;
  const hasp::FitSums sums = hasp::SumFit(
    scene.moved, scene.moved[0].bodyInWorld.position, scene.standing, {}, 4096, &residuals);
  ASSERT_GT(residuals.size(), 1000U);
  hasp::Vector6 pull{};
  hasp::Symmetric6 matrix{};
  for (const hasp::FitResidual& r : residuals)
    for (std::size_t row = 0; row < 6; ++row)
    {
      pull[row] -= r.weight * r.mm * r.slope[row];
      for (std::size_t column = row; column < 6; ++column)
        matrix[hasp::UpperIndex(row, column)] += r.weight * r.slope[row] * r.slope[column];
    }
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(pull[k], sums.pull[k], 1e-9 * (1.0 + std::abs(pull[k])));
  for (std::size_t n = 0; n < matrix.size(); ++n)
    EXPECT_NEAR(matrix[n], sums.matrix[n], 1e-9 * (1.0 + matrix.back())) << n;
}

TEST(FitTerms, WhatIsFarApartIsNotSummed)
{
  Scene scene;
  scene.moved[0].bodyInWorld.position.z += 100.0;
  const hasp::FitSums sums = scene.At({}, {}, {});
  EXPECT_EQ(sums.energy, 0.0);
  EXPECT_EQ(sums.facesMm2, 0.0);
}

TEST(SmoothPoints, ArePointsOfSidesAndNotOfEdges)
{
  const hasp::PlacedBody half = BrokenBlock{ .wave = 0.0 }.Half(true);
  const auto points = half.body->Smooth().Points();
  ASSERT_GT(points.size(), 500U);
  for (const hasp::OrientedPoint& p : points)
  {
    // Of a box: one of the axes is the normal.
    const glm::dvec3 n = glm::abs(p.normal);
    EXPECT_GT(std::max({ n.x, n.y, n.z }), 0.95);
  }
  // A quarter of the surface and more is within 2 mm of an edge.
  EXPECT_LT(
    half.body->Smooth().AreaOfPoint() * double(points.size()), 0.95 * half.body->SurfaceArea());
}

TEST(PointBoxes, FindAllThatAreNear)
{
  const hasp::PlacedBody half = BrokenBlock{}.Half(true);
  const auto points = half.body->Points(100'000);
  const hasp::PointBoxes boxes(points, 2.5);
  for (const glm::dvec3 center : { glm::dvec3(0.0), glm::dvec3(15.0, 10.0, 6.0), glm::dvec3(1e9) })
  {
    std::vector<std::uint32_t> found;
    boxes.NearTo(center, 4.0, [&](std::uint32_t n) { found.push_back(n); });
    std::sort(found.begin(), found.end());
    for (std::uint32_t n = 0; n < points.size(); ++n)
      if (glm::length(points[n].place - center) <= 4.0)
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), n));
  }
}
