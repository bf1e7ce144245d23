#pragma once
#include "Segmentation/VoxelGraph.h"

#include <memory>
#include <span>
#include <vector>

namespace hasp
{

/// A voxel whose label is known.
struct WalkerSeed
{
  std::int32_t node = 0; ///< VoxelGraph::NodeAt
  Label label = 1;
  bool operator==(const WalkerSeed&) const noexcept = default;
};

struct RandomWalkerSettings
{
  double tolerance = 5e-3;  ///< of probabilities, (0, 0.1]; see RandomWalkerRun::error
  int mostIterations = 500; ///< [1, 100000]
  bool coarseStart = true;  ///< begin with what the coarse graphs say; off: for comparison
  bool localEnd = true;     ///< end with cycles on what is not good enough; off: for comparison
};

/// What a solve cost, and how good it is.
struct RandomWalkerRun
{
  int iterations = 0;       ///< multigrid cycles on voxels; the most of all batches of labels
  double work = 0.0;        ///< the same, each cycle counted by its share of the voxels
  int coarseIterations = 0; ///< cycles on the first coarse graph, before them
  double error =
    0.0; ///< of probabilities, estimated: four times the largest change a cycle still asks for
  bool converged = true;
};

/// The probability that a random walk from a voxel meets a seed of each label first (Grady 2006;
/// BoneSplit): on free voxels L x = 0, at seeds x is 1 in their label's system and 0 in others'.
///
/// Solved by conjugate gradients with a multigrid cycle (Multigrid.h), four labels at once; one
/// label less than there are, since probabilities add up to 1. It starts with what the coarse
/// graphs make of the residual, and ends with cycles on that tenth of the voxels or less where a
/// cycle still asks for more than the tolerance (LocalGraph.h): the rest is not passed over again.
/// What was solved is where the next solve starts. So two ways to the same seeds agree within
/// the tolerance, not to the last bit: Reset() first where bytes must not depend on what was
/// before. Pieces of the graph that no seed touches are left out, and pieces with seeds of one
/// label alone are known at once.
///
/// Cost: RandomWalkerRun::work counts cycles as if each passed over all voxels, as those of a solve
/// without the coarse start and the local end do. Coarse cycles are not in it: one costs 0.4 of a
/// cycle on all voxels. Figures: decision 24.
/// Memory: 16 bytes a voxel for each four labels, about 95 a voxel for the solver, and 64 more
/// while it solves, 145 where all voxels are seeds. WORKER threads: one caller at a time. The same
/// bits with any number of threads.
class RandomWalker
{
public:
  static constexpr std::size_t DefaultMostBytes = std::size_t{ 16 } << 30;

  /// mostBytes: of memory, here and in a solve, without the graph. Throws std::invalid_argument
  /// before it takes any if two labels would take more; Cancelled. O(voxels), on all cores.
  explicit RandomWalker(std::shared_ptr<const VoxelGraph> graph,
    const ProgressFunction& progress = {}, std::size_t mostBytes = DefaultMostBytes);
  ~RandomWalker();

  /// All seeds there are; of two on one node the last counts. Throws std::invalid_argument if a
  /// node is not of the graph, a label is 0, or labels times voxels take more memory than there may
  /// be; all is then as it was. Keeps what was solved.
  void SetSeeds(std::vector<WalkerSeed> seeds);

  /// Throws std::invalid_argument on bad settings, Cancelled: what is solved so far is kept, and
  /// Solve may be called again.
  RandomWalkerRun Solve(
    const RandomWalkerSettings& settings = {}, const ProgressFunction& progress = {});

  /// Forgets what was solved, not the seeds.
  void Reset();

  /// Writes each voxel's most likely label; of equal ones the smallest. Voxels of the graph that no
  /// seed is connected to get the label `unreached`, or keep theirs if that is 0; all others keep
  /// theirs. Throws std::invalid_argument if sizes differ.
  void WriteLabels(GridView<Label> labels, Label unreached = 0) const;

  /// In [0, 1] up to the tolerance. 0 where no seed is connected.
  double Probability(std::int32_t node, Label label) const;

  const VoxelGraph& Graph() const;
  /// Of the solver and its solution, without the graph.
  std::size_t Bytes() const;

private:
  struct Internals;
  std::unique_ptr<Internals> internals;
};

} // namespace hasp
