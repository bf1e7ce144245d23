// Fragments as they come: tiny, at the border, oblique, thin, many.
#include "BrokenBall.h"

#include "Evaluation/MeshCheck.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace
{

using hasp::FragmentModels;
using hasp::testing::LabelledScan;

std::string Failure(const auto& call)
{
  try
  {
    call();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "nothing failed";
}

hasp::MeshCheck Check(const hasp::TriangleMesh& mesh)
{
  return hasp::CheckMesh(hasp::WeldPoints(mesh));
}

/// Bone everywhere, 1000 HU, but for what a function leaves out.
LabelledScan Block(
  const hasp::GridGeometry& grid, const std::function<std::uint16_t(const glm::ivec3&)>& labelOf)
{
  return { grid, { "block", [](const glm::dvec3&) { return 2.0; }, 1.0 },
    [&](const glm::dvec3& p) { return labelOf(glm::ivec3(glm::round(grid.WorldToIndex(p)))); } };
}

const hasp::GridGeometry Skewed = hasp::testing::GridAt(
  { 20, 18, 16 }, { 0.5, 0.6, 0.9 }, hasp::testing::SkewAxes(true), { 9, 8, 7 });

const hasp::FragmentSettings Quick{ .rangeMm = 3.0, .shellPoints = 400 };

TEST(FragmentShapes, EightVoxelsWithinBoneAreABoxOfThem)
{
  const LabelledScan scan = Block(Skewed,
    [](const glm::ivec3& at) {
      return glm::all(glm::equal(at / 2, glm::ivec3(4))) ? 3 : at.x < 12 ? 2 : 0;
    });
  FragmentModels models(scan.Scan(), Quick);
  ASSERT_EQ(models.Labels()[1].voxels, 8U);
  const hasp::MeshCheck check = Check(*models.Surface(3));
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1U);
  // A box of 2 x 2.4 x 3.6 spacings: CoverageDistance rounds its edges, all there is of it.
  const double voxels = 8.0 * scan.VoxelMm3();
  std::printf("8 voxels: volume %.3f of theirs\n", check.volumeMm3 / voxels);
  EXPECT_GT(check.volumeMm3, 0.5 * voxels);
  EXPECT_LT(check.volumeMm3, 1.1 * voxels);
  const auto map = models.Map(3);
  // The middle is 0.5 mm deep; all of the box is within three spacings of edges, where distances
  // err by 1.5 spacings at most (BodyDistance.h).
  std::printf("8 voxels: %.3f mm deep in the middle\n", -map->At(models.Finished(3).origin).mm);
  EXPECT_LT(map->At(models.Finished(3).origin).mm, -0.1);
  EXPECT_GT(models.Shell(3)->LevelEnd(0), 0U);
  // And bone around it has them as a hollow.
  const hasp::MeshCheck around = Check(*models.Surface(2));
  EXPECT_TRUE(around.Closed() && around.TwoManifold());
  EXPECT_EQ(around.pieces, 2U);
}

TEST(FragmentShapes, AVoxelAloneIsAFragment)
{
  const LabelledScan scan =
    Block(Skewed, [](const glm::ivec3& at) { return at == glm::ivec3(9, 8, 7) ? 5 : 2; });
  FragmentModels models(scan.Scan(), Quick);
  const hasp::MeshCheck check = Check(*models.Surface(5));
  EXPECT_TRUE(check.Sound());
  EXPECT_GT(check.volumeMm3, 0.3 * scan.VoxelMm3());
  EXPECT_LT(check.volumeMm3, 1.2 * scan.VoxelMm3());
}

// Bone that goes on beyond the scan ends, flat, at the last samples: closed, and as large.
TEST(FragmentShapes, AtTheScansBorderTheyAreClosed)
{
  const LabelledScan scan = Block(Skewed,
    [](const glm::ivec3& at) {
      return std::uint16_t(at.x < 10 ? 2 : at.z < 8 ? 3 : 4);
    });
  FragmentModels models(scan.Scan(), Quick);
  double together = 0.0;
  for (const std::uint16_t label : { 2, 3, 4 })
  {
    const hasp::MeshCheck check = Check(*models.Surface(label));
    EXPECT_TRUE(check.Sound()) << label;
    EXPECT_EQ(check.pieces, 1U);
    together += check.volumeMm3;
    EXPECT_GT(models.Shell(label)->Levels(), 0);
  }
  const glm::dvec3 size = glm::dvec3(Skewed.Cells()) * Skewed.spacing;
  EXPECT_NEAR(together, size.x * size.y * size.z, 0.03 * size.x * size.y * size.z);
  const auto map = models.Map(2);
  for (const double y : { 4.0, 8.5, 13.0 }) // the face of the scan, far from its edges
    EXPECT_NEAR(map->At(Skewed.IndexToWorld({ 0.0, y, 7.5 })).mm, 0.0, 0.1);
}

// A cut that is no layer of the grid: labels know it to half a voxel, and so do distances.
TEST(FragmentShapes, AnObliqueCutIsAsTrueAsItsVoxels)
{
  const glm::dvec3 middle(5.0, 6.0, 7.0), normal = glm::normalize(glm::dvec3(3.0, 2.0, 1.0));
  const hasp::GridGeometry grid =
    hasp::testing::GridAt({ 40, 40, 40 }, glm::dvec3(0.5), glm::dmat3(1.0), middle);
  const LabelledScan scan(grid, hasp::AnalyticSphere(middle, 8.0),
    [&](const glm::dvec3& p) { return glm::dot(p - middle, normal) < 0.0 ? 2 : 3; });
  FragmentModels models(scan.Scan(), Quick);
  const auto map = models.Map(2);
  double sum = 0.0, most = 0.0;
  int count = 0;
  const glm::dvec3 u = glm::normalize(glm::cross(normal, glm::dvec3(0, 0, 1))),
                   v = glm::cross(normal, u);
  for (double a = -4.0; a <= 4.0; a += 0.31)
    for (double b = -4.0; b <= 4.0; b += 0.31)
    {
      const double off = std::abs(map->At(middle + a * u + b * v).mm) / 0.5;
      sum += off * off, most = std::max(most, off), ++count;
    }
  std::printf("oblique cut: %.3f spacings rms, %.3f at most\n", std::sqrt(sum / count), most);
  EXPECT_LT(std::sqrt(sum / count), 0.3);
  EXPECT_LT(most, 0.9); // half the diagonal of a voxel
  const double half = 2.0 / 3.0 * std::numbers::pi * 512.0;
  EXPECT_NEAR(Check(*models.Surface(2)).volumeMm3, half, 0.02 * half);
}

TEST(FragmentShapes, ALabelWithoutBoneIsSaidAndAllOthersAreMade)
{
  LabelledScan scan = hasp::testing::Cuboids(2,
    hasp::testing::GridAt({ 26, 26, 26 }, glm::dvec3(0.5), glm::dmat3(1.0), glm::dvec3(0.0)), 5.0);
  ASSERT_EQ(scan.Label({ 1, 1, 1 }), 0);
  scan.Label({ 1, 1, 1 }) = 40;
  scan.Label({ 1, 1, 2 }) = 40;
  scan.Label({ 24, 1, 1 }) = 41;
  FragmentModels models(scan.Scan(), Quick);
  const std::string said = Failure([&] { models.Map(40); });
  EXPECT_NE(
    said.find("label 40: none of its 2 voxels is bone, grey value >= 226"), std::string::npos)
    << said;
  std::vector<std::uint16_t> all;
  for (const hasp::FragmentLabel& there : models.Labels())
    all.push_back(there.label);
  const std::string both = Failure([&] { models.Prepare(all, { .surface = true }); });
  EXPECT_NE(both.find("label 40:"), std::string::npos) << both;
  EXPECT_NE(both.find("nor could labels 41 be made"), std::string::npos) << both;
  for (int label = 2; label <= 9; ++label)
    EXPECT_NE(models.Finished(std::uint16_t(label)).surface, nullptr);
}

TEST(FragmentShapes, WhatIsThinnerThanTheSpacingIsSaid)
{
  const LabelledScan scan = Block(
    Skewed, [](const glm::ivec3& at) { return std::uint16_t(at == glm::ivec3(9, 8, 7) ? 5 : 2); });
  FragmentModels models(scan.Scan(), { .spacingMm = 1.7 });
  const std::string said = Failure([&] { models.Surface(5); });
  EXPECT_NE(said.find("label 5: its bone is thinner than the spacing of 1.7 mm"), std::string::npos)
    << said;
}

// 100:1 spacing asks for long grids: refused by a number before memory is taken, or made.
TEST(FragmentShapes, TooManySamplesAreRefusedBeforeTheyAreTaken)
{
  const hasp::GridGeometry grid =
    hasp::testing::GridAt({ 12, 12, 8 }, { 0.1, 0.1, 10.0 }, glm::dmat3(1.0), glm::dvec3(0.0));
  const LabelledScan scan =
    Block(grid, [](const glm::ivec3& at) { return std::uint16_t(at.x < 6 ? 2 : 3); });
  const std::string said =
    Failure([&] { FragmentModels(scan.Scan(), { .mostSamples = 100'000 }).Map(2); });
  EXPECT_NE(said.find("at most 100000 are allowed; choose a larger spacingMm (now 0.1 mm)"),
    std::string::npos)
    << said;
  FragmentModels models(scan.Scan(), { .spacingMm = 0.2 });
  const hasp::MeshCheck check = Check(*models.Surface(2));
  EXPECT_TRUE(check.Sound());
  EXPECT_NEAR(check.volumeMm3, 0.55 * 1.1 * 70.0, 0.1 * 0.55 * 1.1 * 70.0);
}

// Each is measured on its own box: all together take little more than the whole bone does.
TEST(FragmentShapes, ManyFragmentsAreNotAsManyVolumes)
{
  const LabelledScan scan = hasp::testing::Cuboids(3,
    hasp::testing::GridAt({ 44, 44, 44 }, glm::dvec3(0.5), glm::dmat3(1.0), glm::dvec3(0.0)), 10.3);
  FragmentModels models(scan.Scan(), Quick);
  std::vector<std::uint16_t> all;
  for (const hasp::FragmentLabel& there : models.Labels())
    all.push_back(there.label);
  ASSERT_EQ(all.size(), 27U);
  const auto work = models.Begin(all, { .surface = true });
  work->Run();
  const std::size_t volume = scan.Samples.size();
  std::printf("27 fragments: %.2f samples of grids for one of the volume\n",
    double(work->Samples()) / double(volume));
  EXPECT_LT(work->Samples(), 5 * volume); // (14 + 10)^3 of 15^3
  for (const std::uint16_t label : all)
    ASSERT_NE(models.Finished(label).surface, nullptr);
}

// Whatever the type of the samples.
TEST(FragmentShapes, FloatSamplesGiveTheSameAsWholeNumbers)
{
  const LabelledScan scan = hasp::testing::Cuboids(2, Skewed, 3.5);
  const std::vector<float> samples(scan.Samples.begin(), scan.Samples.end());
  hasp::FragmentScan other = scan.Scan();
  other.grey = hasp::GridView<const float>{ samples.data(), scan.Grid };
  EXPECT_EQ(
    FragmentModels(other).Surface(4)->points, FragmentModels(scan.Scan()).Surface(4)->points);
}

} // namespace
