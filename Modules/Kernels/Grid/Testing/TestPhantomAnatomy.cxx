#include "Grid/Phantom.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace
{

using glm::dvec3;
using hasp::AnalyticSolid;
using hasp::PhantomPart;
using hasp::PhantomSettings;

/// Random points at most `band` from the surface.
template <typename Body>
void ForPointsNear(const AnalyticSolid& solid, double band, int points, const Body& body)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  const hasp::Box box = solid.Bounds();
  for (int n = 0; n < points;)
  {
    const dvec3 share(any(random), any(random), any(random));
    const dvec3 p = box.low - band + (box.high - box.low + 2.0 * band) * share;
    if (std::abs(solid.Bound(p).mm) > band)
      continue;
    body(p, solid.Distance(p));
    ++n;
  }
}

PhantomSettings With(hasp::PhantomAnatomy anatomy)
{
  PhantomSettings s;
  s.anatomy = anatomy;
  return s;
}

/// Free of distances: only which side points are on. The ball of the true distance has one side,
/// and both sides meet at its rim, in the nearest point.
void ExpectTrue(const AnalyticSolid& solid, const dvec3& p, const hasp::SolidDistance& d,
  std::mt19937& random, double clear)
{
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  const bool inside = solid.Bound(p).mm < 0.0;
  ASSERT_EQ(d.mm < 0.0, inside);
  ASSERT_NEAR(glm::length(p - d.nearest), std::abs(d.mm), 1e-9);
  int inner = 0, tries = 0;
  while (tries < 2000 && (inner == 0 || inner == tries))
    inner += solid.Bound(d.nearest + 1e-6 * any()).mm < 0.0, ++tries;
  ASSERT_TRUE(inner > 0 && inner < tries) << "no surface at the nearest point";
  for (int n = 0; n < 40; ++n)
    ASSERT_EQ(solid.Bound(p + (0.999 * clear) * glm::normalize(any())).mm < 0.0, inside);
}

TEST(PhantomAnatomy, ProvenDistancesAreTrueByBruteForceAndNearlyAllAreProven)
{
  for (const auto anatomy : { hasp::PhantomAnatomy::Head, hasp::PhantomAnatomy::Fibula })
    for (const PhantomPart part : hasp::PhantomParts(With(anatomy)))
    {
      const AnalyticSolid solid = hasp::PhantomSolid(With(anatomy), part);
      std::mt19937 random(3);
      int proven = 0, points = 600;
      ForPointsNear(solid, 3.0, points,
        [&](const dvec3& p, const hasp::SolidDistance& d)
        {
          proven += d.errorMm == 0.0;
          ExpectTrue(solid, p, d, random, std::abs(d.mm) - d.errorMm);
        });
      EXPECT_GT(proven, 0.95 * points) << hasp::NameOf(part);
    }
}

TEST(PhantomAnatomy, DistancesThatAreNotProvenAreTrueAllTheSame)
{
  // Where two surfaces' curve is the nearest: found by Newton, held against 4000 points of the
  // ball.
  const AnalyticSolid solid = hasp::PhantomSolid({});
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  int open = 0, wrong = 0;
  ForPointsNear(solid, 3.0, 1500,
    [&](const dvec3& p, const hasp::SolidDistance& d)
    {
      if (d.errorMm == 0.0)
        return;
      ++open;
      const bool inside = d.mm < 0.0;
      const AnalyticSolid near = solid.Near(p, std::abs(d.mm) + 0.1);
      bool free = true;
      for (int n = 0; n < 4000 && free; ++n)
      {
        const dvec3 way = glm::normalize(dvec3(unit(random), unit(random), unit(random)));
        free = (near.Bound(p + 0.999 * std::abs(d.mm) * way).mm < 0.0) == inside;
      }
      wrong += !free;
    });
  EXPECT_GT(open, 5);
  EXPECT_LE(wrong, 0.1 * open); // nearest corners of three surfaces are not looked for
}

