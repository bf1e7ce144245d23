#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "GuideFrame.h"

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace hasp
{

/// Turns distances to bone into the guide's own field, in place.
///
/// field   on frame.Grid(), mm: in, signed distance to bone, negative inside; out, negative inside
///         the guide: region and shell, less the shadow of bone (all that lies under bone or closer
///         than the gap as seen along the withdrawal direction), less slots, less holes
/// keep    one byte a sample of `ct`, as KeepLargePieces gives it: bone above the working grid
///         shadows the columns below it
/// Throws std::runtime_error if nothing is left, or a slot or hole takes nothing away (named);
/// Cancelled. All cores.
void ComposeGuideField(std::vector<float>& field, const AnyGridView& ct,
  const std::vector<std::uint8_t>& keep, const GuideFrame& frame, const GuideRecipe& recipe,
  const ProgressFunction& progress);

/// The error of a guide without substance.
std::runtime_error NothingLeft();

} // namespace hasp
