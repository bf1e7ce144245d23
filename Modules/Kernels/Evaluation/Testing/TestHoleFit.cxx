#include "Evaluation/HoleFit.h"
#include "PartMeshes.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

// 96 sides whose middles lie on the circle: their ends are 0.05 % farther off.
constexpr int Sides = 96;

hasp::ClaimedHole Claim(const parttest::Motion& motion, double diameter)
{
  return { motion.to, motion.Turn({ 0, 0, 1 }), diameter };
}

TEST(HoleFit, MeasuresDiametersUnderAnyRotation)
{
  for (int seed = 0; seed < 8; ++seed)
  {
    const auto motion = parttest::AnyMotion(seed);
    const double diameter = 1.5 + 0.4 * seed;
    const auto tube = motion(parttest::Tube(0.5 * diameter, 0.5 * diameter + 1.5, 4.0, Sides));
    const auto fit = hasp::FitHole(hasp::TriangleTree(tube), Claim(motion, diameter));
    EXPECT_NEAR(fit.diameterMm, diameter, 6e-4 * diameter);
    EXPECT_GT(fit.leastMm, diameter - 1e-3 * diameter); // no ray need meet a side's middle
    EXPECT_LT(fit.leastMm, fit.diameterMm);
    EXPECT_LT(fit.roundnessMm, 6e-4 * diameter);
    EXPECT_LT(fit.tiltDegrees, 0.02);
    EXPECT_LT(fit.offsetMm, 1e-3);
    EXPECT_NEAR(fit.guideMm, 4.0, 0.25);
    EXPECT_EQ(fit.touchedShare, 1.0);
    EXPECT_FALSE(fit.blockedAt);
  }
}

TEST(HoleFit, TheFitIsOfTheMeshNotOfTheClaim)
{
  const auto motion = parttest::AnyMotion(5);
  const hasp::TriangleTree tree(motion(parttest::Tube(1.0, 3.0, 5.0, Sides)));
  hasp::ClaimedHole claim = Claim(motion, 2.4); // too large, 0.2 mm off and 1.5 degrees askew
  const double angle = glm::radians(1.5);
  claim.point += motion.Turn({ 0.2, 0, 0 });
  claim.axis = motion.Turn({ 0, std::sin(angle), std::cos(angle) });
  const auto fit = hasp::FitHole(tree, claim);
  EXPECT_NEAR(fit.diameterMm, 2.0, 2e-3);
  EXPECT_NEAR(fit.offsetMm, 0.2, 5e-3);
  EXPECT_NEAR(fit.tiltDegrees, 1.5, 0.03);
}

TEST(HoleFit, APinGoesBesideABurrAndNotBetweenTwo)
{
  // A flat of 0.2 mm on one side of a hole of 2 mm leaves room for 1.8, 0.1 mm beside the axis; two
  // that face each other leave 1.6.
  for (int flats = 0; flats <= 2; ++flats)
  {
    hasp::TriangleMesh tube = parttest::Tube(1.0, 3.0, 4.0, Sides);
    for (glm::dvec3& p : tube.points)
      if (glm::length(glm::dvec2(p)) < 1.5)
        p.x = std::clamp(p.x, flats > 1 ? -0.8 : -2.0, flats > 0 ? 0.8 : 2.0);
    const auto motion = parttest::AnyMotion(flats);
    const auto fit = hasp::FitHole(hasp::TriangleTree(motion(tube)), Claim(motion, 2.0));
    EXPECT_NEAR(fit.leastMm, 2.0 - 0.2 * flats, 5e-3) << flats;
  }
}

TEST(HoleFit, AnObliqueMouthTurnsNoAxis)
{
  // A bore of 2 mm that ends in a side at 45 degrees, around most of it.
  hasp::TriangleMesh tube = parttest::Tube(1.0, 3.0, 4.0, Sides);
  for (glm::dvec3& p : tube.points)
    if (glm::length(glm::dvec2(p)) > 2.0 && p.z < 0.0 && std::abs(std::atan2(p.y, p.x)) < 2.45)
      p.z -= 2.0;
  const auto motion = parttest::AnyMotion(6);
  const auto fit = hasp::FitHole(hasp::TriangleTree(motion(tube)), Claim(motion, 2.0));
  EXPECT_NEAR(fit.diameterMm, 2.0, 2e-3);
  EXPECT_GT(fit.leastMm, 1.99);
  EXPECT_LT(fit.tiltDegrees, 0.02);
  EXPECT_LT(fit.offsetMm, 1e-3);
}

