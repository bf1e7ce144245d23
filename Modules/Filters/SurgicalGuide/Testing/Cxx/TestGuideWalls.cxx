// What of a solid is thick enough, against closed forms.
#include "Distance/Csg.h"
#include "Distance/SolidShapes.h"
#include "GuideWalls.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

const hasp::GridGeometry Grid{ { 61, 61, 61 }, glm::dvec3(-12), glm::dvec3(0.4), glm::dmat3(1) };
constexpr double Ball = 0.6, Kept = 0.27;

hasp::SolidPointer BoxOf(const glm::dvec3& center, const glm::dvec3& half)
{
  return hasp::MakeBox(center, glm::dmat3(1), half);
}

TEST(GuideWalls, AFinThinnerThanTheBallIsGoneAndItsWallStays)
{
  // A plate of 3 mm with two fins on it, 1.1 and 2 mm thick.
  const auto part = hasp::MakeUnion({ BoxOf({ 0, 0, 0 }, { 8, 8, 1.5 }),
    BoxOf({ -4, 0, 3 }, { 0.55, 8, 3 }), BoxOf({ 4, 0, 3 }, { 1.0, 8, 3 }) });
  const auto thick = hasp::ThickParts(part, Grid, Ball, 0.0, {});
  ASSERT_TRUE(thick);
  for (double z = 1.8; z < 6.0; z += 0.1)
    EXPECT_GT(thick->At({ -4, 0, z }), 0.0) << z;
  for (double z = 1.8; z < 5.9; z += 0.1)
    EXPECT_LT(thick->At({ 4, 0, z }), 0.0) << z;
  EXPECT_LT(thick->At({ -4, 0, 1.4 }), 0.0);
  EXPECT_NEAR(thick->At({ 0, 0, 1.4 }), part->At({ 0, 0, 1.4 }), 1e-12); // its own surface
  EXPECT_GT(thick->At({ 0, 0, 1.6 }), 0.0);
}

TEST(GuideWalls, SquareEdgesStaySharpWhereThatIsAsked)
{
  const auto part = BoxOf({ 0, 0, 0 }, { 6, 5, 2 });
  const glm::dvec3 edge = { 5.97, 4.97, 0 };
  EXPECT_LT(hasp::ThickParts(part, Grid, Ball, Kept, {})->At(edge), 0.0);
  EXPECT_GT(hasp::ThickParts(part, Grid, Ball, 0.0, {})->At(edge), 0.05);
  // Round: 0.6 mm about (5.4, 4.4)
  const auto round = hasp::ThickParts(part, Grid, Ball, 0.0, {});
  for (double a = 0.1; a < 1.5; a += 0.1)
  {
    const glm::dvec3 out(std::cos(a), std::sin(a), 0);
    EXPECT_LT(round->At(glm::dvec3(5.4, 4.4, 0) + 0.5 * out), 0.0);
    EXPECT_GT(round->At(glm::dvec3(5.4, 4.4, 0) + 0.7 * out), 0.0);
  }
}

TEST(GuideWalls, AWedgeEndsBeforeItIsThin)
{
  // 20 degrees between its planes, its edge along y at x = 0. The last ball is 0.6 / sin 10 off.
  const double half = 3.14159265358979 / 18;
  const auto wedge =
    hasp::MakeIntersection({ hasp::MakePlane({}, { -std::sin(half), 0, std::cos(half) }),
      hasp::MakePlane({}, { -std::sin(half), 0, -std::cos(half) }),
      BoxOf({ 5, 0, 0 }, { 6, 6, 6 }) });
  const auto thick = hasp::ThickParts(wedge, Grid, Ball, Kept, {});
  const double end = Ball / std::sin(half) - Ball - Kept;
  EXPECT_GT(2 * end * std::tan(half), 0.6);
  EXPECT_GT(thick->At({ end - 0.45, 0, 0 }), 0.0);
  EXPECT_LT(thick->At({ end + 0.15, 0, 0 }), 0.0);
}

TEST(GuideWalls, NothingThickIsNothing)
{
  EXPECT_FALSE(hasp::ThickParts(BoxOf({}, { 8, 8, 0.5 }), Grid, Ball, Kept, {}));
  EXPECT_THROW(
    hasp::ThickParts(BoxOf({}, { 8, 8, 2 }), Grid, Ball, Kept, [](double) { return false; }),
    hasp::Cancelled);
}

} // namespace
