#include "Distance/ImplicitShapes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <vector>

namespace
{

const glm::dvec3 Axis = glm::normalize(glm::dvec3(1, 2, -2));

std::vector<glm::dvec3> RandomPoints(int count, double spread)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-spread, spread);
  std::vector<glm::dvec3> points;
  for (int n = 0; n < count; ++n)
    points.emplace_back(any(random), any(random), any(random));
  return points;
}

TEST(ImplicitShapes, AgreeWithClosedFormsAtChosenPoints)
{
  EXPECT_DOUBLE_EQ(hasp::PlaneSide({ 0, 0, 3 }, { 5, 5, 1 }, { 0, 0, 1 }), 2);
  EXPECT_DOUBLE_EQ(hasp::SlabDistance({ 4, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, 2), 2);
  EXPECT_DOUBLE_EQ(hasp::SlabDistance({ 1, 7, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, 2), -1);
  EXPECT_DOUBLE_EQ(hasp::CylinderDistance({ 3, 4, 99 }, { 0, 0, 0 }, { 0, 0, 1 }, 2), 3);
  EXPECT_DOUBLE_EQ(hasp::CapsuleDistance({ -3, 4, 0 }, { 0, 0, 0 }, { 9, 0, 0 }, 1), 4);
  EXPECT_DOUBLE_EQ(hasp::CapsuleDistance({ 0, 0, 2 }, { 0, 0, 0 }, { 0, 0, 0 }, 1), 1);
  const glm::dvec3 half(1, 2, 3);
  EXPECT_DOUBLE_EQ(hasp::BoxDistance({ 4, 6, 0 }, {}, glm::dmat3(1), half), 5);
  EXPECT_DOUBLE_EQ(hasp::BoxDistance({ 0.5, 0, 0 }, {}, glm::dmat3(1), half), -0.5);
}

TEST(ImplicitShapes, AreDistances)
{
  // An exact distance changes by exactly the way walked along its gradient.
  const glm::dmat3 turned(glm::rotate(glm::dmat4(1), 0.8, Axis));
  const std::vector<glm::dvec3> line{ { -4, 0, 1 }, { 2, 3, 0 }, { 5, -2, -3 } };
  const std::function<double(const glm::dvec3&)> shapes[] = {
    [](const glm::dvec3& x) {
      return hasp::CylinderDistance(x, { 1, 0, 0 }, Axis, 2);
    },
    [](const glm::dvec3& x) {
      return hasp::CapsuleDistance(x, { 1, 0, 0 }, { 3, 3, 1 }, 2);
    },
    [&](const glm::dvec3& x) { return hasp::TubeDistance(x, line, true, 1.5); },
    [&](const glm::dvec3& x) {
      return hasp::BoxDistance(x, { 1, 1, 0 }, turned, { 2, 3, 1 });
    },
  };
  for (const auto& shape : shapes)
    for (const glm::dvec3& p : RandomPoints(200, 9))
    {
      const double d = shape(p), h = 1e-5;
      if (d < 0.1)
        continue; // inside, ridges bend the gradient
      glm::dvec3 g;
      for (int a = 0; a < 3; ++a)
      {
        glm::dvec3 e(0);
        e[a] = h;
        g[a] = (shape(p + e) - shape(p - e)) / (2 * h);
      }
      // On a ridge between two parts the gradient is no unit vector: the points avoid those.
      EXPECT_NEAR(shape(p - d * g), 0.0, 1e-3);
    }
}

TEST(ImplicitShapes, TubesOpenAndClosed)
{
  const std::vector<glm::dvec3> line{ { 0, 0, 0 }, { 10, 0, 0 }, { 10, 10, 0 } };
  EXPECT_NEAR(hasp::TubeDistance({ 5, 5, 0 }, line, false, 1), 4, 1e-12);
  EXPECT_NEAR(hasp::TubeDistance({ 5, 5, 0 }, line, true, 1), -1, 1e-12);
  EXPECT_EQ(hasp::TubeDistance({ 0, 0, 0 }, {}, true, 1), std::numeric_limits<double>::infinity());
}

TEST(ImplicitShapes, PolygonsKnowTheirInsideFromBruteForce)
{
  // An L: inside is known without a polygon.
  const std::vector<glm::dvec2> corners{ { 0, 0 }, { 6, 0 }, { 6, 2 }, { 2, 2 }, { 2, 5 },
    { 0, 5 } };
  const auto inside = [](const glm::dvec2& p)
  { return p.x > 0 && p.y > 0 && ((p.x < 6 && p.y < 2) || (p.x < 2 && p.y < 5)); };
  for (const glm::dvec3& p3 : RandomPoints(500, 8))
  {
    const glm::dvec2 p(p3);
    double least = 1e9;
    for (std::size_t n = 0; n < corners.size(); ++n)
      for (int s = 0; s <= 1000; ++s)
        least = std::min(least,
          glm::length(p - glm::mix(corners[n], corners[(n + 1) % corners.size()], s / 1000.0)));
    // Steps of at most 0.006 mm along the sides: 0.003^2 / (2 d) too far, 0.003 at worst.
    EXPECT_NEAR(hasp::PolygonDistance(p, corners), inside(p) ? -least : least, 0.003);
  }
}

} // namespace
