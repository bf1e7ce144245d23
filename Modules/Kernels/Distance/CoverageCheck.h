#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/ParallelFor.h"

#include <atomic>
#include <span>
#include <stdexcept>
#include <string>

namespace hasp
{

/// What every transform of coverage asks of it: a valid geometry, a value for each voxel, each in
/// [0,1]. Throws std::invalid_argument, with `who` before what is wrong. One pass over the values,
/// all cores.
inline void CheckCoverage(
  const GridGeometry& geometry, std::span<const float> coverage, const std::string& who)
{
  geometry.Validate();
  if (coverage.size() != geometry.Size())
    throw std::invalid_argument(who + ": " + std::to_string(coverage.size()) +
                                " coverage values for " + std::to_string(geometry.Size()) +
                                " voxels");
  std::atomic<bool> sound{ true };
  ParallelFor(0, std::int64_t(coverage.size()), 1 << 18,
    [&](std::int64_t first, std::int64_t last)
    {
      int outside = 0;
      for (std::int64_t v = first; v < last; ++v)
        outside |= !(coverage[v] >= 0.0F) | !(coverage[v] <= 1.0F); // NaN is outside, too
      if (outside)
        sound = false;
    });
  if (!sound)
    throw std::invalid_argument(who + ": coverage must be in [0, 1]");
}

} // namespace hasp
