#include "Distance/DividedTetrahedron.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// A corner of a cube, cut at `first` and `last` of the sides from the first corner.
hasp::CrossedTriangle Crossed(double first, double last)
{
  hasp::CrossedTriangle t;
  t.lone = { 0, 0, 0 }, t.ends[0] = { 1, 0, 0 }, t.ends[1] = { 0, 1, 0 };
  t.crossing[0] = { first, 0, 0 }, t.crossing[1] = { 0, last, 0 };
  t.inside = true;
  return t;
}

/// Twice the area of the parts, by their direction along z.
glm::dvec2 Areas(const hasp::CrossedTriangle& t, bool turned)
{
  hasp::Shell parts;
  hasp::Divide(t, turned, parts);
  glm::dvec2 area(0.0);
  for (const auto& part : parts)
    area[part.inside] += glm::cross(part.at[1] - part.at[0], part.at[2] - part.at[0]).z;
  return area;
}

TEST(DividedTetrahedron, PartsOfATriangleCoverItOnceOnBothSidesOfTheLine)
{
  auto t = Crossed(0.5, 0.25);
  EXPECT_GT(hasp::ChooseDiagonal(t), 0.0);
  EXPECT_DOUBLE_EQ(Areas(t, false)[1], 0.125);
  EXPECT_DOUBLE_EQ(Areas(t, false)[0], 0.875);
  EXPECT_DOUBLE_EQ(Areas(t, true)[1], -0.125);
  t.bends = 1, t.bend[0] = { 0.5, 0.25, 0 }; // a rectangle, and the rest
  EXPECT_GT(hasp::ChooseDiagonal(t), 0.0);
  EXPECT_DOUBLE_EQ(Areas(t, false)[1], 0.25);
  EXPECT_DOUBLE_EQ(Areas(t, false)[0], 0.75);
  t.bends = 2, t.bend[1] = { 0.125, 0.375, 0 };
  EXPECT_GT(hasp::ChooseDiagonal(t), 0.0);
  EXPECT_DOUBLE_EQ(Areas(t, false)[0] + Areas(t, false)[1], 1.0);
  t.inside = false;
  EXPECT_DOUBLE_EQ(Areas(t, false)[1], 1.0 - 0.3125);
}

TEST(DividedTetrahedron, TheBetterDiagonalIsChosen)
{
  // The crossing that is further out is joined to the other end: the parts are as high as it is
  // away from its own, and not as the square of that.
  auto t = Crossed(0.99, 0.01);
  const double far = hasp::ChooseDiagonal(t);
  EXPECT_TRUE(t.diagonal);
  EXPECT_NEAR(far, 0.01 / std::sqrt(2.0), 1e-4); // of the corner (1, 0, 0)
  auto other = Crossed(0.01, 0.99);
  EXPECT_DOUBLE_EQ(hasp::ChooseDiagonal(other), far);
  EXPECT_FALSE(other.diagonal);
}

TEST(DividedTetrahedron, LinesThatMeetThemselvesOrLeaveAreSeen)
{
  auto t = Crossed(0.5, 0.5);
  t.bends = 1;
  for (const glm::dvec3& out : { glm::dvec3(0.7, 0.7, 0), glm::dvec3(-0.1, 0.4, 0) })
  {
    t.bend[0] = out;
    EXPECT_LT(hasp::ChooseDiagonal(t), 0.0);
  }
  t.bends = 2; // crossed: in the other order they are not
  t.bend[0] = { 0.1, 0.5, 0 }, t.bend[1] = { 0.5, 0.1, 0 };
  EXPECT_LT(hasp::ChooseDiagonal(t), 0.0);
  std::swap(t.bend[0], t.bend[1]);
  EXPECT_GT(hasp::ChooseDiagonal(t), 0.0);
}

/// A unit corner, of which a surface cuts off the part near 0.
hasp::Shell Corner()
{
  hasp::Shell shell;
  const glm::dvec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (int a = 0; a < 3; ++a)
  {
    hasp::CrossedTriangle t;
    t.ends[0] = axis[(a + 1) % 3], t.ends[1] = axis[a]; // seen from outside
    t.crossing[0] = 0.5 * t.ends[0], t.crossing[1] = 0.5 * t.ends[1];
    t.inside = true;
    hasp::ChooseDiagonal(t);
    hasp::Divide(t, false, shell);
  }
  shell.push_back({ { axis[0], axis[1], axis[2] }, false });
  return shell;
}

TEST(DividedTetrahedron, HeightsAreLeastAtTheNearestSideAndNegativeBeyond)
{
  const auto shell = Corner();
  EXPECT_EQ(shell.size(), 10U);
  EXPECT_NEAR(hasp::LeastHeight({ 0.25, 0.25, 1e-3 }, shell), 1e-3, 1e-8); // over the largest side
  EXPECT_LT(hasp::LeastHeight({ 0.25, 0.25, -1e-3 }, shell), 0.0);
  EXPECT_LT(hasp::LeastHeight({ 0.34, 0.34, 0.34 }, shell), 0.0);
  EXPECT_GT(hasp::LeastHeight({ 0.32, 0.32, 0.32 }, shell), 0.0);
}

TEST(DividedTetrahedron, ASurfaceThatIsTurnedOverIsSeen)
{
  const auto shell = Corner();
  const glm::dvec3 a(0.5, 0, 0), b(0, 0.5, 0), c(0, 0, 0.5);
  const std::array<glm::dvec3, 3> out{ a, b, c }, in{ a, c, b };
  EXPECT_GT(hasp::LeastHeight(shell, { &out, 1 }), 0.05);
  EXPECT_LT(hasp::LeastHeight(shell, { &in, 1 }), 0.0);
}

} // namespace
