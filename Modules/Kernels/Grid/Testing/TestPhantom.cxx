#include "Grid/GridView.h"
#include "Grid/Phantom.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

using hasp::PhantomSettings;

/// Every number among the settings.
std::vector<double*> NumbersOf(PhantomSettings& s)
{
  return { &s.center.x, &s.center.y, &s.center.z, &s.skinRadii.x, &s.skinRadii.y, &s.skinRadii.z,
    &s.scalpMm, &s.skullMm, &s.skullBaseMm, &s.tableMm, &s.jawCortexMm, &s.fibulaCortexMm,
    &s.enamelMm, &s.airHU, &s.softHU, &s.boneHU, &s.diploeHU, &s.jawMarrowHU, &s.fibulaMarrowHU,
    &s.dentineHU, &s.enamelHU, &s.edgeMm, &s.blurMm.x, &s.blurMm.y, &s.blurMm.z, &s.sliceMm,
    &s.noiseHU, &s.fieldRadiusMm, &s.metal.crownHU, &s.metal.streakHU, &s.metal.bandHU,
    &s.metal.decayMm, &s.metal.sliceMm, &s.coneBeam.scale, &s.coneBeam.offset, &s.coneBeam.cupping,
    &s.coneBeam.cupRadiusMm };
}

TEST(Phantom, BadSettingsAreRefused)
{
  PhantomSettings s;
  const std::size_t count = NumbersOf(s).size();
  for (std::size_t n = 0; n < count; ++n)
    for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
           std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
    {
      s = {};
      *NumbersOf(s)[n] = bad;
      EXPECT_THROW(hasp::PhantomSolid(s), std::invalid_argument) << n << ": " << bad;
      EXPECT_THROW(hasp::SamplePhantom({ { 2, 2, 2 }, {}, { 1, 1, 1 } }, s), std::invalid_argument);
    }
  for (double PhantomSettings::*positive : { &PhantomSettings::scalpMm, &PhantomSettings::skullMm,
         &PhantomSettings::tableMm, &PhantomSettings::jawCortexMm, &PhantomSettings::edgeMm })
  {
    s = {};
    s.*positive = 0.0;
    EXPECT_THROW(hasp::PhantomBone(s), std::invalid_argument);
  }
  s = {};
  s.noiseHU = -1.0;
  EXPECT_THROW(hasp::SamplePhantom({ { 2, 2, 2 }, {}, { 1, 1, 1 } }, s), std::invalid_argument);
  s = {};
  s.coneBeam.cupping = 1.0;
  EXPECT_THROW(hasp::PhantomLandmarks(s), std::invalid_argument);
  EXPECT_THROW(hasp::PhantomGrid({ 1, 0, 1 }), std::invalid_argument);
  EXPECT_THROW(hasp::PhantomGrid({ 1, 1, std::nan("") }), std::invalid_argument);
  EXPECT_THROW(hasp::PhantomGrid({ 1, 1, 1e-9 }), std::invalid_argument);
  EXPECT_THROW(hasp::PhantomGridOfSize({ 1, 10, 10 }), std::invalid_argument);
  EXPECT_THROW(hasp::PhantomOuterTable({}, { 0, 0, 0 }), std::invalid_argument);
  EXPECT_THROW(hasp::PhantomSolid({}, hasp::PhantomPart::Fibula), std::invalid_argument);
}

TEST(Phantom, BoneFieldNeverOverstatesTheDistance)
{
  const auto bone = hasp::PhantomBone({});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-100, 100), small(-2, 2);
  for (int n = 0; n < 20000; ++n)
  {
    const glm::dvec3 a(any(random), any(random), any(random));
    const glm::dvec3 b = a + glm::dvec3(small(random), small(random), small(random));
    ASSERT_LE(std::abs(bone.value(a) - bone.value(b)), glm::length(a - b) + 1e-9);
  }
}

TEST(Phantom, RaysFromOutsideMeetTheOuterTable)
{
  PhantomSettings s;
  s.center = { 10, -20, 30 };
  s.defect = false;
  const auto bone = hasp::PhantomBone(s);
  for (const glm::dvec3& d : { glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0.2), glm::dvec3(1, 0.1, 0.3),
         glm::dvec3(-0.45, -0.7, 0.55) })
  {
    const glm::dvec3 unit = glm::normalize(d), start = s.center + 200.0 * unit;
    const auto t = hasp::FirstSurface(bone, start, -unit, 0.0, 200.0);
    ASSERT_TRUE(t);
    // FirstSurface bisects to 1e-12 of the range.
    EXPECT_LT(glm::length(start - *t * unit - hasp::PhantomOuterTable(s, d)), 1e-8);
  }
}

