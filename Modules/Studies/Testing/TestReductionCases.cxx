#include "Studies/BrokenPot.h"
#include "Studies/ReductionCases.h"

#include "Reduction/Assembly.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <stdexcept>

namespace
{
/// A coarse and quick case.
hasp::ReductionCaseSettings Coarse(bool halfLevels)
{
  hasp::ReductionCaseSettings settings;
  settings.spacingMm = 1.2;
  settings.halfLevels = halfLevels;
  settings.bake.spacingMm = 1.0;
  settings.seed = 5;
  return settings;
}

/// Median distance between faces of the broken jaw that look at each other, at the true poses.
double FaceGap(const hasp::ReductionCase& broken)
{
  std::vector<double> gaps;
  for (std::size_t n = 2; n < broken.bodies.size(); ++n)
    for (const std::size_t k : broken.partners[n])
    {
      const hasp::RigidPose toOther =
        broken.trueBodyInWorld[k].Inverse() * broken.trueBodyInWorld[n];
      for (const hasp::OrientedPoint& p : broken.bodies[n].body->Points(100'000))
        if (const auto foot = broken.bodies[k].body->FootOf(toOther.Place(p.place));
            foot && std::abs(foot->mm) < 1.5 &&
            glm::dot(toOther.Turn(p.normal), foot->outward) < -0.6)
          gaps.push_back(foot->mm);
    }
  EXPECT_GT(gaps.size(), 100U);
  std::nth_element(gaps.begin(), gaps.begin() + std::ptrdiff_t(gaps.size() / 2), gaps.end());
  return gaps[gaps.size() / 2];
}
} // namespace

TEST(ReductionCases, FacesMeetAtTheTruthWhereTheScanSawHalf)
{
  EXPECT_LT(std::abs(FaceGap(hasp::MakeReductionCase(Coarse(true)))), 0.25);
  EXPECT_LT(FaceGap(hasp::MakeReductionCase(Coarse(false))), -0.25); // a threshold's overlap
}

TEST(ReductionCases, StartsAreWithinWhatWasAskedFor)
{
  const hasp::ReductionCase broken = hasp::MakeReductionCase(Coarse(true));
  EXPECT_TRUE(broken.fixed[0] && broken.fixed[1] && !broken.fixed[2]);
  EXPECT_EQ(broken.SceneWithout(3).obstacles.size(), 1U); // the cranium
  double farthest = 0.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    const hasp::RigidPose start = broken.StartOf(3, 3.0, 5.0, seed);
    const glm::dvec3 middle = broken.bodies[3].body->Centroid();
    const double mm = glm::length(start.Place(middle) - broken.trueBodyInWorld[3].Place(middle));
    const double degrees = glm::degrees(glm::length(hasp::RotationVector(
      start.orientation * glm::conjugate(broken.trueBodyInWorld[3].orientation))));
    EXPECT_LE(mm, 3.0 + 1e-9);
    EXPECT_LE(degrees, 5.0 + 1e-9);
    farthest = std::max(farthest, mm);
  }
  EXPECT_GT(farthest, 2.7);
}

TEST(BrokenPot, RefusesSettingsOutOfRange)
{
  EXPECT_THROW(hasp::MakeBrokenPot({ .sherds = 1 }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeBrokenPot({ .spacingMm = 0.0 }), std::invalid_argument);
}

TEST(BrokenPot, SherdsTouchAtTheTruthAndDoNotOverlap)
{
  const hasp::BrokenPot pot = hasp::MakeBrokenPot({ .sherds = 4, .spacingMm = 1.5, .seed = 3 });
  ASSERT_EQ(pot.sherds.size(), 4U);
  double touching = 0.0;
  for (std::size_t n = 0; n < 4; ++n)
    for (std::size_t k = 0; k < 4; ++k)
      if (k != n)
      {
        const hasp::RigidPose toOther =
          pot.sherds[k].bodyInWorld.Inverse() * pot.sherds[n].bodyInWorld;
        const auto points = pot.sherds[n].body->Points(100'000);
        for (const hasp::OrientedPoint& p : points)
          if (const auto foot = pot.sherds[k].body->FootOf(toOther.Place(p.place)))
          {
            EXPECT_GT(foot->mm, -0.75); // half a sample of the grid
            touching += std::abs(foot->mm) < 0.4 ? pot.areaMm2[n] / double(points.size()) : 0.0;
          }
      }
  EXPECT_GT(touching, 2000.0); // mm2, both sides
}
