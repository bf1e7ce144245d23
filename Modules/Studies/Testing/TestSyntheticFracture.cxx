#include "Grid/ThreadLimit.h"
#include "Studies/SyntheticFracture.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using glm::dvec3;
using hasp::FracturedScan;
using hasp::FractureFace;
using hasp::FractureSettings;
using hasp::GridGeometry;
using hasp::GridView;
using hasp::Label;

GridGeometry GridOf(const glm::ivec3& dims, const dvec3& spacing)
{
  GridGeometry grid;
  grid.dims = dims;
  grid.spacing = spacing;
  grid.origin = -0.5 * spacing * dvec3(dims - 1);
  return grid;
}

template <typename Body>
void ForEachVoxel(const GridGeometry& grid, const Body& body)
{
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        body((std::size_t(k) * grid.dims.y + j) * grid.dims.x + i, grid.IndexToWorld({ i, j, k }));
}

/// A ball of bone, sharp.
std::vector<std::int16_t> Ball(const GridGeometry& grid, double radius)
{
  std::vector<std::int16_t> samples(grid.Size());
  ForEachVoxel(
    grid, [&](std::size_t v, const dvec3& p) { samples[v] = glm::length(p) < radius ? 1000 : 40; });
  return samples;
}

/// Two oblique planes without roughness: a piece behind the first, another behind both others.
FractureSettings SmoothCuts()
{
  FractureSettings s;
  s.scanner.blurMm = dvec3(0.4);
  const auto plane = [](const dvec3& point, const dvec3& outward)
  {
    FractureFace face;
    face.point = point;
    face.outward = glm::normalize(outward);
    face.roughMm = 0.0;
    return face;
  };
  s.pieces = { { "cap", 0, { plane({ 0, 0, -3 }, { 0.2, 0.1, 1 }) }, {} },
    { "wedge", 0, { plane({ 1, 0, 0 }, { -1, 0.3, 0.1 }), plane({ 0, 2, 0 }, { 0, 1, 0.4 }) },
      {} } };
  return s;
}

Label SideOf(const FractureSettings& s, const dvec3& p)
{
  for (std::size_t n = 0; n < s.pieces.size(); ++n)
  {
    bool behind = true;
    for (const FractureFace& face : s.pieces[n].faces)
      behind = behind && glm::dot(p - face.point, face.outward) < 0.0;
    if (behind)
      return static_cast<Label>(3 + n);
  }
  return 2;
}

FracturedScan Break(
  const std::vector<std::int16_t>& intact, const GridGeometry& grid, const FractureSettings& s)
{
  return hasp::BreakScan(GridView<const std::int16_t>{ intact.data(), grid }, s);
}

TEST(RoughPlane, NonsenseIsRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto made = [](auto change)
  {
    FractureFace face;
    change(face);
    return hasp::RoughPlane(face);
  };
  EXPECT_THROW(made([&](FractureFace& f) { f.point.x = nan; }), std::invalid_argument);
  EXPECT_THROW(made([](FractureFace& f) { f.outward = { 0, 0, 1.1 }; }), std::invalid_argument);
  EXPECT_THROW(made([](FractureFace& f) { f.roughMm = -1.0; }), std::invalid_argument);
  EXPECT_THROW(made([](FractureFace& f) { f.shortestMm = 0.0; }), std::invalid_argument);
  EXPECT_THROW(made([](FractureFace& f) { f.longestMm = 1.0; }), std::invalid_argument);
}

TEST(RoughPlane, HeightsHaveTheirRmsBoundAndSlope)
{
  FractureFace face;
  face.outward = glm::normalize(dvec3(1, 2, 3));
  face.seed = 5;
  const hasp::RoughPlane plane(face);
  const dvec3 u = glm::normalize(glm::cross(face.outward, dvec3(1, 0, 0)));
  const dvec3 v = glm::cross(face.outward, u);
  double squares = 0.0;
  int count = 0;
  for (double a = -150.0; a < 150.0; a += 0.7)
    for (double b = -150.0; b < 150.0; b += 2.3, ++count)
    {
      const double height = plane.HeightMm(a * u + b * v);
      squares += height * height;
      ASSERT_LE(std::abs(height), plane.MostMm());
    }
  EXPECT_NEAR(std::sqrt(squares / count), face.roughMm, 0.05); // 300 mm are some twenty waves
  // The foot's normal by differences of the heights themselves.
  const dvec3 p = 3.3 * u - 7.1 * v + 0.4 * face.outward;
  const double h = 1e-5;
  const double du = (plane.HeightMm(p + h * u) - plane.HeightMm(p - h * u)) / (2.0 * h);
  const double dv = (plane.HeightMm(p + h * v) - plane.HeightMm(p - h * v)) / (2.0 * h);
  const dvec3 normal = glm::normalize(face.outward - du * u - dv * v);
  EXPECT_LT(glm::distance(plane.FootOf(p).outward, normal), 1e-8);
  EXPECT_NEAR(
    plane.FootOf(p).mm, (0.4 - plane.HeightMm(p)) / std::hypot(1.0, std::hypot(du, dv)), 1e-8);
  EXPECT_LE(std::hypot(1.0, std::hypot(du, dv)), plane.Steepest());
}

