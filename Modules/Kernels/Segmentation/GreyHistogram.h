#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <cstdint>
#include <vector>

namespace hasp
{

/// How often grey values occur. Bin b counts lowest + b * binWidth <= value < lowest + (b + 1) *
/// binWidth; at most 65,536 bins, neither the first nor the last of them empty.
struct GreyHistogram
{
  double lowest = 0.0;
  double binWidth = 1.0; ///< > 0
  std::vector<std::uint64_t> counts;

  double Middle(std::size_t bin) const { return lowest + (double(bin) + 0.5) * binWidth; }
};

/// Of all finite samples; none gives no bins. Integers have bins of 1 that begin half a unit below
/// them, so that a bin's middle is its value. Floats have 65,536 bins (one of width 1 where all are
/// the same) from their smallest to their largest value. Where 99.98 % of them then share fewer
/// than 256 bins, a few values being far off, these bins are divided again, at most 15 times, and
/// the few are left out; unless the many are one value, and the few all that there is besides.
///
/// Throws Cancelled. Any thread; no state kept; all cores, the same counts with any number.
/// O(samples), for floats two passes and one more each time.
GreyHistogram CountGreyValues(const AnyGridView& grid, const ProgressFunction& progress = {});

} // namespace hasp
