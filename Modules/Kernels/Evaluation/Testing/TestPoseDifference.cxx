#include "Evaluation/PoseDifference.h"
#include "Evaluation/SurfaceDifference.h"
#include "PartMeshes.h"

#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace
{

using hasp::RigidPose;
using hasp::WeightedPoint;

struct Anything
{
  std::mt19937 random;
  std::normal_distribution<double> normal{ 0.0, 20.0 };
  glm::dvec3 Place() { return { normal(random), normal(random), normal(random) }; }
  RigidPose Pose() { return { this->Place(), hasp::TurnBy(0.1 * this->Place()) }; }
  std::vector<WeightedPoint> Points(int count)
  {
    std::vector<WeightedPoint> points;
    for (int n = 0; n < count; ++n)
      points.push_back({ this->Place(), 0.5 + std::abs(0.1 * normal(random)) });
    return points;
  }
};

double Misfit(const std::vector<hasp::PosedPoints>& fragments, const RigidPose& secondToFirst)
{
  double sum = 0;
  for (const hasp::PosedPoints& f : fragments)
    for (const WeightedPoint& p : f.points)
    {
      const glm::dvec3 off = f.first.Place(p.point) - secondToFirst.Place(f.second.Place(p.point));
      sum += p.weight * glm::dot(off, off);
    }
  return sum;
}

TEST(PoseDifference, BadInputIsRefused)
{
  const std::vector<WeightedPoint> one{ { { 1, 2, 3 } } };
  const auto refused = [](auto&& make) { EXPECT_THROW(make(), std::invalid_argument); };
  refused([] { return hasp::ComparePoses({}, {}, {}); });
  refused([] { return hasp::BestAlignment({}); });
  refused([&] { return hasp::ComparePoses({ {}, { 1.1, 0, 0, 0 } }, {}, one); });
  for (const double weight : { 0.0, -1.0, std::numeric_limits<double>::infinity() })
  {
    const std::vector<WeightedPoint> points{ { { 0, 0, 0 }, weight } };
    refused([&] { return hasp::ComparePoses({}, {}, points); });
  }
  const std::vector<WeightedPoint> none{ { { std::nan(""), 0, 0 } } };
  const hasp::PosedPoints posed{ {}, {}, none };
  refused([&] { return hasp::BestAlignment({ &posed, 1 }); });
}

TEST(PoseDifference, AShiftIsThatFarEverywhere)
{
  Anything any{ std::mt19937(3) };
  const auto points = any.Points(500);
  const RigidPose pose = any.Pose();
  for (const double shift : { 0.0, 1e-9, 0.7, 250.0 })
  {
    const RigidPose other = RigidPose{ shift * glm::normalize(any.Place()) } * pose;
    const auto d = hasp::ComparePoses(pose, other, points);
    EXPECT_LT(d.rotationDegrees, 1e-12);
    for (const double mm : { d.translationMm, d.tre.meanMm, d.tre.rmsMm, d.tre.p95Mm, d.tre.maxMm })
      EXPECT_NEAR(mm, shift, 1e-12 + 1e-13 * 250);
    EXPECT_LE(d.tre.meanMm, d.tre.maxMm);
  }
}

TEST(PoseDifference, ATurnIsItsAngleHoweverSmall)
{
  Anything any{ std::mt19937(4) };
  const auto points = any.Points(20);
  for (const double degrees : { 1e-9, 1e-5, 0.3, 5.0, 90.0, 179.9999, 180.0 })
  {
    const RigidPose pose = any.Pose();
    const glm::dquat turn = hasp::TurnBy(glm::radians(degrees) * glm::normalize(any.Place()));
    const auto d = hasp::ComparePoses(pose, { any.Place(), pose.orientation * turn }, points);
    EXPECT_NEAR(d.rotationDegrees, degrees, 1e-11 + 1e-13 * degrees);
    // A quaternion and its negative are one turn.
    const auto same =
      hasp::ComparePoses(pose, { pose.position, -(pose.orientation * turn) }, points);
    EXPECT_NEAR(same.rotationDegrees, degrees, 1e-11 + 1e-13 * degrees);
  }
}

TEST(PoseDifference, PointsOnACircleGoItsChord)
{
  std::vector<WeightedPoint> circle;
  for (int n = 0; n < 36; ++n)
    circle.push_back(
      { { 10 * std::cos(n * glm::radians(10.0)), 10 * std::sin(n * glm::radians(10.0)), 3 } });
  const double angle = glm::radians(7.0);
  const auto d = hasp::ComparePoses({}, { {}, hasp::TurnBy({ 0, 0, angle }) }, circle);
  EXPECT_NEAR(d.translationMm, 0.0, 1e-12); // about their middle
  EXPECT_NEAR(d.tre.meanMm, 20 * std::sin(0.5 * angle), 1e-12);
  EXPECT_NEAR(d.tre.maxMm, 20 * std::sin(0.5 * angle), 1e-12);
  EXPECT_EQ(d.tre.points, 36U);
}

TEST(PoseDifference, IsSymmetricAndWeighted)
{
  Anything any{ std::mt19937(5) };
  const auto points = any.Points(300);
  const RigidPose a = any.Pose(), b = any.Pose();
  const auto one = hasp::ComparePoses(a, b, points), other = hasp::ComparePoses(b, a, points);
  EXPECT_NEAR(one.rotationDegrees, other.rotationDegrees, 1e-10);
  EXPECT_EQ(one.tre.meanMm, other.tre.meanMm);
  EXPECT_EQ(one.translationMm, other.translationMm);
  std::vector<WeightedPoint> twice; // a weight of two is the point twice
  std::vector<WeightedPoint> heavy{ { { 1, 2, 3 }, 2.0 }, { { -40, 5, 6 }, 1.0 } };
  twice = { { { 1, 2, 3 } }, { { 1, 2, 3 } }, { { -40, 5, 6 } } };
  const auto w = hasp::ComparePoses(a, b, heavy), t = hasp::ComparePoses(a, b, twice);
  EXPECT_NEAR(w.tre.meanMm, t.tre.meanMm, 1e-12);
  EXPECT_NEAR(w.tre.rmsMm, t.tre.rmsMm, 1e-12);
  EXPECT_NEAR(w.translationMm, t.translationMm, 1e-12);
}

TEST(PoseDifference, WhatMovedAsOneIsAlignedAway)
{
  Anything any{ std::mt19937(6) };
  const auto first = any.Points(40), second = any.Points(60);
  for (int n = 0; n < 50; ++n)
  {
    const RigidPose a = any.Pose(), b = any.Pose(), motion = any.Pose();
    const std::vector<hasp::PosedPoints> both{ { a, motion * a, first },
      { b, motion * b, second } };
    const RigidPose aligned = hasp::BestAlignment(both);
    EXPECT_LT(hasp::ComparePoses(b, aligned * motion * b, second).tre.maxMm, 1e-11);
    EXPECT_LT(hasp::ComparePoses(aligned, motion.Inverse(), first).rotationDegrees, 1e-11);
  }
}

TEST(PoseDifference, NoOtherMotionAlignsBetter)
{
  Anything any{ std::mt19937(7) };
  const auto first = any.Points(10), second = any.Points(15);
  for (int n = 0; n < 20; ++n)
  {
    const std::vector<hasp::PosedPoints> both{ { any.Pose(), any.Pose(), first },
      { any.Pose(), any.Pose(), second } };
    const RigidPose aligned = hasp::BestAlignment(both);
    const double least = Misfit(both, aligned);
    for (int m = 0; m < 50; ++m)
    {
      EXPECT_LE(least, Misfit(both, any.Pose()));
      const RigidPose nudge{ 1e-3 * any.Place(), hasp::TurnBy(1e-4 * any.Place()) };
      EXPECT_LE(least, Misfit(both, nudge * aligned));
    }
  }
}

TEST(PoseDifference, PlacesOneByOneAreAlignedLikewise)
{
  Anything any{ std::mt19937(9) };
  std::vector<glm::dvec3> first, second;
  const RigidPose motion = any.Pose();
  for (int n = 0; n < 30; ++n)
  {
    second.push_back(any.Place());
    first.push_back(motion.Place(second.back()));
  }
  const RigidPose aligned = hasp::BestAlignment(first, second);
  for (std::size_t n = 0; n < first.size(); ++n)
    EXPECT_LT(glm::distance(aligned.Place(second[n]), first[n]), 1e-11);
  second.pop_back();
  EXPECT_THROW(hasp::BestAlignment(first, second), std::invalid_argument);
}

TEST(PoseDifference, PointsOnALineAndASinglePointAreAligned)
{
  std::vector<WeightedPoint> line{ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 5, 0, 0 } } };
  for (int count = 1; count <= 3; ++count)
  {
    Anything any{ std::mt19937(8) };
    const RigidPose a = any.Pose(), b = any.Pose();
    const hasp::PosedPoints posed{ a, b, std::span(line).first(count) };
    const RigidPose aligned = hasp::BestAlignment({ &posed, 1 });
    EXPECT_LT(hasp::ComparePoses(a, aligned * b, posed.points).tre.maxMm, 1e-9) << count;
  }
}

TEST(PoseDifference, TheSurfaceOfAPartWeighsItsPoints)
{
  const hasp::MeasuredSurface ball(parttest::Ball(10, 20));
  const auto points = hasp::WeightedPoints(ball.Samples());
  const double angle = glm::radians(2.0);
  const auto d = hasp::ComparePoses({}, { {}, hasp::TurnBy({ 0, angle, 0 }) }, points);
  // The mean distance of a sphere's places from an axis through its middle is pi / 4 of its radius.
  EXPECT_NEAR(d.tre.meanMm, 2 * std::sin(0.5 * angle) * 10 * 0.25 * glm::pi<double>(), 0.004);
  EXPECT_NEAR(hasp::MeasureSurfaceDifference(ball, {}, ball, { {}, hasp::TurnBy({ 0, angle, 0 }) })
                .both.meanMm,
    0.0, 0.02); // and its surface stays where it is, but for its flat sides
}

} // namespace
