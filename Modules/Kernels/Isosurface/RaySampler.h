#pragma once
#include "Isosurface/PictureRays.h"
#include "Isosurface/RayCaster.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace hasp
{

/// One eye's picture, to be sampled.
struct SampledEye
{
  PictureView view;
  /// Window depth of its last picture, row by row from the lowest, 1 where nothing was drawn. It
  /// only guides the rays and need not be exact. Empty: not known.
  std::span<const float> depth;
  int number = 0; ///< which eye it is, >= 0: what its tiles found is remembered
};

/// Where a ray met the surface.
struct SampledHit
{
  glm::ivec3 cell;     ///< of the volume
  float pixelsAVoxel;  ///< about how many of the view's pixels a voxel spans there
  bool inHole = false; ///< nothing was drawn at this pixel in the last picture
};

/// Spreads a fixed number of rays over each tile of the pictures (thesis 3.2.1): half of them by
/// a low-discrepancy sequence (R2, Roberts 2018) that goes on from frame to frame of an eye, half
/// at pixels where nothing was drawn, as long as rays there still find something. A single ray goes
/// to such pixels in every other frame. A tile that has a ray a pixel gets them through the pixels'
/// middles, where pictures are drawn: one call then meets all that the picture shows, and further
/// ones of the same view meet the same. What is left of the number is spread as before.
///
/// What is remembered of an eye is forgotten when 256 calls of Sample have gone by without it.
///
/// Threads: one; Sample uses all cores inside. The same hits with any number of them.
class RaySampler
{
public:
  static constexpr int TileSide = 16;                    ///< pixels
  static constexpr int TilePixels = TileSide * TileSide; ///< so many rays a tile are one a pixel

  struct Frame
  {
    std::vector<SampledHit> hits; ///< of the eyes, tile by tile; then of what is predicted
    std::int64_t rays = 0;
  };
  /// count: rays a tile and eye, >= 0; a predicted view gets a quarter. Throws
  /// std::invalid_argument if a view cannot be inverted or a depth is not of its size.
  Frame Sample(const RayCaster& caster, std::span<const SampledEye> eyes,
    std::span<const PictureView> predicted, int count);

private:
  struct Tile;
  /// What is remembered of an eye.
  struct Memory
  {
    std::vector<float> misses; ///< a tile: the share of the rays into its holes that met nothing
    std::uint32_t cast = 0;    ///< rays a tile so far, modulo 2^32: where its sequence goes on
    std::uint32_t frames = 0;
    std::uint32_t sampled = 0; ///< the last call
  };
  Tile SampleTile(const RayCaster& caster, const PictureRays& rays, const SampledEye& eye,
    const glm::ivec2& place, int count, const Memory& memory, float misses) const;
  void SampleEye(
    const RayCaster& caster, const SampledEye& eye, int count, Memory& memory, Frame& frame) const;

  std::uint32_t Now = 0; ///< counts calls
  std::map<int, Memory> Eyes;
  std::vector<Memory> Predictions; ///< of the first predicted view, and so on
};

} // namespace hasp
