#ifndef CellDraws_h
#define CellDraws_h

#include "Isosurface/ClusterCulling.h"

/// Entries [first, first + count) of CellDraws: clusters of one part, drawn as points or rectangles
/// by one call.
struct DrawRange
{
  hasp::ClusterPart part;
  bool points;
  std::size_t first, count;

  int VerticesPerCell() const { return this->points ? 1 : 6; }
  /// Piece n of `pieces`, front to back.
  DrawRange Piece(std::size_t n, std::size_t pieces) const;
};

/// What one frame draws: each entry is a cluster, counted from the first one of its part; within a
/// range from front to back. Vertex numbers of its cells begin at entry * 512 * VerticesPerCell.
struct CellDraws
{
  std::vector<std::uint32_t> entries;
  std::vector<DrawRange> ranges;

  CellDraws(const hasp::VisibleClusters& visible, const std::vector<hasp::ClusterPart>& parts);
};

#endif
