#pragma once
#include "Isosurface/ClusteredCells.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <vector>

namespace hasp
{

/// Cells [first, first + count), in the order of ClusteredCells.
struct CellRange
{
  std::uint32_t first, count;
};

/// Which cells a view needs, and with which primitive. Points cost a sixth of the vertices of a
/// rectangle but OpenGL drops a point whose centre is off-screen and limits its size.
struct VisibleCells
{
  std::vector<CellRange> points;     ///< cells wholly on screen, none larger than the point limit
  std::vector<CellRange> rectangles; ///< the others that may be seen
  std::size_t culledCells = 0;       ///< in clusters wholly outside the view
};

/// indexToClip     index coordinates of the volume to OpenGL clip coordinates
/// viewport        width and height in pixels
/// pointLimit      largest point the GPU draws, in pixels; 0 asks for rectangles only
/// Conservative: a cell that can be seen is always in one of the lists. Any thread. O(clusters).
VisibleCells CullClusters(const ClusteredCells& cells, const glm::dmat4& indexToClip,
  const glm::ivec2& viewport, double pointLimit);

} // namespace hasp
