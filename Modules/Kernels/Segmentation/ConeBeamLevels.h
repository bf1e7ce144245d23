#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <optional>

namespace hasp
{

/// Levels of an image in which the patient is grey value > insideAbove.
struct ConeBeamLevels
{
  std::optional<double> air; ///< plateau of what is not the patient
  double softTissue = 0.0;   ///< the strongest level of the patient
  double lowest = 0.0;       ///< half a percent of the patient is below
  double highest = 0.0;      ///< 0.1 % of the patient is above
};

/// Throws std::invalid_argument if no finite sample is > insideAbove; Cancelled. All threads, the
/// same levels with any number of them. O(samples).
ConeBeamLevels FindConeBeamLevels(
  const AnyGridView& grid, double insideAbove, const ProgressFunction& progress);

} // namespace hasp
