#pragma once
#include "Segmentation/Lanes.h"
#include "Segmentation/VoxelGraph.h"

#include <memory>
#include <vector>

/// Internal: the part of a graph where a solution is not good enough yet. WORKER threads.
namespace hasp::walk
{

/// Cells of 4 x 4 x 4 voxels of the grid, some of them marked.
class MarkedCells
{
public:
  static constexpr int Size = 4; ///< voxels

  /// Marks each cell with a voxel of which a value is above `limit`, and the 26 cells around it: at
  /// least four voxels lie between what is above and what is not marked. All cores.
  MarkedCells(const VoxelGraph& graph, const NodeValues& values, float limit);

  bool At(int i, int j, int k) const { return marked[Index(i / Size, j / Size, k / Size)] != 0; }
  /// The nodes in marked cells, O(voxels).
  std::int64_t Nodes() const { return nodes; }
  /// The largest of the values in cells that are not marked, at most the limit.
  float LargestOutside() const { return largestOutside; }

private:
  std::size_t Index(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * cells.y + j) * cells.x + i;
  }
  glm::ivec3 cells{ 0 };
  std::vector<std::uint8_t> marked;
  std::int64_t nodes = 0;
  float largestOutside = 0.0F;
};

/// A part of a graph as a graph of its own.
struct LocalGraph
{
  struct Piece ///< nodes one behind another in both
  {
    std::int32_t whole, local, count;
  };
  std::shared_ptr<const VoxelGraph> graph;
  std::vector<Piece> pieces;
  std::vector<std::int32_t> rim; ///< local nodes with a neighbour in the whole that is left out

  /// The nodes in marked cells.
  LocalGraph(const VoxelGraph& whole, const MarkedCells& cells);
  /// The nodes n with in[n] != 0; one value a node.
  LocalGraph(const VoxelGraph& whole, const std::vector<std::uint8_t>& in);

  NodeValues Take(const NodeValues& whole) const;
  void Put(const NodeValues& local, NodeValues& whole) const;

private:
  void Cut(
    const VoxelGraph& whole, std::vector<VoxelGraph::Run> runs, std::vector<std::int32_t> rowRuns);
};

} // namespace hasp::walk
