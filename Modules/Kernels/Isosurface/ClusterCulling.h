#pragma once
#include "Isosurface/ClusteredCells.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace hasp
{

namespace glsl
{
#define HASP_FUNCTION inline
#include "Isosurface/glsl/ClusterState.glsl"
#undef HASP_FUNCTION
} // namespace glsl

/// Which clusters a view needs, by number, and with which primitive. Points cost a sixth of the
/// vertices of a rectangle but OpenGL drops a point whose centre is off-screen and limits its size.
struct VisibleClusters
{
  std::vector<std::uint32_t> points;     ///< wholly on screen, no cell larger than the point limit
  std::vector<std::uint32_t> rectangles; ///< the others that may be seen
  std::size_t culled = 0;                ///< clusters wholly outside the view
};

/// indexToClip     index coordinates of the volume to OpenGL clip coordinates
/// viewport        width and height in pixels
/// pointLimit      largest point the GPU draws, in pixels; 0 asks for rectangles only
/// margin          voxels that cells are drawn larger on each side
/// Conservative: a cluster that can be seen is always in one of the lists. Each list runs from
/// front to back by the depth of the clusters' middles, to 1/4096 of their span; equals by number.
/// Any thread. O(clusters): 2 ms for 100,000.
VisibleClusters CullClusters(const ClusteredCells& cells, const glm::dmat4& indexToClip,
  const glm::ivec2& viewport, double pointLimit, double margin = 0.0);

/// The same for several views of one viewport, two eyes say, in one pass over the clusters: for
/// each what it gets by itself.
std::vector<VisibleClusters> CullClusters(const ClusteredCells& cells,
  std::span<const glm::dmat4> indexToClip, const glm::ivec2& viewport, double pointLimit,
  double margin = 0.0);

/// The state (glsl/ClusterState.glsl) of a cluster that no viewer has seen yet: the box around its
/// active cells, of which there must be one.
std::uint32_t UnseenState(const CellCluster& cluster);

/// Clusters [first, end) and the words [firstWord, endWord) that hold their corners.
struct ClusterPart
{
  std::size_t first = 0, end = 0, firstWord = 0, endWord = 0;
};

/// Least `blockBytes` of DivideClusters; OpenGL promises 512 times as much.
constexpr std::size_t LeastBlockBytes = 32768;

/// Splits the cells for a GPU whose storage blocks hold no more than blockBytes: clusters, words,
/// labels and colours of each part fit one block each, and the parts together are all clusters, in
/// order. Parts begin at multiples of 8 clusters and 64 words, for what is bound must begin at a
/// multiple of up to 256 bytes. Throws std::invalid_argument if blockBytes < LeastBlockBytes.
/// O(clusters).
std::vector<ClusterPart> DivideClusters(const ClusteredCells& cells, std::size_t blockBytes);

} // namespace hasp
