#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/RigidPose.h"
#include "ImplantFootprint.h"

#include <span>
#include <vector>

namespace hasp
{

/// Places of the bone's outer table, seen from above along the grid's third axis, under columns
/// where `depth` (OutlineDepth) is within [-outsideMm, 0]: around the hole. Where bone leans more
/// than 60 degrees from the axis there are none.
std::vector<glm::dvec3> RimPlaces(
  const ImplicitSolid& bone, const ColumnLayer& depth, double outsideMm);

/// A mirrored table laid on the bone around a hole. mm, degrees.
struct LaidTable
{
  RigidPose pose;       ///< moves the mirrored side
  double shiftMm = 0.0; ///< along the axis, in the middle of the places
  double tiltDeg = 0.0;
  double rmsMm = 0.0; ///< of the mirrored table to bone, at the places
  double p95Mm = 0.0; ///< 95 % of the places are nearer
};

/// Heads are not quite symmetric: moves the mirrored side along the axis and tilts it so that it
/// meets the places of the rim, least in squares (Gauss and Newton) of those three fifths of them
/// that are nearest, and all within 0.3 mm: the rest may be sunk or broken. It is not slid across:
/// what is round does not tell how far.
///
/// mirrored   signed distance to the mirrored side, filled below its outer table
/// Throws std::runtime_error, beginning with "implant", if there are fewer than 20 places, if less
/// than half of them come to lie within 2 mm, or it would move by more than 6 mm or 8 degrees.
LaidTable LayOnRim(
  const ImplicitSolid& mirrored, std::span<const glm::dvec3> places, const glm::dmat3& axes);

} // namespace hasp
