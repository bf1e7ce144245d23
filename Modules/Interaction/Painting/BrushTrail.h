#ifndef BrushTrail_h
#define BrushTrail_h

#include "Planning/SegmentationRecipe.h"
#include "SeenDepth.h"

#include "vtkHaspInteractionPaintingModule.h" // for export macro: tests

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace hasp
{

/// A drag of the pointer as strokes: every pixel between two of the pointer's is asked what it
/// shows, so that a fast drag has no gaps and follows what lies between. A drag is cut into pieces,
/// each a stroke of its own, where a pixel shows nothing, and where neighbouring pixels show places
/// farther apart than a brush's radius (and than JumpPixels pixels, where a pixel is that large):
/// at a silhouette. A line across a shorter step marks next to nothing that the balls at its ends
/// do not.
///
/// Points are places that pixels show, SpacingRadii radii apart or more, and the last of each
/// piece. A piece has at most MostPoints; the next one then goes on from its end.
/// Threads: any, one at a time. O(pixels passed).
class VTKHASPINTERACTIONPAINTING_EXPORT BrushTrail
{
public:
  static constexpr double SpacingRadii = 0.25;
  static constexpr double JumpPixels = 4.0;
  static constexpr std::size_t MostPoints = 100'000; ///< of a BrushStroke

  /// What a pixel of the window shows.
  using Finder = std::function<std::optional<PixelPlace>(const glm::ivec2&)>;

  /// A new drag; forgets the pieces of the last one.
  void Begin();
  /// Of what follows; a change within a drag begins a new piece where the last one ends.
  void SetBrush(std::uint16_t label, double radiusMm);
  /// The pointer goes straight to this pixel. True if a piece has begun or grown.
  bool MoveTo(const glm::ivec2& pixel, const Finder& find);
  /// What comes next is no neighbour of what was: a new piece. The pixels between are not asked.
  void Break();
  /// The drag is over: its last place is a point, too. True if that was one more.
  bool End();

  const std::vector<BrushStroke>& Pieces() const { return this->Strokes; }
  std::size_t Points() const; ///< of all pieces

private:
  bool Take(const PixelPlace& place);
  void Add(const glm::dvec3& point);
  bool Close();

  std::uint16_t Label = 2;
  double RadiusMm = 2.0;
  std::vector<BrushStroke> Strokes;
  std::optional<glm::ivec2> Pixel;  ///< where the pointer was
  std::optional<glm::dvec3> Latest; ///< of the piece that grows: perhaps no point of it yet
};

} // namespace hasp

#endif
