#include "Testing/RandomBone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <tuple>

namespace
{

using hasp::Label;
using hasp::VoxelGraph;
using hasp::testing::RandomBone;

/// Nodes as they are promised: voxels of the label, x fastest.
std::vector<std::int32_t> NodesByBruteForce(const RandomBone& bone)
{
  std::vector<std::int32_t> nodes(bone.labels.size(), -1);
  std::int32_t count = 0;
  for (std::size_t v = 0; v < nodes.size(); ++v)
    if (bone.labels[v] == 1)
      nodes[v] = count++;
  return nodes;
}

TEST(VoxelGraph, NodesAreTheVoxelsOfTheLabel)
{
  const RandomBone bone({ 13, 7, 5 }, glm::dvec3(1.0), 0.6, 1);
  const auto graph = bone.Graph();
  const std::vector<std::int32_t> nodes = NodesByBruteForce(bone);
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 7; ++j)
      for (int i = 0; i < 13; ++i)
        ASSERT_EQ(graph->NodeAt(i, j, k), nodes[(k * 7 + j) * 13 + i]);
  EXPECT_EQ(graph->Nodes(), std::count(bone.labels.begin(), bone.labels.end(), 1));
  for (const auto& [i, j, k] : { std::tuple{ -1, 0, 0 }, { 13, 0, 0 }, { 0, 7, 0 }, { 0, 0, 5 } })
    EXPECT_EQ(graph->NodeAt(i, j, k), -1);
}

TEST(VoxelGraph, SpansHaveEachLinkOnceInBothDirections)
{
  for (const double share : { 0.3, 0.7, 0.95, 1.0 })
  {
    const RandomBone bone({ 11, 9, 6 }, glm::dvec3(1.0), share, 2);
    const auto graph = bone.Graph();
    const std::vector<std::int32_t> nodes = NodesByBruteForce(bone);
    std::set<std::pair<std::int32_t, std::int32_t>> truth;
    const glm::ivec3 dims = bone.geometry.dims;
    const int step[3] = { 1, dims.x, dims.x * dims.y };
    for (int v = 0; v < static_cast<int>(nodes.size()); ++v)
    {
      const int at[3] = { v % dims.x, v / dims.x % dims.y, v / dims.x / dims.y };
      for (int axis = 0; axis < 3; ++axis)
        if (nodes[v] >= 0 && at[axis] + 1 < dims[axis] && nodes[v + step[axis]] >= 0)
          truth.emplace(nodes[v], nodes[v + step[axis]]);
    }
    std::set<std::pair<std::int32_t, std::int32_t>> found;
    for (const hasp::testing::GraphLink& link : hasp::testing::LinksOf(*graph))
      EXPECT_TRUE(found.emplace(link.a, link.b).second);
    EXPECT_EQ(found, truth);
    std::set<std::pair<std::int32_t, std::int32_t>> backwards;
    for (const VoxelGraph::Span& span : graph->Spans())
      for (std::int32_t n = span.first; n < span.first + span.count; ++n)
        for (int axis = 0; axis < 2; ++axis)
          if (span.below[axis] != 0)
            backwards.emplace(n + span.below[axis], n);
    EXPECT_TRUE(std::includes(truth.begin(), truth.end(), backwards.begin(), backwards.end()));
    std::size_t alongX = 0;
    for (std::int64_t n = -1; n <= graph->Nodes(); ++n)
      alongX += graph->Along(0)[n] > 0.0F ? 1 : 0;
    EXPECT_EQ(alongX + backwards.size(), truth.size());
  }
}

