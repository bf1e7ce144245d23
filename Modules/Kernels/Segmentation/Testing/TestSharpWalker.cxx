#include "Segmentation/SharpWalker.h"

#include "Grid/Progress.h"
#include "Testing/RandomBone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>

namespace
{

using hasp::Label;
using hasp::RandomWalker;
using hasp::SharpWalker;
using hasp::VoxelGraph;
using hasp::WalkerSeed;
using hasp::testing::GraphLink;
using hasp::testing::LinksOf;
using hasp::testing::RandomBone;

using Seeds = std::vector<WalkerSeed>;

std::vector<Label> Walk(const std::shared_ptr<const VoxelGraph>& graph, const Seeds& seeds)
{
  RandomWalker walker(graph);
  walker.SetSeeds(seeds);
  walker.Solve();
  const hasp::GridGeometry& grid = graph->Geometry();
  std::vector<Label> map(grid.Size());
  walker.WriteLabels({ map.data(), grid });
  std::vector<Label> labels;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        if (graph->NodeAt(i, j, k) >= 0)
          labels.push_back(map[(std::size_t(k) * grid.dims.y + j) * grid.dims.x + i]);
  return labels;
}

/// The weight of all links between voxels of two labels.
double CutOf(const VoxelGraph& graph, const std::vector<Label>& labels)
{
  double cut = 0.0;
  for (const GraphLink& link : LinksOf(graph))
    cut += labels[link.a] != labels[link.b] ? link.weight : 0.0;
  return cut;
}

/// The least cut between two sets of seeds: as much as flows (Edmonds and Karp), by brute force.
double LeastCut(const VoxelGraph& graph, const Seeds& seeds, Label from)
{
  const std::vector<GraphLink> links = LinksOf(graph);
  std::vector<std::vector<std::pair<int, std::size_t>>> at(graph.Nodes());
  std::vector<double> room(2 * links.size());
  for (std::size_t l = 0; l < links.size(); ++l)
  {
    at[links[l].a].emplace_back(links[l].b, 2 * l);
    at[links[l].b].emplace_back(links[l].a, 2 * l + 1);
    room[2 * l] = room[2 * l + 1] = links[l].weight;
  }
  std::vector<char> isEnd(at.size());
  for (const WalkerSeed& seed : seeds)
    isEnd[seed.node] = seed.label != from;
  double flow = 0.0;
  while (true)
  {
    std::vector<std::pair<int, std::size_t>> came(at.size(), { -1, 0 });
    std::vector<int> queue;
    for (const WalkerSeed& seed : seeds)
      if (seed.label == from)
      {
        queue.push_back(seed.node);
        came[seed.node].first = seed.node;
      }
    int end = -1;
    for (std::size_t q = 0; q < queue.size() && end < 0; ++q)
      for (const auto& [to, arc] : at[queue[q]])
        if (came[to].first < 0 && room[arc] > 1e-9)
        {
          came[to] = { queue[q], arc };
          queue.push_back(to);
          if (isEnd[to])
          {
            end = to;
            break;
          }
        }
    if (end < 0)
      return flow;
    double least = std::numeric_limits<double>::max();
    for (int n = end; came[n].first != n; n = came[n].first)
      least = std::min(least, room[came[n].second]);
    for (int n = end; came[n].first != n; n = came[n].first)
    {
      room[came[n].second] -= least;
      room[came[n].second ^ 1] += least;
    }
    flow += least;
  }
}

hasp::GridGeometry Box(const glm::ivec3& dims)
{
  hasp::GridGeometry geometry;
  geometry.dims = dims;
  return geometry;
}

TEST(SharpWalker, CutsARowAtItsWeakestLink)
{
  // A walk parts a row where half the resistance is: 138 links of 1 and one of 0.2, at 71.5.
  std::vector<std::array<float, 3>> weights(140, { 1.0F, 0.0F, 0.0F });
  weights[119][0] = 0.2F;
  const auto graph = std::make_shared<const VoxelGraph>(Box({ 140, 1, 1 }), weights);
  const Seeds seeds{ { 0, 2 }, { 139, 3 } };
  const SharpWalker walker(graph);
  const auto borderOf = [](const std::vector<Label>& labels)
  { return std::find(labels.begin(), labels.end(), Label(3)) - labels.begin(); };
  EXPECT_NEAR(borderOf(Walk(graph, seeds)), 72, 1);
  const SharpWalker::Shares shares = walker.Solve(seeds, 1.0);
  EXPECT_TRUE(shares.run.converged);
  EXPECT_EQ(borderOf(shares.labels), 120);
  EXPECT_TRUE(std::is_sorted(shares.labels.begin(), shares.labels.end()));
  EXPECT_LT(borderOf(walker.Solve(seeds, 2.0).labels), 115);
}

/// Bone of two labels that a sheet parts, whose voxels hold together by less.
struct TwoParts
{
  std::shared_ptr<const VoxelGraph> graph;
  Seeds seeds;

