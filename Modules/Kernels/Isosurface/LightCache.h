#pragma once
#include "Isosurface/CellTracer.h"

#include <glm/gtc/type_precision.hpp>

#include <array>

namespace hasp
{

class LightBlocks;
class LightBlockFinder;
class SharedLight;

struct LightCacheSettings
{
  std::size_t blocks = 65'536; ///< of the table, 524 bytes each; a power of two, 64 to 2^24
  double pixelsACorner = 1.0;  ///< distance of the places where light is kept, about; > 0
  double raysAPixel = 0.25;    ///< and frame, where something is known; in (0, 4]
};

/// Whose picture it is: of a pair of eyes the second one takes what the first has found.
enum class LightEye
{
  Alone,
  First, ///< a Second follows, most likely: its light is kept for that
  Second ///< of the same cells and light as the last First's
};

/// The light that a picture asks for. World: of the cells' geometry.
struct PictureLightSettings
{
  std::optional<double> ambientDistanceMm; ///< ambient occlusion: what is farther away does not
                                           ///< darken; > 0, may be infinite
  std::optional<glm::dvec4> light; ///< hard shadow of a light: (the world direction towards it, 0)
                                   ///< or (its place in the world, mm, 1); finite, not 0
  LightEye eye = LightEye::Alone;
};

/// A pixel: x the share of the cosine-weighted hemisphere that is open (ambient occlusion), y
/// whether the light reaches the surface. 255 in the open, where nothing was met and where it was
/// not asked for.
using PictureLight = std::vector<glm::u8vec2>;

/// Light in traced pictures that costs a fraction of the rays: ambient occlusion adds up in object
/// space, over frames (RayCaching: thesis 3.2.1, Paper V). One for all pictures of a surface.
///
/// Openness is kept at the corners of cubic lattices, apart for each of the six main directions
/// of the surface's normal, so the sides of a thin wall do not mix. A ray adds to the 8 corners
/// around its start with trilinear weights, and a pixel looks up the mean with the same weights:
/// the light is smooth over the surface. The lattice is the one whose corners lie about
/// pixelsACorner apart in the picture; the next coarser one helps where that knows little, and is
/// ready when the viewer steps back. Where nothing is known three rays a pixel are cast at once, so
/// the first picture is about as good as one of 16 rays each; later a quarter. A view that stays
/// (one of the last two pictures had it: there may be two eyes) goes on with three till 256 samples
/// are known, about 150 pictures, so noise falls with the square root of the pictures; not after
/// something was forgotten, for then more may change.
///
/// Error: from the eighth frame of an orbit a picture is better than one of 16 rays a pixel, in
/// PSNR and by what FLIP sees of it (`hasp report raycaching`, rows cost.lit and ao, has the
/// figures). Noise falls with about the square root of the rays; what blurring over the lattice
/// takes away stays, most where the surface is rough. It falls with pixelsACorner.
///
/// Hard shadows are one traced ray a pixel that faces the light; nothing is kept of them.
///
/// Two eyes (LightEye): the second one takes the light of the first one's picture where that shows
/// the same surface (SharedLight says when), and casts rays and looks up only where it does not:
/// along edges, and for what it sees alone.
///
/// Limit: what changes is told (Forget), nothing ages. Isovalue, geometry and distance are watched.
/// Deviations from the paper: no bricks; nothing is known of the layout of its cache.
/// Fixed memory: Bytes(), and beside it about 40 bytes a pixel that casts rays, at most those of
/// the picture in which most did. Threads: one; Light uses all cores inside. The same light with
/// any number of them.
class LightCache
{
public:
  /// Throws std::invalid_argument on settings out of range.
  explicit LightCache(const LightCacheSettings& settings = {});
  ~LightCache();
  LightCache(const LightCache&) = delete;
  LightCache& operator=(const LightCache&) = delete;

  /// The light of a picture that tracer made of view. What is asked for is paid for, no more: no
  /// rays and no look-ups without ambientDistanceMm. About 0.4 us a surface pixel and core, and the
  /// rays. Throws std::invalid_argument on settings out of range or a picture of another size.
  void Light(const CellTracer& tracer, const PictureView& view, const TracedPicture& picture,
    const PictureLightSettings& settings, PictureLight& light);

  /// Forgets everything: another volume or isovalue.
  void Forget();
  /// Forgets what the samples [low, high] can have darkened or lit: after they have changed.
  void Forget(const glm::ivec3& low, const glm::ivec3& high);

  /// Of the table: fixed, and 0 until ambient occlusion is first asked for. The system hands the
  /// memory out as it is used.
  std::size_t Bytes() const;
  /// What is kept of the first eye's picture for the second one's: 8 bytes a pixel; else 0.
  std::size_t SharedBytes() const;
  /// For ambient occlusion, in the last picture.
  std::int64_t Rays() const { return this->RayCount; }
  /// In it, pixels that took the first eye's light.
  std::int64_t SharedPixels() const { return this->SharedPixelCount; }

private:
  struct Tile;
  struct Picture;
  struct Group;
  void Watch(const ClusteredCells& cells, const std::optional<double>& distance);
  void CastRays(const Picture& seen, std::int64_t number, PictureLight& light);
  float Gather(
    const Picture& seen, const Group& group, std::size_t n, Tile& tile, LightBlockFinder& finder);
  double RaysFor(float samples, bool stays) const;
  void AddRays(const Tile& tile);
  void Share(const Picture& seen, const PictureView& view, const PictureLight& light);
  void Settle(const Picture& seen, const Tile& tile, PictureLight& light);

  LightCacheSettings Settings;
  std::unique_ptr<LightBlocks> Blocks;
  std::vector<Tile> Tiles;
  std::unique_ptr<SharedLight> FirstEye;
  std::array<PictureView, 2> LastViews; ///< newest first; two, for two eyes
  std::uint32_t Now = 0;                ///< counts pictures
  std::int64_t RayCount = 0, SharedPixelCount = 0;
  GridGeometry Geometry; ///< that what is known is of
  float Isovalue = 0.0F;
  double Distance = 0.0;
};

} // namespace hasp
