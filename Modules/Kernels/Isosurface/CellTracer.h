#pragma once
#include "Isosurface/ClusteredCells.h"
#include "Isosurface/PictureRays.h"

#include <glm/vec4.hpp>

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hasp
{

/// Where a ray meets the surface.
struct CellHit
{
  double t;             ///< of the ray
  std::uint32_t number; ///< of the active cell, as ClusteredCells counts
  glm::ivec3 cell;      ///< its place in the volume
  glm::vec3 local;      ///< the hit in the cell, [0,1]^3
  glm::vec3 gradient;   ///< of the volume at the hit, per index step; points to larger samples
  bool fromInside;      ///< the ray came from where samples are >= isovalue

  glm::dvec3 Position() const { return glm::dvec3(this->cell) + glm::dvec3(this->local); }
};

/// One entry a pixel, row by row from the lowest (as OpenGL has it), ready to be textures.
struct TracedPicture
{
  static constexpr std::uint32_t Nothing = 0xFFFFFFFFU;
  static constexpr float NoDepth = 2.0F;
  glm::ivec2 size{ 0 };
  std::vector<std::uint32_t> cells; ///< number of the active cell met, or Nothing
  /// Per index step, as CellHit's; depth, [0,1] as in a window, or NoDepth.
  std::vector<glm::vec4> gradients;
  /// Empty where they were not asked for. Else where something was met, for most of a picture may
  /// be open and memory is what it costs; elsewhere they keep what was there, 0 in a new picture.
  std::vector<glm::vec3> places;   ///< hit in the cell, [0,1]^3
  std::vector<glm::ivec3> corners; ///< lowest sample of the cell, index coordinates
};

struct AmbientOcclusionSettings
{
  int rays = 16;          ///< >= 1. The error falls about with rays^-0.75
  double distanceMm = 25; ///< what is farther away does not darken; > 0, may be infinite
};

struct ShadowSettings
{
  glm::dvec3 towardsLight{ 0.0, 0.0, 1.0 }; ///< world direction, not 0
  double halfAngle = 0.0; ///< of the light as seen from the surface, radians, [0, pi/2]; 0: a point
  int rays = 16;          ///< >= 1; a point takes one
  double distanceMm = std::numeric_limits<double>::infinity(); ///< to the light; > 0
};

/// Traces rays against the trilinear isosurface in clustered cells, with Embree's tree over the
/// boxes of the clusters' active cells and, in each box, a walk from cell to cell with the root of
/// glsl/RayRoot.glsl in active ones (thesis 3.2.2; Decisions/0012 says why not triangles).
///
/// No ray slips between cells or clusters: both sides of a face see the same point and the same
/// value there. A ray is moved in double precision to where it enters the volume, so an eye a
/// million voxels away is as good as a near one. Hits do not depend on the CPU's instruction
/// set; the directions of soft light do in the last bit, as the C library's sine does.
///
/// Threads: all const functions from any thread. The cells are shared, never copied.
class CellTracer
{
public:
  /// O(clusters log clusters), all threads. Throws std::invalid_argument if cells is null, or not
  /// consistent (a cluster without cells, outside the volume or with corners beyond the stream; not
  /// 128 levels where they are compact). Cells of unknown origin are for ValidateCells to check.
  /// std::runtime_error if Embree fails, with its reason. device: how Embree is to work, as
  /// rtcNewDevice takes it, say "isa=avx2"; empty: as suits the CPU.
  explicit CellTracer(
    std::shared_ptr<const ClusteredCells> cells, const std::string& device = std::string());
  ~CellTracer();
  CellTracer(const CellTracer&) = delete;
  CellTracer& operator=(const CellTracer&) = delete;

  const ClusteredCells& Cells() const;
  /// What the tracer holds beside the cells: Embree's memory as Embree counts it, and the boxes.
  /// About 110 bytes a cluster, 1.6 an active cell on a head; a mesh and its tree take 170.
  std::size_t Bytes() const;

  /// The first point of the surface along the ray, from either side. Nothing if it misses, or if a
  /// component is not finite. About 0.2 us on a head CT.
  std::optional<CellHit> Trace(const CellRay& ray) const;
  /// Does it meet the surface at all? No dearer than Trace.
  bool Occluded(const CellRay& ray) const;

  /// The first point of the surface along a ray that starts on it, at a hit, towards a direction of
  /// the world; t counts in the direction's length, up to `distance`. The root that it starts from
  /// is divided out, so it neither meets itself nor starts behind a thin wall. The direction leads
  /// to the side that the hit's ray came from; else nothing is met before the other side.
  std::optional<CellHit> TraceFrom(
    const CellHit& hit, const glm::dvec3& direction, double distance) const;
  /// Does that ray meet the surface at all?
  bool OccludedFrom(const CellHit& hit, const glm::dvec3& direction, double distance) const;

  /// Unit, out of the surface on the side the hit's ray came from, in the world; 0 where the
  /// gradient is.
  glm::dvec3 Outwards(const CellHit& hit) const;

  /// Trace for every pixel of a view, in packets whose rays walk side by side (Decisions/0015), all
  /// threads; the same picture, bit for bit, with any number of them and on any CPU. Throws
  /// std::invalid_argument if the size is negative or indexToClip cannot be inverted.
  /// places: are the picture's places and corners wanted? Light needs them.
  void TracePicture(const PictureView& view, TracedPicture& picture, bool places = true) const;

  /// The share of a cosine-weighted hemisphere over the hit, on the side the ray came from, that is
  /// open: 1 in the open, exactly. seed: the pixel's number, say; the same seed gives the same
  /// rays. Throws std::invalid_argument on settings out of range.
  float AmbientOcclusion(
    const CellHit& hit, const AmbientOcclusionSettings& settings, std::uint32_t seed = 0) const;

  /// One of those rays: does it leave the hit without meeting the surface within so many
  /// millimetres? sample: in the unit square; even samples make cosine-weighted directions.
  bool Open(const CellHit& hit, const glm::dvec2& sample, double distanceMm) const;

  /// The share of the light that reaches the hit, on the side the ray came from: 0 or 1 for a
  /// point, between them in the half shadow of a disc. Cosines are the shading's business. seed and
  /// throws as above.
  float Light(const CellHit& hit, const ShadowSettings& settings, std::uint32_t seed = 0) const;

  static constexpr std::size_t PacketSize = 16;
  /// Which of at most so many hits see a light, a bit each, as Light says of a point. light: in the
  /// world; w 0: a direction towards it, else its place. In packets: hits that lie close together
  /// cost half as much. Throws std::invalid_argument on more hits, or if light is 0 or not finite.
  std::uint32_t Sees(std::span<const CellHit> hits, const glm::dvec4& light) const;

private:
  class Scene;
  std::unique_ptr<const Scene> Embree;
};

} // namespace hasp