TEST(VoxelGraph, WeightsFollowTheFormula)
{
  RandomBone bone({ 6, 5, 4 }, { 0.5, 1.0, 2.0 }, 1.0, 3);
  std::fill(bone.samples.begin(), bone.samples.end(), 100.0F);
  bone.samples[0] = 228.0F; // a difference of 128 on three links: the largest, and the scale
  const auto graph = bone.Graph({ .beta = 2.0, .crack = 0.0, .floor = 1e-3 });
  // 128 is the lower end of its bin; the scale is the upper one.
  const double step = 128.0 / 144.0;
  const double steep = 1e-3 + (1.0 - 1e-3) * std::exp(-2.0 * step * step);
  const double shape[3] = { 1.0, 0.25, 0.0625 }; // area / length, over the largest
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(graph->Along(axis)[0], steep * shape[axis], 1e-7);
    EXPECT_NEAR(graph->Along(axis)[1], shape[axis], 1e-7);
  }
}

TEST(VoxelGraph, ExtremesOfBetaStayWithinTheFloor)
{
  const RandomBone bone({ 8, 8, 8 }, glm::dvec3(1.0), 0.8, 4);
  for (const hasp::testing::GraphLink& link :
    hasp::testing::LinksOf(*bone.Graph({ .beta = 0.0, .crack = 0.0 })))
    EXPECT_EQ(link.weight, 1.0F);
  for (const hasp::testing::GraphLink& link :
    hasp::testing::LinksOf(*bone.Graph({ .beta = 1e12, .crack = 0.0, .floor = 1e-12 })))
  {
    EXPECT_GE(link.weight, 0.99e-12F);
    EXPECT_LE(link.weight, 1.0F);
  }
}

TEST(VoxelGraph, WeightsAreTheSameAtTheEndsOfFloat)
{
  RandomBone bone({ 9, 8, 7 }, glm::dvec3(1.0), 0.9, 6);
  for (float& sample : bone.samples)
    sample = (sample - 500.0F) * 0x1p+119F; // up to 3.3e38 on both sides of 0
  RandomBone small = bone;
  for (float& sample : small.samples)
    sample *= 0x1p-119F;
  for (const double beta : { 0.0, 90.0, 1e12 })
  {
    const auto links = hasp::testing::LinksOf(*bone.Graph({ .beta = beta, .crack = 0.0 }));
    const auto truth = hasp::testing::LinksOf(*small.Graph({ .beta = beta, .crack = 0.0 }));
    ASSERT_EQ(links.size(), truth.size());
    for (std::size_t n = 0; n < links.size(); ++n)
      ASSERT_EQ(links[n].weight, truth[n].weight) << beta;
  }
}

TEST(VoxelGraph, NonsenseIsRefused)
{
  RandomBone bone({ 4, 4, 4 }, glm::dvec3(1.0), 0.8, 5);
  EXPECT_THROW(bone.Graph({ .beta = -1.0 }), std::invalid_argument);
  EXPECT_THROW(bone.Graph({ .crack = -0.1 }), std::invalid_argument);
  EXPECT_THROW(bone.Graph({ .crack = std::nan("") }), std::invalid_argument);
  EXPECT_THROW(bone.Graph({ .beta = std::nan("") }), std::invalid_argument);
  EXPECT_THROW(bone.Graph({ .floor = 0.0 }), std::invalid_argument);
  EXPECT_THROW(bone.Graph({ .floor = 1.5 }), std::invalid_argument);
  const RandomBone other({ 4, 4, 5 }, glm::dvec3(1.0), 0.8, 5);
  EXPECT_THROW(VoxelGraph(bone.Samples(), other.Labels(), 1), std::invalid_argument);
  EXPECT_THROW(VoxelGraph(bone.Samples(), bone.Labels(), 1, {}, [](double) { return false; }),
    hasp::Cancelled);
  bone.labels[0] = 1;
  bone.samples[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(bone.Graph(), std::invalid_argument);
  bone.labels[0] = 0; // not bone: does not matter
  EXPECT_NO_THROW(bone.Graph());
}

TEST(VoxelGraph, NothingIsAGraphToo)
{
  const RandomBone bone({ 4, 4, 4 }, glm::dvec3(1.0), 0.0, 6);
  const auto graph = bone.Graph();
  EXPECT_EQ(graph->Nodes(), 0);
  EXPECT_TRUE(graph->Spans().empty());
  EXPECT_EQ(graph->NodeAt(1, 1, 1), -1);
}

} // namespace
