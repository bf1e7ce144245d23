#pragma once
#include "Grid/GridGeometry.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hasp::bench
{

/// ITK's SignedMaurerDistanceMapImageFilter as it comes, mm, negative inside, on `threads` threads.
/// Only with HASP_ENABLE_ITK. ITK measures to the centres of the mask's outermost voxels.
std::vector<float> ItkSignedMaurer(
  const GridGeometry& geometry, std::span<const std::uint8_t> inside, int threads);

} // namespace hasp::bench