TEST(PhantomAnatomy, DistancesAgreeWithACloudOfSurfacePoints)
{
  // The left condyle and its joint: roots along parallel rays in all three directions.
  const AnalyticSolid solid = hasp::PhantomSolid({});
  const dvec3 low(44, -16, -58), high(64, 4, -38);
  const AnalyticSolid near = solid.Near(0.5 * (low + high), 0.5 * glm::length(high - low));
  constexpr double Step = 0.5;
  std::vector<dvec3> cloud;
  for (int axis = 0; axis < 3; ++axis)
    for (double u = low[(axis + 1) % 3]; u < high[(axis + 1) % 3]; u += Step)
      for (double v = low[(axis + 2) % 3]; v < high[(axis + 2) % 3]; v += Step)
      {
        dvec3 a;
        a[axis] = low[axis];
        a[(axis + 1) % 3] = u;
        a[(axis + 2) % 3] = v;
        bool before = near.Bound(a).mm < 0.0;
        for (; a[axis] < high[axis]; a[axis] += Step)
        {
          dvec3 in = a, out = a;
          out[axis] += Step;
          const bool after = near.Bound(out).mm < 0.0;
          for (int n = 0; n < 40 && after != before; ++n)
          {
            const dvec3 middle = 0.5 * (in + out);
            ((near.Bound(middle).mm < 0.0) == before ? in : out) = middle;
          }
          if (after != before)
            cloud.push_back(0.5 * (in + out));
          before = after;
        }
      }
  ASSERT_GT(cloud.size(), 2000u);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-4, 4);
  for (int n = 0; n < 300; ++n)
  {
    const dvec3 p = 0.5 * (low + high) + dvec3(any(random), any(random), any(random));
    double brute = 1e9;
    for (const dvec3& q : cloud)
      brute = std::min(brute, glm::length(p - q));
    const double d = std::abs(solid.Distance(p).mm);
    ASSERT_LE(d, brute + 1e-9);
    // A surface that leans no more than 1/sqrt(3) from some axis has a ray within step / sqrt(2)
    // of each point, and so a root within sqrt(3/2) of that.
    ASSERT_LE(brute, d + 0.5 * std::sqrt(2.0) * std::sqrt(3.0) * Step + 1e-9);
  }
}

TEST(PhantomAnatomy, DistanceIsLipschitzAndItsGradientHasLengthOne)
{
  const AnalyticSolid solid = hasp::PhantomSolid(With(hasp::PhantomAnatomy::HeadAndFibula));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  int tried = 0;
  ForPointsNear(solid, 3.0, 400,
    [&](const dvec3& p, const hasp::SolidDistance& d)
    {
      const dvec3 q = p + dvec3(unit(random), unit(random), unit(random));
      const hasp::SolidDistance e = solid.Distance(q);
      ASSERT_LE(std::abs(d.mm - e.mm), glm::length(p - q) + d.errorMm + e.errorMm + 1e-11);
      constexpr double Step = 1e-4;
      dvec3 gradient;
      double apart = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        dvec3 step(0.0);
        step[a] = Step;
        const auto up = solid.Distance(p + step), down = solid.Distance(p - step);
        gradient[a] = (up.mm - down.mm) / (2.0 * Step);
        apart = std::max(apart, glm::length(up.nearest - down.nearest) + up.errorMm + down.errorMm);
      }
      // Not across a kink, and where the surface bends no more than 1/mm: Step^2 / 2 is left out.
      if (d.errorMm > 0.0 || apart > 4.0 * Step || std::abs(d.mm) < 2.0 * Step)
        return;
      ++tried;
      ASSERT_NEAR(glm::length(gradient), 1.0, 1e-6);
    });
  EXPECT_GT(tried, 300);
}

TEST(PhantomAnatomy, LandmarksLieOnTheirPartsAndLeftIsLeft)
{
  for (const dvec3& center : { dvec3(0.0), dvec3(12, -340, 95) })
  {
    PhantomSettings s = With(hasp::PhantomAnatomy::HeadAndFibula);
    s.center = center;
    std::map<std::string, dvec3> at;
    for (const hasp::PhantomLandmark& mark : hasp::PhantomLandmarks(s))
    {
      EXPECT_NEAR(hasp::PhantomSolid(s, mark.part).Distance(mark.point).mm, 0.0, 1e-9) << mark.name;
      at[mark.name] = mark.point - center;
    }
    EXPECT_GT(at.at("condylion left").x, 40.0);
    EXPECT_LT(at.at("condylion right").x, -40.0);
    EXPECT_GT(at.at("gonion left").x, 40.0);
    EXPECT_LT(at.at("menton").z, at.at("gonion left").z);
    EXPECT_LT(at.at("menton").y, -70.0);
    // Adults: 110 to 130 mm from condylion to menton... a short face; 95 to 115 between gonia.
    EXPECT_NEAR(glm::length(at.at("condylion left") - at.at("menton")), 110.0, 10.0);
    EXPECT_NEAR(at.at("gonion left").x - at.at("gonion right").x, 102.0, 8.0);
    EXPECT_NEAR(glm::length(at.at("fibula upper end") - at.at("fibula lower end")), 346.0, 1e-9);
    EXPECT_GT(at.at("coronoid tip left").z, at.at("coronoid tip right").z + 2.0) << "asymmetric";
  }
}

