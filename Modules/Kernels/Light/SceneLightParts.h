#pragma once
// Private to SceneLightCache: one call of Light, and what its tiles say.
#include "Isosurface/EvenPoints.h"
#include "Isosurface/LightBlocks.h"
#include "Light/SceneLightCache.h"
#include "Light/ViewPlaces.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>

namespace hasp
{

/// What a place's light is kept as, and turned back by: radiance = share * Reference.
struct SceneLightCache::Picture
{
  const LitScene& scene;
  const PictureView& view;
  const PictureRays& rays;
  const ViewPlaces& places;
  const PathTracer<SobolSequence>& paths;
  const DrawnDepths& drawn;
  const SceneLightRequest& request;
  glm::dvec4 eye;  ///< w 0: it looks along xyz
  glm::vec3 floor; ///< added to the open light, so that no place is without
  bool stays;
  bool reflects;             ///< do coats and metals show what is around them?
  const Environment& soft;   ///< what lights surfaces by the cache
  const Environment* bright; ///< and by rays of each pixel; null: nothing does

  glm::vec3 Open(const glm::dvec3& normal) const
  {
    return this->soft.Irradiance(normal) / glm::pi<float>();
  }
  /// Of what is kept as shares of it.
  glm::vec3 Reference(const glm::dvec3& normal) const
  {
    return this->Traced() ? this->Open(normal) + this->floor : glm::vec3(1.0F);
  }
  bool Traced() const { return this->request.kind == SceneLightRequest::Kind::Traced; }
  std::optional<LitHit> HitOf(std::size_t pixel) const;
  /// One sample of the light at a hit, as a share of its Reference.
  glm::vec3 Share(const LitHit& hit, SobolSequence& points, Tile& tile) const;
  /// The direct light of lamps on a white surface.
  glm::vec3 Lamps(const LitHit& hit, Tile& tile) const;
  /// One sample of the direct light that the environment's bright parts give a white surface.
  glm::vec3 White(const LitHit& hit, SobolSequence& points, Tile& tile) const;
  glm::dvec3 TowardsEye(const LitHit& hit) const
  {
    return this->eye.w == 0.0 ? -glm::normalize(glm::dvec3(this->eye))
                              : glm::normalize(glm::dvec3(this->eye) - hit.position);
  }
};

/// The scene's environment, its small bright parts apart.
struct SceneLightCache::Parts
{
  std::weak_ptr<const Environment> whole;
  std::unique_ptr<const Environment> soft, bright; ///< null where they need not be told apart
};

/// A place on the surface and where both lattices keep its light.
struct SceneLightCache::Known
{
  // Samples, as ColorMean counts.
  static constexpr float Coarse = 16.0F;  ///< what the coarser lattice counts for where the finer
                                          ///< knows nothing
  static constexpr float Enough = 128.0F; ///< and above this the finer one is alone

  LightSpot fine, coarse;

  Known(const LightBlocks& blocks, LightBlockFinder& finder, const LightPlace& place)
    : fine(blocks.Find(finder, place)),
      coarse(blocks.Find(finder, place.Coarser()))
  {
  }
  /// What both say. No samples: nothing is known.
  ColorMean Mean(const LightBlocks& blocks) const
  {
    const ColorMean finer = blocks.MeanColor(this->fine);
    if (finer.samples >= Enough)
      return finer;
    const ColorMean coarser = blocks.MeanColor(this->coarse);
    if (coarser.samples == 0.0F)
      return finer;
    const float share = Coarse * (1.0F - finer.samples / Enough);
    return { (finer.samples * finer.color + share * coarser.color) / (finer.samples + share),
      std::max(finer.samples, 1e-6F) };
  }
};

/// What the pixels of a tile have to say in a frame. The vectors keep their memory.
struct SceneLightCache::Tile
{
  static constexpr int Side = 16; ///< pixels

  struct Sample
  {
    LightPlace place;
    glm::vec3 share;
  };
  struct Doubtful ///< looked up once the frame's paths are added
  {
    LightPlace place;
    glm::vec3 factor; ///< times the share
    std::uint32_t pixel;
  };
  std::vector<Sample> samples;
  std::vector<Doubtful> doubtful;
  std::vector<LightBlocks::Key> missing;
  std::int64_t rays = 0, unknown = 0;
  std::uint32_t seed = 0, points = 0; ///< of its sequence; goes on from frame to frame
  double due = 0.0;                   ///< paths, from frame to frame; the whole part is cast

  void Begin(std::uint32_t number)
  {
    this->samples.clear();
    this->doubtful.clear();
    this->missing.clear();
    this->rays = this->unknown = 0;
    this->seed = HashOf(number ^ 0x68BC21EBU);
  }
};

} // namespace hasp
