#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hasp
{

/// What a voxel belongs to: 0 is nothing, 1 … 65535 a fragment each. A label map is one of these a
/// voxel, on the grid of its scan.
using Label = std::uint16_t;
constexpr Label MaxLabel = 65535;

/// Voxels of each label: element l counts label l; as many elements as the largest label asks for,
/// at least 1. Any thread; no state kept. O(voxels), on all cores.
std::vector<std::size_t> CountLabels(GridView<const Label> labels);

/// 1 where lowest <= value <= highest, 0 elsewhere: bone as a label map. NaN is outside. Throws
/// std::invalid_argument if lowest > highest or either is NaN, if sizes differ, Cancelled if
/// progress says so. Any thread; no state kept. O(voxels), on all cores.
void ThresholdLabels(const AnyGridView& grid, double lowest, double highest, GridView<Label> labels,
  const ProgressFunction& progress = {});

} // namespace hasp
