#pragma once
#include "Segmentation/VoxelGraph.h"

#include <vector>

namespace hasp
{

/// How dark each voxel of a graph is against brighter bone on both of its sides: where a crack
/// runs, even one thinner than a voxel. One value a node, in [0, 1]; 0: no crack.
///
/// Along each of the 13 directions to neighbours: m is the lesser of the largest values on the two
/// sides, as far as two of the shortest spacings (one step at least); depth is
/// (m - g) / (m - soft), the largest of all directions. `soft`, what a crack is filled with, is
/// judged from the graph's own samples: low - 0.35 (median - low), low their 1 % quantile. In CT of
/// bone above 226 HU that is some 50 HU; it goes along with any scale and shift of the grey values.
/// An edge of bone, or of its marrow, is bright on one side only and no crack; a layer of marrow as
/// thin as two voxels is one.
///
/// samples: of the graph's nodes, in their order; grid: all of the scan, values that are not finite
/// are passed over. O(nodes * 50), on all cores; the same with any number of them.
std::vector<float> CrackDepths(
  const VoxelGraph& graph, const AnyGridView& grid, const std::vector<float>& samples);

} // namespace hasp