TEST(SyntheticFracture, NonsenseIsRefused)
{
  const GridGeometry grid = GridOf({ 8, 8, 8 }, dvec3(1.0));
  const std::vector<std::int16_t> intact = Ball(grid, 3.0);
  const auto broken = [&](auto change)
  {
    FractureSettings s = SmoothCuts();
    change(s);
    return Break(intact, grid, s);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(broken([](auto& s) { s.crackMm = -0.1; }), std::invalid_argument);
  EXPECT_THROW(broken([&](auto& s) { s.erodedMm = nan; }), std::invalid_argument);
  EXPECT_THROW(broken([](auto& s) { s.crackHU = 300.0; }), std::invalid_argument);
  EXPECT_THROW(broken([](auto& s) { s.bones.clear(); }), std::invalid_argument);
  EXPECT_THROW(broken([](auto& s) { s.bones.resize(2); }), std::invalid_argument);
  EXPECT_THROW(broken([](auto& s) { s.pieces[0].bone = 1; }), std::invalid_argument);
  EXPECT_THROW(broken([](auto& s) { s.pieces[0].faces.clear(); }), std::invalid_argument);
  EXPECT_THROW(
    broken([](auto& s) { s.pieces[0].moved.orientation.w = 2.0; }), std::invalid_argument);
  EXPECT_THROW(broken([](auto& s) { s.scanner.noiseHU = -1.0; }), std::invalid_argument);
  const std::vector<std::uint8_t> few(7, 1);
  const GridView<const std::int16_t> view{ intact.data(), grid };
  EXPECT_THROW(hasp::BreakScan(view, SmoothCuts(), few), std::invalid_argument);
  EXPECT_THROW(
    hasp::BreakScan(view, SmoothCuts(), {}, [](double) { return false; }), hasp::Cancelled);
}

TEST(SyntheticFracture, LabelsAreTheSidesOfPlanesExactly)
{
  GridGeometry grid = GridOf({ 45, 37, 41 }, { 0.5, 0.7, 0.6 });
  const double c = std::cos(0.3), q = std::sin(0.3);
  grid.direction = { c, q, 0, q, -c, 0, 0, 0, 1 };
  grid.origin = dvec3(0.0);
  grid.origin = -grid.IndexToWorld(0.5 * dvec3(grid.dims - 1));
  const std::vector<std::int16_t> intact = Ball(grid, 9.0);
  FractureSettings s = SmoothCuts();
  const FracturedScan broken = Break(intact, grid, s);
  std::size_t bone = 0;
  ForEachVoxel(grid,
    [&](std::size_t v, const dvec3& p)
    {
      ASSERT_EQ(broken.truth[v] != 0, broken.samples[v] >= 226);
      ASSERT_LE(broken.samples[v], intact[v]);
      if (broken.truth[v] == 0)
        return;
      ++bone;
      ASSERT_EQ(broken.truth[v], SideOf(s, p));
    });
  const double ball = 4.0 / 3.0 * glm::pi<double>() * 729.0;
  EXPECT_NEAR(double(bone) * 0.5 * 0.7 * 0.6, ball, 0.01 * ball); // the crack stays above 226 HU
  EXPECT_EQ(broken.names, (std::vector<std::string>{ "bone", "cap", "wedge" }));
}

TEST(SyntheticFracture, ACrackIsTheClosedFormOfAGapThatIsBlurred)
{
  const GridGeometry grid = GridOf({ 9, 9, 101 }, dvec3(0.1));
  const std::vector<std::int16_t> intact(grid.Size(), 1000);
  FractureSettings s = SmoothCuts();
  s.pieces.resize(1);
  s.pieces[0].faces[0].outward = { 0, 0, 1 };
  s.pieces[0].faces[0].point = { 0, 0, 0.03 };
  s.crackMm = 0.6;
  const FracturedScan broken = Break(intact, grid, s);
  const auto below = [](double x) { return 0.5 * std::erfc(-x / (0.4 * std::sqrt(2.0))); };
  ForEachVoxel(grid,
    [&](std::size_t v, const dvec3& p)
    {
      const double d = p.z - 0.03, gap = below(d + 0.3) - below(d - 0.3);
      ASSERT_NEAR(broken.samples[v], 1000.0 - 950.0 * gap, 0.51) << p.z; // rounded
    });
}

TEST(SyntheticFracture, AMovedPieceIsWhereItsPoseSays)
{
  const GridGeometry grid = GridOf({ 60, 60, 60 }, dvec3(0.5));
  const std::vector<std::int16_t> intact = Ball(grid, 10.0);
  FractureSettings s = SmoothCuts();
  s.pieces.resize(1);
  s.crackMm = 0.0;
  s.scanner.blurMm = dvec3(0.15);
  s.pieces[0].moved = { { 0.4, -0.3, -2.5 }, hasp::TurnBy({ 0.03, 0.02, 0.05 }) };
  const FracturedScan broken = Break(intact, grid, s);
  const hasp::RigidPose back = s.pieces[0].moved.Inverse();
  std::size_t piece = 0, rest = 0;
  ForEachVoxel(grid,
    [&](std::size_t v, const dvec3& p)
    {
      const dvec3 from = back.Place(p);
      const auto clear = [&](const dvec3& at) // a voxel from every surface
      {
        return std::abs(glm::length(at) - 10.0) > 0.9 &&
               std::abs(glm::dot(at - s.pieces[0].faces[0].point, s.pieces[0].faces[0].outward)) >
                 0.9;
      };
      if (!clear(from) || !clear(p))
        return;
      const bool inPiece = glm::length(from) < 10.0 && SideOf(s, from) == 3;
      const bool inRest = glm::length(p) < 10.0 && SideOf(s, p) == 2;
      ASSERT_EQ(broken.truth[v], inPiece ? 3 : inRest ? 2 : 0);
      ASSERT_EQ(broken.samples[v], inPiece || inRest ? 1000 : std::min<int>(intact[v], 50));
      piece += inPiece;
      rest += inRest;
    });
  EXPECT_GT(piece, 2000U); // so that something was asked
  EXPECT_GT(rest, 10000U);
}

TEST(SyntheticFracture, APieceThatGoesFarLeavesNothingBehindAndCoversAir)
{
  const GridGeometry grid = GridOf({ 90, 50, 50 }, dvec3(0.6));
  std::vector<std::int16_t> intact = Ball(grid, 8.0);
  for (std::int16_t& sample : intact)
    sample = sample < 1000 ? -1000 : sample;
  FractureSettings s = SmoothCuts();
  s.pieces.resize(1);
  s.crackMm = 0.0;
  s.scanner.blurMm = dvec3(0.15);
  s.pieces[0].moved.position = { 17.0, 0.0, 0.0 }; // beside the ball, none of it where it was
  const FracturedScan broken = Break(intact, grid, s);
  std::size_t piece = 0;
  ForEachVoxel(grid,
    [&](std::size_t v, const dvec3& p)
    {
      const dvec3 from = p - s.pieces[0].moved.position;
      for (const dvec3& at : { p, from })
        if (std::abs(glm::length(at) - 8.0) < 1.1 ||
            std::abs(glm::dot(at - s.pieces[0].faces[0].point, s.pieces[0].faces[0].outward)) < 1.1)
          return;
      const bool inPiece = glm::length(from) < 8.0 && SideOf(s, from) == 3;
      const bool inRest = glm::length(p) < 8.0 && SideOf(s, p) == 2;
      const bool left = glm::length(p) < 8.0 && SideOf(s, p) == 3;
      ASSERT_EQ(broken.truth[v], inPiece ? 3 : inRest ? 2 : 0);
      ASSERT_EQ(broken.samples[v], inPiece || inRest ? 1000 : left ? 50 : -1000);
      piece += inPiece;
    });
  EXPECT_GT(piece, 300U);
}

TEST(SyntheticFracture, AChipIsInNoFragment)
{
  const GridGeometry grid = GridOf({ 50, 50, 50 }, dvec3(0.5));
  const std::vector<std::int16_t> intact = Ball(grid, 11.0);
  FractureSettings s = SmoothCuts();
  const FracturedScan whole = Break(intact, grid, s);
  FractureFace face; // a slab about the first face, of 3 mm: both sides of it lose bone
  face.roughMm = 0.0;
  face.point = { 0.0, 0.0, -1.5 };
  face.outward = { 0.0, 0.0, 1.0 };
  s.chips = { { 0, { face } } };
  face.point = { 0.0, 0.0, -4.5 };
  face.outward = { 0.0, 0.0, -1.0 };
  s.chips[0].faces.push_back(face);
  const FracturedScan chipped = Break(intact, grid, s);
  EXPECT_EQ(chipped.names, whole.names); // labels are the same
  std::size_t lost = 0;
  ForEachVoxel(grid,
    [&](std::size_t v, const dvec3& p)
    {
      if (std::abs(std::abs(p.z + 3.0) - 1.5) < 1.6 && std::abs(p.z + 3.0) > 0.3)
        return; // blurred
      const bool inChip = std::abs(p.z + 3.0) < 1.5;
      ASSERT_EQ(chipped.truth[v], inChip ? 0 : whole.truth[v]);
      lost += inChip && whole.truth[v] != 0;
    });
  EXPECT_GT(lost, 500U);
}

TEST(SyntheticFracture, ErosionTakesBoneFromRoughFacesOnly)
{
  const GridGeometry grid = GridOf({ 50, 50, 50 }, dvec3(0.5));
  const std::vector<std::int16_t> intact = Ball(grid, 11.0);
  FractureSettings s = SmoothCuts();
  s.pieces.resize(1);
  s.pieces[0].faces[0].roughMm = 1.1;
  const FracturedScan whole = Break(intact, grid, s);
  s.erodedMm = 1.0;
  const FracturedScan eroded = Break(intact, grid, s);
  std::size_t lost = 0;
  for (std::size_t v = 0; v < whole.truth.size(); ++v)
  {
    ASSERT_LE(eroded.samples[v], whole.samples[v]);
    lost += whole.truth[v] != eroded.truth[v];
    ASSERT_TRUE(eroded.truth[v] == 0 || eroded.truth[v] == whole.truth[v]);
  }
  EXPECT_GT(lost, 100U);
}

TEST(SyntheticFracture, SeedsAndThreadsGiveTheSameBytes)
{
  const GridGeometry grid = GridOf({ 50, 40, 45 }, { 0.5, 0.6, 0.5 });
  const std::vector<std::int16_t> intact = Ball(grid, 10.0);
  FractureSettings s = SmoothCuts();
  s.pieces[0].faces[0].roughMm = 1.1;
  s.pieces[1].moved = { { 0.5, 0.2, 0.1 }, hasp::TurnBy({ 0.0, 0.01, 0.0 }) };
  s.scanner.noiseHU = 30.0;
  s.scanner.coneBeam.on = true;
  s.scanner.fieldRadiusMm = 9.0;
  std::vector<FracturedScan> scans(3);
  for (int n = 0; n < 3; ++n)
    hasp::WithThreadLimit(1 << n, [&] { scans[n] = Break(intact, grid, s); });
  for (int n = 1; n < 3; ++n)
  {
    EXPECT_EQ(scans[n].samples, scans[0].samples);
    EXPECT_EQ(scans[n].truth, scans[0].truth);
  }
  s.pieces[0].faces[0].seed = 2;
  EXPECT_NE(Break(intact, grid, s).truth, scans[0].truth);
}

TEST(SyntheticFracture, OutsideTheFieldThereIsNoTruthAndConeBeamIsNotHU)
{
  const GridGeometry grid = GridOf({ 40, 40, 12 }, dvec3(0.6));
  const std::vector<std::int16_t> intact = Ball(grid, 10.0);
  FractureSettings s = SmoothCuts();
  s.scanner.coneBeam.on = true;
  s.scanner.fieldRadiusMm = 6.0;
  s.axis = { 2.0, 0.0, 0.0 };
  const FracturedScan clean = Break(intact, grid, SmoothCuts()), broken = Break(intact, grid, s);
  ForEachVoxel(grid,
    [&](std::size_t v, const dvec3& p)
    {
      const double out = std::hypot(p.x - 2.0, p.y);
      ASSERT_EQ(broken.truth[v], out > 6.0 ? 0 : clean.truth[v]);
      const hasp::ConeBeamModel& m = s.scanner.coneBeam;
      const double share = out / m.cupRadiusMm;
      const double cupped = (clean.samples[v] + 1000.0) * (1.0 - m.cupping * (1.0 - share * share));
      ASSERT_NEAR(broken.samples[v],
        out > 6.0 ? m.scale * -1000.0 + m.offset : m.scale * (cupped - 1000.0) + m.offset, 0.51);
    });
}

TEST(SyntheticFracture, OnlyWhatIsNamedHasALabel)
{
  const GridGeometry grid = GridOf({ 30, 30, 30 }, dvec3(0.8));
  const std::vector<std::int16_t> intact = Ball(grid, 9.0);
  std::vector<std::uint8_t> named(grid.Size(), 0);
  ForEachVoxel(grid, [&](std::size_t v, const dvec3& p) { named[v] = p.x > 0.0; });
  const FracturedScan all = Break(intact, grid, SmoothCuts());
  const FracturedScan some =
    hasp::BreakScan(GridView<const std::int16_t>{ intact.data(), grid }, SmoothCuts(), named);
  for (std::size_t v = 0; v < named.size(); ++v)
    ASSERT_EQ(some.truth[v], named[v] != 0 ? all.truth[v] : 0);
  EXPECT_EQ(some.samples, all.samples);
}

} // namespace
