#include "Segmentation/RandomWalker.h"

#include "Testing/DirectSolution.h"
#include "Testing/RandomBone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace
{

using hasp::Label;
using hasp::RandomWalker;
using hasp::RandomWalkerRun;
using hasp::VoxelGraph;
using hasp::WalkerSeed;
using hasp::testing::DirectSolution;
using hasp::testing::RandomBone;

constexpr double tight = 2e-7; ///< a few units of single precision below 1

/// A row of voxels with given links: resistors in series.
std::shared_ptr<const VoxelGraph> Chain(const std::vector<double>& weights)
{
  hasp::GridGeometry geometry;
  geometry.dims = { static_cast<int>(weights.size()) + 1, 1, 1 };
  std::vector<std::array<float, 3>> links(weights.size() + 1);
  for (std::size_t n = 0; n < weights.size(); ++n)
    links[n] = { static_cast<float>(weights[n]), 0.0F, 0.0F };
  return std::make_shared<const VoxelGraph>(geometry, links);
}

/// Largest difference from the direct solution, over all labels.
double ErrorAgainst(const RandomWalker& walker, const std::vector<WalkerSeed>& seeds)
{
  double worst = 0.0;
  const std::vector<Label> labels = hasp::testing::LabelsOf(seeds);
  const std::vector<std::vector<double>> truth = DirectSolution(walker.Graph(), seeds);
  for (std::size_t l = 0; l < labels.size(); ++l)
    for (std::size_t n = 0; n < truth[l].size(); ++n)
      worst = std::max(
        worst, std::abs(truth[l][n] - walker.Probability(static_cast<std::int32_t>(n), labels[l])));
  return worst;
}

TEST(RandomWalker, ARowOfResistorsDividesTheVoltage)
{
  std::vector<double> weights;
  for (int n = 0; n < 60; ++n)
    weights.push_back(std::pow(10.0, -(n * 7 % 13))); // over twelve decades, shuffled
  const auto chain = Chain(weights);
  RandomWalker walker(chain);
  walker.SetSeeds({ { 0, 1 }, { 60, 2 } });
  const RandomWalkerRun run = walker.Solve({ .tolerance = tight });
  EXPECT_TRUE(run.converged);
  double all = 0.0;
  for (const double w : weights)
    all += 1.0 / static_cast<float>(w);
  double before = 0.0;
  for (int n = 0; n <= 60; ++n)
  {
    EXPECT_NEAR(walker.Probability(n, 2), before / all, 1e-6);
    EXPECT_NEAR(walker.Probability(n, 1), 1.0 - before / all, 1e-6);
    if (n < 60)
      before += 1.0 / static_cast<float>(weights[n]);
  }
}

TEST(RandomWalker, AgreesWithADirectSolver)
{
  unsigned seed = 10;
  for (const double share : { 0.5, 0.8, 1.0 })
    for (const double beta : { 0.0, 90.0, 1e12 })
      for (const glm::dvec3& spacing : { glm::dvec3(1.0), glm::dvec3(0.3, 0.3, 1.25) })
      {
        const RandomBone bone({ 12, 11, 10 }, spacing, share, ++seed);
        const auto graph = bone.Graph({ .beta = beta });
        const auto last = static_cast<std::int32_t>(graph->Nodes()) - 1;
        const std::vector<WalkerSeed> seeds{ { 0, 2 }, { 1, 2 }, { last / 3, 3 }, { last / 2, 4 },
          { last, 5 }, { last - 7, 2 } };
        RandomWalker walker(graph);
        walker.SetSeeds(seeds);
        const RandomWalkerRun run = walker.Solve({ .tolerance = tight });
        EXPECT_TRUE(run.converged);
        EXPECT_LE(ErrorAgainst(walker, seeds), 1e-6) << share << ' ' << beta;
      }
}

TEST(RandomWalker, WeightsOverTwelveDecadesAreSolved)
{
  hasp::GridGeometry geometry;
  geometry.dims = { 9, 8, 7 };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> decade(-12.0, 0.0);
  for (int trial = 0; trial < 5; ++trial)
  {
    std::vector<std::array<float, 3>> weights(geometry.Size());
    for (auto& w : weights)
      for (float& axis : w)
        axis = static_cast<float>(std::pow(10.0, decade(random)));
    const auto graph = std::make_shared<const VoxelGraph>(geometry, weights);
    const std::vector<WalkerSeed> seeds{ { 0, 1 }, { 250, 2 }, { 503, 3 } };
    RandomWalker walker(graph);
    walker.SetSeeds(seeds);
    EXPECT_TRUE(walker.Solve({ .tolerance = tight }).converged);
    EXPECT_LE(ErrorAgainst(walker, seeds), 1e-5); // single precision in 500 weak steps
  }
}

TEST(RandomWalker, AStrokeMoreLeadsToTheSameAsAllAtOnce)
{
  const RandomBone bone({ 14, 14, 14 }, glm::dvec3(1.0), 0.9, 21);
  const auto graph = bone.Graph();
  std::vector<WalkerSeed> seeds{ { 10, 2 }, { 1000, 3 }, { 2000, 4 } };
  RandomWalker walker(graph);
  walker.SetSeeds(seeds);
  walker.Solve({ .tolerance = tight });
  seeds.push_back({ 1500, 7 }); // a new label
  seeds.push_back({ 1501, 7 });
  seeds.erase(seeds.begin() + 1); // and one that is gone
  walker.SetSeeds(seeds);
  EXPECT_TRUE(walker.Solve({ .tolerance = tight }).converged);
  EXPECT_LE(ErrorAgainst(walker, seeds), 1e-6);
}

TEST(RandomWalker, WarmStartsTakeFewerCycles)
{
  const RandomBone bone({ 40, 40, 40 }, glm::dvec3(1.0), 0.95, 22);
  RandomWalker walker(bone.Graph());
  std::vector<WalkerSeed> seeds{ { 10, 2 }, { 30000, 3 }, { 50000, 4 } };
  walker.SetSeeds(seeds);
  const int cold = walker.Solve({ .tolerance = 5e-3, .coarseStart = false }).iterations;
  seeds.push_back({ 20000, 3 });
  walker.SetSeeds(seeds);
  EXPECT_LT(walker.Solve({ .tolerance = 5e-3 }).iterations, cold);
  EXPECT_EQ(walker.Solve({ .tolerance = 5e-3, .coarseStart = false }).iterations, 1); // is there
}

TEST(RandomWalker, TheEstimateOfTheErrorIsNotBelowATenthOfIt)
{
  const RandomBone bone({ 12, 12, 12 }, glm::dvec3(1.0), 0.9, 23);
  const std::vector<WalkerSeed> seeds{ { 10, 2 }, { 700, 3 }, { 1400, 4 } };
  for (const double tolerance : { 5e-2, 1e-2, 1e-3, 1e-4 })
  {
    RandomWalker walker(bone.Graph());
    walker.SetSeeds(seeds);
    const RandomWalkerRun run = walker.Solve({ .tolerance = tolerance });
    EXPECT_LE(run.error, tolerance);
    EXPECT_LE(ErrorAgainst(walker, seeds), 10.0 * run.error);
  }
}

/// The second solve is a stroke more. The truth: all voxels to the end, far below the tolerance.
TEST(RandomWalker, ALocalEndIsAsGoodAsAWholeOneForLessWork)
{
  const RandomBone bone({ 50, 46, 42 }, glm::dvec3(1.0), 0.95, 31);
  const auto graph = bone.Graph();
  const auto nodes = static_cast<std::int32_t>(graph->Nodes());
  std::vector<WalkerSeed> seeds{ { 10, 2 }, { nodes / 2, 3 }, { nodes - 9, 4 } };
  RandomWalker truth(graph), local(graph), whole(graph);
  for (int stroke = 0; stroke < 2; ++stroke)
  {
    for (RandomWalker* walker : { &truth, &local, &whole })
      walker->SetSeeds(seeds);
    truth.Solve({ .tolerance = 2e-5, .localEnd = false });
    const RandomWalkerRun run = local.Solve({ .tolerance = 2e-3 });
    const RandomWalkerRun wholeRun = whole.Solve({ .tolerance = 2e-3, .localEnd = false });
    EXPECT_TRUE(run.converged);
    EXPECT_LE(run.error, 2e-3);
    EXPECT_LT(run.work, run.iterations - 0.5); // some were local
    EXPECT_LT(run.work, wholeRun.work);
    EXPECT_EQ(wholeRun.work, wholeRun.iterations);
    double worst = 0.0;
    for (std::int32_t n = 0; n < nodes; ++n)
      for (const Label label : { Label{ 2 }, Label{ 3 }, Label{ 4 } })
        worst =
          std::max(worst, std::abs(local.Probability(n, label) - truth.Probability(n, label)));
    EXPECT_LE(worst, 10.0 * run.error);
    seeds.push_back({ nodes / 3, 4 });
  }
}

/// Seven labels are two batches; each ends locally.
TEST(RandomWalker, ProgressNeverRunsBackwards)
{
  const RandomBone bone({ 50, 46, 42 }, glm::dvec3(1.0), 0.95, 31);
  const auto graph = bone.Graph();
  const auto nodes = static_cast<std::int32_t>(graph->Nodes());
  std::vector<WalkerSeed> seeds;
  for (int f = 0; f < 7; ++f)
    seeds.push_back({ nodes / 7 * f + 10, static_cast<Label>(f + 2) });
  RandomWalker walker(graph);
  walker.SetSeeds(seeds);
  std::vector<double> shares;
  const auto note = [&](double share)
  {
    shares.push_back(share);
    return true;
  };
  const RandomWalkerRun run = walker.Solve({ .tolerance = 2e-4 }, note);
  ASSERT_LT(run.work, run.iterations - 0.5); // some were local
  ASSERT_GT(shares.size(), 6U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end())) << testing::PrintToString(shares);
  EXPECT_GE(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
}

TEST(RandomWalker, SixtyLabelsAreSolvedInBatches)
{
  const RandomBone bone({ 16, 16, 16 }, glm::dvec3(1.0), 1.0, 24);
  RandomWalker walker(bone.Graph());
  std::vector<WalkerSeed> seeds;
  for (int f = 0; f < 60; ++f)
    seeds.push_back({ f * 68, static_cast<Label>(f + 2) });
  walker.SetSeeds(seeds);
  EXPECT_TRUE(walker.Solve({ .tolerance = tight }).converged);
  EXPECT_LE(ErrorAgainst(walker, { seeds.begin(), seeds.end() }), 1e-6);
}

TEST(RandomWalker, PiecesWithoutSeedsKeepTheirLabels)
{
  const RandomBone bone({ 30, 10, 10 }, glm::dvec3(1.0), 1.0, 25);
  RandomBone apart = bone;
  for (std::size_t v = 0; v < apart.labels.size(); ++v)
    if (v % 30 == 10 || v % 30 == 20) // three slabs
      apart.labels[v] = 0;
  const auto graph = apart.Graph();
  RandomWalker walker(graph);
  walker.SetSeeds({ { graph->NodeAt(0, 0, 0), 2 }, { graph->NodeAt(9, 9, 9), 3 },
    { graph->NodeAt(15, 5, 5), 4 } });
  walker.Solve();
  std::vector<Label> out(apart.labels.size(), 9);
  walker.WriteLabels({ out.data(), apart.geometry });
  for (std::size_t v = 0; v < out.size(); ++v)
  {
    const int x = static_cast<int>(v % 30);
    if (x == 10 || x == 20 || x > 20)
      EXPECT_EQ(out[v], 9);
    else if (x > 10)
      EXPECT_EQ(out[v], 4);
    else
      EXPECT_TRUE(out[v] == 2 || out[v] == 3);
  }
  EXPECT_EQ(walker.Probability(graph->NodeAt(25, 5, 5), 2), 0.0);
  EXPECT_EQ(walker.Probability(graph->NodeAt(15, 1, 1), 4), 1.0);
}

TEST(RandomWalker, ASeedOnEveryVoxelIsTheAnswer)
{
  const RandomBone bone({ 7, 6, 5 }, glm::dvec3(1.0), 0.9, 26);
  const auto graph = bone.Graph();
  std::vector<WalkerSeed> seeds;
  for (std::int32_t n = 0; n < graph->Nodes(); ++n)
    seeds.push_back({ n, static_cast<Label>(2 + n % 3) });
  RandomWalker walker(graph);
  walker.SetSeeds(seeds);
  EXPECT_TRUE(walker.Solve().converged);
  std::vector<Label> out(bone.labels.size());
  walker.WriteLabels({ out.data(), bone.geometry });
  std::int32_t n = 0;
  for (std::size_t v = 0; v < out.size(); ++v)
    if (bone.labels[v] == 1)
    {
      EXPECT_EQ(out[v], 2 + n % 3);
      ++n;
    }
}

TEST(RandomWalker, OneLabelOrNoneNeedsNoSolve)
{
  const RandomBone bone({ 7, 6, 5 }, glm::dvec3(1.0), 1.0, 27);
  RandomWalker walker(bone.Graph());
  EXPECT_EQ(walker.Solve().iterations, 0);
  walker.SetSeeds({ { 3, 5 } });
  EXPECT_EQ(walker.Solve().iterations, 0);
  EXPECT_EQ(walker.Probability(100, 5), 1.0);
  walker.SetSeeds({});
  EXPECT_EQ(walker.Probability(100, 5), 0.0);
}

TEST(RandomWalker, MirroredSeedsShareABlockInTheMiddle)
{
  for (const glm::dvec3& spacing : { glm::dvec3(1.0), glm::dvec3(1.0, 1.0, 100.0) })
    for (const double beta : { 0.0, 90.0 })
    {
      // Each slice on, 100 times as far, has a ten-thousandth of the difference: two, no more.
      const int slices = spacing.z > 1.0 ? 2 : 8;
      RandomBone bone({ 20, 8, slices }, spacing, 1.0, 28);
      std::fill(bone.samples.begin(), bone.samples.end(), 500.0F); // a constant image
      const auto graph = bone.Graph({ .beta = beta });
      RandomWalker walker(graph);
      walker.SetSeeds({ { graph->NodeAt(0, 4, 1), 2 }, { graph->NodeAt(19, 4, 1), 3 } });
      walker.Solve({ .tolerance = tight });
      std::vector<Label> out(bone.labels.size());
      walker.WriteLabels({ out.data(), bone.geometry });
      for (std::size_t v = 0; v < out.size(); ++v)
        ASSERT_EQ(out[v], v % 20 < 10 ? 2 : 3);
    }
}

TEST(RandomWalker, NonsenseIsRefused)
{
  const RandomBone bone({ 7, 6, 5 }, glm::dvec3(1.0), 1.0, 29);
  RandomWalker walker(bone.Graph());
  EXPECT_THROW(walker.SetSeeds({ { -1, 2 } }), std::invalid_argument);
  EXPECT_THROW(walker.SetSeeds({ { 210, 2 } }), std::invalid_argument);
  EXPECT_THROW(walker.SetSeeds({ { 3, 0 } }), std::invalid_argument);
  EXPECT_THROW(walker.Solve({ .tolerance = 0.0 }), std::invalid_argument);
  EXPECT_THROW(walker.Solve({ .tolerance = std::nan("") }), std::invalid_argument);
  EXPECT_THROW(walker.Solve({ .mostIterations = 0 }), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(walker.Probability(210, 1)), std::invalid_argument);
  std::vector<Label> small(10);
  hasp::GridGeometry geometry;
  geometry.dims = { 10, 1, 1 };
  EXPECT_THROW(walker.WriteLabels({ small.data(), geometry }), std::invalid_argument);
}

TEST(RandomWalker, MemoryIsRefusedBeforeItIsTaken)
{
  const RandomBone bone({ 20, 20, 20 }, glm::dvec3(1.0), 1.0, 32);
  const auto graph = bone.Graph();
  EXPECT_THROW(RandomWalker(graph, {}, 100 * 8000), std::invalid_argument);
  RandomWalker walker(graph, {}, 280 * 8000); // for two batches
  std::vector<WalkerSeed> seeds;
  for (int label = 1; label <= 9; ++label)
    seeds.push_back({ 100 * label, static_cast<Label>(label) });
  walker.SetSeeds(seeds);
  walker.Solve();
  const std::size_t bytes = walker.Bytes();
  EXPECT_LE(bytes, 200 * 8000);
  const double before = walker.Probability(1000, 3);
  seeds.push_back({ 5000, 10 });
  EXPECT_THROW(walker.SetSeeds(seeds), std::invalid_argument);
  EXPECT_EQ(walker.Bytes(), bytes);
  EXPECT_EQ(walker.Probability(1000, 3), before);
  seeds.erase(seeds.begin()); // nine again, of which one is new: its system is free
  walker.SetSeeds(seeds);
}

TEST(RandomWalker, ACancelledSolveCanGoOn)
{
  const RandomBone bone({ 12, 12, 12 }, glm::dvec3(1.0), 0.9, 30);
  const std::vector<WalkerSeed> seeds{ { 10, 2 }, { 700, 3 } };
  RandomWalker walker(bone.Graph());
  walker.SetSeeds(seeds);
  int calls = 0;
  EXPECT_THROW(
    walker.Solve({ .tolerance = tight }, [&](double) { return ++calls < 3; }), hasp::Cancelled);
  EXPECT_TRUE(walker.Solve({ .tolerance = tight }).converged);
  EXPECT_LE(ErrorAgainst(walker, seeds), 1e-6);
}

} // namespace