  explicit TwoParts(unsigned number)
  {
    RandomBone bone({ 18, 12, 10 }, { 0.5, 0.5, 0.7 }, 0.9, number);
    for (std::size_t v = 0; v < bone.samples.size(); ++v)
    {
      const auto x = static_cast<int>(v % 18), y = static_cast<int>(v / 18 % 12);
      bone.samples[v] = (x == 6 + y / 3 ? 500.0F : 1000.0F) + 0.2F * bone.samples[v];
    }
    graph = bone.Graph({ .crack = 0.0 });
    for (int j = 2; j < 6; ++j)
      for (const auto& [x, label] : { std::pair(1, Label(2)), std::pair(16, Label(3)) })
        if (const std::int32_t node = graph->NodeAt(x, j, 5); node >= 0)
          seeds.push_back({ node, label });
  }
};

TEST(SharpWalker, CutsByNearlyTheLeast)
{
  double walked = 0.0, sharp = 0.0, least = 0.0;
  for (unsigned number = 1; number <= 12; ++number)
  {
    const TwoParts parts(number);
    const std::vector<Label> labels = SharpWalker(parts.graph).Solve(parts.seeds, 1.0).labels;
    // Pieces that no seed touches have label 0, and cost nothing.
    const double cut = CutOf(*parts.graph, labels);
    const double truth = LeastCut(*parts.graph, parts.seeds, 2);
    EXPECT_GE(cut, truth * (1.0 - 1e-5)) << number;
    EXPECT_LE(cut, truth * 1.15) << number;
    walked += CutOf(*parts.graph, Walk(parts.graph, parts.seeds));
    sharp += cut;
    least += truth;
  }
  EXPECT_LT(sharp, 1.05 * least);
  EXPECT_LT(sharp, walked);
}

TEST(SharpWalker, WithNormTwoIsTheRandomWalkButForAggregates)
{
  std::size_t differ = 0, all = 0;
  for (unsigned number = 1; number <= 8; ++number)
  {
    const TwoParts parts(number);
    const std::vector<Label> walked = Walk(parts.graph, parts.seeds);
    const std::vector<Label> labels = SharpWalker(parts.graph).Solve(parts.seeds, 2.0).labels;
    for (std::size_t n = 0; n < labels.size(); ++n)
      differ += labels[n] != walked[n];
    all += labels.size();
  }
  EXPECT_LT(differ, all / 20);
}

TEST(SharpWalker, KeepsSeedsAndSharesOutAllTheyReach)
{
  // From no seed to one on every voxel, several labels within one aggregate, 60 labels.
  const RandomBone bone({ 20, 16, 14 }, { 0.4, 0.4, 0.6 }, 0.7, 5);
  const auto graph = bone.Graph();
  const auto nodes = static_cast<std::int32_t>(graph->Nodes());
  const SharpWalker walker(graph);
  EXPECT_EQ(walker.Solve({}, 1.0).labels, std::vector<Label>(nodes, 0));
  for (const int each : { 1, 2, 7, 50, 400 })
    for (const int labels : { 1, 2, 3, 60 })
    {
      Seeds seeds;
      for (std::int32_t n = 0; n < nodes; n += each)
        seeds.push_back({ n, static_cast<Label>(2 + n / each % labels) });
      const SharpWalker::Shares shares = walker.Solve(seeds, 1.0);
      EXPECT_TRUE(shares.run.converged);
      for (const WalkerSeed& seed : seeds)
        ASSERT_EQ(shares.labels[seed.node], seed.label);
      // Reached is what the random walker reaches.
      const std::vector<Label> walked = Walk(graph, seeds);
      for (std::int32_t n = 0; n < nodes; ++n)
        ASSERT_EQ(shares.labels[n] == 0, walked[n] == 0);
      if (labels == 1)
      {
        EXPECT_EQ(shares.labels, walked);
      }
    }
}

TEST(SharpWalker, LabelsHangTogetherWithTheirSeedsHoweverCloseThoseAre)
{
  // Strokes against each other, at all places within aggregates; all links are alike.
  const glm::ivec3 dims(24, 10, 8);
  const std::vector<std::array<float, 3>> weights(
    std::size_t(dims.x * dims.y * dims.z), { 1.0F, 1.0F, 1.0F });
  const auto graph = std::make_shared<const VoxelGraph>(Box(dims), weights);
  const SharpWalker walker(graph);
  for (int x = 8; x < 16; ++x)
  {
    Seeds seeds;
    for (int k = 0; k < dims.z; ++k)
      for (int j = 0; j < dims.y; ++j)
        for (const int side : { 0, 1 })
          seeds.push_back({ graph->NodeAt(x + side, j, k), Label(2 + side) });
    const std::vector<Label> labels = walker.Solve(seeds, 1.0).labels;
    for (std::size_t n = 0; n < labels.size(); ++n)
      ASSERT_EQ(labels[n], int(n) % dims.x <= x ? 2 : 3) << "seeds at " << x << ", node " << n;
  }
  const auto row = std::make_shared<const VoxelGraph>(
    Box({ 140, 1, 1 }), std::vector<std::array<float, 3>>(140, { 1.0F, 0.0F, 0.0F }));
  for (int x = 60; x < 80; ++x)
  {
    const std::vector<Label> labels =
      SharpWalker(row).Solve({ { x, 2 }, { x + 1, 3 } }, 1.0).labels;
    EXPECT_EQ(std::count(labels.begin(), labels.end(), 2), x + 1) << x;
    EXPECT_TRUE(std::is_sorted(labels.begin(), labels.end())) << x;
  }
}

TEST(SharpWalker, HoldsOnStiffGraphs)
{
  const Seeds corners{ { 0, 2 }, { 19, 3 }, { 20 * 16 * 14 - 1, 4 } };
  // mostCut: of norm 1; none given: what the random walk's border cuts.
  const auto check = [&](const std::shared_ptr<const VoxelGraph>& graph, const char* what,
                       std::optional<double> mostCut = {})
  {
    for (const double norm : { 1.0, 1.5, 2.0 })
    {
      const SharpWalker::Shares shares = SharpWalker(graph).Solve(corners, norm);
      EXPECT_TRUE(shares.run.converged) << what;
      std::set<Label> found(shares.labels.begin(), shares.labels.end());
      EXPECT_EQ(found, (std::set<Label>{ 2, 3, 4 })) << what;
      if (norm == 1.0)
      {
        EXPECT_LE(
          CutOf(*graph, shares.labels), mostCut ? *mostCut : CutOf(*graph, Walk(graph, corners)))
          << what;
      }
    }
  };
  RandomBone noise({ 20, 16, 14 }, { 0.4, 0.4, 0.6 }, 1.0, 6);
  for (const double beta : { 0.0, 1.0, 1e12 })
    check(noise.Graph({ .beta = beta, .floor = 1e-12 }), "beta");
  RandomBone flat({ 20, 16, 14 }, { 0.01, 0.1, 1.0 }, 1.0, 7);
  std::fill(flat.samples.begin(), flat.samples.end(), 700.0F);
  check(flat.Graph(), "constant, spacing 100:1");
  std::vector<std::array<float, 3>> weights(20 * 16 * 14);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> decade(-12.0, 0.0);
  for (std::array<float, 3>& w : weights)
    for (float& axis : w)
      axis = static_cast<float>(std::pow(10.0, decade(random)));
  // 224 links across the box cost 8 at random; the walk finds 5.6e-6 and aggregates miss that.
  check(std::make_shared<const VoxelGraph>(Box({ 20, 16, 14 }), weights), "twelve decades", 1e-4);
}

TEST(SharpWalker, TellsItsProgressAndCanBeCancelled)
{
  const TwoParts parts(1);
  const SharpWalker walker(parts.graph);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> decade(-12.0, 0.0);
  std::vector<std::array<float, 3>> weights(30 * 30 * 30);
  for (std::array<float, 3>& w : weights)
    for (float& axis : w)
      axis = static_cast<float>(std::pow(10.0, decade(random)));
  const SharpWalker stiff(std::make_shared<const VoxelGraph>(Box({ 30, 30, 30 }), weights));
  const Seeds ends{ { 0, 2 }, { 29, 3 }, { 26999, 4 }, { 13000, 5 }, { 14, 6 }, { 20000, 7 } };
  for (const auto& [which, seeds] : { std::pair(&walker, parts.seeds), { &stiff, ends } })
  {
    std::vector<double> told;
    which->Solve(seeds, 1.0, {},
      [&](double share)
      {
        told.push_back(share);
        return true;
      });
    ASSERT_GT(told.size(), 4U);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1.0);
  }
  for (const double at : { 0.0, 0.3, 0.5, 0.99 })
    EXPECT_THROW(
      walker.Solve(parts.seeds, 1.0, {}, [&](double share) { return share < at; }), hasp::Cancelled)
      << at;
}

TEST(SharpWalker, RefusesWhatItCannotDo)
{
  const TwoParts parts(1);
  const SharpWalker walker(parts.graph);
  for (const double norm : { 0.99, 2.01, std::nan("") })
    EXPECT_THROW(walker.Solve(parts.seeds, norm), std::invalid_argument);
  EXPECT_THROW(walker.Solve({ { -1, 2 } }, 1.0), std::invalid_argument);
  EXPECT_THROW(walker.Solve({ { 0, 0 } }, 1.0), std::invalid_argument);
  EXPECT_THROW(walker.Solve(parts.seeds, 1.0, { .tolerance = 0.0 }), std::invalid_argument);
  EXPECT_THROW(SharpWalker(parts.graph, {}, 1000), std::invalid_argument);
  Seeds many;
  for (Label label = 2; label < 60; ++label)
    many.push_back({ 7 * label, label });
  const auto voxels = static_cast<std::size_t>(parts.graph->Nodes());
  EXPECT_THROW(SharpWalker(parts.graph, {}, 100 * voxels).Solve(many, 1.0), std::invalid_argument);
  EXPECT_NO_THROW(SharpWalker(parts.graph, {}, 1000 * voxels).Solve(many, 1.0));
}

} // namespace
