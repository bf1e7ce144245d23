#pragma once
#include "Segmentation/Brush.h"
#include "Segmentation/LabelDelta.h"
#include "Segmentation/RandomWalker.h"
#include "Segmentation/SharpWalker.h"

#include <memory>
#include <optional>
#include <span>

namespace hasp
{

/// A stroke as the voxels that it marks.
struct SeedVoxels
{
  Label label = 2;
  VoxelRuns voxels; ///< those outside the bone that is split mark nothing
};

struct SplitSettings
{
  EdgeWeightSettings weights;
  double norm = 1.0; ///< [1, 2]; 2: the random walk (RandomWalker.h); else SharpWalker.h
};

/// The voxels of one label while they are shared out among strokes: made once, asked after each
/// stroke. Keeps the graph, and with norm 2 what was solved, so that one more stroke takes a few
/// cycles.
///
/// WORKER threads: one caller at a time. Memory as RandomWalker.h, SharpWalker.h and VoxelGraph.h
/// say.
class LabelSplit
{
public:
  /// The voxels that have `label` in `labels`, tied to each other by the samples of `grid`. Keeps
  /// neither. Throws std::invalid_argument if norm is out of its range or two labels would take too
  /// much memory, and as VoxelGraph's constructor does.
  LabelSplit(const AnyGridView& grid, GridView<const Label> labels, Label label,
    const SplitSettings& settings = {}, const ProgressFunction& progress = {});

  /// Shares the voxels out among all strokes there are; where two mark a voxel the later one
  /// counts. A piece of bone that no stroke touches has the label that all had. Changes the map and
  /// returns the change. Throws std::invalid_argument if a label is 0, sizes differ or there are
  /// more labels than memory for them (RandomWalker.h), Cancelled; the map is then as it was. The
  /// map need not be the one this was made from: only voxels of the split are written, whatever
  /// they hold.
  LabelDelta Share(std::span<const SeedVoxels> strokes, GridView<Label> labels,
    const RandomWalkerSettings& settings = {}, const ProgressFunction& progress = {});

  /// Forgets what was solved: the next Share gives what it would if it were the first.
  void Forget();
  /// Whether what was solved is where the next Share starts: its labels then depend on it, within
  /// the tolerance. Not with a norm below 2.
  bool Remembers() const { return walker.has_value(); }

  /// What the last Share cost, and how good it is.
  const RandomWalkerRun& LastRun() const { return run; }
  /// Of the last Share: voxels that no stroke is connected to. They have the label that all had.
  std::uint64_t Unreached() const { return unreached; }
  /// Whether a stroke marks any voxel of the split.
  bool Touches(const SeedVoxels& stroke) const;
  const VoxelGraph& Graph() const { return *graph; }
  std::size_t Bytes() const { return graph->Bytes() + (walker ? walker->Bytes() : sharp->Bytes()); }

private:
  void Solve(std::vector<WalkerSeed> seeds, GridView<Label> labels,
    const RandomWalkerSettings& settings, const ProgressFunction& progress);

  Label label;
  double norm;
  std::shared_ptr<const VoxelGraph> graph;
  std::optional<RandomWalker> walker; ///< the one that the norm asks for
  std::optional<SharpWalker> sharp;
  RandomWalkerRun run;
  std::uint64_t unreached = 0;
};

} // namespace hasp
