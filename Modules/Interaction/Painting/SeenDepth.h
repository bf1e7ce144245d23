#ifndef SeenDepth_h
#define SeenDepth_h

#include "vtkHaspInteractionPaintingModule.h" // for export macro: tests

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace hasp
{

/// A place that a pixel shows.
struct PixelPlace
{
  glm::dvec3 world{ 0.0 }; ///< mm
  double pixelMm = 0.0;    ///< how far apart neighbouring pixels are there, across the view
};

/// What a viewport showed, pixel by pixel: a copy of its depth, and how it was looked at. Of the
/// frame itself, so that a camera that has moved since changes nothing.
/// Threads: any; a value. 4 bytes a pixel.
struct VTKHASPINTERACTIONPAINTING_EXPORT SeenDepth
{
  glm::ivec2 origin{ 0 };        ///< of the viewport in its window, pixels from the lower left
  glm::ivec2 size{ 0 };          ///< of the viewport, pixels
  glm::dmat4 clipToWorld{ 1.0 }; ///< from device coordinates in [-1, 1]
  std::vector<float> depths;     ///< size.x * size.y, bottom row first; in [0, 1], 1: nothing

  /// World mm of a place in a pixel of the window; 0.5 is its middle. depth in [0, 1].
  glm::dvec3 Unproject(const glm::dvec2& pixel, double depth) const;

  /// What is seen in the middle of a pixel of the window; nothing outside the viewport, before the
  /// background and without a picture.
  std::optional<PixelPlace> At(const glm::ivec2& pixel) const;
};

} // namespace hasp

#endif
