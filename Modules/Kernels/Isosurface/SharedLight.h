#pragma once
// Private to LightCache: what the second eye takes from the first.
#include "Isosurface/LightCache.h"

namespace hasp
{

/// The light of the first eye's picture, for the second eye. A place on the surface is looked for
/// in that picture: where it lies on the surface that the four pixels round it show, and all four
/// are in the light or all four in the shadow, so is it, and as open as they are, by weight.
/// Elsewhere nothing is said: along the edges of shadows and of things, and where the first eye
/// does not see.
///
/// Limit: a shadow thinner than a pixel may pass between the four. 8 bytes a pixel. Threads: one
/// writes; At from any thread.
class SharedLight
{
public:
  void Keep(const PictureView& view, const TracedPicture& picture, const PictureLight& light,
    const PictureLightSettings& settings);
  /// Is it of that light? A lamp at the camera is another one for each eye, unless both eyes are
  /// one camera's.
  bool IsOf(const PictureLightSettings& settings) const;
  std::size_t Bytes() const { return this->Pixels.capacity() * sizeof(Pixel); }

  /// Where the second eye sees the surface; nothing if the first one was at its other side.
  std::optional<glm::u8vec2> At(const CellHit& hit) const;

private:
  // In depth. Slopes of four pixels take some; between them, where they lie in one plane, none. The
  // two sides of a wall are a voxel apart or so.
  static constexpr double SameSurfaceVoxels = 2.0, OwnSurfaceVoxels = 0.2;
  struct Pixel
  {
    float depth;
    glm::u8vec2 light;
  };

  glm::ivec2 Size{ 0 };
  glm::dmat4 IndexToClip{ 1.0 };
  glm::dvec4 Eye{ 0.0 }; ///< w 0: it looks along xyz
  glm::dvec4 DepthRow{ 0.0 }, WRow{ 0.0 };
  glm::dvec3 Along{ 0.0 }; ///< as many voxels along the view
  std::vector<Pixel> Pixels;
  PictureLightSettings Settings;
};

} // namespace hasp
