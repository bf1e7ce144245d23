#pragma once
#include "Evaluation/MeshSamples.h"
#include "Evaluation/SurfaceDistance.h"
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace hasp
{

struct GuideGapSettings
{
  double isovalue = 226.0;  ///< the bone's surface
  double gapMm = 0.3;       ///< what was asked for, >= 0
  double toleranceMm = 0.2; ///< > 0
  double nearMm = 1.5;      ///< walls farther from bone are no inner wall; > gapMm
  double facing = 0.8;      ///< least cosine between a wall's normal and the way to the bone
};

/// How far the inner wall of a guide is from the bone. Shares are of wall area.
struct GuideGap
{
  double innerWallMm2 = 0.0; ///< 0: nothing of the mesh faces bone within reach
  double share = 0.0;        ///< of the inner wall within tolerance of the gap asked for
  double closer = 0.0;       ///< of the inner wall nearer than gap - tolerance
  double least = 0.0, p5 = 0.0, p50 = 0.0, p95 = 0.0, most = 0.0; ///< mm
  double leastAnywhere = 0.0; ///< mm, over all triangles within reach, whichever way they face
  glm::dvec3 leastAnywhereAt{ 0.0 }; ///< place of the wall there
  glm::dvec3 worstAt{ 0.0 };         ///< of the inner wall, farthest from the gap asked for
  std::vector<double> histogramMm2;  ///< of the inner wall: BinMm a bin, the first from -nearMm on
  static constexpr double BinMm = 0.05;
};

/// Is the bone at this place bone at all? See BonePieces.
using CountsAsBone = std::function<bool(const glm::dvec3&)>;

/// Measures a guide as it was written: give the mesh read back from its file.
///
/// samples   of the mesh, and `nearest`, one for each: where bone is, no farther than nearMm
/// The inner wall is chosen by geometry alone: places whose outward normal points at the bone
/// (against the isosurface's outward normal at the nearest point, cosine >= facing) and which lie
/// within nearMm of it. Where a wall is too close, `counts` is asked whether what is there is bone;
/// if not, the place is left out.
/// Throws std::invalid_argument on settings out of range or sizes that differ. Any thread; one
/// core.
GuideGap MeasureGuideGap(std::span<const MeshSample> samples,
  std::span<const std::optional<NearestSurface>> nearest, const GuideGapSettings& settings,
  const CountsAsBone& counts = {});

/// The same of places all over the mesh, GapSampleMm apart, by DistanceToIsosurface. Throws
/// std::invalid_argument likewise, on a bad volume and on a triangle whose points are not there;
/// Cancelled. All cores.
GuideGap MeasureGuideGap(const AnyGridView& volume, const TriangleMesh& guide,
  const GuideGapSettings& settings, const ProgressFunction& progress = {});
inline constexpr double GapSampleMm = 0.5;

} // namespace hasp
