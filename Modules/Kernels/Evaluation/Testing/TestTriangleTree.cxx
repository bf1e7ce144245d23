#include "Evaluation/MeshSamples.h"
#include "Evaluation/TriangleTree.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <random>

namespace
{

/// Every triangle, one after the other, by planes and sides of edges.
std::optional<double> FirstOfAll(
  const hasp::TriangleMesh& mesh, const glm::dvec3& origin, const glm::dvec3& direction)
{
  std::optional<double> first;
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double s = glm::dot(a - origin, n) / glm::dot(direction, n);
    const glm::dvec3 p = origin + s * direction;
    if (s > 0 && glm::dot(glm::cross(b - a, p - a), n) >= 0 &&
        glm::dot(glm::cross(c - b, p - b), n) >= 0 && glm::dot(glm::cross(a - c, p - c), n) >= 0)
      first = std::min(first.value_or(s), s);
  }
  return first;
}

TEST(TriangleTree, MeetsWhatAllTrianglesMeet)
{
  const hasp::TriangleMesh ball = parttest::AnyMotion(2)(parttest::Ball(10, 20));
  const hasp::TriangleTree tree(ball);
  const glm::dvec3 center = parttest::AnyMotion(2).to;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-15, 15);
  int met = 0;
  for (int n = 0; n < 2000; ++n)
  {
    const glm::dvec3 from = center + glm::dvec3(any(random), any(random), any(random));
    const glm::dvec3 direction(any(random), any(random), any(random));
    const auto expected = FirstOfAll(ball, from, direction);
    const auto hit = tree.First(from, direction);
    ASSERT_EQ(hit.has_value(), expected.has_value()) << n;
    if (!hit)
      continue;
    ++met;
    EXPECT_NEAR(hit->t, *expected, 1e-9);
    // Nothing of the ball is nearer than its flat triangles' middles, nor outside the sphere.
    const double r = glm::distance(from, center);
    if (r < 9.8 || r > 10.0)
    {
      EXPECT_EQ(tree.Inside(from, direction), r < 9.8);
    }
  }
  EXPECT_GT(met, 500);
}

TEST(TriangleTree, NoRayThroughAnEdgeSlips)
{
  const hasp::TriangleMesh box =
    parttest::Blocks({ 0, 1, 2 }, { 0, 1, 2 }, { 0, 1, 2 }, [](int, int, int) { return true; });
  const hasp::TriangleTree tree(box);
  for (const double x : { 0.25, 0.5, 1.0, 1.5 }) // along diagonals, edges and through points
    for (const double y : { 0.25, 0.5, 1.0, 1.5 })
    {
      const auto hit = tree.First({ x, y, -3 }, { 0, 0, 2 });
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->t, 1.5, 1e-12);
      EXPECT_EQ(hit->normal, glm::dvec3(0, 0, -1));
      EXPECT_NEAR(tree.First({ x, y, -3 }, { 0, 0, 2 }, 1.6)->t, 2.5, 1e-12);
      EXPECT_FALSE(tree.First({ x, y, -3 }, { 0, 0, 2 }, 0.0, 1.4));
    }
  EXPECT_LT(glm::length(tree.Low()), 1e-8);
  EXPECT_NEAR(tree.Reach({ 0, 1, 0 }), 1.0, 1e-8);
}

TEST(TriangleTree, BadMeshesAreRefusedAndEmptyOnesMeetNothing)
{
  EXPECT_THROW(hasp::TriangleTree({ { { 0, 0, 0 } }, { { 0, 0, 1 } } }), std::invalid_argument);
  EXPECT_FALSE(hasp::TriangleTree({}).First({}, { 1, 0, 0 }));
}

TEST(MeshSamples, NeedlesWithoutEndAreRefusedBeforeMemoryIs)
{
  hasp::TriangleMesh mesh; // 5 km long, a hundredth of a millimetre high
  mesh.points = { { 0, 0, 0 }, { 5e6, 0, 0 }, { 2.5e6, 0.01, 0 } };
  mesh.triangles = { { 0, 1, 2 } };
  EXPECT_THROW(hasp::SampleMesh(mesh, 0.5), std::runtime_error);
}

TEST(MeshSamples, CoverTheAreaAsCloselyAsAsked)
{
  const hasp::TriangleMesh box = parttest::AnyMotion(1)(
    parttest::Blocks({ 0, 30 }, { 0, 20 }, { 0, 2 }, [](int, int, int) { return true; }));
  const auto samples = hasp::SampleMesh(box, 0.5);
  double area = 0;
  for (const hasp::MeshSample& sample : samples)
  {
    area += sample.areaMm2;
    EXPECT_LE(sample.areaMm2, 0.5 * 0.25);
  }
  EXPECT_NEAR(area, 2 * (600 + 60 + 40), 1e-9);
  hasp::TriangleMesh sliver = box; // no direction of its own: left out
  sliver.points.push_back(box.points[0] + 0.0005 * glm::normalize(box.points[1] - box.points[0]));
  sliver.triangles = { { 0, 1, unsigned(box.points.size()) } };
  EXPECT_TRUE(hasp::SampleMesh(sliver, 0.5).empty());
  EXPECT_THROW(hasp::SampleMesh(box, 0.0), std::invalid_argument);
}

} // namespace