TEST(Phantom, DefectIsAHoleInTheRightFrontalBoneAndOnlyThere)
{
  const PhantomSettings s;
  const auto hole = hasp::DefectOf(s);
  EXPECT_LT(hole.center.x, -20.0) << "right";
  EXPECT_LT(hole.center.y, -40.0) << "anterior";
  EXPECT_GT(hole.center.z, 20.0) << "superior";
  EXPECT_NEAR(glm::dot(glm::cross(hole.outward, hole.along), hole.across), 1.0, 1e-12);
  const auto bone = hasp::PhantomBone(s);
  const auto boneBelow = [&](const glm::dvec3& at)
  {
    for (double depth = -2.0; depth < 12.0; depth += 0.1)
      if (bone.value(at - depth * hole.outward) > 0.0)
        return true;
    return false;
  };
  EXPECT_FALSE(boneBelow(hole.center));
  EXPECT_FALSE(boneBelow(hole.center + (0.5 * hole.lengthMm - 0.5) * hole.along));
  EXPECT_FALSE(boneBelow(hole.center - (0.5 * hole.widthMm - 0.5) * hole.across));
  EXPECT_TRUE(boneBelow(hole.center + (0.5 * hole.lengthMm + 0.5) * hole.along));
  EXPECT_TRUE(boneBelow(hole.center - (0.5 * hole.widthMm + 0.5) * hole.across));
  const glm::dvec3 left(-hole.center.x, hole.center.y, hole.center.z);
  EXPECT_GT(bone.value(left * 0.96), 0.0) << "the left frontal bone is whole";
}

TEST(Phantom, SamplesAgreeWithTheFieldOnARotatedAnisotropicGrid)
{
  const PhantomSettings s;
  const double c = 0.8, q = 0.6;
  const hasp::GridGeometry g{ { 40, 38, 36 }, { -60, -120, -80 }, { 4.1, 4.7, 5.3 },
    glm::dmat3(c, q, 0, -q, c, 0, 0, 0, 1) };
  const auto samples = hasp::SamplePhantom(g, s);
  const auto bone = hasp::PhantomBone(s);
  int inBone = 0;
  std::size_t n = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i, ++n)
      {
        const double b = bone.value(g.IndexToWorld({ i, j, k }));
        // Beyond half the soft edge a sample is bone or has none; the mandible's marrow is least.
        if (b > 0.5 * s.edgeMm)
        {
          ASSERT_GE(samples[n], s.jawMarrowHU);
        }
        else if (b < -0.5 * s.edgeMm)
        {
          ASSERT_LE(samples[n], s.softHU);
        }
        inBone += b > 0.5 * s.edgeMm;
      }
  EXPECT_GT(inBone, 1000);
}

TEST(Phantom, NoiseHasTheSpreadAskedForAndFollowsTheSeed)
{
  const hasp::GridGeometry brain{ { 20, 20, 20 }, { -10, -10, -10 }, { 1, 1, 1 } };
  PhantomSettings s;
  s.noiseHU = 25.0;
  const auto a = hasp::SamplePhantom(brain, s);
  EXPECT_EQ(a, hasp::SamplePhantom(brain, s));
  s.seed = 2;
  EXPECT_NE(a, hasp::SamplePhantom(brain, s));
  double sum = 0, squares = 0;
  for (const double v : a)
  {
    sum += v - s.softHU;
    squares += (v - s.softHU) * (v - s.softHU);
  }
  // 8000 draws: the mean's standard error is 0.28 HU, the deviation's 0.2 HU; five of each.
  EXPECT_NEAR(sum / a.size(), 0.0, 1.4);
  EXPECT_NEAR(std::sqrt(squares / a.size()), 25.0, 1.0);
}

TEST(Phantom, GridHoldsTheWholeHeadInAir)
{
  const auto g = hasp::PhantomGrid({ 6, 5, 7 });
  const auto samples = hasp::SamplePhantom(g);
  const hasp::GridView<const std::int16_t> view{ samples.data(), g };
  const glm::ivec3 last = g.dims - 1;
  for (int k = 0; k <= last.z; ++k)
    for (int j = 0; j <= last.y; ++j)
      for (int i = 0; i <= last.x; ++i)
        if (i * j * k == 0 || i == last.x || j == last.y || k == last.z)
        {
          ASSERT_EQ(view(i, j, k), -1000);
        }
  EXPECT_GE(*std::max_element(samples.begin(), samples.end()), 1000);
}

} // namespace
