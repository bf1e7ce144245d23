#pragma once
#include "Isosurface/PictureRays.h"
#include "Light/LitScene.h"
#include "Light/SobolSequence.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace hasp
{

struct PathTracerSettings
{
  int bounces = 3; ///< surfaces that light may have met on its way to the eye, [1, 64]; 1: direct
                   ///< light alone
  /// From which bounce on paths end by Russian roulette, with the share of light that they lose, so
  /// that the mean stays; >= 1.
  int rouletteFrom = 2;

  /// Throws std::invalid_argument, with the value and the range.
  void Validate() const;
  bool operator==(const PathTracerSettings&) const = default;
};

/// What light a sample carries, and how many rays it took.
struct PathSample
{
  glm::vec3 radiance{ 0.0F };
  int rays = 0;
};

/// Light of a scene by paths from the eye: at each surface the environment is asked by its own
/// bright places and by the surface's lobe, the two weighted against each other (multiple
/// importance sampling, balance heuristic: Veach 1997), and each lamp by one ray.
///
/// Unbiased for paths of `bounces` surfaces, and bounded: no single sample is above
/// BrightestSample, so one pixel of a million in a map makes noise, but no firefly beyond that.
/// Points: a SobolSequence, whose dimensions a path takes one after the other, or a RandomSequence.
/// Threads: any.
template <typename Points>
class PathTracer
{
public:
  /// scene must outlive it. Throws as PathTracerSettings::Validate.
  PathTracer(const LitScene& scene, const PathTracerSettings& settings);

  /// From a surface towards an eye, unit.
  PathSample Radiance(const LitHit& hit, const glm::dvec3& towardsEye, Points& points) const;
  /// That comes along a ray; the environment's where it meets nothing.
  PathSample Incoming(const glm::dvec3& origin, const glm::dvec3& direction, Points& points) const;
  /// What a white diffuse surface in its place would send out: irradiance over pi, without the
  /// direct light of lamps. far: what lights it itself, found by the lobe alone, so without small
  /// bright parts; null: the scene's environment. For light
  /// that is kept on surfaces.
  PathSample WhiteRadiance(
    const LitHit& hit, Points& points, const Environment* far = nullptr) const;

  /// What no sample exceeds in a scene of diffuse bodies, whatever the map: 2 bounces times (the
  /// environment's Total over pi, or its radiance where that is uniform, and all lamps at their
  /// constant attenuation). A gloss adds its peak: not bounded by this.
  double BrightestSample() const;

private:
  struct Path;
  void Lamps(const LitHit& hit, const SurfaceScattering::At& at, Path& path) const;
  void Surroundings(const LitHit& hit, const SurfaceScattering::At& at, const Environment& far,
    Points& points, Path& path) const;
  std::optional<LitHit> Scatter(const LitHit& hit, const SurfaceScattering::At& at,
    const Environment& far, bool weighted, Points& points, int bounce, Path& path) const;
  void Walk(LitHit hit, glm::dvec3 towardsEye, Points& points, int bounce, Path& path) const;

  const LitScene* Scene;
  PathTracerSettings Settings;
  bool Dark; ///< nothing comes from far away
};

class RandomSequence;
extern template class PathTracer<SobolSequence>;
extern template class PathTracer<RandomSequence>;

/// A picture that becomes better sample by sample.
struct PathTracedPicture
{
  glm::ivec2 size{ 0 };
  int samples = 0;              ///< of every pixel
  std::vector<glm::dvec3> sums; ///< of radiance, row by row from the lowest; the background is 0
  std::vector<float> covered;   ///< samples that met a surface
  std::int64_t rays = 0;

  /// Mean radiance over black, and the share of the pixel that a surface covers.
  glm::vec4 Pixel(std::size_t n) const;
  std::size_t Bytes() const;
};

struct PathPictureSettings
{
  PathTracerSettings paths;
  std::uint32_t seed = 0;
  /// Samples lie all over a pixel, so that edges are smooth; else in its centre.
  bool smoothEdges = true;
};

/// Adds samples to a picture of a view, whose index coordinates are the world's, on all cores: the
/// same picture with any number of them. Between two tiles of 16 x 16 pixels it asks cancel and
/// returns false: the picture then holds what earlier calls made, no part of this sample. Throws
/// std::invalid_argument on a negative size or a matrix that cannot be inverted.
/// A picture of another size begins anew. Memory: 56 bytes a pixel.
bool AddPathSample(const LitScene& scene, const PictureView& view,
  const PathPictureSettings& settings, PathTracedPicture& picture,
  const std::atomic<bool>* cancel = nullptr);

} // namespace hasp
