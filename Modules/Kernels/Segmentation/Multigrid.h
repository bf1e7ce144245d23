#pragma once
#include "Segmentation/CoarseGraph.h"

#include <memory>
#include <vector>

/// Internal. WORKER threads.
namespace hasp::walk
{

/// Aggregates of aggregates: the part of multigrid that knows no voxels.
///
/// A node of level 0 is an aggregate of voxels. Each level has the sums of the links between its
/// aggregates (Galerkin with piecewise constant functions), less what fixed voxels take out of
/// them, and the weight that ties each node to fixed voxels.
class CoarseLevels
{
public:
  explicit CoarseLevels(CoarseGraph finest);
  ~CoarseLevels();

  /// A link of which one end or both are fixed.
  struct FixedLink
  {
    std::int32_t a; ///< node of level 0 that the fixed end lies in
    std::int32_t b; ///< that the other end lies in
    float weight;
    bool bothFixed;
  };
  /// free: how many free voxels each node of level 0 has.
  void Fix(std::vector<FixedLink> links, const std::vector<std::int32_t>& free);

  /// z is about the inverse of level 0 times r: one cycle.
  void Precondition(const NodeValues& r, NodeValues& z);
  /// product = level 0 times x; returns x . product, lane by lane.
  WideLanes Multiply(const NodeValues& x, NodeValues& product) const;

  std::size_t Bytes() const;
  int Count() const { return static_cast<int>(levels.size()); }

private:
  struct Level;
  void Cycle(std::size_t level, const Lanes* residual, Lanes* correction);
  void Refine(std::size_t level);
  void SolveCoarsest(const Lanes* residual, Lanes* correction);
  void Factorise();

  std::vector<std::unique_ptr<Level>> levels;
  std::vector<double>
    factor; ///< of the coarsest: unit lower triangle, row by row; pivots' inverses
};

/// The whole cycle: voxels, and the levels above them.
///
/// The same bits with any number of threads: blocks of nodes are smoothed by Gauss-Seidel, forwards
/// before and backwards after the coarse levels; beside each other they stand as in Jacobi's
/// method. Not quite linear, since coarse levels take steps of the best length: for flexible
/// conjugate gradients. It never overshoots: x + z is nearer to the solution than x (in L's norm).
class Multigrid
{
public:
  Multigrid(std::shared_ptr<const VoxelGraph> graph, const ProgressFunction& progress);

  /// Nodes that hold their values from now on, ascending; all others are free.
  void Fix(const std::vector<std::int32_t>& nodes);

  /// residual = -L x in free nodes, 0 in fixed ones: what flows in. Sums are in double: weak links
  /// count beside strong ones.
  void Residual(const NodeValues& x, NodeValues& residual) const;
  /// product = L x in free nodes, 0 in fixed ones. Returns x . product, lane by lane.
  WideLanes Multiply(const NodeValues& x, NodeValues& product) const;
  /// z is about the inverse of L times r, 0 in fixed nodes as r must be.
  void Precondition(const NodeValues& r, NodeValues& z);
  /// z is what the coarse levels alone make of r, solved until a step is below tolerance. Returns
  /// its iterations.
  int SolveCoarse(const NodeValues& r, NodeValues& z, double tolerance);

  bool Free(std::int64_t node) const { return inverse[node] > 0.0F; }
  std::size_t Bytes() const;
  int Levels() const { return coarse.Count() + 1; }

private:
  struct Block ///< whole runs
  {
    std::int64_t firstSpan, endSpan;
    std::int32_t firstNode;
  };
  void Restrict(const NodeValues& fine);
  /// to = from, and the coarse correction in free nodes; may be one.
  void Prolong(const NodeValues& from, NodeValues& to) const;
  void SmoothForwards(const NodeValues& r, NodeValues& z) const;
  /// z: of what it was `before`.
  void SmoothBackwards(const NodeValues& r, const NodeValues& before, NodeValues& z) const;

  std::shared_ptr<const VoxelGraph> graph;
  std::vector<Block> blocks;
  std::vector<float> inverse; ///< of the sum of a node's links; 0: fixed, or alone
  Aggregates aggregates;
  CoarseLevels coarse;
  NodeValues coarseResidual, coarseCorrection;
  NodeValues scratch;
};

} // namespace hasp::walk