TEST(HoleFit, AHeadsRoomIsNoPartOfItsBore)
{
  // A bore of 2.4 mm from -3 to 0, and above it to 3 room of 3 mm.
  const auto motion = parttest::AnyMotion(3);
  auto mesh = parttest::Tube(1.5, 3.0, 3.0, Sides);
  for (glm::dvec3& p : mesh.points)
    p.z += 1.5;
  auto below = parttest::Tube(1.2, 3.0, 3.0, Sides);
  for (glm::dvec3& p : below.points)
    p.z -= 1.51; // two tubes, one on the other
  for (const glm::uvec3& t : below.triangles)
    mesh.triangles.push_back(t + std::uint32_t(mesh.points.size()));
  mesh.points.insert(mesh.points.end(), below.points.begin(), below.points.end());
  const hasp::TriangleTree tree(motion(mesh));
  hasp::ClaimedHole claim = Claim(motion, 2.4);
  EXPECT_GT(hasp::FitHole(tree, claim).diameterMm, 2.6); // both are one hole where none is told
  claim.highMm = -0.1;
  auto fit = hasp::FitHole(tree, claim);
  EXPECT_NEAR(fit.diameterMm, 2.4, 2e-3);
  EXPECT_NEAR(fit.guideMm, 3.0, 0.3);
  // What is on the axis far beyond is in the way only where the claim reaches.
  const auto far =
    parttest::Blocks({ -1, 1 }, { -1, 1 }, { 20, 22 }, [](int, int, int) { return true; });
  for (const glm::uvec3& t : far.triangles)
    mesh.triangles.push_back(t + std::uint32_t(mesh.points.size()));
  mesh.points.insert(mesh.points.end(), far.points.begin(), far.points.end());
  const hasp::TriangleTree blocked(motion(mesh));
  EXPECT_TRUE(hasp::FitHole(blocked, claim).blockedAt);
  claim.clearMm = 5.0;
  fit = hasp::FitHole(blocked, claim);
  EXPECT_FALSE(fit.blockedAt);
  EXPECT_NEAR(fit.diameterMm, 2.4, 2e-3);
}

TEST(HoleFit, SaysIfItIsBlockedOpenOrNotThere)
{
  const auto motion = parttest::AnyMotion(4);
  const auto solid =
    motion(parttest::Blocks({ -5, 5 }, { -5, 5 }, { -2, 2 }, [](int, int, int) { return true; }));
  auto fit = hasp::FitHole(hasp::TriangleTree(solid), Claim(motion, 2));
  EXPECT_EQ(fit.sections, 0U);
  ASSERT_TRUE(fit.blockedAt);
  // A notch of 2 x 2 mm in the rim, its axis 0.2 mm from there.
  const auto notched = motion(parttest::Blocks(
    { -5, -1, 1, 5 }, { -1, 1, 5 }, { -2, 2 }, [](int i, int j, int) { return i != 1 || j != 0; }));
  hasp::ClaimedHole rim = Claim(motion, 2);
  rim.point += motion.Turn({ 0, -0.8, 0 });
  fit = hasp::FitHole(hasp::TriangleTree(notched), rim);
  EXPECT_EQ(fit.sections, 0U);
  EXPECT_GT(fit.touchedShare, 0.3);
  EXPECT_FALSE(fit.blockedAt);
  hasp::ClaimedHole away = Claim(motion, 2);
  away.point += motion.Turn({ 30, 0, 0 });
  fit = hasp::FitHole(hasp::TriangleTree(notched), away);
  EXPECT_EQ(fit.sections, 0U);
  EXPECT_EQ(fit.touchedShare, 0.0);
}

} // namespace
