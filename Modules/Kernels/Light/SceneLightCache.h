#pragma once
#include "Isosurface/PictureRays.h"
#include "Light/PathTracer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hasp
{

class LightBlocks;
class LightBlockFinder;

struct SceneLightSettings
{
  std::size_t blocks = 65'536; ///< of the table, 1,036 bytes each; a power of two, 64 to 2^24
  double pixelsACorner = 1.0;  ///< distance of the places where light is kept, about; > 0
  double pathsAPixel = 0.25;   ///< and frame, where something is known; in (0, 4]
};

/// What light is asked for.
struct SceneLightRequest
{
  enum class Kind
  {
    Coverage,         ///< no light: what is seen, as alpha; no cache
    Lamps,            ///< and the environment, with nothing between; no cache
    AmbientOcclusion, ///< the same, times the share of the hemisphere that is open
    Traced            ///< paths
  };
  Kind kind = Kind::Traced;
  bool shadows = true;      ///< of lamps; one ray a pixel and lamp
  double distanceMm = 25;   ///< of ambient occlusion: beyond it nothing darkens; > 0
  PathTracerSettings paths; ///< of Traced

  bool operator==(const SceneLightRequest&) const = default;
};

/// What was drawn, for light to fall on.
struct DrawnDepths
{
  std::span<const float> depths; ///< [0, 1] of each pixel, row by row from the lowest; 1: nothing
  double slackPixels = 0.0; ///< as far beside the pixels' centres they may have been taken, times
                            ///< the slope
};

/// Linear radiance of a picture; alpha 1 where a body is seen and 0 elsewhere.
using LitPicture = std::vector<glm::vec4>;

/// The hybrid (thesis 4.2): what is seen is drawn or traced anew for each picture, and light that
/// paths bring is added up where it arrives, on the surfaces of a scene, and kept while the view
/// moves (as LightCache does with openness, RayCaching, thesis 3.2.1).
///
/// What is kept is the light that a white diffuse surface would get, over what it would get with
/// nothing in the way, for each of the six main directions of its normal, at the corners of cubic
/// lattices about pixelsACorner apart. So a pixel's own normal still shapes its light, and albedo
/// and gloss are the pixel's own. So is direct light from small bright parts of the environment (a
/// sun, windows: what is above 4 times its mean), by a ray a picture, for it has shadows with
/// edges; that of lamps, without noise; and a coat's or a metal's reflections, by two rays. These
/// rays' light adds up while the view stays (not that of Lamps), and so do paths that each pixel
/// then casts for itself, four a picture up to 256, which outweigh what is kept and blurred. What a
/// reflection meets is taken as diffuse, lit as it is known here.
///
/// Changes: a body that comes, goes, moves or is another surface makes the light in its box, old
/// and new, and about it forgotten: within distanceMm for ambient occlusion, exactly, and within a
/// quarter of the box's size for paths; what paths bring elsewhere then counts as 16 samples, so it
/// follows in some frames. Another environment, lamp or number of bounces forgets all paths'
/// light; a material ages it.
///
/// Limit: light is blurred over about a corner's distance, most where normals are rough; corners of
/// a room two of whose faces are within 45 degrees share light. Samples brighter than 127 times
/// the open light count as that.
/// Fixed memory: the table, and 16 bytes a pixel where rays add up, 16 at rest, 4 where depths are
/// given, and some 100 bytes a pixel of the first picture; twice the environment where it has
/// bright parts. Threads: one; Light uses all cores inside. The same light with any number of them.
class SceneLightCache
{
public:
  /// Throws std::invalid_argument on settings out of range.
  explicit SceneLightCache(const SceneLightSettings& settings = {});
  ~SceneLightCache();
  SceneLightCache(const SceneLightCache&) = delete;
  SceneLightCache& operator=(const SceneLightCache&) = delete;

  /// The light of what a view, whose index coordinates are the world's, shows of the scene.
  /// drawn: with depths the surface is looked for there alone, and where it is not found there, or
  /// the depth is 1, alpha is 0. Empty: rays find what is seen. Throws std::invalid_argument on a
  /// request out of range or depths of another number.
  void Light(const LitScene& scene, const PictureView& view, const DrawnDepths& drawn,
    const SceneLightRequest& request, LitPicture& picture);

  void Forget(); ///< everything

  std::size_t Bytes() const; ///< but for the tiles'; 0 until light is first kept
  std::int64_t Rays() const { return this->RayCount; } ///< in the last picture
  /// In it, pixels that knew nothing of their light before.
  std::int64_t NewPixels() const { return this->NewPixelCount; }

private:
  struct Tile;
  struct Picture;
  struct Known;
  struct Seen;  ///< of the scene that what is kept belongs to
  struct Parts; ///< of the environment
  void Watch(const LitScene& scene, const SceneLightRequest& request);
  bool ForgetChanges(const LitScene& scene, const SceneLightRequest& request);
  void PartEnvironment(const LitScene& scene, const SceneLightRequest& request);
  void ForgetAround(const LitScene::Box& box, double reach);
  void CastPaths(const Picture& seen, std::int64_t number, LitPicture& picture);
  void Gather(const Picture& seen, const LitHit& hit, std::size_t pixel, Tile& tile,
    LightBlockFinder& finder, LitPicture& picture);
  void AddPaths(const Picture& seen, const Tile& tile);
  void Settle(const Picture& seen, Tile& tile, LitPicture& picture);
  glm::vec3 PixelsOwn(const Picture& seen, const LitHit& hit, const glm::dvec3& towardsEye,
    std::size_t pixel, Tile& tile, LightBlockFinder& finder);
  glm::vec3 Gloss(const Picture& seen, const LitHit& hit, const SurfaceScattering::At& at,
    SobolSequence& points, Tile& tile, LightBlockFinder& finder);

  SceneLightSettings Settings;
  std::unique_ptr<LightBlocks> Blocks;
  std::unique_ptr<Seen> Last;
  std::vector<Tile> Tiles;
  std::unique_ptr<Parts> Far;
  std::vector<glm::vec4> OwnShares; ///< of a pixel at rest; samples as alpha
  std::vector<glm::vec4> OwnSums;   ///< of PixelsOwn, while the view stays; samples as alpha
  PictureView LastView;
  std::vector<float> LastDepths;        ///< of what was drawn in it
  bool Fresh = true;                    ///< something was forgotten or aged since the last picture
  std::uint32_t Now = 0, OwnNumber = 0; ///< of pictures; of the first point in OwnSums
  std::int64_t RayCount = 0, NewPixelCount = 0;
};

} // namespace hasp
