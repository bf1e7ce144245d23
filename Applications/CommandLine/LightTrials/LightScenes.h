#pragma once
#include "Grid/AnalyticVolumes.h"
#include "Light/PathTracer.h"

#include <memory>
#include <string>
#include <vector>

namespace hasp
{

// Scenes, views and pictures that the trials of light share. Any thread; all cores inside.

/// The surface of a volume, as active cells.
std::shared_ptr<const CellTracer> CellsOf(const AnyGridView& grid, double isovalue);
/// The surface of a closed form, sampled n^3 times in a cube about the origin; spacing in mm.
/// spacing may differ per axis, then the form is squeezed or stretched with it: cells look the same
/// in index coordinates whatever it is.
std::shared_ptr<const CellTracer> CellsOf(
  const AnalyticVolume& shape, int n, double halfMm, const glm::dvec3& spacingScale = { 1, 1, 1 });

LitBody BodyOf(std::shared_ptr<const CellTracer> cells, const SurfaceMaterial& material);
/// Flat triangles.
LitBody BodyOf(TriangleMesh mesh, const SurfaceMaterial& material);
/// Two triangles across z, at z 0, facing up.
TriangleMesh SquareMesh(double halfMm);

/// Daylight with its default sun.
std::shared_ptr<const Environment> Daylight();
std::shared_ptr<const Environment> UniformLight(float radiance);

/// The scene from afar, turned about z by so much; side x side pixels.
PictureView OrbitView(const LitScene& scene, double degrees, int side);

/// What pixels of a view see.
struct SeenHit
{
  LitHit hit;
  glm::dvec3 towardsEye; ///< unit
};
/// Of all pixels that see a surface, or of as many of them, evenly chosen.
std::vector<SeenHit> SeenHits(
  const LitScene& scene, const PictureView& view, std::size_t most = SIZE_MAX);

/// Linear radiance; alpha above 0 where a surface is seen.
using LightPixels = std::vector<glm::vec4>;
LightPixels PixelsOf(const PathTracedPicture& picture);
/// By paths through the centres of pixels.
PathTracedPicture TracePaths(
  const LitScene& scene, const PictureView& view, int bounces, int samples, std::uint32_t seed);

/// Root of the mean square of what a channel is off by, over the pixels of the truth's surface.
double RmsError(const LightPixels& pixels, const LightPixels& truth);
/// Mean of a channel over the same.
double MeanRadiance(const LightPixels& pixels);

/// A seed of a place's sequence: unlike for neighbours.
std::uint32_t SeedOf(std::uint64_t seed, std::size_t place);

/// sums[n] of `samples` samples of each hit, in double: sample(hit, number of the hit, of the
/// sample).
using SampleHit = std::function<glm::vec3(const SeenHit&, std::uint32_t, std::uint32_t)>;
std::vector<glm::dvec3> MeansOf(
  const std::vector<SeenHit>& hits, int samples, const SampleHit& sample);

} // namespace hasp
