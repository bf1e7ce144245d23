#pragma once
#include "Segmentation/VoxelGraph.h"

#include <memory>
#include <random>
#include <vector>

namespace hasp::testing
{

/// Random samples and a random mask: ragged, with holes, islands and single voxels.
struct RandomBone
{
  GridGeometry geometry;
  std::vector<float> samples;
  std::vector<Label> labels;

  RandomBone(const glm::ivec3& dims, const glm::dvec3& spacing, double share, unsigned seed)
  {
    geometry.dims = dims;
    geometry.spacing = spacing;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0F, 1000.0F);
    std::bernoulli_distribution bone(share);
    samples.resize(geometry.Size());
    labels.resize(geometry.Size());
    for (std::size_t v = 0; v < samples.size(); ++v)
    {
      samples[v] = value(random);
      labels[v] = bone(random) ? 1 : 0;
    }
  }

  GridView<const float> Samples() const { return { samples.data(), geometry }; }
  GridView<const Label> Labels() const { return { labels.data(), geometry }; }
  std::shared_ptr<const VoxelGraph> Graph(const EdgeWeightSettings& settings = {}) const
  {
    return std::make_shared<const VoxelGraph>(Samples(), Labels(), Label{ 1 }, settings);
  }
};

/// All links of a graph: (node, node, weight), each once.
struct GraphLink
{
  std::int32_t a, b;
  float weight;
};
inline std::vector<GraphLink> LinksOf(const VoxelGraph& graph)
{
  std::vector<GraphLink> links;
  for (const VoxelGraph::Span& span : graph.Spans())
    for (std::int32_t n = span.first; n < span.first + span.count; ++n)
    {
      if (n + 1 < span.first + span.count || span.joined != 0)
        links.push_back({ n, n + 1, graph.Along(0)[n] });
      for (int axis = 1; axis < 3; ++axis)
        if (span.above[axis - 1] != 0)
          links.push_back({ n, n + span.above[axis - 1], graph.Along(axis)[n] });
    }
  return links;
}

} // namespace hasp::testing
