#include "Evaluation/ShellThickness.h"
#include "Evaluation/WallThickness.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

hasp::WallThickness WallsOf(const hasp::TriangleMesh& mesh)
{
  const hasp::TriangleTree tree(mesh);
  const auto samples = hasp::SampleMesh(mesh, 0.5);
  return hasp::MeasureWalls(samples, hasp::MeasureChords(tree, samples));
}

TEST(WallThickness, IsThatOfAPlateWhereverItLies)
{
  for (int seed = 0; seed < 6; ++seed)
  {
    const auto plate =
      parttest::Blocks({ 0, 20 }, { 0, 15 }, { 0, 2.5 }, [](int, int, int) { return true; });
    const auto walls = WallsOf(parttest::AnyMotion(seed)(plate));
    EXPECT_NEAR(walls.leastMm, 2.5, 1e-9);
    EXPECT_NEAR(walls.p5Mm, 2.5, 1e-9);
    EXPECT_NEAR(walls.p50Mm, 2.5, 1e-9); // 600 of 775 mm2 are its two large sides
    EXPECT_NEAR(walls.wallMm2, 2 * (300 + 37.5 + 50), 1e-6);
  }
}

TEST(WallThickness, FindsAThinPlaceAndSaysWhere)
{
  // 2.5 mm, but for a pit of 2 x 1 mm with 0.4 mm below it.
  const auto plate = parttest::Blocks({ 0, 11, 13, 20 }, { 0, 6, 7, 15 }, { 0, 0.4, 2.5 },
    [](int i, int j, int k) { return k == 0 || i != 1 || j != 1; });
  for (int seed = 0; seed < 6; ++seed)
  {
    const auto motion = parttest::AnyMotion(seed);
    const auto walls = WallsOf(motion(plate));
    EXPECT_NEAR(walls.leastMm, 0.4, 1e-9);
    const glm::dvec3 off = walls.leastAt - motion.Place({ 12, 6.5, 0.2 });
    EXPECT_LT(glm::length(off), 1.2); // anywhere in the pit
    EXPECT_NEAR(glm::dot(off, motion.Turn({ 0, 0, 1 })), 0.0, 1e-9);
  }
}

TEST(WallThickness, AnEdgeIsNoWall)
{
  // A wedge of 30 degrees runs out to nothing; a ball has no thin place at its side.
  hasp::TriangleMesh wedge{ { { 0, 0, 0 }, { 10, 0, 0 },
                              { 10, 0, 10 * std::tan(glm::pi<double>() / 6) }, { 0, 9, 0 },
                              { 10, 9, 0 }, { 10, 9, 10 * std::tan(glm::pi<double>() / 6) } },
    { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4 }, { 0, 4, 1 }, { 1, 4, 5 }, { 1, 5, 2 }, { 0, 2, 5 },
      { 0, 5, 3 } } };
  ASSERT_TRUE(hasp::CheckMesh(wedge).Sound());
  EXPECT_NEAR(WallsOf(wedge).leastMm, 9.0, 1e-9); // between its triangles alone
  // Of 10 mm; its triangles lie up to 10 (1 - cos 4.5 degrees) inside.
  EXPECT_NEAR(WallsOf(parttest::Ball(10, 20)).leastMm, 20.0, 0.6);
}

TEST(WallThickness, WhatIsSmallerThanAPrintersDetailIsNoWall)
{
  // A fin, 0.1 mm thick: of 0.3 x 0.2 mm nobody prints; of 0.9 x 0.6 mm a thin wall is left.
  for (const double size : { 0.3, 0.9 })
  {
    const auto finned =
      parttest::Blocks({ 0, 6, 6.1, 20 }, { 0, 7, 7 + size, 15 }, { 0, 2.5, 2.5 + 2 * size / 3 },
        [](int i, int j, int k) { return k == 0 || (i == 1 && j == 1); });
    EXPECT_NEAR(WallsOf(finned).leastMm, size > 0.5 ? 0.1 : 2.5, 1e-9);
  }
}

/// A plate of 20 x 15 mm and this thickness over z = 0, which is bone.
struct Shell
{
  explicit Shell(const hasp::TriangleMesh& mesh)
    : samples(hasp::SampleMesh(mesh, 0.5)),
      chords(hasp::MeasureChords(hasp::TriangleTree(mesh), samples))
  {
    for (const auto& s : this->samples)
      this->nearest.push_back(s.point.z < 1.5 ? std::optional(hasp::NearestSurface{ s.point.z,
                                                  { s.point.x, s.point.y, 0 }, { 0, 0, 1 } })
                                              : std::nullopt);
  }
  hasp::ShellThickness Measure(const std::optional<glm::dvec3>& withdrawal = {}) const
  {
    return hasp::MeasureShell(
      this->samples, this->chords, this->nearest, { 0.3, 0.2, 0.8, withdrawal });
  }
  std::vector<hasp::MeshSample> samples;
  std::vector<hasp::Chord> chords;
  std::vector<std::optional<hasp::NearestSurface>> nearest;
};

TEST(ShellThickness, IsMeasuredFromTheSideThatFacesBone)
{
  const Shell whole(
    parttest::Blocks({ 0, 20 }, { 0, 15 }, { 0.3, 2.8 }, [](int, int, int) { return true; }));
  EXPECT_NEAR(whole.Measure().shellMm2, 300.0, 1e-9);
  EXPECT_NEAR(whole.Measure().leastMm, 2.5, 1e-9);
  // A pit from outside, and one from inside: of either, what is left.
  for (const bool outside : { true, false })
  {
    const Shell dented(parttest::Blocks({ 0, 11, 13, 20 }, { 0, 6, 7, 15 }, { 0.3, 1.2, 2.8 },
      [&](int i, int j, int k) { return i != 1 || j != 1 || (k == 0) == outside; }));
    EXPECT_NEAR(dented.Measure(glm::dvec3(0, 0, 1)).leastMm, outside ? 0.9 : 1.6, 1e-9);
    EXPECT_NEAR(dented.Measure().shellMm2, 300.0, 1e-9);
  }
  // Walls along the withdrawal direction are where undercuts were blocked out.
  EXPECT_EQ(whole.Measure(glm::dvec3(1, 0, 0)).shellMm2, 0.0);
}

TEST(ShellThickness, SizesThatDifferThrow)
{
  const Shell shell(
    parttest::Blocks({ 0, 2 }, { 0, 2 }, { 0.3, 2.8 }, [](int, int, int) { return true; }));
  EXPECT_THROW(hasp::MeasureShell(shell.samples, {}, shell.nearest, {}), std::invalid_argument);
}

} // namespace
