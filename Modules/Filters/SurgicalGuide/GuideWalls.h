#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridGeometry.h"
#include "Grid/Progress.h"

namespace hasp
{

/// What of a solid is thick enough: all within `ballMm + keptMm` of the places deeper than `ballMm`
/// in it, and in it (the opening of mathematical morphology, with keptMm = 0; Serra 1982). Fins and
/// films thinner than two balls are gone, those of two balls and two spacings stay; tips of wedges
/// are gone from keptMm behind their last ball on, within 1.1 spacings.
/// Edges of 90 degrees stay sharp where keptMm >= 0.42 ballMm; at 0 they are round.
///
/// solid    its values must be distances inside, where it is not deeper than ballMm
/// grid     holds the solid, or all that matters of it: beyond it there is nothing
/// ballMm   at least 1.25 spacings, so that samples see it
/// The surface that stays is the solid's own; what is cut off ends true to 0.1 of a spacing.
/// Null if nothing is as thick. All cores, the same result with any number of them; Cancelled.
/// O(samples near the surface), 8 bytes a sample.
SolidPointer ThickParts(const SolidPointer& solid, const GridGeometry& grid, double ballMm,
  double keptMm, const ProgressFunction& progress);

} // namespace hasp
