#include "Evaluation/TriangleTree.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <limits>
#include <random>

namespace
{

/// From a segment, by its closed form.
double FromSegment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p)
{
  const double length = glm::dot(b - a, b - a);
  const double t = length > 0 ? std::clamp(glm::dot(p - a, b - a) / length, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * (b - a));
}

/// Every triangle, one after the other: its plane where that is met within, else its sides.
double NearestOfAll(const hasp::TriangleMesh& mesh, const glm::dvec3& p)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    if (length > 0 && glm::dot(glm::cross(b - a, p - a), n) >= 0 &&
        glm::dot(glm::cross(c - b, p - b), n) >= 0 && glm::dot(glm::cross(a - c, p - c), n) >= 0)
      nearest = std::min(nearest, std::abs(glm::dot(p - a, n)) / length);
    nearest =
      std::min({ nearest, FromSegment(a, b, p), FromSegment(b, c, p), FromSegment(c, a, p) });
  }
  return nearest;
}

struct Places
{
  std::mt19937 random{ 11 };
  std::uniform_real_distribution<double> any{ -15, 15 };
  glm::dvec3 operator()() { return { any(random), any(random), any(random) }; }
};

TEST(NearestTriangle, BadPlacesAndEmptyMeshesHaveNone)
{
  const hasp::TriangleTree tree(parttest::Ball(10, 6));
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(tree.Nearest({ none, 0, 0 }));
  EXPECT_FALSE(tree.Nearest({ std::numeric_limits<double>::infinity(), 0, 0 }));
  EXPECT_FALSE(tree.Nearest({ 0, 0, 0 }, 0.0));
  EXPECT_FALSE(tree.Nearest({ 0, 0, 0 }, none));
  EXPECT_FALSE(hasp::TriangleTree({}).Nearest({ 0, 0, 0 }));
}

TEST(NearestTriangle, IsTheNearestOfAll)
{
  const parttest::Motion motion = parttest::AnyMotion(2);
  const hasp::TriangleMesh ball = motion(parttest::Ball(10, 14));
  const hasp::TriangleTree tree(ball);
  Places places;
  for (int n = 0; n < 1500; ++n)
  {
    const glm::dvec3 p = motion.Place(places());
    const double expected = NearestOfAll(ball, p);
    const auto near = tree.Nearest(p);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->distanceMm, expected, 1e-11);
    EXPECT_NEAR(glm::distance(near->point, p), expected, 1e-11);
    hasp::TriangleMesh one = ball;
    one.triangles = { ball.triangles[near->triangle] };
    EXPECT_LT(NearestOfAll(one, near->point), 1e-11); // it lies where it is said to lie
    EXPECT_GT(glm::dot(near->normal, near->point - motion.to), 0.0);
    EXPECT_EQ(tree.Nearest(p, expected + 1e-9).has_value(), true);
    EXPECT_EQ(tree.Nearest(p, expected - 1e-9).has_value(), false);
  }
}

TEST(NearestTriangle, NeedlesLinesAndPointsAreNearAsWhatTheyAre)
{
  Places places;
  for (const double height : { 0.0, 1e-13, 1e-10, 1e-7, 1e-5, 1e-4, 1e-3 })
    for (int n = 0; n < 300; ++n)
    {
      hasp::TriangleMesh mesh; // 10 mm long, so high, anyhow; the third point beyond an end, too
      const glm::dvec3 a = places(), u = glm::normalize(places()),
                       v = glm::normalize(glm::cross(u, places()));
      mesh.points = { a, a + 10.0 * u, a + places().x * u + 10.0 * height * v, a };
      mesh.triangles = { { 0, 1, 2 } };
      if (n % 10 == 0)
        mesh.triangles = { { 0, 0, 3 } };
      const glm::dvec3 p = places();
      EXPECT_NEAR(hasp::TriangleTree(mesh).Nearest(p)->distanceMm, NearestOfAll(mesh, p), 5e-6)
        << height;
    }
  const hasp::TriangleMesh point{ { { 1, 2, 3 } }, { { 0, 0, 0 } } };
  const auto near = hasp::TriangleTree(point).Nearest({ 1, 2, 7 });
  EXPECT_EQ(near->distanceMm, 4.0);
  EXPECT_EQ(near->normal, glm::dvec3(0.0));
}

TEST(NearestTriangle, ManyAskedForArePrinted)
{
  const hasp::TriangleMesh ball = parttest::Ball(50, 160); // 102,000 triangles of 1 mm
  const hasp::TriangleTree tree(ball);
  Places places;
  std::vector<glm::dvec3> near, inside;
  for (int n = 0; n < 20'000; ++n)
  {
    const glm::dvec3 p = places();
    near.push_back((50.0 + 0.1 * p.x) * glm::normalize(p));
    inside.push_back(p);
  }
  const auto time = [&](const std::vector<glm::dvec3>& asked, double reach)
  {
    const auto start = std::chrono::steady_clock::now();
    double sum = 0;
    for (const glm::dvec3& p : asked)
      if (const auto found = tree.Nearest(p, reach))
        sum += found->distanceMm;
    EXPECT_GT(sum, 0.0);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    return 1e-6 * double(asked.size()) / spent.count();
  };
  std::printf("million queries a second on one core: %.2f within 1.5 mm, %.2f with reach 2 mm\n",
    time(near, 1e9), time(near, 2.0));
}

} // namespace
