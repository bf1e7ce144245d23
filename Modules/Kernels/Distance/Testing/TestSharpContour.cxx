#include "Distance/ContourSize.h"
#include "Distance/NearSurface.h"
#include "Distance/SharpContour.h"
#include "Distance/TetrahedraContour.h"
#include "Evaluation/MeshCheck.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif
#include "Testing/MovedSolid.h"
#include "Testing/RandomSolid.h"
#include "Testing/SlottedBlock.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <vector>

namespace
{

/// As an STL file keeps it and gives it back.
hasp::TriangleMesh Rounded(hasp::TriangleMesh mesh)
{
  for (glm::dvec3& p : mesh.points)
    p = glm::dvec3(glm::vec3(p));
  return hasp::WeldPoints(mesh);
}

hasp::MeshCheck CheckContour(const hasp::ImplicitSolid& solid, const hasp::GridGeometry& grid)
{
  return hasp::CheckMesh(Rounded(hasp::SharpContour(solid, grid)));
}

TEST(SharpContour, ABoxKeepsItsVolumeAndHasEightCorners)
{
  std::mt19937 random(3);
  int exact = 0;
  for (int n = 0; n < 4; ++n)
  {
    const auto axes = n == 0 ? glm::dmat3(1) : hasp::AnyAxes(random);
    const auto box = hasp::MakeBox({ 0.1, -0.13, 0.07 }, axes, { 3, 4, 2 });
    auto grid = hasp::GridAround(glm::dvec3(0), 6, 0.5);
    if (n == 3) // a left-handed grid must not turn the mesh inside out
      grid.direction[1] *= -1.0, grid.origin.y *= -1.0;
    const auto mesh = hasp::SharpContour(*box, grid);
    const auto check = hasp::CheckMesh(mesh);
    EXPECT_TRUE(check.Sound());
    EXPECT_EQ(check.pieces, 1U);
    // Flat to the last digits but for points that keep 1 % of an edge from grid points, and
    // corners of 0.1 mm: 0.02 % of it. The plain contour loses 0.5 %.
    EXPECT_NEAR(check.volumeMm3 / 192, 1.0, 4e-4) << n;
    EXPECT_NEAR(check.areaMm2 / 208, 1.0, 1e-3) << n;
    for (const double x : { -3.0, 3.0 })
      for (const double y : { -4.0, 4.0 })
        for (const double z : { -2.0, 2.0 })
        {
          const double off =
            hasp::DistanceToMesh(glm::dvec3(0.1, -0.13, 0.07) + axes * glm::dvec3(x, y, z), mesh);
          EXPECT_LT(off, 0.17) << n; // 0.34 of a cell
          exact += off < 1e-5;
        }
  }
  EXPECT_GE(exact, 20) << "of 32";
}

TEST(SharpContour, SlotsEdgesAndHolesAreTrue)
{
  std::mt19937 random(5);
  for (int n = 0; n < 3; ++n)
  {
    hasp::SlottedBlock block;
    if (n > 0)
      block = { { 0.13, -0.05, 0.17 * n }, n == 1 ? glm::dmat3(1) : hasp::AnyAxes(random) };
    const auto solid = block.Solid();
    const auto grid = hasp::GridAround(glm::dvec3(0), 9.2, 0.4);
    const auto sharp = hasp::MeasureSharpness(block, hasp::SharpContour(*solid, grid));
    EXPECT_LE(sharp.flat, 0.02) << n; // the bars of slots and holes at 0.4 mm
    EXPECT_LE(sharp.edge, 0.05) << n;
    EXPECT_LE(sharp.hole, 0.03) << n;
    EXPECT_LE(sharp.rim, 0.15) << n; // chords of circles beside
    EXPECT_LE(sharp.corner, 0.3) << n;
    // They tell a plain contour from a sharp one.
    const auto samples = hasp::DenseValues(hasp::EvaluateNearSurface(*solid, grid, 1.0));
    const auto plain =
      hasp::MeasureSharpness(block, hasp::ContourTetrahedra({ samples.data(), grid }));
    EXPECT_GT(plain.flat, 0.02) << n;
    EXPECT_GT(plain.edge, 0.2) << n;
  }
}

/// What the random trees of a test lie like.
struct Place
{
  double scale;
  glm::dvec3 at;
  bool turned;
};

TEST(SharpContour, RandomTreesAreSoundAsFloatsAtAnyScale)
{
  // Half of the shapes lie on grid points: coplanar, touching, slots along planes of voxels.
  // bin/BenchKernelSharpContour looks at 1,000 of them.
  const glm::dvec3 far(150, -180, 120);
  int meshes = 0;
  const auto check = [&](unsigned seed, double spacing, const Place& place)
  {
    std::mt19937 random(seed);
    const auto axes = place.turned ? hasp::AnyAxes(random) : glm::dmat3(1);
    const hasp::MovedSolid tree(
      hasp::RandomSolid(seed, 1 + int((seed - 1) % 4)), place.scale, place.at, axes);
    hasp::SharpContourFacts facts;
    const auto mesh = hasp::SharpContour(
      tree, hasp::GridAround(place.at, 6.0 * place.scale, spacing * place.scale), {}, &facts);
    if (mesh.triangles.empty())
      return;
    ++meshes;
    SCOPED_TRACE(testing::Message() << seed << " " << spacing << " " << place.scale);
    EXPECT_GE(facts.leastHeight, 0.05); // the proof: no part is turned over
    for (const glm::dvec3& p : mesh.points)
      ASSERT_EQ(p, glm::dvec3(glm::vec3(p)));
    ASSERT_TRUE(hasp::CheckMesh(hasp::WeldPoints(mesh)).Sound());
#if HASP_WITH_CGAL
    ASSERT_EQ(hasp::CountSelfIntersections(mesh), 0U);
#endif
  };
  for (unsigned n = 0; n < 6; ++n)
    for (const double spacing : { 0.5, 0.83 })
      for (const Place& place : { Place{ 1.0, {}, false }, Place{ 0.125, far, false },
             Place{ 0.125, far, true }, Place{ 0.08, 2.0 * far, true } })
        check(1001 + n, spacing, place);
  check(356, 0.83, { 0.125, far, false }); // met itself while thickness alone was looked at
  EXPECT_GE(meshes, 36);
#if !HASP_WITH_CGAL
  RecordProperty("SelfIntersections", "not checked: HASP_ENABLE_CGAL is off");
#endif
}

TEST(SharpContour, PartsThatTouchAreOneAndWhatIsTakenAwayLeavesNoSkin)
{
  const auto left = hasp::MakeBox({ -1, 0, 0 }, glm::dmat3(1), { 1, 1, 1 });
  const auto right = hasp::MakeBox({ 1, 0, 0 }, glm::dmat3(1), { 1, 1, 1 });
  const auto grid = hasp::GridAround(glm::dvec3(0), 3, 0.25); // points on all of their faces
  const auto both = CheckContour(*hasp::MakeUnion({ left, right }), grid);
  EXPECT_TRUE(both.Sound());
  EXPECT_EQ(both.pieces, 1U);
  // Faces on grid points are 1 % of a cell further in.
  EXPECT_NEAR(both.volumeMm3 / 16, 0.995, 0.0049);
  const auto none = hasp::SharpContour(*hasp::MakeDifference(left, left), grid);
  EXPECT_TRUE(none.triangles.empty());
}

TEST(SharpContour, WhatReachesTheBorderIsCutFlat)
{
  const auto half = hasp::MakePlane({ 0, 0, 0.03 }, { 0, 0, 1 });
  const auto check = CheckContour(*half, hasp::GridAround(glm::dvec3(0), 2, 0.5));
  EXPECT_TRUE(check.Sound());
  const double side = 4 - 2 * 0.125 * 0.5; // an eighth of a cell less at both ends
  EXPECT_NEAR(check.volumeMm3, side * side * (0.03 + 0.5 * side), 0.02);
  const auto all = hasp::MakeOffset(half, 100);
  EXPECT_NEAR(CheckContour(*all, hasp::GridAround(glm::dvec3(0), 2, 0.5)).volumeMm3,
    side * side * side, 0.02);
}

TEST(SharpContour, IsSoundWhereGridsAndPartsAreExtreme)
{
  const auto ball = hasp::MakeCapsule({ 0, 0, 0 }, { 0.3, 0, 0 }, 1);
  auto flat = hasp::GridAround(glm::dvec3(0), 2, 0.1);
  flat.dims.z = 5, flat.spacing.z = 10.0, flat.origin.z = -23; // 100 to 1, and a miss
  EXPECT_TRUE(hasp::SharpContour(*ball, flat).triangles.empty());
  flat.origin.z = -20; // one point of a hundred in the ball
  EXPECT_TRUE(CheckContour(*ball, flat).Sound());
  // Thinner than a cell: what is left is sound.
  for (const double width : { 0.3, 0.05, 1e-3 })
  {
    const auto slab = hasp::MakeSlab({ 0, 0, 0.01 }, { 1, 1, 3 }, width);
    const auto left = CheckContour(*slab, hasp::GridAround(glm::dvec3(0), 3, 0.5));
    EXPECT_TRUE(left.triangles == 0 || left.Sound()) << width;
  }
  // A slot below the grid's step, along a plane of points and across: sound, and no more lost.
  for (const double at : { 0.0, 0.21 })
  {
    const auto box = hasp::MakeBox({}, glm::dmat3(1), { 2, 2, 2 });
    const auto slot = hasp::MakeBox({ at, 0, 1.5 }, glm::dmat3(1), { 0.05, 3, 1 });
    const auto cut =
      CheckContour(*hasp::MakeDifference(box, slot), hasp::GridAround(glm::dvec3(0), 3, 0.5));
    EXPECT_TRUE(cut.Sound()) << at;
    EXPECT_GT(cut.volumeMm3, 64 - 0.8 - 0.8) << at; // faces on grid points are 1 % of a cell lower
    EXPECT_LT(cut.volumeMm3, 64 + 1e-3) << at;
  }
  // 1 m long at 5 mm, and 0.05 mm.
  const auto bar = hasp::MakeBox({ 500, 0, 0 }, glm::dmat3(1), { 498, 12, 13 });
  const hasp::GridGeometry meter{ { 205, 9, 9 }, { -10, -20, -20 }, glm::dvec3(5), glm::dmat3(1) };
  EXPECT_NEAR(CheckContour(*bar, meter).volumeMm3 / (996.0 * 24 * 26), 1.0, 1e-3);
  const auto fine = CheckContour(*ball, hasp::GridAround(glm::dvec3(0.15, 0, 0), 1.3, 0.05));
  EXPECT_TRUE(fine.Sound());
  const double volume = glm::pi<double>() * (4.0 / 3.0 + 0.3);
  EXPECT_NEAR(fine.volumeMm3 / volume, 1.0, 2e-3); // chords
  const hasp::GridGeometry line{ { 5, 1, 1 }, {}, glm::dvec3(1), glm::dmat3(1) };
  EXPECT_TRUE(hasp::SharpContour(*ball, line).points.empty());
}

/// Counts what it is asked; and may be steeper than it says.
class Asked final : public hasp::ImplicitSolid
{
public:
  Asked(hasp::SolidPointer part, double steeper = 1.0) : Part(std::move(part)), Steeper(steeper) {}
  double At(const glm::dvec3& x) const noexcept override { return this->SampleAt(x).value; }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    ++this->Count;
    Sample sample = this->Part->SampleAt(x);
    sample.value *= this->Steeper;
    return sample;
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    ++this->Count;
    return this->Part->FaceAt(face, x);
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override { return this->Part->Bounds(); }

