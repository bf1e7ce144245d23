#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

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
};

/// Measures a guide as it was written: give the mesh read back from its file.
///
/// The inner wall is chosen by geometry alone: triangles whose outward normal points at the bone
/// (against the isosurface's outward normal at the nearest point, cosine >= facing) and whose
/// centre lies within nearMm of it. Distances are DistanceToIsosurface at triangle centres.
/// Throws std::invalid_argument on settings out of range, a bad volume or a triangle whose points
/// are not there; Cancelled. Any thread;
/// all cores.
GuideGap MeasureGuideGap(const AnyGridView& volume, const TriangleMesh& guide,
  const GuideGapSettings& settings, const ProgressFunction& progress = {});

} // namespace hasp
