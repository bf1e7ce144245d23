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
/// the shell: a tube around the landmarks, or for a filled outline the prism around their polygon,
/// not deeper than half a width below the lowest; strokes added or taken away.
struct GuideFrame
{
  GridGeometry grid;
  SolidPointer region;
};

/// The recipe must be valid, and its directions unit. `keep` marks the samples of `ct` that are
/// bone: the grid of a filled outline reaches as high as bone does inside it. The grid holds all of
/// `parts`, too. Throws std::invalid_argument if it would exceed 2e8 voxels. Any thread.
GuideFrame MakeGuideFrame(const GuideRecipe& recipe, const GridGeometry& ct,
  std::span<const std::uint8_t> keep, std::span<const GuidePart> parts);

/// The region alone of the band around open or closed landmarks, the strokes and, of a filled
/// outline, the ring around it: what needs no withdrawal direction.
SolidPointer MakeGuideBand(const GuideRecipe& recipe);

} // namespace hasp
