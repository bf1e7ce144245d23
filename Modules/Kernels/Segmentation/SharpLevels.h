#pragma once
#include "Segmentation/CoarseGraph.h"

#include "Grid/Progress.h"

#include <memory>
#include <vector>

/// Internal: from the random walk towards the least cut, on one level. WORKER threads.
namespace hasp::walk
{

struct SharpSettings
{
  double norm;      ///< of differences that is least, [1, 2]
  double tolerance; ///< of probabilities
  int most;         ///< cycles a round and batch
};

/// What the rounds of a level cost.
struct SharpRun
{
  int cycles = 0;     ///< of all rounds, the most of all batches
  float error = 0.0F; ///< of the last round's probabilities, estimated
  bool converged = true;
};

/// Solves sum over links of w |x_a - x_b|^norm -> least for all labels at once, by reweighting
/// (Sinop and Grady 2007): the random walk first, and then the walk on links of
///   w (e / (d + e))^(2 - norm),   d the largest of all labels' differences along the link,
/// SharpRounds times. More rounds and a smaller e change little (decision 25).
///
/// fixed    not 0 where x holds; at least one of each piece of the graph that is to be solved
/// batches  x of each label but one, four a batch: fixed nodes' values, and where the others begin
/// Throws Cancelled, x is then what the last round made.
constexpr int SharpRounds = 3;
constexpr float SharpEnd = 3e-3F; ///< e
SharpRun Sharpen(const CoarseGraph& graph, const std::vector<std::uint8_t>& fixed,
  std::vector<NodeValues>& batches, const SharpSettings& settings,
  const ProgressFunction& progress);
/// The same on voxels. fixed: nodes, ascending.
SharpRun Sharpen(std::shared_ptr<const VoxelGraph> graph, const std::vector<std::int32_t>& fixed,
  std::vector<NodeValues>& batches, const SharpSettings& settings,
  const ProgressFunction& progress);

} // namespace hasp::walk
