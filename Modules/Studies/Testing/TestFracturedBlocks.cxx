#include "Studies/FracturedBlocks.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using hasp::FracturedBlocks;

FracturedBlocks Made(int pieces, double lostMm = 0.0)
{
  return hasp::MakeFracturedBlocks(
    { .pieces = pieces, .sideMm = { 20, 16, 16 }, .lostMm = lostMm, .points = 2048, .seed = 3 });
}

const FracturedBlocks& InTwo()
{
  static const FracturedBlocks made = Made(2);
  return made;
}

/// The least signed distance of the moved piece's points to the others, and of how many a face is
/// within 0.1 mm of one that looks at it.
struct Met
{
  double deepest = std::numeric_limits<double>::infinity();
  int faces = 0, points = 0;
};
Met Meet(const FracturedBlocks& blocks, const glm::dvec3& shift = glm::dvec3(0.0))
{
  Met met;
  hasp::RigidPose pose = blocks.Moved().whole.bodyInWorld;
  pose.position += shift;
  for (const hasp::OrientedPoint& point : blocks.Moved().whole.body->Points(4096))
  {
    ++met.points;
    for (const hasp::PlacedBody& other : blocks.SceneOfOthers().partners)
    {
      const auto foot =
        other.body->FootOf(other.bodyInWorld.Inverse().Place(pose.Place(point.place)));
      if (!foot)
        continue;
      met.deepest = std::min(met.deepest, foot->mm);
      met.faces += std::abs(foot->mm) < 0.1 && glm::dot(foot->outward, point.normal) < -0.8;
    }
  }
  return met;
}

TEST(FracturedBlocks, WhatCannotBeBrokenIsRefused)
{
  const auto refused = [](auto change)
  {
    hasp::FracturedBlockSettings settings;
    change(settings);
    EXPECT_THROW(hasp::MakeFracturedBlocks(settings), std::invalid_argument);
  };
  refused([](auto& s) { s.pieces = 1; });
  refused([](auto& s) { s.pieces = 4; });
  refused([](auto& s) { s.sideMm.y = 5.0; });
  refused([](auto& s) { s.roughMm = -0.1; });
  refused([](auto& s) { s.roughMm = std::nan(""); });
  refused([](auto& s) { s.spacingMm = 0.0; });
  refused([](auto& s) { s.shortestMm = 1.0; });
  refused([](auto& s) { s.longestMm = 1.0; });
  refused([](auto& s) { s.lostMm = HUGE_VAL; });
  refused([](auto& s) { s.points = 0; });
  refused([](auto& s) { s.coarsest = 0; });
}

// Both sides of a break are one surface. What is left is what trilinear cells make of its waves:
// those of 2 mm are 4 voxels long, and what they bend within one is under a fifth of it.
TEST(FracturedBlocks, AtTheTruthFacesTouchAllOverAndNothingOverlaps)
{
  for (const int pieces : { 2, 3 })
  {
    const FracturedBlocks blocks = pieces == 2 ? InTwo() : Made(pieces);
    ASSERT_EQ(int(blocks.pieces.size()), pieces);
    const Met met = Meet(blocks);
    EXPECT_GT(met.deepest, -0.1) << pieces;
    // A face of 20 x 16 mm, or one of half the length and one of 16 x 8 mm, of the whole surface.
    const double faces = pieces == 2 ? 20.0 * 16.0 : 10.0 * 16.0 + 16.0 * 8.0;
    EXPECT_GT(
      met.faces / double(met.points), 0.9 * faces / blocks.Moved().whole.body->SurfaceArea())
      << pieces;
    // Half a millimetre in, along the push: they overlap by the share of it that is along normals.
    EXPECT_LT(Meet(blocks, 0.5 * blocks.push).deepest, -0.3) << pieces;
  }
}

TEST(FracturedBlocks, FacesLoseNoMoreThanWasAskedFor)
{
  const Met whole = Meet(InTwo()), lost = Meet(Made(2, 0.4));
  EXPECT_LT(lost.faces, whole.faces / 2); // the lost share runs from 0 to 1
  EXPECT_GT(lost.faces, 0);
  EXPECT_GT(lost.deepest, -0.1);
}

TEST(FracturedBlocks, ASeedIsAFace)
{
  const hasp::FracturedBlockSettings small{ .sideMm = { 10, 10, 10 }, .points = 256 };
  hasp::FracturedBlockSettings other = small;
  other.seed = 2;
  const FracturedBlocks a = hasp::MakeFracturedBlocks(small), b = hasp::MakeFracturedBlocks(small),
                        c = hasp::MakeFracturedBlocks(other);
  const glm::dvec3 place(1.3, -2.1, 0.2);
  EXPECT_EQ(a.pieces[0].map->At(place).mm, b.pieces[0].map->At(place).mm);
  EXPECT_NE(a.pieces[0].map->At(place).mm, c.pieces[0].map->At(place).mm);
}

} // namespace
