// Kernels against each other: vectors against one point after the other, int16 against float.
#include "Grid/Testing/CountNew.h"
#include "Haptics/CoarsePhase.h"
#include "Haptics/PointShell.h"
#include "Testing/ContactReaders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <span>
#include <string>

namespace
{

using namespace hasp;

constexpr double Radius = 9.0;

const GridGeometry Grid = hasp::testing::SkewGrid({ 56, 36, 25 });
const hasp::testing::DistanceFunction Bumpy = hasp::testing::BumpyBall(Radius, 0.8);

/// Forces relative to how hard the body is pressed, torques to that at the shell's radius: sums may
/// cancel to nothing.
double WrenchError(const ContactSums& a, const ContactSums& b, double lever)
{
  double worst = std::abs(a.energy - b.energy) / b.energy;
  const auto compare = [&](const Wrench& u, const Wrench& v)
  {
    const double force = glm::length(v.force);
    worst = std::max(worst, glm::length(u.force - v.force) / force);
    worst = std::max(worst, glm::length(u.torque - v.torque) / (force * lever));
  };
  compare(a.contact, b.contact);
  if (b.attractedArea > 0.0)
    compare(a.attraction, b.attraction);
  return worst;
}

/// Relative to the diagonal. What a point adds is there or not, so one that is at the very surface
/// makes a step: `flips` of them may.
double MatrixError(const ContactSums& a, const ContactSums& b, double lever, double flips)
{
  double worst = 0.0;
  const double size = b.matrix[0] + b.matrix[6] + b.matrix[11];
  for (std::size_t n = 0; n < a.matrix.size() && size > 0.0; ++n)
    worst = std::max(worst, std::abs(a.matrix[n] - b.matrix[n]) / (size * lever * lever));
  return worst - flips / b.contacts;
}

class Poses : public ::testing::Test
{
protected:
  Poses()
  {
    AddBall(this->Shell, 5000, 5.0);
    Dice dice(3);
    for (int n = 0; n < 5000; ++n)
      this->Areas.push_back(static_cast<float>(0.02 + 0.1 * dice()));
    for (int n = 0; n < 20; ++n)
    {
      const glm::dvec3 away = glm::normalize(dice.InBox(1.0));
      const double mm = Radius + 5.0 - 0.5 - 1.5 * dice(); // pressed in by 1 to 2 mm
      this->All.push_back({ away * mm, TurnBy(dice.InBox(2.0)) });
    }
  }
  ShellOfPoints Shell;
  std::vector<float> Areas;
  std::vector<RigidPose> All;
  const ContactSettings Settings{ .attraction = 0.01F, .captureMm = 3.0F };
};

TEST_F(Poses, VectorsAgreeWithOneByOne)
{
  const ContactMap map(Grid, 6.0, Bumpy);
  const ContactKernels scalar = ScalarContactKernels();
  for (const bool own : { false, true })
  {
    const ContactPoints points = this->Shell.Get(0.06F, own ? this->Areas : std::vector<float>());
    for (const RigidPose& pose : this->All)
      for (const ContactTerms terms : AllTerms)
      {
        ContactSums truth;
        scalar[terms](points, { pose }, map.Shorts(), this->Settings, truth);
        ASSERT_GT(truth.contacts, 50U);
        for (const ContactKernels& kernels : AllContactKernels())
        {
          ContactSums sums;
          kernels[terms](points, { pose }, map.Shorts(), this->Settings, sums);
          EXPECT_LE(WrenchError(sums, truth, 5.0), 1e-5) << kernels.name; // the promise
          // A point at the very surface may be on either side by the last bit.
          const int flips = std::abs(static_cast<int>(sums.contacts - truth.contacts));
          EXPECT_LE(flips, 1) << kernels.name;
          EXPECT_LE(MatrixError(sums, truth, 5.0, flips), 1e-5) << kernels.name;
          EXPECT_NEAR(sums.deepestMm, truth.deepestMm, 1e-5) << kernels.name;
          EXPECT_NEAR(sums.contactArea, truth.contactArea, 0.13) << kernels.name;
          EXPECT_NEAR(sums.attractedArea, truth.attractedArea, 0.13) << kernels.name;
        }
      }
  }
}

/// A shell all over its own surface, half of it pressed in: the contact of parts that fit.
TEST(ContactKernels, ShortsAgreeWithFloats)
{
  const double range = 16.0 * 0.7; // the default: sixteen of the smallest spacings
  const ContactMap map(Grid, range, Bumpy);
  ShellOfPoints shell;
  AddBall(shell, 6000, Radius);
  const ContactPoints points = shell.Get(0.06F);
  const ContactSettings settings{ .attraction = 0.01F, .captureMm = 3.0F };
  Dice dice(5);
  for (int n = 0; n < 10; ++n)
  {
    const RigidPose pose{ 0.5 * glm::normalize(dice.InBox(1.0)), TurnBy(dice.InBox(2.0)) };
    for (const ContactTerms terms : AllTerms)
    {
      ContactSums truth;
      ContactForceReference(terms, points, { pose }, map.Floats(), settings, truth);
      ASSERT_GT(truth.contacts, 2000U);
      for (const ContactKernels& kernels : AllContactKernels())
      {
        ContactSums sums;
        kernels[terms](points, { pose }, map.Shorts(), settings, sums);
        EXPECT_LE(WrenchError(sums, truth, Radius), 1e-4) << kernels.name; // the promise
        EXPECT_LE(MatrixError(sums, truth, Radius, 5.0), 1e-4) << kernels.name;
      }
    }
  }
}

/// A small contact lies in a few cells, and all of their points share those samples' rounding: half
/// a step is 9e-5 mm among depths of some tenths.
TEST_F(Poses, ShortsAreCloseToFloatsInASmallContact)
{
  const ContactMap map(Grid, 6.0, Bumpy);
  const ContactPoints points = this->Shell.Get(0.06F);
  for (const RigidPose& pose : this->All)
    for (const ContactTerms terms : AllTerms)
    {
      ContactSums truth;
      ContactForceReference(terms, points, { pose }, map.Floats(), this->Settings, truth);
      for (const ContactKernels& kernels : AllContactKernels())
      {
        ContactSums sums;
        kernels[terms](points, { pose }, map.Shorts(), this->Settings, sums);
        EXPECT_LE(WrenchError(sums, truth, 5.0), 5e-4) << kernels.name;
        EXPECT_LE(MatrixError(sums, truth, 5.0, 3.0), 5e-4) << kernels.name;
      }
    }
}

/// What ContactForce.h says of int16, for contact: of the wrench and of the energy, with what the
/// scene's sums tell of sum A and sum A d. And nothing of it is large: the rest is float's.
TEST_F(Poses, ShortsKeepToTheirBoundInASmallContact)
{
  for (const double range : { 3.0, 6.0, 12.0 })
  {
    const ContactMap map(Grid, range, Bumpy);
    const ContactPoints points = this->Shell.Get(0.06F);
    const double step = range / 32767.0, k = this->Settings.stiffness, lever = 5.0;
    const double perSpacing = glm::length(1.0 / Grid.spacing), steepest = map.Shorts().steepest;
    double closest = 0.0;
    for (const RigidPose& pose : this->All)
      for (const ContactTerms terms : { ContactTerms::Force, ContactTerms::Matrix })
      {
        ContactSums truth;
        ContactForceReference(terms, points, { pose }, map.Floats(), this->Settings, truth);
        for (const ContactKernels& kernels : AllContactKernels())
        {
          ContactSums sums;
          kernels[terms](points, { pose }, map.Shorts(), this->Settings, sums);
          const double area = std::max(truth.contactArea, sums.contactArea);
          const double depths = std::sqrt(area * 2.0 * truth.energy / k); // >= sum A d
          const bool gradient = terms != ContactTerms::Force;
          const double bound = k * 0.5 * step * area * (gradient ? steepest : 1.0) +
                               k * (gradient ? step * perSpacing * (depths + step * area) : 0.0);
          const double rounding = 1e-5 * k * depths;
          const double off = glm::length(sums.contact.force - truth.contact.force);
          EXPECT_LE(off, bound + rounding) << kernels.name << range;
          EXPECT_LE(
            glm::length(sums.contact.torque - truth.contact.torque), lever * (bound + rounding))
            << kernels.name << range;
          EXPECT_LE(std::abs(sums.energy - truth.energy),
            k * 0.5 * step * (depths + step * area) + 1e-5 * truth.energy)
            << kernels.name << range;
          closest = std::max(closest, off / bound);
        }
      }
    EXPECT_GT(closest, 0.05) << "of another order than what it bounds";
  }
}

TEST(ContactKernels, FeelAllOfItInWhatTheCoarsePhaseLeaves)
{
  const hasp::testing::SampledDistance body(Bumpy, Grid);
  const auto map = std::make_shared<const DistanceMap>(body.View());
  const auto shell = PointShell::OfSurface(body.View(), glm::dvec3(0.0), { .points = 4000 });
  CoarsePhase coarse(shell, map);
  const ContactSettings settings{ .attraction = 0.01F, .captureMm = 3.0F };
  const ContactKernels& kernels = FastestContactKernels();
  std::vector<ContactPoints> all, near;
  for (int level = 0; level < shell->Levels(); ++level)
    all.push_back(shell->Level(level));
  Dice dice(23);
  std::uint32_t left = 0, contacts = 0;
  for (int n = 0; n < 200; ++n)
  {
    // Steps of a walk around the body: what sleeps must wake.
    const double angle = 0.05 * n, apart = 2.0 * Radius + 4.0 * std::sin(0.31 * n) - 1.0;
    const RigidPose pose{ { apart * std::cos(angle), apart * std::sin(angle), 0.0 },
      TurnBy({ 0.1 * dice(), angle, 0.0 }) };
    ContactSums whole, part;
    kernels[ContactTerms::Snap](
      std::span<const ContactPoints>(all), { pose }, map->View(), settings, whole);
    coarse.Begin(pose, settings.captureMm);
    near.clear();
    for (int level = 0; level < shell->Levels(); ++level)
    {
      const std::span<const ContactPoints> runs = coarse.Near(level);
      near.insert(near.end(), runs.begin(), runs.end());
    }
    kernels[ContactTerms::Snap](
      std::span<const ContactPoints>(near), { pose }, map->View(), settings, part);
    for (const ContactPoints& run : near)
      left += run.count;
    contacts += whole.contacts;
    ASSERT_EQ(part.contacts, whole.contacts) << n;
    // The same points, added up in another order.
    EXPECT_NEAR(part.attractedArea, whole.attractedArea, 1e-5 * whole.attractedArea);
    EXPECT_NEAR(part.energy, whole.energy, 1e-5 * whole.energy);
    EXPECT_LE(glm::length(part.attraction.torque - whole.attraction.torque),
      1e-4 * glm::length(whole.attraction.force) * Radius);
  }
  EXPECT_GT(contacts, 1000U);
  EXPECT_LT(left, 200U * 3000U); // it did leave out points
}

TEST_F(Poses, KernelsAreRepeatable)
{
  const ContactMap map(Grid, 6.0, Bumpy);
  const ContactPoints points = this->Shell.Get(0.06F);
  for (const ContactKernels& kernels : AllContactKernels())
  {
    ContactSums one, two;
    kernels[ContactTerms::Snap](points, { this->All[0] }, map.Shorts(), this->Settings, one);
    kernels[ContactTerms::Snap](points, { this->All[0] }, map.Shorts(), this->Settings, two);
    EXPECT_EQ(one.contact.torque, two.contact.torque) << kernels.name;
    EXPECT_EQ(one.matrix, two.matrix) << kernels.name;
  }
}

TEST_F(Poses, KernelsTakeNoMemory)
{
  const ContactMap map(Grid, 6.0, Bumpy);
  const DistanceMapView<std::int16_t> view = map.Shorts();
  ContactPoints points = this->Shell.Get(0.06F, this->Areas);
  const ContactPoints withAreas = points;
  points.areas = nullptr;
  for (const ContactKernels& kernels : AllContactKernels())
    for (const ContactTerms terms : AllTerms)
    {
      const std::size_t before = hasp::test::NewCount();
      ContactSums sums;
      kernels[terms](points, { this->All[0] }, view, this->Settings, sums);
      kernels[terms](withAreas, { this->All[0] }, view, this->Settings, sums);
      EXPECT_EQ(hasp::test::NewCount(), before) << kernels.name;
      EXPECT_GT(sums.contacts, 0U);
    }
  const std::size_t before = hasp::test::NewCount();
  EXPECT_FALSE(AllContactKernels().empty());
  EXPECT_GT(hasp::test::NewCount(), before); // it does count, in the library too
}

TEST(ContactKernels, TheScalarOneIsFirstAndNamesDiffer)
{
  const std::vector<ContactKernels> all = AllContactKernels();
  ASSERT_FALSE(all.empty());
  EXPECT_STREQ(all[0].name, "scalar");
  std::set<std::string> names;
  for (const ContactKernels& kernels : all)
  {
    names.insert(kernels.name);
    for (const ContactTerms terms : AllTerms)
      EXPECT_NE(kernels[terms], nullptr) << kernels.name;
  }
  EXPECT_EQ(names.size(), all.size());
#if HASP_WITH_HIGHWAY && defined(__x86_64__)
  EXPECT_EQ(names.count("AVX2"), __builtin_cpu_supports("avx2") ? 1U : 0U);
#endif
}

TEST(ContactKernels, TheFastestIsOneOfThem)
{
  const ContactKernels& fastest = FastestContactKernels();
  const std::vector<ContactKernels> all = AllContactKernels();
  EXPECT_TRUE(std::any_of(
    all.begin(), all.end(), [&](const ContactKernels& k) { return k.byTerms == fastest.byTerms; }));
  EXPECT_EQ(&fastest, &FastestContactKernels()); // timed once
}

} // namespace
