#pragma once
#include "Blade.h"
#include "FragmentLabels.h"
#include "Planning/CutRecipe.h"

#include <cstdint>
#include <optional>

namespace hasp
{

/// What of the bone within a blade the blade is meant for.
struct BladeSection
{
  CutTool tool;
  std::uint32_t fragment; ///< that it belongs to
  double leftMm2;         ///< bone within the blade that is not taken
};

/// bone     what the cuts before left
/// stepMm   of the samples in the blade; a quarter of the thinnest kerf, so that the kerfs of cuts
///          before are seen between their fragments
/// Nothing if there is no bone in the blade. Lazy: without bone that must stay whole the tool is
/// the box. All cores, the same with any number.
std::optional<BladeSection> FindSection(
  const BoneCut& cut, const ImplicitSolid& bone, const FragmentLabels& labels, double stepMm);

} // namespace hasp
