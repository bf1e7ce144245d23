#include "Evaluation/SurfaceRegistration.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

namespace
{

using hasp::MeasuredSurface;
using hasp::RigidPose;

/// A tube along a spiral that widens: nothing of it is like anything else of it, nor like its
/// mirror image. `around` sides, `along` parts, from a share of its length to another.
hasp::TriangleMesh Spiral(int around, int along, double from = 0.0, double to = 1.0)
{
  hasp::TriangleMesh mesh;
  for (int i = 0; i <= along; ++i)
  {
    const double t = from + (to - from) * i / along, turn = 5.0 * glm::pi<double>() * t,
                 wide = 12.0 + 14.0 * t, tube = 2.0 + 2.5 * t;
    const glm::dvec3 out(std::cos(turn), std::sin(turn), 0), up(0, 0, 1);
    for (int j = 0; j < around; ++j)
    {
      const double angle = j * glm::two_pi<double>() / around;
      mesh.points.push_back(
        (wide + tube * std::cos(angle)) * out + (40.0 * t + tube * std::sin(angle)) * up);
    }
  }
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < around; ++j)
    {
      const auto at = [&](int a, int b) { return std::uint32_t(a * around + b % around); };
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i, j + 1));
      mesh.triangles.emplace_back(at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
    }
  return mesh;
}

hasp::TriangleMesh Moved(hasp::TriangleMesh mesh, const RigidPose& pose)
{
  for (glm::dvec3& p : mesh.points)
    p = pose.Place(p);
  return mesh;
}

RigidPose AnyPose(int seed)
{
  const parttest::Motion motion = parttest::AnyMotion(seed);
  return { motion.to, glm::quat_cast(motion.turn) };
}

double FarthestOff(const hasp::TriangleMesh& mesh, const RigidPose& a, const RigidPose& b)
{
  double most = 0;
  for (const glm::dvec3& p : mesh.points)
    most = std::max(most, glm::distance(a.Place(p), b.Place(p)));
  return most;
}

TEST(SurfaceRegistration, SettingsOutOfRangeAreRefused)
{
  const MeasuredSurface ball(parttest::Ball(5, 6), 500);
  for (const hasp::SurfaceRegistrationSettings& s :
    { hasp::SurfaceRegistrationSettings{ 0.0 }, hasp::SurfaceRegistrationSettings{ 2.0, 1.5 },
      hasp::SurfaceRegistrationSettings{ 2.0, 0.5, 0.0 },
      hasp::SurfaceRegistrationSettings{ 2.0, 0.5, 1.0, 10 } })
    EXPECT_THROW(hasp::RegisterSurfaces(ball, ball, s), std::invalid_argument);
  EXPECT_THROW(
    hasp::RegisterSurfaces(ball, ball, {}, [](double) { return false; }), hasp::Cancelled);
}

TEST(SurfaceRegistration, AnotherScanIsFoundWhereverItLies)
{
  const hasp::TriangleMesh mesh = Spiral(10, 80);
  const MeasuredSurface part(mesh, 500);
  for (const int seed : { 1, 2 })
  {
    const RigidPose scanToOther = AnyPose(seed);
    const auto found = hasp::RegisterSurfaces(part, MeasuredSurface(Moved(mesh, scanToOther), 500));
    EXPECT_LT(FarthestOff(mesh, found.otherToScan * scanToOther, {}), 1e-3) << seed;
    EXPECT_TRUE(found.fits);
    EXPECT_FALSE(found.ambiguous);
    EXPECT_LT(found.medianMm, 1e-4);
    EXPECT_GT(found.share, 0.999);
  }
}

TEST(SurfaceRegistration, PartsAndTrianglesMayDiffer)
{
  const hasp::TriangleMesh mesh = Spiral(14, 130, 0.0, 0.9);
  const RigidPose scanToOther = AnyPose(2);
  hasp::TriangleMesh other = Spiral(17, 90, 0.1, 1.0); // a ninth is missing, another is new
  const auto more =
    parttest::Blocks({ 60, 75 }, { 0, 15 }, { 0, 15 }, [](int, int, int) { return true; });
  const auto first = std::uint32_t(other.points.size());
  other.points.insert(other.points.end(), more.points.begin(), more.points.end());
  for (const glm::uvec3& t : more.triangles)
    other.triangles.push_back(t + first);
  const auto found = hasp::RegisterSurfaces(
    MeasuredSurface(mesh, 500), MeasuredSurface(Moved(other, scanToOther), 500));
  // Sides are flat: chords of both meshes lie up to 0.08 mm within the tube, and along the spiral.
  EXPECT_LT(FarthestOff(mesh, found.otherToScan * scanToOther, {}), 0.2);
  EXPECT_TRUE(found.fits);
  EXPECT_LT(found.medianMm, 0.1);
  EXPECT_GT(found.share, 0.85);
  EXPECT_LT(found.share, 0.96);
}

TEST(SurfaceRegistration, AMirrorImageAndAnotherBoneDoNotFit)
{
  const hasp::TriangleMesh mesh = Spiral(10, 80);
  const MeasuredSurface part(mesh, 500);
  hasp::TriangleMesh mirrored = mesh;
  for (glm::dvec3& p : mirrored.points)
    p.x = -p.x;
  for (glm::uvec3& t : mirrored.triangles)
    std::swap(t.y, t.z);
  const auto mirror = hasp::RegisterSurfaces(part, MeasuredSurface(mirrored, 500));
  EXPECT_FALSE(mirror.fits) << mirror.medianMm << " " << mirror.share;
  const auto ball = hasp::RegisterSurfaces(part, MeasuredSurface(parttest::Ball(25, 20), 500));
  EXPECT_FALSE(ball.fits) << ball.medianMm << " " << ball.share;
}

TEST(SurfaceRegistration, WhatIsAlikeFromSeveralSidesIsSaidToBe)
{
  const MeasuredSurface box(
    parttest::Blocks({ 0, 30 }, { 0, 20 }, { 0, 10 }, [](int, int, int) { return true; }), 1000);
  const auto found = hasp::RegisterSurfaces(box, box);
  EXPECT_TRUE(found.fits);
  EXPECT_TRUE(found.ambiguous);
}

} // namespace
