#pragma once
#include "Evaluation/MeshSamples.h"
#include "Evaluation/SurfaceDistance.h"
#include "Evaluation/WallThickness.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>

namespace hasp
{

struct ShellSettings
{
  double gapMm = 0.3;          ///< of the inner wall to bone, as claimed
  double gapToleranceMm = 0.2; ///< of it
  double facing = 0.8;         ///< least cosine between a wall's normal and the way to the bone
  std::optional<glm::dvec3> withdrawal; ///< unit; see below
};

/// How thick a shell on bone is: from its wall that faces bone straight to its outer side. mm.
struct ShellThickness
{
  double shellMm2 = 0.0;          ///< of the inner wall that was measured; 0: there is no shell
  double leastMm = 0.0;           ///< of ThinnestPlace (ThinPlaces.h)
  glm::dvec3 leastAt{ 0.0 };      ///< middle of the shell there
  double p5Mm = 0.0, p50Mm = 0.0; ///< 5 and 50 % of the inner wall's area have less
};

/// Chords of the places that face bone (`nearest`: where it is) and come out of a side that looks
/// away within 30 degrees: what comes out steeper is cut, by a slot, a hole or the rim.
///
/// Undercuts are blocked out along the withdrawal direction, which leaves walls along it (within 10
/// degrees), and the shell runs out there by design. Where the inner wall is one, and within
/// tolerance of its gap, what the gap has too much is counted in, since the outer side is measured
/// from bone; farther off, and where the outer side is one, nothing is measured. WallThickness
/// holds those places to what a wall must be.
/// The three spans have one size; else std::invalid_argument. Any thread; one core.
ShellThickness MeasureShell(std::span<const MeshSample> samples, std::span<const Chord> chords,
  std::span<const std::optional<NearestSurface>> nearest, const ShellSettings& settings);

} // namespace hasp
