#pragma once
#include "Grid/GridGeometry.h"

namespace hasp
{

/// Which stored axis runs nearest to L, P and S, and whether against it.
struct CanonicalOrder
{
  int axis[3] = { 0, 1, 2 };
  bool turned[3] = {};
};

/// "Nearest" is by a frame turned three degrees from the patient's, so that scans at exactly 45
/// degrees, where rounding would decide, lie clear of the border.
CanonicalOrder CanonicalOrderOf(const GridGeometry& geometry);

/// The geometry of the same samples in that order.
GridGeometry Reordered(const GridGeometry& geometry, const CanonicalOrder& order);

} // namespace hasp
