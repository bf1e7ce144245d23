#pragma once
#include "Isosurface/ClusteredCells.h"

namespace hasp
{

/// The same active cells with 8 bits a corner: the sign of sample - isovalue, exact, and one of 128
/// magnitudes (CompactLevels). Their range is the least power of two above the largest distance of
/// a corner from the isovalue, so that most edits of the volume leave the levels alone.
///
/// exact  cells with CellPrecision::Exact; attributes are kept
/// Throws std::invalid_argument if they are compact already. O(corners), all threads, the same
/// bytes whatever their number.
ClusteredCells CompactCells(const ClusteredCells& exact);

/// As above, with levels up to 2^exponent, which must be no less than CompactExponent(exact).
ClusteredCells CompactCells(const ClusteredCells& exact, int exponent);

/// Exponents below this one are raised to it: no level may become 0 where denormal numbers are
/// flushed, or its sign would be lost. Corners nearer than 2^-100 to the isovalue keep their sign
/// and not their size.
constexpr int LeastCompactExponent = -100;

/// Of the cluster of compact cells, or the largest of exact ones.
int CompactExponent(const CellCluster& cluster);
int CompactExponent(const ClusteredCells& exact);

} // namespace hasp