TEST(PhantomAnatomy, JawsDoNotTouch)
{
  const AnalyticSolid upper = AnalyticSolid::Union({ hasp::PhantomSolid({}, PhantomPart::Cranium),
    hasp::PhantomSolid({}, PhantomPart::UpperTeeth) });
  const AnalyticSolid lower = AnalyticSolid::Union({ hasp::PhantomSolid({}, PhantomPart::Mandible),
    hasp::PhantomSolid({}, PhantomPart::LowerTeeth) });
  ForPointsNear(lower, 0.5, 4000,
    [&](const dvec3& p, const hasp::SolidDistance&) { ASSERT_GT(upper.Bound(p).mm, 2.0); });
}

TEST(PhantomAnatomy, TeethStandInTheirJaws)
{
  for (const auto& [teeth, jaw] : { std::pair(PhantomPart::UpperTeeth, PhantomPart::Cranium),
         std::pair(PhantomPart::LowerTeeth, PhantomPart::Mandible) })
  {
    const AnalyticSolid bone = hasp::PhantomSolid({}, jaw), row = hasp::PhantomSolid({}, teeth);
    int inJaw = 0, points = 0;
    ForPointsNear(row, 1.0, 2000,
      [&](const dvec3& p, const hasp::SolidDistance& d)
      {
        points += d.mm < 0.0;
        inJaw += d.mm < 0.0 && bone.Bound(p).mm < 0.0;
      });
    EXPECT_GT(inJaw, 0.2 * points);
    EXPECT_LT(inJaw, 0.8 * points);
  }
}

TEST(PhantomAnatomy, MissingTeethTellLeftFromRight)
{
  const AnalyticSolid upper = hasp::PhantomSolid({}, PhantomPart::UpperTeeth);
  int different = 0;
  ForPointsNear(upper, 1.0, 2000,
    [&](const dvec3& p, const hasp::SolidDistance&)
    {
      const double mirrored = upper.Bound({ -p.x, p.y, p.z }).mm;
      different += mirrored > 1.0 && upper.Bound(p).mm < 0.0;
      if (mirrored > 1.0 && upper.Bound(p).mm < 0.0)
      {
        ASSERT_LT(p.x, 0.0) << "the missing upper tooth is a left one";
      }
    });
  EXPECT_GT(different, 10);
}

TEST(PhantomAnatomy, FibulaIsAsThickAsAFibula)
{
  const AnalyticSolid fibula =
    hasp::PhantomSolid(With(hasp::PhantomAnatomy::Fibula), PhantomPart::Fibula);
  for (const double z : { -100.0, -30.0, 0.0, 70.0, 110.0 })
  {
    double least = 1e9, most = 0.0; // widths over all directions in the section
    for (double angle = 0.0; angle < 3.14; angle += 0.1)
    {
      const dvec3 way(std::cos(angle), std::sin(angle), 0.0);
      double low = 1e9, high = -1e9;
      for (double x = -12.0; x < 12.0; x += 0.4)
        for (double y = -16.0; y < 10.0; y += 0.4)
          if (fibula.Bound({ x, y, z }).mm < 0.0)
          {
            low = std::min(low, x * way.x + y * way.y);
            high = std::max(high, x * way.x + y * way.y);
          }
      least = std::min(least, high - low);
      most = std::max(most, high - low);
    }
    EXPECT_GT(least, 11.0) << z; // 12 less what the lattice misses
    EXPECT_LT(most, 16.0) << z;
  }
}

} // namespace
