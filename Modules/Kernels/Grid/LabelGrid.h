#pragma once
#include "Grid/GridGeometry.h"

namespace hasp
{

/// Throws std::invalid_argument, beginning with `who`, unless labels are of a scan's samples: as
/// many along each axis, and each within a hundredth of the scan's least spacing of the place of
/// its own, which is more than decimals of a header lose. Says which of size, spacing, direction
/// and origin is another.
/// Any thread; O(1).
void CheckLabelGrid(const char* who, const GridGeometry& scan, const GridGeometry& labels);

} // namespace hasp
