#include "Grid/AnalyticShapes.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

namespace
{

using glm::dvec2;
using glm::dvec3;

class Points
{
public:
  explicit Points(double reach) : any(-reach, reach) {}
  dvec3 operator()() { return { any(random), any(random), any(random) }; }
  double One() { return any(random); }

private:
  std::mt19937 random{ 17 };
  std::uniform_real_distribution<double> any;
};

/// Distances by a membership that knows nothing of distances: no change of side within the ball
/// that the distance claims to be free, and both sides next to the nearest point.
void ExpectTrueDistances(const hasp::AnalyticShape& shape,
  const std::function<bool(const dvec3&)>& inside, double reach, int points)
{
  Points any(reach), unit(1.0);
  for (int n = 0; n < points; ++n)
  {
    const dvec3 p = any();
    const hasp::Foot foot = hasp::FootOn(shape, p);
    ASSERT_NEAR(glm::length(foot.outward), 1.0, 1e-12);
    ASSERT_EQ(inside(p), foot.mm < 0.0) << foot.mm;
    const dvec3 nearest = p - foot.mm * foot.outward;
    ASSERT_LT(std::abs(hasp::FootOn(shape, nearest).mm), 1e-9);
    int inner = 0, tries = 0; // few at a sharp corner
    while (tries < 10000 && (inner == 0 || inner == tries))
      inner += inside(nearest + 1e-6 * unit()), ++tries;
    ASSERT_TRUE(inner > 0 && inner < tries);
    for (int k = 0; k < 60; ++k)
    {
      const dvec3 d = unit();
      const double within = std::abs(foot.mm) * (k % 3 == 0 ? std::abs(unit.One()) : 0.999);
      ASSERT_EQ(inside(p + within * glm::normalize(d)), inside(p));
    }
    const dvec3 q = p + 0.3 * unit();
    ASSERT_LE(std::abs(hasp::FootOn(shape, q).mm - foot.mm), glm::length(p - q) + 1e-11);
  }
}

TEST(AnalyticShapes, BadPolygonsAreRefused)
{
  const std::vector<dvec3> low{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const std::vector<dvec3> high{ { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 } };
  EXPECT_THROW(hasp::Frustum({ low[0], low[1] }, { high[0], high[1] }, 1.0), std::invalid_argument);
  EXPECT_THROW(hasp::Frustum(low, { high[0], high[1] }, 1.0), std::invalid_argument);
  EXPECT_THROW(hasp::Frustum(low, low, 1.0), std::invalid_argument);
}

TEST(AnalyticShapes, EllipsoidsAreTrueInAndOutAlsoFlatAndLong)
{
  for (const dvec3& radii : { dvec3(3, 5, 4), dvec3(7, 0.5, 6), dvec3(1, 1, 8), dvec3(4, 4, 4) })
  {
    const dvec3 center(0.3, -0.2, 0.1);
    ExpectTrueDistances(
      hasp::EllipsoidShape{ center, radii },
      [&](const dvec3& p)
      {
        const dvec3 q = (p - center) / radii;
        return q.x * q.x + q.y * q.y + q.z * q.z < 1.0;
      },
      9.0, 3000);
  }
}

TEST(AnalyticShapes, EllipsoidsHoldOnTheirPlanesOfSymmetryAndFarAway)
{
  const hasp::EllipsoidShape e{ {}, { 3, 5, 4 } };
  EXPECT_NEAR(hasp::FootOn(e, { 0, 0, 0 }).mm, -3.0, 1e-12);
  EXPECT_NEAR(hasp::FootOn(e, { 0, 5, 0 }).mm, 0.0, 1e-12);
  EXPECT_NEAR(hasp::FootOn(e, { 0, 0, 9 }).mm, 5.0, 1e-12);
  EXPECT_NEAR(hasp::FootOn(e, { -1e6, 0, 0 }).mm, 1e6 - 3.0, 1e-9);
  // On the long axis the nearest point is off the axis: x = 0, y = 25 y0 / (25 - 9) at first.
  const double y0 = 1.0, y = 25.0 * y0 / 16.0, x = 3.0 * std::sqrt(1.0 - y * y / 25.0);
  EXPECT_NEAR(hasp::FootOn(e, { 0, y0, 0 }).mm, -std::hypot(x, y - y0), 1e-12);
}

TEST(AnalyticShapes, RoundConesAreHullsOfTwoBalls)
{
  for (const dvec2& radii : { dvec2(2, 2), dvec2(2.5, 0.7), dvec2(0.4, 3), dvec2(5, 1) })
  {
    const dvec3 a(-1, 0.5, 0), b(2, -1, 1.5);
    ExpectTrueDistances(
      hasp::RoundConeShape{ a, b, radii.x, radii.y },
      [&](const dvec3& p)
      {
        // Some ball between the two holds p. |p - c(t)| - r(t) is convex in t: golden section.
        const auto above = [&](double t)
        { return glm::length(p - a - t * (b - a)) - (radii.x + t * (radii.y - radii.x)); };
        double low = 0.0, high = 1.0;
        for (int n = 0; n < 60; ++n)
        {
          const double left = low + 0.381966 * (high - low), right = high - 0.381966 * (high - low);
          (above(left) < above(right) ? high : low) = above(left) < above(right) ? right : left;
        }
        return std::min({ above(0.0), above(1.0), above(0.5 * (low + high)) }) < 0.0;
      },
      6.0, 500);
  }
}

TEST(AnalyticShapes, BarsAndHalfSpacesAreTrue)
{
  const dvec3 along = glm::normalize(dvec3(1, 2, 0.5));
  const dvec3 across = glm::normalize(glm::cross(along, dvec3(0, 0, 1)));
  const hasp::BarShape bar{ { 0.5, 0, 0 }, along, across, { 3.0, 1.5 }, 0.8 };
  ExpectTrueDistances(
    bar,
    [&](const dvec3& p)
    {
      const dvec2 q(
        std::abs(glm::dot(p - bar.center, along)), std::abs(glm::dot(p - bar.center, across)));
      const bool inCross = (q.x < 3.0 && q.y < 0.7) || (q.x < 2.2 && q.y < 1.5);
      return inCross || glm::length(q - dvec2(2.2, 0.7)) < 0.8;
    },
    6.0, 3000);
  const hasp::HalfSpaceShape half{ { 0, 1, 0 }, along };
  ExpectTrueDistances(
    half, [&](const dvec3& p) { return glm::dot(p, along) < glm::dot(half.point, along); }, 6, 500);
}

TEST(AnalyticShapes, HorseshoesHoldWhatIsNearTheirMiddleBand)
{
  const hasp::HorseshoeShape shoe{ { 0.2, -0.1, 0.3 }, 4.0, 1.1, 5.0, 1.5, 1.2 };
  // The middle line as many points: a membership good to the sagitta between them.
  std::vector<dvec2> line;
  const double half = shoe.arc * shoe.halfAngle + shoe.arm;
  for (int n = -20000; n <= 20000; ++n)
    line.emplace_back(shoe.PointAt(half * n / 20000.0) - shoe.center);
  Points any(9.0);
  for (int n = 0; n < 1000; ++n)
  {
    const dvec3 p = any(), d = p - shoe.center;
    double least = 1e9;
    for (const dvec2& q : line)
      least = std::min(least, glm::length(dvec2(d) - q));
    const double away = std::hypot(least, std::max(std::abs(d.z) - shoe.halfHeight, 0.0));
    const hasp::Foot foot = hasp::FootOn(shoe, p);
    // Points are 0.0005 mm apart; |p - q| errs most where it is small itself.
    ASSERT_NEAR(foot.mm, away - shoe.tube, 3e-4);
    ASSERT_LT(std::abs(hasp::FootOn(shoe, p - foot.mm * foot.outward).mm), 1e-11);
  }
}

TEST(AnalyticShapes, RoundedFrustaAreTrue)
{
  const std::vector<dvec3> low{ { -1, -3, -2 }, { 3, 1, -2 }, { -2, 2, -2 } };
  std::vector<dvec3> high;
  for (const dvec3& p : low)
    high.emplace_back(0.6 * p.x + 0.5, 0.6 * p.y, 3.0);
  for (const double rounding : { 0.0, 0.9 })
  {
    const hasp::PolyhedronShape shape = hasp::Frustum(low, high, rounding);
    const hasp::PolyhedronShape sharp = hasp::Frustum(low, high, 0.0);
    const auto inSharp = [&](const dvec3& p)
    {
      const double t = (p.z + 2.0) / 5.0; // the section at p's height, by its half planes
      bool in = t > 0.0 && t < 1.0;
      for (int n = 0; n < 3 && in; ++n)
      {
        const dvec3 a = low[n] + t * (high[n] - low[n]);
        const dvec3 e = low[(n + 1) % 3] - low[n];
        in = e.x * (p.y - a.y) - e.y * (p.x - a.x) > 0.0;
      }
      return in;
    };
    if (rounding == 0.0)
      ExpectTrueDistances(shape, inSharp, 6.0, 3000);
    else // an offset: proven by the sharp one
      ExpectTrueDistances(
        shape, [&](const dvec3& p) { return hasp::FootOn(sharp, p).mm < rounding; }, 6.0, 3000);
  }
}

TEST(AnalyticShapes, BoxesHoldTheirShapes)
{
  const std::vector<dvec3> low{ { -1, -3, -2 }, { 3, 1, -2 }, { -2, 2, -2 } };
  std::vector<dvec3> high = low;
  for (dvec3& p : high)
    p.z = 3.0;
  const std::vector<hasp::AnalyticShape> shapes{ hasp::EllipsoidShape{ { 1, 0, 0 }, { 3, 2, 1 } },
    hasp::RoundConeShape{ { -1, 0, 0 }, { 2, 2, 1 }, 2.0, 1.0 },
    hasp::HorseshoeShape{ {}, 3.0, 1.2, 2.0, 1.0, 1.0 }, hasp::Frustum(low, high, 0.7) };
  Points any(8.0);
  for (const hasp::AnalyticShape& shape : shapes)
  {
    const hasp::Box box = hasp::BoundsOf(shape);
    for (int n = 0; n < 20000; ++n)
    {
      const dvec3 p = any();
      if (hasp::FootOn(shape, p).mm < 0.0)
      {
        ASSERT_TRUE(glm::all(glm::lessThan(box.low, p)) && glm::all(glm::lessThan(p, box.high)));
      }
    }
  }
}

} // namespace
