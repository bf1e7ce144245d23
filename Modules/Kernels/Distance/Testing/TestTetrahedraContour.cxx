#include "Distance/ImplicitShapes.h"
#include "Distance/TetrahedraContour.h"
#include "Grid/AnalyticVolumes.h"
#include "Testing/MeshFacts.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace
{

using Field = std::function<double(const glm::dvec3&)>;

std::vector<float> Sample(const Field& field, const hasp::GridGeometry& grid)
{
  return hasp::SampleAnalytic<float>({ "", field, 1 }, grid, 1, 0);
}

hasp::GridGeometry Cube(int n, double side)
{
  return { glm::ivec3(n), glm::dvec3(-0.5 * side), glm::dvec3(side / (n - 1)), glm::dmat3(1) };
}

TEST(TetrahedraContour, ASphereHasItsVolumeAndOnePiece)
{
  for (const double flip : { 1.0, -1.0 }) // a left-handed grid must not turn the mesh inside out
  {
    hasp::GridGeometry grid = Cube(41, 24);
    grid.direction[1] *= flip;
    grid.origin.y *= flip;
    const auto field = Sample([](const glm::dvec3& p) { return glm::length(p) - 10; }, grid);
    const auto mesh = hasp::ContourTetrahedra({ field.data(), grid });
    const auto facts = hasp::FactsOf(mesh);
    EXPECT_TRUE(facts.closed && facts.manifold && facts.noArea == 0);
    EXPECT_EQ(facts.euler, 2); // a sphere
    // Chords of 0.6 mm cells: h^2 / (8 R) of radius, twice over: 0.3 % of the volume.
    EXPECT_NEAR(facts.volume / (4.0 / 3.0 * glm::pi<double>() * 1000), 1.0, 0.004);
  }
}

TEST(TetrahedraContour, ABoxMinusACylinderIsATorus)
{
  const glm::dmat3 axes(glm::rotate(glm::dmat4(1), 0.3, glm::normalize(glm::dvec3(1, 1, 2))));
  const auto shape = [&](const glm::dvec3& p)
  {
    return std::max(
      hasp::BoxDistance(p, {}, axes, { 8, 6, 3 }), -hasp::CylinderDistance(p, {}, axes[2], 2.5));
  };
  const auto grid = Cube(71, 24);
  const auto field = Sample(shape, grid);
  const auto facts = hasp::FactsOf(hasp::ContourTetrahedra({ field.data(), grid }));
  EXPECT_TRUE(facts.closed && facts.manifold && facts.noArea == 0);
  EXPECT_EQ(facts.euler, 0); // one handle
  // Edges are bevelled by part of a 0.34 mm cell: 96 mm of them, 0.03 mm2 each.
  EXPECT_NEAR(facts.volume / (16 * 12 * 6 - glm::pi<double>() * 2.5 * 2.5 * 6), 1.0, 0.005);
}

TEST(TetrahedraContour, RandomFieldsAreClosedAndManifoldEvenAsFloats)
{
  std::mt19937 random(13);
  std::normal_distribution<double> any;
  for (int n = 0; n < 12; ++n)
  {
    glm::dvec3 wave[5];
    double phase[5];
    for (int w = 0; w < 5; ++w)
    {
      wave[w] = glm::dvec3(any(random), any(random), any(random)) * 0.8;
      phase[w] = 3 * any(random);
    }
    const auto field = [&](const glm::dvec3& p)
    {
      double sum = 0.2;
      for (int w = 0; w < 5; ++w)
        sum += std::sin(glm::dot(wave[w], p) + phase[w]);
      return sum;
    };
    hasp::GridGeometry grid = Cube(22, 20);
    grid.spacing = { 0.3, 1, 3 };
    grid.origin += 150.0; // far out, where floats are coarse
    const auto samples = Sample(field, grid);
    const auto mesh = hasp::RoundedAndWelded(hasp::ContourTetrahedra({ samples.data(), grid }));
    const auto facts = hasp::FactsOf(mesh);
    ASSERT_GT(mesh.triangles.size(), 100U);
    ASSERT_TRUE(facts.closed && facts.manifold) << n;
    ASSERT_EQ(facts.noArea, 0U) << n;
    ASSERT_GT(facts.volume, 0) << n;
  }
}

TEST(TetrahedraContour, ValuesOfZeroNaNAndInfinityHaveASide)
{
  std::mt19937 random(17);
  const float values[] = { 0.0F, -0.0F, -1.0F, 1.0F, std::numeric_limits<float>::quiet_NaN(),
    std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(), 1e-40F,
    -1e-40F };
  const auto grid = Cube(12, 11);
  for (int n = 0; n < 20; ++n)
  {
    std::vector<float> field(grid.Size());
    for (float& v : field)
      v = values[random() % std::size(values)];
    const auto mesh = hasp::RoundedAndWelded(hasp::ContourTetrahedra({ field.data(), grid }));
    const auto facts = hasp::FactsOf(mesh);
    ASSERT_TRUE(facts.closed && facts.manifold && facts.noArea == 0) << n;
    for (const glm::dvec3& p : mesh.points)
      ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
  }
}

TEST(TetrahedraContour, WhatReachesTheBorderIsClosedThere)
{
  const auto grid = Cube(9, 8);
  const std::vector<float> inside(grid.Size(), -1.0F);
  const auto facts = hasp::FactsOf(hasp::ContourTetrahedra({ inside.data(), grid }));
  EXPECT_TRUE(facts.closed && facts.manifold && facts.noArea == 0);
  EXPECT_NEAR(facts.volume, 512, 0.1 * 512); // the border counts as outside, 2 % of a cell in
  const std::vector<float> outside(grid.Size(), 1.0F);
  EXPECT_TRUE(hasp::ContourTetrahedra({ outside.data(), grid }).triangles.empty());
  const hasp::GridGeometry flat{ { 5, 5, 1 }, {}, glm::dvec3(1), glm::dmat3(1) };
  EXPECT_TRUE(hasp::ContourTetrahedra({ inside.data(), flat }).points.empty());
}

TEST(TetrahedraContour, SmallPiecesAndHollowsGo)
{
  // A ball with a hollow, and a speck beside it.
  const auto shape = [](const glm::dvec3& p)
  {
    const double ball = std::max(glm::length(p) - 6, 1.0 - glm::length(p - glm::dvec3(2, 0, 0)));
    return std::min(ball, glm::length(p - glm::dvec3(9, 0, 0)) - 0.8);
  };
  const auto grid = Cube(81, 24);
  const auto field = Sample(shape, grid);
  const auto mesh = hasp::ContourTetrahedra({ field.data(), grid });
  auto volumes = hasp::FindPieces(mesh).volume;
  std::sort(volumes.begin(), volumes.end());
  ASSERT_EQ(volumes.size(), 3U);
  EXPECT_NEAR(volumes[0], -4.19, 0.2); // the hollow's wall faces inward
  EXPECT_NEAR(volumes[1], 2.14, 0.2);
  const auto clean = hasp::WithoutSmallPieces(mesh, 10);
  const auto facts = hasp::FactsOf(clean);
  EXPECT_TRUE(facts.closed && facts.manifold && facts.noArea == 0);
  EXPECT_EQ(facts.euler, 2);
  EXPECT_NEAR(facts.volume, 904.8, 4);
}

TEST(TetrahedraContour, CancellingThrows)
{
  const auto grid = Cube(9, 8);
  const std::vector<float> inside(grid.Size(), -1.0F);
  EXPECT_THROW(hasp::ContourTetrahedra({ inside.data(), grid }, [](double) { return false; }),
    hasp::Cancelled);
}

} // namespace
