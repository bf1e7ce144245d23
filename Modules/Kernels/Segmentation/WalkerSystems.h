#pragma once
#include "Segmentation/Lanes.h"
#include "Segmentation/RandomWalker.h"

#include <vector>

/// Internal: what all walkers do before they solve. WORKER threads.
namespace hasp::walk
{

/// Throws std::invalid_argument if a solve takes more than it may.
void CheckBytes(std::size_t bytes, const VoxelGraph& graph, std::size_t labels, std::size_t most);

/// How many values a voxel has, four labels each; of one label none.
std::size_t BatchesOf(std::size_t labels);

/// In order of nodes, one each: of two on one node the last. Throws std::invalid_argument if a node
/// is not of the graph, or a label is 0.
std::vector<WalkerSeed> OrderSeeds(const VoxelGraph& graph, std::vector<WalkerSeed> seeds);

/// Ascending, each once.
std::vector<Label> LabelsOf(const std::vector<WalkerSeed>& seeds);

/// Throws std::invalid_argument.
void CheckSettings(const RandomWalkerSettings& settings);

constexpr std::int32_t noLabel = -1; ///< no seed in this piece of the graph
constexpr std::int32_t severalLabels = -2;
/// Of a piece with that label so far, and a seed more.
inline std::int32_t WithSeed(std::int32_t label, Label seed)
{
  return label == noLabel || label == seed ? seed : severalLabels;
}

/// Labels with a system of their own, four to a batch of values; the probability of `rest` is what
/// is left.
struct Systems
{
  std::vector<Label> lanes; ///< 0: free
  Label rest = 0;

  /// 1 in the system of the label, 0 in all others.
  Lanes Known(std::size_t batch, std::int32_t label) const;
  /// The most likely label of a node, of equal ones the smallest.
  Label Best(const std::vector<NodeValues>& batches, std::int64_t node) const;
};

} // namespace hasp::walk
