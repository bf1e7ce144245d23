#ifndef SlicePlace_h
#define SlicePlace_h

#include "SeenDepth.h"

#include "vtkHaspInteractionPaintingModule.h" // for export macro: tests

#include <glm/vec3.hpp>

#include <optional>

class vtkImageSlice;

namespace hasp
{

/// A plane that a slice is cut along, in world mm.
struct SlicePlane
{
  glm::dvec3 point{ 0.0 };
  glm::dvec3 normal{ 0, 0, 1 }; ///< of length 1
  bool operator==(const SlicePlane&) const noexcept = default;
};

/// The plane that the prop's mapper shows, as of its last picture; nothing without a mapper or an
/// image. Limit: the prop's own matrix alone is asked, so not within a vtkAssembly. Threads:
/// RENDER.
VTKHASPINTERACTIONPAINTING_EXPORT std::optional<SlicePlane> PlaneOf(vtkImageSlice* slice);

/// Where the line of sight through the middle of a pixel meets the plane: in closed form, no depth
/// is asked. Nothing outside of `view`'s viewport, where the line lies in the plane, where they
/// meet outside what the camera's clipping planes leave, and where that is outside of the slice's
/// image (half a voxel around its samples is inside). Throws std::invalid_argument if the image is
/// none that hasp::ImageGeometry takes. Threads: RENDER.
VTKHASPINTERACTIONPAINTING_EXPORT std::optional<PixelPlace> PlaceInSlice(
  const SeenDepth& view, const glm::ivec2& pixel, vtkImageSlice* slice, const SlicePlane& plane);

} // namespace hasp

#endif
