#pragma once
#include "Grid/Progress.h"
#include "Isosurface/ClusteredCells.h"

#include <functional>
#include <stdexcept>

namespace hasp
{

/// Slices [first, first + count) of a volume, as a view of count slices; its origin does not
/// matter. The view is good until the next call. Calls go forward: each begins with the last slice
/// of the one before.
using SlabSource = std::function<AnyGridView(int first, int count)>;

/// A volume in memory as a source. It must outlive it.
SlabSource SlabsOf(const AnyGridView& volume);

/// More memory would be needed than the cap allows.
struct MemoryCapExceeded : std::runtime_error
{
  MemoryCapExceeded(std::size_t needed, std::size_t cap, double done);
  std::size_t neededBytes; ///< at least
  std::size_t capBytes;
  double share; ///< of the volume that was searched, [0, 1]
};

struct SlabSettings
{
  CellPrecision precision = CellPrecision::Exact;
  /// Most that a slab and the cells made so far may take together, with the room that moving and
  /// compacting them needs; checked before it is taken. The clusters of one layer of blocks are
  /// counted when they are made. What the source keeps beside the slab is not known here.
  std::size_t memoryCapBytes = std::size_t(4) << 30;
  /// Of a slab: 8 n + 1 with n >= 1. 0: as many layers as there are threads, where they fit into a
  /// quarter of the cap.
  int slices = 0;
};

/// What ExtractActiveCells gives for the whole volume, byte for byte, without it ever being in
/// memory: slabs of slices are asked for, searched and forgotten (thesis 3.2.2: large grids). Each
/// sample is read from the source once, but for the slices that neighbouring slabs share.
///
/// geometry  of the whole volume
/// isovalue  as in ExtractActiveCells
/// Throws std::invalid_argument as ExtractActiveCells, for settings out of range, and if the source
/// gives slices of another size or type; MemoryCapExceeded; whatever the source throws; Cancelled.
/// O(samples), all threads, the same bytes whatever their number and the slab's height.
ClusteredCells ExtractActiveCellsFromSlabs(const GridGeometry& geometry, const SlabSource& source,
  double isovalue, const SlabSettings& settings = {}, const ProgressFunction& progress = {});

/// Bytes of one slice of samples of that type of view.
std::size_t SliceBytes(const AnyGridView& view);

} // namespace hasp
