#pragma once
#include "Grid/GridView.h"

#include <cstddef>

namespace hasp
{

struct ClusteredCells;

/// Exact cells against the volume they were made of, by decoding everything.
struct LosslessCheck
{
  std::size_t activeInVolume = 0; ///< counted by brute force
  std::size_t cells = 0;          ///< listed and truly active, each place once
  std::size_t wrongCorners = 0;   ///< decoded samples that differ from the volume's
  bool Lossless() const { return this->activeInVolume == this->cells && this->wrongCorners == 0; }
};
LosslessCheck CheckLossless(const AnyGridView& grid, const ClusteredCells& exact);
/// The same for the cells of some slices of the volume, from slice `first`, a multiple of 8; `slab`
/// holds 8 n + 1 of them, or what is left. Its origin does not matter.
LosslessCheck CheckLosslessSlab(const AnyGridView& slab, int first, const ClusteredCells& exact);

/// How far the surface of compact cells lies from the exact one, where it crosses the grid's edges,
/// voxels.
struct CompactShift
{
  double rms = 0.0, p999 = 0.0, max = 0.0;
  std::size_t edges = 0;
  std::size_t changedCells = 0; ///< with a corner on the other side than the volume's; must be 0
};
CompactShift MeasureShift(const AnyGridView& grid, const ClusteredCells& compact);

/// Bytes in which the two differ, of everything that they hold; lengths that differ count in whole.
std::size_t DifferentBytes(const ClusteredCells& a, const ClusteredCells& b);

} // namespace hasp