  mutable std::atomic<std::size_t> Count = 0;

private:
  hasp::SolidPointer Part;
  double Steeper;
};

// All along an edge between two grid points, which are outside, it is as deep as what counts as a
// tip: halving finds no place that is deeper, and none where there cannot be one.
TEST(SharpContour, ARibAsThinAsTheLeastTipIsLookedForWithAnEnd)
{
  const auto rib = hasp::MakeBox({ 4.5, 4, 4 }, glm::dmat3(1), { 0.3, 0.007001, 0.007001 });
  const hasp::GridGeometry grid{ glm::ivec3(9), glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  const auto mesh = hasp::SharpContour(*rib, grid);
  EXPECT_TRUE(mesh.triangles.empty() || hasp::CheckMesh(mesh).Sound());
}

TEST(SharpContour, AsksOnlyNearTheSurface)
{
  const Asked ball(hasp::MakeCapsule({}, {}, 3));
  const auto grid = hasp::GridAround(glm::dvec3(0), 16, 0.25);
  hasp::SharpContourFacts facts;
  const auto mesh = hasp::SharpContour(ball, grid, {}, &facts);
  EXPECT_EQ(facts.blocks, 4096U);
  EXPECT_LT(facts.blocksHeld, 130U); // 113 mm^2 of blocks of 2 mm: 28 of their faces, 4 times that
  // A point of the grid in twenty, and a few times for each triangle.
  EXPECT_LT(ball.Count, grid.Size() / 20 + 4 * mesh.triangles.size());
}

TEST(SharpContour, SaysHowFarItIsAndCanBeStopped)
{
  const auto ball = hasp::MakeCapsule({}, {}, 1);
  const auto grid = hasp::GridAround(glm::dvec3(0), 8, 0.1); // 8,000 blocks: two batches
  std::vector<double> said;
  hasp::SharpContour(*ball, grid, {}, nullptr,
    [&](double done)
    {
      said.push_back(done);
      return true;
    });
  ASSERT_GE(said.size(), 2U);
  EXPECT_TRUE(std::is_sorted(said.begin(), said.end()));
  EXPECT_GT(said.front(), 0.0);
  EXPECT_EQ(said.back(), 1.0);
  int calls = 0;
  EXPECT_THROW(hasp::SharpContour(*ball, grid, {}, nullptr, [&](double) { return ++calls < 1; }),
    hasp::Cancelled);
  EXPECT_EQ(calls, 1);
}

TEST(SharpContour, BadInputIsRefused)
{
  const auto ball = hasp::MakeCapsule({}, {}, 1);
  const auto grid = hasp::GridAround(glm::dvec3(0), 2, 0.25);
  hasp::SharpContourSettings settings;
  for (const double tolerance : { 0.0, 0.2, std::numeric_limits<double>::quiet_NaN() })
  {
    settings.tolerance = tolerance;
    EXPECT_THROW(hasp::SharpContour(*ball, grid, settings), std::invalid_argument);
  }
  auto bad = grid;
  bad.spacing.y = 0;
  EXPECT_THROW(hasp::SharpContour(*ball, bad), std::invalid_argument);
  bad = grid;
  bad.origin.x = 9000; // where floats come in steps of 1 um
  EXPECT_THROW(hasp::SharpContour(*ball, bad), std::invalid_argument);
  // A solid that is steeper than it says loses blocks: that is no mesh with holes, but an error.
  const Asked steep(hasp::MakeCapsule({ 0.1, 0.2, 0.3 }, { 0.1, 0.2, 0.3 }, 2), 3.0);
  EXPECT_THROW(
    hasp::SharpContour(steep, hasp::GridAround(glm::dvec3(0), 3, 0.1)), std::runtime_error);
}

TEST(SharpContour, EachOfItsBlocksEndsWhereTheNextBegins)
{
  // The same solid in a grid that begins somewhere else has its block sides elsewhere, and the
  // same surface.
  const auto tree = hasp::RandomSolid(3, 3);
  auto grid = hasp::GridAround(glm::dvec3(0), 6.0, 0.5);
  const auto one = hasp::CheckMesh(hasp::SharpContour(*tree, grid));
  grid.origin -= 1.5;
  grid.dims += 6;
  const auto other = hasp::CheckMesh(hasp::SharpContour(
    *hasp::MakeIntersection(
      { tree, hasp::MakeBox(glm::dvec3(0), glm::dmat3(1), glm::dvec3(6.0 - 0.125 * 0.5)) }),
    grid));
  ASSERT_TRUE(one.Sound() && other.Sound());
  EXPECT_NEAR(one.volumeMm3 / other.volumeMm3, 1.0, 1e-3);
  EXPECT_EQ(one.pieces, other.pieces);
}

TEST(SharpContour, HowManyTrianglesIsKnownBefore)
{
  const auto ball = hasp::MakeCapsule({}, {}, 10.0);
  const auto box = hasp::MakeBox({}, glm::dmat3(1), { 9.0, 4.0, 2.0 });
  const auto wall = hasp::MakeIntersection({ hasp::MakeSlab({}, { 1, 2, 3 }, 1.0), ball });
  for (const hasp::SolidPointer& solid : { ball, box, wall })
    for (const double spacing : { 0.8, 0.4 })
    {
      const int cells = int(24.0 / spacing);
      const hasp::GridGeometry grid{ glm::ivec3(cells + 1), glm::dvec3(-12), glm::dvec3(spacing),
        glm::dmat3(1) };
      const double told = hasp::EstimateTriangles(hasp::BoundedSolid(*solid, grid), grid);
      const double made = double(hasp::SharpContour(*solid, grid).triangles.size());
      EXPECT_LT(told, 2.0 * made) << spacing;
      EXPECT_GT(told, 0.5 * made) << spacing;
    }
}

TEST(SharpContour, MoreTrianglesThanAskedForAreRefused)
{
  // A cube of 10 mm at 0.0005 mm would have 3e10 triangles, and take days.
  const auto box = hasp::MakeBox({}, glm::dmat3(1), { 5, 5, 5 });
  const hasp::GridGeometry fine{ glm::ivec3(20801), glm::dvec3(-5.2), glm::dvec3(0.0005),
    glm::dmat3(1) };
  EXPECT_THROW(hasp::SharpContour(*box, fine), std::invalid_argument);
  // Where no estimate is made: while it grows.
  const hasp::GridGeometry coarse{ glm::ivec3(27), glm::dvec3(-6.5), glm::dvec3(0.5),
    glm::dmat3(1) };
  const std::size_t triangles = hasp::SharpContour(*box, coarse).triangles.size();
  hasp::SharpContourSettings settings;
  settings.mostTriangles = triangles;
  EXPECT_EQ(hasp::SharpContour(*box, coarse, settings).triangles.size(), triangles);
  for (const std::size_t least : { triangles - 1, triangles / 4 })
  {
    settings.mostTriangles = least;
    EXPECT_THROW(hasp::SharpContour(*box, coarse, settings), std::invalid_argument);
  }
}

} // namespace
