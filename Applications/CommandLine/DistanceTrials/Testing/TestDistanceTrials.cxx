#include "DistanceCases.h"
#include "DistanceErrors.h"
#include "RandomTree.h"
#include "ReportRegistry.h"
#include "RivalTransform.h"
#include "TrialShapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace
{

using namespace hasp;

TEST(DistanceTrials, CoverageIsTheShareOfEachVoxel)
{
  // Brute force, 40^3 places a voxel, of a ball; and its volume.
  const GridGeometry grid = TrialGrid(12);
  const AnalyticVolume ball = AnalyticSphere({ 0.05, -0.08, 0.03 }, 1.83);
  const std::vector<float> coverage = ExactCoverage(ball, grid);
  double squares = 0.0, sum = 0.0;
  int partial = 0;
  for (std::size_t v = 0; v < coverage.size(); ++v)
  {
    sum += coverage[v];
    if (coverage[v] <= 0.0F || coverage[v] >= 1.0F || v % 7 != 0)
      continue;
    const glm::dvec3 index(v % 12, v / 12 % 12, v / 144);
    int inside = 0;
    for (int s = 0; s < 64'000; ++s)
    {
      const glm::dvec3 sub = (glm::dvec3(s % 40, s / 40 % 40, s / 1600) + 0.5) / 40.0 - 0.5;
      inside += ball.value(grid.IndexToWorld(index + sub)) > 0.0;
    }
    squares += (coverage[v] - inside / 64e3) * (coverage[v] - inside / 64e3);
    ++partial;
  }
  EXPECT_GT(partial, 40);
  EXPECT_LT(std::sqrt(squares / partial), 5e-4); // of it 40^3 places 2e-4
  const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(1.83 / TrialVoxelMm, 3);
  // Pieces of an eighth of a voxel on a radius of 4.6: planes lose a twelfth of their square's
  // curvature, 2e-4.
  EXPECT_NEAR(sum / volume, 1.0, 3e-4);
}

TEST(DistanceTrials, CoverageByCountingIsNearExact)
{
  const GridGeometry grid = TrialGrid(12);
  const AnalyticVolume ball = AnalyticSphere({ 0.05, -0.08, 0.03 }, 1.83);
  const std::vector<float> exact = ExactCoverage(ball, grid),
                           counted = SampledCoverage(ball, grid, 4);
  double worst = 0.0;
  for (std::size_t v = 0; v < exact.size(); ++v)
  {
    EXPECT_EQ(64.0F * counted[v], std::round(64.0F * counted[v]));
    worst = std::max(worst, double(std::abs(exact[v] - counted[v])));
  }
  EXPECT_GT(worst, 0.01);
  EXPECT_LT(worst, 0.2); // a layer of four, not more than that
}

TEST(DistanceTrials, ScansAreWhatAGaussianMakesOfABall)
{
  const GridGeometry grid = TrialGrid(28);
  const double v = TrialVoxelMm, r = 8.3 * v, s = 0.8 * v;
  const glm::dvec3 centre(0.05, -0.08, 0.03);
  const std::vector<float> image = ScannedImage(AnalyticSphere(centre, r), grid, 0.8, 0.0, 1);
  double worst = 0.0;
  for (std::size_t n = 0; n < image.size(); ++n)
  {
    const double d =
      glm::distance(centre, grid.IndexToWorld(glm::dvec3(n % 28, n / 28 % 28, n / 784)));
    const auto erf = [&](double x) { return std::erf(x / (std::numbers::sqrt2 * s)); };
    const auto exp = [&](double x) { return std::exp(-0.5 * x * x / (s * s)); };
    const double truth = 0.5 * (erf(r - d) + erf(r + d)) -
                         s / (d * std::sqrt(2.0 * std::numbers::pi)) * (exp(r - d) - exp(r + d));
    worst = std::max(worst, std::abs(image[n] - truth));
  }
  EXPECT_LT(worst, 2e-3); // boxes of a third of a voxel, where they lie along the surface
  const std::vector<float> noisy = ScannedImage(AnalyticSphere(centre, r), grid, 0.8, 0.03, 1);
  double squares = 0.0;
  for (std::size_t n = 0; n < image.size(); ++n)
    squares += (noisy[n] - image[n]) * (noisy[n] - image[n]) / static_cast<double>(image.size());
  EXPECT_NEAR(std::sqrt(squares), 0.03, 0.001);
}

TEST(DistanceTrials, ErrorsAreInVoxelsAndKnowWhereTheyAre)
{
  const GridGeometry grid = TrialGrid(16);
  const AnalyticVolume ball = AnalyticSphere({ 0.1, 0.0, 0.0 }, 2.0);
  const std::vector<double> truth = TrueDistances(ball, grid);
  std::vector<float> distances(truth.begin(), truth.end());
  for (float& distance : distances)
    distance += 0.04F;
  distances[0] = 1e9F; // far outside: 3 voxels do not reach it
  const std::size_t worst = 8 + 16 * (8 + 16 * 3);
  ASSERT_LT(std::abs(truth[worst]), 1.2);
  distances[worst] += 0.4F;
  DistanceErrors errors(TrialVoxelMm);
  AddErrors(distances, truth, grid, {}, "ball", errors);
  EXPECT_NEAR(errors.Most(), 1.1, 1e-5);
  EXPECT_NEAR(errors.P99(), 0.1, 0.001);
  EXPECT_NEAR(errors.Bias(), 0.1, 0.005);
  EXPECT_NE(errors.Text().find("ball at (0.2, 0.2, -1.8) mm"), std::string::npos) << errors.Text();
  DistanceErrors offset(TrialVoxelMm);
  distances[worst] -= 0.4F;
  AddOffsetErrors(
    distances, grid, 0.4, [&](const glm::dvec3& p) { return -ball.value(p); }, "ball", offset);
  EXPECT_NEAR(offset.Bias(), -0.1, 0.02); // drawn 0.04 mm too far in; chords of a ball
  distances[worst] = 1e20F;               // far beyond any bin
  AddErrors(distances, truth, grid, {}, "ball", errors);
  EXPECT_NEAR(errors.Most(), 2.5e20, 1e15);
  distances[worst] = std::nanf("");
  AddErrors(distances, truth, grid, {}, "ball", errors);
  EXPECT_TRUE(std::isnan(errors.Rms()) && std::isinf(errors.Most()));
}

TEST(DistanceTrials, CentresLieBetweenSamplesInEveryWay)
{
  std::set<int> thirds;
  for (int n = 0; n < 27; ++n)
  {
    const glm::dvec3 centre = SubVoxelCentre(n, 3);
    const glm::ivec3 third(glm::floor(3.0 * centre));
    thirds.insert(third.x + 3 * (third.y + 3 * third.z));
  }
  EXPECT_EQ(thirds.size(), 27U);
  EXPECT_EQ(*thirds.rbegin(), 26);
}

TEST(DistanceTrials, RivalsMeasureWhatTheySayOrAreAbsent)
{
  const AnalyticVolume ball = AnalyticSphere(0.31 * glm::dvec3(TrialVoxelMm), 5.0);
  TransformInput input;
  input.grid = TrialGrid(40);
  input.coverage = ExactCoverage(ball, input.grid);
  input.mask = MaskOf(input.coverage);
  for (const RivalTransform& rival : { MaurerRival(), FogRival(), MeshRival(4), MeshRival(12) })
  {
    if (!rival.absent.empty())
    {
      EXPECT_NE(rival.absent.find("this build has no"), std::string::npos);
      EXPECT_FALSE(rival.make);
      continue;
    }
    const auto run = rival.make(input);
    for (int n = 0; n < 2; ++n) // the second run is as the first
    {
      run->Run();
      DistanceErrors errors(TrialVoxelMm);
      AddErrors(run->Distances(), TrueDistances(ball, input.grid), input.grid, {}, "ball", errors);
      // Of the mask; of coverage's trilinear surface, less.
      EXPECT_LT(errors.Rms(), rival.exact ? 0.5 : 0.15) << rival.name;
      EXPECT_GT(errors.Rms(), 0.005) << rival.name;
    }
  }
}

TEST(DistanceTrials, TreesAreTheSameForASeedAndCoverWhatTheyShould)
{
  std::set<SolidNode::Kind> kinds, meshKinds;
  const auto collect = [](const auto& self, const SolidNode& node, auto& all) -> void
  {
    all.insert(node.kind);
    for (const SolidNode& part : node.parts)
      self(self, part, all);
  };
  RandomTreeSettings settings;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    settings.meshes = false;
    const SolidNode tree = RandomTree(seed, settings);
    collect(collect, tree, kinds);
    EXPECT_EQ(
      SolidOf(tree)->At(glm::dvec3(0.3)), SolidOf(RandomTree(seed, settings))->At(glm::dvec3(0.3)));
    settings.meshes = true;
    collect(collect, RandomTree(seed, settings), meshKinds);
  }
  EXPECT_EQ(kinds.size(), 12U);
  EXPECT_EQ(meshKinds.size(), 6U);
  settings.depth = 9;
  EXPECT_THROW(RandomTree(1, settings), std::invalid_argument);
}

TEST(DistanceTrials, VolumesOfSolidsAreTrue)
{
  SolidNode ball;
  ball.kind = SolidNode::Kind::Capsule;
  ball.size = glm::dvec3(1.5);
  ball.mm = 2.0;
  const double volume = std::numbers::pi * (4.0 / 3.0 * 8.0 + 3.0 * 4.0);
  EXPECT_NEAR(VolumeOf(*SolidOf(ball), 8.0, 0.1) / volume, 1.0, 1e-3);
  SolidNode box;
  box.size = { 1.0, 2.0, 3.0 };
  box.axis = glm::normalize(glm::dvec3(1, 2, 2));
  SolidNode both;
  both.kind = SolidNode::Kind::Difference;
  both.parts = { ball, box };
  // Cells along edges count by the nearest face alone.
  EXPECT_NEAR(VolumeOf(*SolidOf(box), 8.0, 0.1) / 48.0, 1.0, 3e-3);
  EXPECT_LT(VolumeOf(*SolidOf(both), 8.0, 0.1), volume);
}

} // namespace
