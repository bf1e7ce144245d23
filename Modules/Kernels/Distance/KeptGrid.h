#pragma once
#include "Grid/GridGeometry.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <utility>

/// The grids on which a fragment of a scan is measured: those of cut bone, and of a scene's
/// fragments.
namespace hasp
{

/// First and last index of what is kept, one byte a sample, x fastest (CoverageSettings::keep);
/// first > last if nothing is. Any thread; O(samples), one core.
std::pair<glm::ivec3, glm::ivec3> KeptRange(
  const glm::ivec3& dims, std::span<const std::uint8_t> keep);

constexpr double KeptGridMarginSteps = 4.0; ///< as wide as the band of CoverageDistanceBand

/// The same step along the scan's three axes, from the first to the last sample that is kept, and
/// around them a step of the scan, which an isosurface reaches out, and KeptGridMarginSteps of its
/// own. Which samples the scan has besides does not matter: a crop of it gives the same grid, to
/// the last digits. Throws std::invalid_argument unless spacingMm is finite and > 0, and if an axis
/// has 2^30 points or more; who takes memory checks their product.
GridGeometry KeptGrid(
  const GridGeometry& scan, const glm::ivec3& first, const glm::ivec3& last, double spacingMm);

} // namespace hasp
