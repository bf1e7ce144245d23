// A drag becomes pieces: on surfaces that are functions of the pixel.
#include "BrushTrail.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace
{

using namespace hasp;

constexpr double PixelMm = 0.1;

/// A plane across the view, and nothing beyond x = 100.
std::optional<PixelPlace> Plane(const glm::ivec2& pixel)
{
  if (pixel.x >= 100)
    return std::nullopt;
  return PixelPlace{ PixelMm * glm::dvec3(pixel, 0), PixelMm };
}

/// Two planes, one `stepMm` behind the other from x = 50 on.
BrushTrail::Finder Step(double stepMm)
{
  return [stepMm](const glm::ivec2& pixel)
  {
    return PixelPlace{ glm::dvec3(PixelMm * glm::dvec2(pixel), pixel.x < 50 ? 0.0 : -stepMm),
      PixelMm };
  };
}

double LargestStep(const BrushStroke& stroke)
{
  double most = 0.0;
  for (std::size_t n = 1; n < stroke.points.size(); ++n)
    most = std::max(most, glm::length(stroke.points[n] - stroke.points[n - 1]));
  return most;
}

TEST(BrushTrail, AClickIsOnePoint)
{
  BrushTrail trail;
  trail.Begin();
  trail.SetBrush(3, 2.0);
  EXPECT_TRUE(trail.MoveTo({ 10, 20 }, Plane));
  EXPECT_FALSE(trail.End());
  ASSERT_EQ(trail.Pieces().size(), 1u);
  EXPECT_EQ(trail.Pieces()[0], (BrushStroke{ 3, 2.0, { PixelMm * glm::dvec3(10, 20, 0) } }));
}

TEST(BrushTrail, WhereNothingIsSeenThereIsNoPiece)
{
  BrushTrail trail;
  trail.Begin();
  EXPECT_FALSE(trail.MoveTo({ 150, 20 }, Plane));
  EXPECT_FALSE(trail.MoveTo({ 120, 20 }, Plane));
  EXPECT_FALSE(trail.End());
  EXPECT_TRUE(trail.Pieces().empty());
}

// One event a long way off is as good as one a pixel.
TEST(BrushTrail, AFastDragHasNoHolesAndEndsWhereThePointerDoes)
{
  BrushTrail trail;
  trail.Begin();
  trail.SetBrush(2, 2.0); // a point each 0.5 mm: 5 pixels
  trail.MoveTo({ 3, 7 }, Plane);
  EXPECT_TRUE(trail.MoveTo({ 91, 33 }, Plane));
  trail.End();
  ASSERT_EQ(trail.Pieces().size(), 1u);
  const BrushStroke& stroke = trail.Pieces()[0];
  EXPECT_LE(LargestStep(stroke), 0.5 + std::sqrt(2.0) * PixelMm); // and what a pixel adds
  EXPECT_EQ(stroke.points.back(), PixelMm * glm::dvec3(91, 33, 0));
  for (const glm::dvec3& point : stroke.points) // within half a pixel of the straight line
    EXPECT_LE(
      std::abs(point.y / PixelMm - (7 + 26.0 / 88.0 * (point.x / PixelMm - 3))), 0.5 + 1e-9);
}

TEST(BrushTrail, EachDragIsAskedPixelByPixelAndNoneTwice)
{
  BrushTrail trail;
  trail.Begin();
  std::vector<glm::ivec2> asked;
  const auto note = [&](const glm::ivec2& pixel)
  {
    asked.push_back(pixel);
    return Plane(pixel);
  };
  for (const glm::ivec2& to : { glm::ivec2(5, 5), glm::ivec2(5, 9), glm::ivec2(1, 2) })
    trail.MoveTo(to, note);
  ASSERT_EQ(asked.size(), 1u + 4u + 7u);
  for (std::size_t n = 1; n < asked.size(); ++n)
  {
    const glm::ivec2 step = glm::abs(asked[n] - asked[n - 1]);
    EXPECT_EQ(std::max(step.x, step.y), 1);
  }
}

TEST(BrushTrail, AJumpBeyondTheRadiusBeginsANewPiece)
{
  for (const double step : { 1.9, 2.1 })
  {
    BrushTrail trail;
    trail.Begin();
    trail.SetBrush(2, 2.0);
    trail.MoveTo({ 0, 0 }, Step(step));
    trail.MoveTo({ 99, 0 }, Step(step));
    trail.End();
    ASSERT_EQ(trail.Pieces().size(), step < 2.0 ? 1u : 2u);
    if (step < 2.0)
      continue;
    // Each piece ends at the edge itself, on its own side.
    EXPECT_EQ(trail.Pieces()[0].points.back(), glm::dvec3(4.9, 0, 0));
    EXPECT_LT(glm::length(trail.Pieces()[1].points.front() - glm::dvec3(5.0, 0, -step)), 1e-12);
  }
}

TEST(BrushTrail, PixelsLargerThanTheBrushAreNoJumps)
{
  BrushTrail trail;
  trail.Begin();
  trail.SetBrush(2, 0.05); // half a pixel
  trail.MoveTo({ 0, 0 }, Step(0.0));
  trail.MoveTo({ 99, 0 }, Step(0.0));
  trail.End();
  ASSERT_EQ(trail.Pieces().size(), 1u);
  EXPECT_EQ(trail.Pieces()[0].points.size(), 100u);
}

TEST(BrushTrail, TheBackgroundPartsADrag)
{
  BrushTrail trail;
  trail.Begin();
  trail.SetBrush(2, 2.0);
  trail.MoveTo({ 98, 0 }, Plane);
  trail.MoveTo({ 120, 0 }, Plane);
  trail.MoveTo({ 90, 10 }, Plane);
  trail.End();
  ASSERT_EQ(trail.Pieces().size(), 2u);
  EXPECT_EQ(trail.Pieces()[0].points.back(), PixelMm * glm::dvec3(99, 0, 0));
  EXPECT_EQ(trail.Pieces()[1].points.front().x, PixelMm * 99);
}

TEST(BrushTrail, AnotherBrushGoesOnWhereTheLastOneEnded)
{
  BrushTrail trail;
  trail.Begin();
  trail.SetBrush(2, 2.0);
  trail.MoveTo({ 0, 0 }, Plane);
  trail.MoveTo({ 33, 0 }, Plane);
  trail.SetBrush(2, 3.0);
  trail.SetBrush(2, 3.0);
  trail.MoveTo({ 66, 0 }, Plane);
  trail.End();
  ASSERT_EQ(trail.Pieces().size(), 2u);
  EXPECT_EQ(trail.Pieces()[0].radiusMm, 2.0);
  EXPECT_EQ(trail.Pieces()[1].radiusMm, 3.0);
  EXPECT_EQ(trail.Pieces()[0].points.back(), trail.Pieces()[1].points.front());
  EXPECT_EQ(trail.Pieces()[0].points.back().x, PixelMm * 33);
}

TEST(BrushTrail, ABreakJoinsNothing)
{
  BrushTrail trail;
  trail.Begin();
  trail.SetBrush(2, 2.0);
  trail.MoveTo({ 10, 0 }, Plane);
  trail.MoveTo({ 12, 0 }, Plane); // less than a point's distance
  trail.Break();
  trail.MoveTo({ 14, 0 }, Plane);
  trail.End();
  ASSERT_EQ(trail.Pieces().size(), 2u);
  EXPECT_EQ(trail.Pieces()[0].points.size(), 2u);
  EXPECT_EQ(trail.Pieces()[1].points.size(), 1u);
  EXPECT_EQ(trail.Points(), 3u);
}

TEST(BrushTrail, NoPieceHasMorePointsThanAStrokeMay)
{
  BrushTrail trail;
  trail.Begin();
  trail.SetBrush(2, PixelMm);
  trail.MoveTo({ 0, 0 }, Plane);
  for (int n = 0; n < 2200; ++n) // to and fro: 99 points each way
    trail.MoveTo({ n % 2 == 0 ? 99 : 0, 0 }, Plane);
  trail.End();
  EXPECT_EQ(trail.Pieces().size(), 3u);
  for (const BrushStroke& stroke : trail.Pieces())
    EXPECT_LE(stroke.points.size(), BrushTrail::MostPoints);
  EXPECT_EQ(trail.Pieces()[0].points.back(), trail.Pieces()[1].points.front());
}

} // namespace
