#pragma once
#include "Segmentation/LabelMap.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hasp
{

/// How strongly neighbouring voxels of bone belong together.
struct EdgeWeightSettings
{
  double beta = 90.0; ///< how much an edge of the image holds a walk back, [0, 1e12]
  double crack = 0.1; ///< a crack so deep (CrackDepth.h) holds it back to 1/e, [0, 1]; 0: none does
  double floor = 1e-6; ///< least weight, of the largest, (0, 1]
};

/// The voxels of one label as a graph, each tied to those of its six face neighbours that have that
/// label, too: what is not bone costs nothing.
///
/// Nodes are numbered along x, then y, then z. They lie in spans: nodes one behind another in x
/// whose neighbours across y and z are all so far on in memory. So a pass over the graph reads in
/// straight lines; there is no list of neighbours.
///
/// weights   Of the link from a voxel to the next along each axis, as conductances:
///           w = (floor + (1 - floor) exp(-beta (difference / scale)^2 - (depth / crack)^2))
///               * area / length,
///           the face's area over the way between centres, divided by the largest of the three.
///           `scale` is what one of a thousand differences of neighbours exceeds; `depth` is the
///           greater of the two voxels' CrackDepths.
/// Deviates from Grady 2006 and BoneSplit: differences are scaled by that quantile and not by the
/// largest, which a metal crown would set; links know the voxel's shape, so that the answer does
/// not depend on how finely an axis is sampled; cracks hold a walk back by what they are and not by
/// their edges alone: the edge of marrow is as steep as theirs, and a hairline dips by a third.
/// Memory: 12 bytes a voxel of bone, and 28 a span (a span is 5 to 10 voxels in bone of CT).
/// Immutable once made; any thread.
class VoxelGraph
{
public:
  struct Span
  {
    std::int32_t first; ///< node
    std::int32_t count;
    std::int32_t above[2]; ///< from a node to its neighbour at y + 1, z + 1; 0: none
    std::int32_t below[2]; ///< at y - 1, z - 1, negative; 0: none
    std::int32_t joined;   ///< 1: the next span's first node is this one's neighbour along x
  };
  struct Run
  {
    std::int32_t first; ///< node
    std::int32_t count;
    std::int32_t x; ///< of the first
  };

  /// All voxels of `label`. Throws std::invalid_argument if sizes differ, a setting is out of its
  /// range, a sample of bone is not finite, or the label has more than 2^31 - 2 voxels; Cancelled
  /// if progress says so. O(voxels), on all cores; the same graph with any number of them.
  VoxelGraph(const AnyGridView& grid, GridView<const Label> labels, Label label,
    const EdgeWeightSettings& settings = {}, const ProgressFunction& progress = {});

  /// A graph of given weights on a full box: for tests. weights: 3 a voxel, along x, y, z.
  VoxelGraph(const GridGeometry& geometry, const std::vector<std::array<float, 3>>& weights);

  /// A part of a graph: the nodes of `part`, runs of `whole` or pieces of them, in order, each
  /// `first` a node of `whole`; rowRuns as below. Numbers its nodes anew. Links to what is left out
  /// are gone.
  VoxelGraph(const VoxelGraph& whole, std::vector<Run> part, std::vector<std::int32_t> rowRuns);

  /// The same links with other weights: of each axis those that Along() has of n = -1 to Nodes().
  /// Throws std::invalid_argument if there are more or less.
  VoxelGraph(const VoxelGraph& like, std::array<std::vector<float>, 3> weights);

  const GridGeometry& Geometry() const { return geometry; }
  std::int64_t Nodes() const { return nodes; }
  const std::vector<Span>& Spans() const { return spans; }
  /// Weights of the links of node n: along x to n + 1, along y and z to what its span says. 0 where
  /// there is none. May be asked for n = -1 and n = Nodes(): 0.
  const float* Along(int axis) const { return along[axis].data() + 1; }
  const std::vector<Run>& Runs() const { return runs; }
  /// The first run of each row (y, z), row z * dims.y + y; one more at the end.
  const std::vector<std::int32_t>& RowRuns() const { return rowRuns; }
  /// -1 where a voxel is not in the graph, or the index is outside the grid. O(log runs of a row).
  std::int32_t NodeAt(int i, int j, int k) const;
  std::size_t Bytes() const;

private:
  void FindRuns(GridView<const Label> labels, Label label, const ProgressFunction& progress);
  void FindSpans();

  GridGeometry geometry;
  std::int64_t nodes = 0;
  std::vector<Run> runs;
  std::vector<std::int32_t> rowRuns;
  std::vector<Span> spans;
  std::vector<float> along[3];
};

} // namespace hasp
