#pragma once
#include "Segmentation/RandomWalker.h"

#include <memory>
#include <vector>

namespace hasp
{

/// Which label each voxel has when the differences of probabilities along links, weighted and to
/// the power of `norm`, add up to the least (Sinop and Grady 2007): norm 2 is the random walk, norm
/// 1 the least cut, whose border keeps to cracks that a walk leaks through.
///
/// Solved by a few rounds of reweighted walks (SharpLevels.h), from coarse to fine: first on
/// aggregates of some 18 voxels that hold together, then on the voxels of those aggregates that
/// have a neighbour with another label. So it costs less than one walk on all voxels, and what is
/// solved needs no memory between strokes.
///
/// Deviates from the least: a few rounds in place of all, and a border further than an aggregate
/// from where it is on aggregates is not looked for; ways within an aggregate count for nothing, so
/// that with a norm near 2 borders lie nearer to weak links than the walk's do. Held to the walks
/// on all voxels in TestSharpWalker and to the truth in `hasp report segmentation`. Where
/// weights differ by twelve decades at random, a cut may cost six times the walk's (both next to
/// nothing). The answer depends on the seeds alone, not on what was solved before. The same bits
/// with any number of threads. Memory: 8 bytes a voxel, and 80 while it is made or solves; then up
/// to 400 more for each voxel near a border, 16 for each four labels there, and 300 for each voxel
/// of an aggregate that has seeds of several labels. WORKER threads: one caller at a time.
class SharpWalker
{
public:
  /// mostBytes: of memory, here and in a solve, without the graph. Throws std::invalid_argument
  /// before it takes any if two labels would take more; Cancelled. O(voxels), on all cores.
  explicit SharpWalker(std::shared_ptr<const VoxelGraph> graph,
    const ProgressFunction& progress = {}, std::size_t mostBytes = RandomWalker::DefaultMostBytes);
  ~SharpWalker();

  struct Shares
  {
    std::vector<Label> labels; ///< of each node; 0 where no seed is connected
    RandomWalkerRun run;       ///< iterations: cycles on voxels, in all rounds
  };
  /// seeds     all there are; of two on one node the last counts
  /// norm      [1, 2]
  /// settings  tolerance and mostIterations (of a round) alone count
  /// Throws std::invalid_argument if a seed or a setting is not as it must be or there are more
  /// labels than memory for them, Cancelled.
  Shares Solve(std::vector<WalkerSeed> seeds, double norm,
    const RandomWalkerSettings& settings = {}, const ProgressFunction& progress = {}) const;

  /// Of what it keeps, without the graph.
  std::size_t Bytes() const;

private:
  struct Internals;
  std::unique_ptr<const Internals> internals;
};

} // namespace hasp
