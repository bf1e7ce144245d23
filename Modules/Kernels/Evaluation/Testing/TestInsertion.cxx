#include "Evaluation/BonePieces.h"
#include "Evaluation/Insertion.h"
#include "Grid/AnalyticVolumes.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

/// Bone: a mushroom under any rotation. A post of radius 6 along z up to z = 10, and a ball of
/// radius 9 on top of it at z = 14. Values are 0 on its surface, 1 a mm.
struct Mushroom
{
  explicit Mushroom(const parttest::Motion& motion)
  {
    this->grid = { glm::ivec3(81), {}, glm::dvec3(0.6), motion.turn };
    this->grid.origin = motion.Place({ -24, -24, -20 });
    const hasp::AnalyticVolume bone{ "mushroom", [motion](const glm::dvec3& world)
      {
        const glm::dvec3 p = (world - motion.to) * motion.turn;
        return std::max(
          std::min(6 - std::hypot(p.x, p.y), 10 - p.z), 9 - glm::length(p - glm::dvec3(0, 0, 14)));
      } };
    this->samples = hasp::SampleAnalytic<float>(bone, this->grid, 1, 0);
  }
  hasp::AnyGridView View() const
  {
    return hasp::GridView<const float>{ this->samples.data(), this->grid };
  }
  hasp::Insertion Lift(const hasp::TriangleMesh& part, const glm::dvec3& direction) const
  {
    hasp::InsertionSettings settings;
    settings.isovalue = 0;
    settings.direction = direction;
    return hasp::MeasureInsertion(this->View(), hasp::SampleMesh(part, 0.5), settings);
  }
  hasp::GridGeometry grid;
  std::vector<float> samples;
};

TEST(Insertion, ARingUnderAMushroomCannotBeTakenOff)
{
  for (int seed = 0; seed < 3; ++seed)
  {
    const auto motion = parttest::AnyMotion(seed);
    const Mushroom bone(motion);
    parttest::Motion low = motion;
    low.to = motion.Place({ 0, 0, -5 });
    const glm::dvec3 up = motion.Turn({ 0, 0, 1 });
    // A ring around the post, wider than it by 0.5 mm: the ball is in its way, but not below.
    const auto narrow = low(parttest::Tube(6.5, 8.5, 4, 48));
    const auto lifted = bone.Lift(narrow, up);
    EXPECT_GT(lifted.blocked, 50U);
    // The ring's innermost wall passes sqrt(9^2 - 6.5^2) mm of the ball on either side of its
    // middle, which is as deep as it gets: 9 - 6.5.
    EXPECT_EQ(lifted.deepestMm, hasp::Insertion::BeyondMm);
    EXPECT_NEAR(glm::dot(lifted.boneAt - motion.to, up), 14.0, 0.5);
    EXPECT_LT(glm::dot(lifted.partAt - motion.to, up), -2.0);
    EXPECT_EQ(bone.Lift(narrow, -up).blocked, 0U);
    // One that is wider than the ball passes.
    EXPECT_EQ(bone.Lift(low(parttest::Tube(9.2, 11.2, 4, 48)), up).blocked, 0U);
  }
}

TEST(Insertion, HowDeepIsTrueAndLittleIsLetThrough)
{
  const auto motion = parttest::AnyMotion(1);
  const Mushroom bone(motion);
  parttest::Motion low = motion;
  low.to = motion.Place({ 0, 0, -5 });
  const glm::dvec3 up = motion.Turn({ 0, 0, 1 });
  // Sides 0.5 mm inside the ball's widest: the corners of a ring of 48 are 0.2 % farther out, the
  // trilinear ball lies up to 0.6^2 / (4 * 9) mm inside the sphere.
  const auto lifted = bone.Lift(low(parttest::Tube(8.5, 11.5, 4, 48)), up);
  EXPECT_GT(lifted.blocked, 0U);
  EXPECT_NEAR(lifted.deepestMm, 0.5, 0.03 + 0.3); // the innermost place is 0.25 mm out of the wall
  // 0.03 mm deep, below the 0.05 that count.
  EXPECT_EQ(bone.Lift(low(parttest::Tube(8.97, 11.5, 4, 48)), up).blocked, 0U);
}

TEST(Insertion, CrumbsAreNoBone)
{
  hasp::GridGeometry grid{ glm::ivec3(40), glm::dvec3(0), glm::dvec3(0.5), glm::dmat3(1) };
  std::vector<std::int16_t> samples(grid.Size(), -1000);
  const auto fill = [&](const glm::ivec3& low, const glm::ivec3& high)
  {
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
          samples[(std::size_t(k) * 40 + j) * 40 + i] = 1000;
  };
  fill({ 0, 0, 0 }, { 39, 39, 5 });     // bone: 2.5 mm at the bottom
  fill({ 18, 18, 20 }, { 21, 21, 21 }); // a crumb of 32 samples, 4 mm3
  const hasp::AnyGridView ct = hasp::GridView<const std::int16_t>{ samples.data(), grid };
  const auto part = hasp::SampleMesh(
    parttest::Blocks({ 5, 15 }, { 5, 15 }, { 3.5, 5 }, [](int, int, int) { return true; }), 0.5);
  hasp::InsertionSettings s;
  s.ignoreBelowMm3 = 4.0;
  EXPECT_GT(hasp::MeasureInsertion(ct, part, s).blocked, 0U);
  s.ignoreBelowMm3 = 4.2;
  EXPECT_EQ(hasp::MeasureInsertion(ct, part, s).blocked, 0U);
  fill({ 18, 18, 30 }, { 21, 21, 39 }); // bone behind the crumb still counts
  s.ignoreBelowMm3 = 15.0;
  const auto behind = hasp::MeasureInsertion(ct, part, s);
  EXPECT_GT(behind.blocked, 0U);
  EXPECT_GT(behind.boneAt.z, 14.5);

  hasp::BonePieces pieces(ct, 226, 15.0);
  EXPECT_TRUE(pieces.Counts({ 3, 3, 1 }));
  EXPECT_FALSE(pieces.Counts({ 10, 10, 10.2 }));
  EXPECT_FALSE(pieces.Counts({ 10, 10, 10.3 })); // as known
  EXPECT_TRUE(pieces.Counts({ 10, 10, 17 }));
  EXPECT_FALSE(pieces.Counts({ 3, 3, 10 })); // no bone
  EXPECT_FALSE(pieces.Counts({ -3, 3, 1 })); // outside
}

TEST(Insertion, BadSettingsThrow)
{
  const Mushroom bone(parttest::AnyMotion(0));
  EXPECT_THROW(bone.Lift({}, glm::dvec3(0)), std::invalid_argument);
  EXPECT_EQ(bone.Lift({}, { 0, 0, 1 }).samples, 0U);
}

} // namespace
