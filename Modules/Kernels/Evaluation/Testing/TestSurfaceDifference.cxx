#include "Evaluation/SurfaceDifference.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace
{

using hasp::MeasuredSurface;
using hasp::RigidPose;

hasp::TriangleMesh Plate(double width, double height)
{
  return { { { 0, 0, 0 }, { width, 0, 0 }, { width, height, 0 }, { 0, height, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } } };
}

hasp::TriangleMesh Box(const glm::dvec3& low, const glm::dvec3& high)
{
  return parttest::Blocks(
    { low.x, high.x }, { low.y, high.y }, { low.z, high.z }, [](int, int, int) { return true; });
}

RigidPose AnyPose(int seed)
{
  const parttest::Motion motion = parttest::AnyMotion(seed);
  return { motion.to, glm::quat_cast(motion.turn) };
}

void ExpectOrdered(const hasp::DirectedDifference& d)
{
  EXPECT_LE(d.meanMm, d.rmsMm);
  EXPECT_LE(d.rmsMm, d.maxMm);
  EXPECT_LE(d.p50Mm, d.p95Mm);
  EXPECT_LE(d.p95Mm, d.p99Mm);
  EXPECT_LE(d.p99Mm, d.maxMm);
  EXPECT_NEAR(glm::distance(d.maxAt, d.maxTo), d.maxMm, 1e-9);
}

TEST(SurfaceDifference, BadMeshesPosesAndCountsAreRefused)
{
  const hasp::TriangleMesh plate = Plate(10, 10);
  const auto refused = [](auto&& make) { EXPECT_THROW(make(), std::invalid_argument); };
  refused([] { return MeasuredSurface({}); });
  refused([&] { return MeasuredSurface(plate, 99); });
  refused([&] { return MeasuredSurface(plate, 200'001); });
  hasp::TriangleMesh bad = plate;
  bad.points[3].x = std::numeric_limits<double>::quiet_NaN();
  refused([&] { return MeasuredSurface(bad); });
  bad = plate;
  bad.triangles[0].x = 4;
  refused([&] { return MeasuredSurface(bad); });
  bad = plate;
  bad.triangles = { { 0, 0, 1 } };
  refused([&] { return MeasuredSurface(bad); });
  const MeasuredSurface surface(plate, 100);
  const RigidPose stretched{ {}, { 1.01, 0, 0, 0 } },
    nowhere{ { std::numeric_limits<double>::infinity(), 0, 0 } };
  refused([&] { return hasp::MeasureSurfaceDifference(surface, stretched, surface, {}); });
  refused([&] { return hasp::MeasureSurfaceDifference(surface, {}, surface, nowhere); });
}

TEST(SurfaceDifference, SamplesAreAsManyAsAskedForAndNoFartherApartThanSaid)
{
  for (const std::size_t least : { 100, 10'000, 100'000 })
    for (const double width : { 1.0, 100.0, 5000.0 })
    {
      const MeasuredSurface surface(Plate(width, 100), least);
      EXPECT_GE(surface.Samples().size(), least);
      EXPECT_NEAR(surface.AreaMm2(), 100 * width, 1e-9 * width);
      EXPECT_NEAR(glm::distance(surface.Centroid(), { 0.5 * width, 50, 0 }), 0.0, 1e-9 * width);
      for (const hasp::MeshSample& sample : surface.Samples()) // no larger than an equilateral one
        ASSERT_LE(sample.areaMm2, 0.4331 * surface.SpacingMm() * surface.SpacingMm());
    }
}

TEST(SurfaceDifference, APlateMovedAlongItsNormalIsThatFarAway)
{
  const MeasuredSurface plate(Plate(30, 20));
  const RigidPose a = AnyPose(1);
  for (const double shift : { 0.0, 1e-6, 0.25, 40.0 })
  {
    const auto apart =
      hasp::MeasureSurfaceDifference(plate, a * RigidPose{ { 0, 0, shift } }, plate, a);
    for (const auto* d : { &apart.aToB, &apart.bToA, &apart.both })
    {
      EXPECT_NEAR(d->meanMm, shift, 1e-10);
      EXPECT_NEAR(d->rmsMm, shift, 1e-10);
      EXPECT_NEAR(d->maxMm, shift, 1e-10);
      EXPECT_NEAR(d->p50Mm, shift, 1e-10);
      ExpectOrdered(*d);
    }
    EXPECT_NEAR(apart.both.areaMm2, 1200.0, 1e-9);
  }
}

TEST(SurfaceDifference, ABoxAroundABoxHasItsFarthestPlaceAtACorner)
{
  const MeasuredSurface inner(Box({ 0, 0, 0 }, { 20, 10, 6 })),
    outer(Box({ -1, -1, -1 }, { 21, 11, 7 }));
  const auto apart = hasp::MeasureSurfaceDifference(inner, AnyPose(2), outer, AnyPose(2));
  EXPECT_NEAR(apart.aToB.meanMm, 1.0, 1e-9);
  EXPECT_NEAR(apart.aToB.maxMm, 1.0, 1e-9);
  EXPECT_NEAR(apart.bToA.maxMm, std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(apart.both.maxMm, std::sqrt(3.0), 1e-9);
  EXPECT_GT(apart.bToA.meanMm, 1.0);
  EXPECT_NEAR(apart.both.meanMm,
    (apart.aToB.meanMm * apart.aToB.areaMm2 + apart.bToA.meanMm * apart.bToA.areaMm2) /
      apart.both.areaMm2,
    1e-12);
  for (const auto* d : { &apart.aToB, &apart.bToA, &apart.both })
    ExpectOrdered(*d);
}

TEST(SurfaceDifference, SidesMayBeSwapped)
{
  const MeasuredSurface ball(parttest::Ball(10, 12)), box(Box({ -8, -8, -8 }, { 9, 7, 8 }));
  const auto one = hasp::MeasureSurfaceDifference(ball, AnyPose(1), box, AnyPose(2));
  const auto other = hasp::MeasureSurfaceDifference(box, AnyPose(2), ball, AnyPose(1));
  const auto way = hasp::MeasureDistances(ball, AnyPose(1), box, AnyPose(2));
  EXPECT_EQ(way.meanMm, one.aToB.meanMm);
  EXPECT_EQ(way.maxMm, one.aToB.maxMm);
  EXPECT_EQ(one.aToB.meanMm, other.bToA.meanMm);
  EXPECT_EQ(one.bToA.maxMm, other.aToB.maxMm);
  EXPECT_EQ(one.both.meanMm, other.both.meanMm);
  EXPECT_EQ(one.both.rmsMm, other.both.rmsMm);
  EXPECT_EQ(one.both.maxMm, other.both.maxMm);
  EXPECT_EQ(one.both.p95Mm, other.both.p95Mm);
}

TEST(SurfaceDifference, IsThatOfEverySampleAndEveryTriangle)
{
  const hasp::TriangleMesh ballMesh = parttest::Ball(10, 5),
                           boxMesh = Box({ -6, -7, -8 }, { 9, 7, 8 });
  const MeasuredSurface ball(ballMesh, 300), box(boxMesh, 300);
  const RigidPose pose{ { 1, 2, -3 }, glm::quat_cast(parttest::AnyMotion(1).turn) };
  double sum = 0, square = 0, most = 0, area = 0;
  const auto nearest = [&](const glm::dvec3& at)
  {
    double least = 1e300; // by many places of each triangle: no better than that, and never less
    for (const glm::uvec3& t : boxMesh.triangles)
      for (int i = 0; i <= 100; ++i)
        for (int j = 0; j <= 100 - i; ++j)
          least = std::min(
            least, glm::distance(at, boxMesh.points[t.x] +
                                       0.01 * i * (boxMesh.points[t.y] - boxMesh.points[t.x]) +
                                       0.01 * j * (boxMesh.points[t.z] - boxMesh.points[t.x])));
    return least;
  };
  for (const hasp::MeshSample& sample : ball.Samples())
  {
    const double d = nearest(pose.Place(sample.point));
    sum += sample.areaMm2 * d;
    square += sample.areaMm2 * d * d;
    area += sample.areaMm2;
    most = std::max(most, d);
  }
  for (const glm::dvec3& point : ballMesh.points)
    most = std::max(most, nearest(pose.Place(point)));
  const auto apart = hasp::MeasureSurfaceDifference(ball, pose, box, {});
  // Places are 0.16 mm apart, so up to 0.12 from the nearest; most are some millimetres away.
  EXPECT_NEAR(apart.aToB.meanMm, sum / area, 0.01);
  EXPECT_NEAR(apart.aToB.rmsMm, std::sqrt(square / area), 0.01);
  EXPECT_NEAR(apart.aToB.maxMm, most, 0.01);
  EXPECT_GT(apart.aToB.meanMm, 1.0);
}

} // namespace
