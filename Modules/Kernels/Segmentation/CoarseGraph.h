#pragma once
#include "Segmentation/Lanes.h"
#include "Segmentation/VoxelGraph.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

/// Internal: what multigrid is made of. WORKER threads.
namespace hasp::walk
{

constexpr std::int64_t nodesAPass = 8192; ///< that a thread takes at once

/// Which coarse node each node belongs to, and the other way round.
struct Aggregates
{
  std::vector<std::int32_t> of;         ///< a node's
  std::vector<std::int32_t> firstChild; ///< of each aggregate in `children`; one more at the end
  std::vector<std::int32_t> children;   ///< ascending
  std::int32_t Count() const { return static_cast<std::int32_t>(firstChild.size()) - 1; }
};

/// A graph of aggregates: rows of links, columns ascending.
struct CoarseGraph
{
  std::vector<std::int64_t> firstLink; ///< of each node; one more at the end
  std::vector<std::int32_t> to;
  std::vector<float> weight; ///< the sum of the links between two aggregates, > 0
  std::int32_t Nodes() const { return static_cast<std::int32_t>(firstLink.size()) - 1; }
  std::size_t Bytes() const;
};

/// Voxels that hold together within a block of 2 x 2 x 2: joined by links of at least a quarter of
/// the stronger voxel's strongest. A voxel alone joins its strongest neighbour's.
Aggregates AggregateVoxels(const VoxelGraph& graph);
/// Nodes in order, each with up to three that hold to it most strongly.
Aggregates AggregateNodes(const CoarseGraph& graph);

CoarseGraph Coarsen(const VoxelGraph& graph, const Aggregates& aggregates);
CoarseGraph Coarsen(const CoarseGraph& graph, const Aggregates& aggregates);

} // namespace hasp::walk
