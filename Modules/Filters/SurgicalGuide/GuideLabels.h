#pragma once
#include "Distance/ImplicitSolid.h"
#include "Planning/GuideRecipe.h"

namespace hasp
{

/// The letters of labels[n], to add (embossed) or to take away (engraved): pillars along the wall's
/// normal below the label's middle, between the depths of the outer wall that the label names.
///
/// bone   signed distance to it, mm
/// bare   the shell where nothing else is on it or through it: what letters must lie on
/// Throws std::runtime_error, naming the label and never its text, if it lies on no wall, is
/// written towards it, or less than 98 of 100 places of its strokes lie on the bare shell.
SolidPointer MakeGuideLabel(
  const GuideRecipe& recipe, std::size_t n, const SolidPointer& bone, const ImplicitSolid& bare);

} // namespace hasp
