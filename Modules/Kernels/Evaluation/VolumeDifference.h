#pragma once
#include "Grid/GridView.h"

#include <cstddef>

namespace hasp
{

/// How far two volumes are from being one.
struct VolumeDifference
{
  bool sameSize = false;   ///< as many samples along each axis, whatever the axes' order
  double positionMm = 0.0; ///< largest distance between a sample's two places in the world
  std::size_t samples = 0; ///< that differ; NaN differs from everything
  double largest = 0.0;    ///< of their differences, grey values
  glm::ivec3 first{ -1 };  ///< index of the first that differs, in the first volume
};

/// Compares samples that belong together by their axes: an axis may run the other way in the second
/// volume, or have another number, as long as the samples lie at the same places. Sample types may
/// differ. Where the sizes differ nothing else is measured. Any thread; one pass over both.
VolumeDifference CompareVolumes(const AnyGridView& a, const AnyGridView& b);

} // namespace hasp
