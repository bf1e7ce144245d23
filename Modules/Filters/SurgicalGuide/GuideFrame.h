#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridGeometry.h"
#include "GuideParts.h"
#include "Planning/GuideRecipe.h"

#include <cstdint>
#include <span>

namespace hasp
{

/// Where a guide may be: the working grid (its z is the withdrawal direction), and the region of
/// the shell, whose walls are upright: what is within half a width of the landmarks' line, or of
/// their polygon for a filled outline, as seen along the withdrawal direction; strokes added or
/// taken away. Along that direction it ends as far as at a slope of 45 degrees bone and shell on it
/// would have left the walls: round the line, or below the lowest landmark of a filled outline.
struct GuideFrame
{
  GridGeometry grid;
  SolidPointer region;
};

/// The recipe must be valid, and its directions unit. `keep` marks the samples of `ct` that are
/// bone: the grid of a filled outline reaches as high as bone does inside it. The grid holds all of
/// `parts` that are added, too. Throws std::invalid_argument if it would exceed 2e8 points, and
/// std::runtime_error if a part lies apart from the region. Any thread.
GuideFrame MakeGuideFrame(const GuideRecipe& recipe, const GridGeometry& ct,
  std::span<const std::uint8_t> keep, const GuideParts& parts);

/// Tubes around the landmarks' line, closed for a filled outline, and the strokes: what needs no
/// withdrawal direction, to look for one.
SolidPointer MakeGuideBand(const GuideRecipe& recipe);

} // namespace hasp
