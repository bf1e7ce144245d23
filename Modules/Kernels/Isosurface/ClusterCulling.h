#pragma once
#include "Isosurface/ClusteredCells.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <vector>

namespace hasp
{

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
/// Conservative: a cluster that can be seen is always in one of the lists, in ascending order. Any
/// thread. O(clusters).
VisibleClusters CullClusters(const ClusteredCells& cells, const glm::dmat4& indexToClip,
  const glm::ivec2& viewport, double pointLimit);

} // namespace hasp
